// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/geometry/angle.h"

#include <Eigen/Core>

namespace spherewalk {

/// The size of an equirectangular picture, which shows the whole sphere: azimuth along u, elevation along v.
/// Frames: panorama, x forward (the picture's centre), y left, z up.
/// Units: pixels; the centre of the top left pixel has the coordinates (0, 0). So
/// azimuth = pi - 2 pi (u + 0.5) / width, and elevation = pi/2 - pi (v + 0.5) / height.
struct EquirectSize {
    int width = 0;
    int height = 0;
    bool operator==(const EquirectSize&) const = default;
};

struct SphericalDirection {
    Radians azimuth;   ///< From +x, counter-clockwise seen from above. Results lie in (-pi, pi].
    Radians elevation; ///< Above the horizon, in [-pi/2, pi/2].
};

/// The unit vector of these angles.
Eigen::Vector3d direction(const SphericalDirection& angles);

/// The angles of a vector of any length. The azimuth of exactly +z or -z is 0. Range: not the zero vector.
SphericalDirection sphericalDirection(const Eigen::Vector3d& direction);

/// The unit vector that the picture shows at this pixel. Range: any u (it wraps), v within [-0.5, H - 0.5].
Eigen::Vector3d direction(const EquirectSize& size, const Eigen::Vector2d& pixel);

/// The pixel that shows this direction. Range: u in [-0.5, W - 0.5), v in [-0.5, H - 0.5].
Eigen::Vector2d pixel(const EquirectSize& size, const Eigen::Vector3d& direction);

} // namespace spherewalk
