// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/geometry/equirect.h"

#include <cmath>
#include <numbers>

namespace spherewalk {

using std::numbers::pi;

Eigen::Vector3d direction(const SphericalDirection& angles) {
    const double horizontal = cos(angles.elevation);
    return {horizontal * cos(angles.azimuth), horizontal * sin(angles.azimuth), sin(angles.elevation)};
}

SphericalDirection sphericalDirection(const Eigen::Vector3d& direction) {
    // atan2 of height and horizontal distance, not asin of the height: accurate at the poles.
    const double horizontal = std::hypot(direction.x(), direction.y());
    return {wrapped(Radians(std::atan2(direction.y(), direction.x()))),
            Radians(std::atan2(direction.z(), horizontal))};
}

Eigen::Vector3d direction(const EquirectSize& size, const Eigen::Vector2d& pixel) {
    return direction(SphericalDirection{Radians(pi - 2 * pi * (pixel.x() + 0.5) / size.width),
                                        Radians(pi / 2 - pi * (pixel.y() + 0.5) / size.height)});
}

Eigen::Vector2d pixel(const EquirectSize& size, const Eigen::Vector3d& direction) {
    const SphericalDirection angles = sphericalDirection(direction);
    return {(pi - angles.azimuth.value()) * size.width / (2 * pi) - 0.5,
            (pi / 2 - angles.elevation.value()) * size.height / pi - 0.5};
}

} // namespace spherewalk
