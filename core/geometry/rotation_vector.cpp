// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/geometry/rotation_vector.h"

#include <cmath>

namespace spherewalk {

Eigen::Quaterniond turn(const Eigen::Vector3d& turnRad) {
    const double angle = turnRad.norm();
    const double half = angle / 2;
    // Near zero the division loses all digits; the series of sin(angle / 2) / angle keeps them.
    const double scale = angle < 1e-6 ? 0.5 - angle * angle / 48 : std::sin(half) / angle;
    return {std::cos(half), scale * turnRad.x(), scale * turnRad.y(), scale * turnRad.z()};
}

} // namespace spherewalk
