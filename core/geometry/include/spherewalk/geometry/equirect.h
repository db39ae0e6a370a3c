// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/geometry/angle.h"

#include <Eigen/Core>

namespace spherewalk {

/// Equirectangular pictures: the whole sphere, azimuth along u and elevation along v.
/// Frames: panorama, x forward (the picture's centre), y left, z up. Pixel (0, 0) is the top left one, and
/// its centre has the coordinates (0, 0): azimuth = pi - 2 pi (u + 0.5) / W, elevation = pi/2 - pi (v + 0.5)
/// / H.
struct EquirectSize {
    int width = 0;
    int height = 0;
    bool operator==(const EquirectSize&) const = default;
};

struct SphericalDirection {
    Radians azimuth;   ///< counter-clockwise seen from above, from +x; (-pi, pi] where this header returns it
    Radians elevation; ///< above the horizon, [-pi/2, pi/2]
};

/// Shape: unit vector.
Eigen::Vector3d direction(const SphericalDirection& angles);

/// Range: any non-zero vector; at the poles the azimuth is that of the remaining rounding, 0 for exactly +-z.
SphericalDirection sphericalDirection(const Eigen::Vector3d& direction);

/// The unit vector that the picture shows at this pixel. Range: any u (it wraps), v within [-0.5, H - 0.5].
Eigen::Vector3d direction(const EquirectSize& size, const Eigen::Vector2d& pixel);

/// The pixel that shows this direction. Range: u in [-0.5, W - 0.5), v in [-0.5, H - 0.5].
Eigen::Vector2d pixel(const EquirectSize& size, const Eigen::Vector3d& direction);

} // namespace spherewalk
