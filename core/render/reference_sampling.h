// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "photo_plane.h"

#include "spherewalk/base/image.h"

#include <Eigen/Core>

namespace spherewalk::render {

/// Bilinear value in [0, 255] per channel. Range: pixel coordinates as geometry/equirect.h gives them.
Eigen::Vector3d bilinear(const PlaneView& photo, const Eigen::Vector2d& pixel);

/// Bilinear value of an equirectangular picture, in [0, 255] per channel. It wraps at the seam, and across a
/// pole it goes on half way round, where the sphere goes on. Range: pixel coordinates as geometry/equirect.h
/// gives them.
Eigen::Vector3d bilinear(const RgbImage& photo, const Eigen::Vector2d& pixel);

} // namespace spherewalk::render
