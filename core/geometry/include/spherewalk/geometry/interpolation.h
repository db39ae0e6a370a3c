// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/geometry/rigid3.h"

namespace spherewalk {

/// The pose between two: a at share 0, b at 1; along a straight line, turned evenly the short way.
inline Rigid3 interpolated(const Rigid3& a, const Rigid3& b, double share) {
    return {a.rotation.slerp(share, b.rotation).normalized(),
            a.translation + share * (b.translation - a.translation)};
}

} // namespace spherewalk
