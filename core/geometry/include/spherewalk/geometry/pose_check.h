// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/geometry/rigid3.h"

#include <cmath>

namespace spherewalk {

/// Whether this is a finite place and a rotation: a quaternion whose length is 1 within the tolerance.
inline bool isPose(const Rigid3& pose, double tolerance = 1e-3) {
    return pose.translation.allFinite() && std::abs(pose.rotation.norm() - 1) <= tolerance; // false for NaN
}

} // namespace spherewalk
