// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/image.h"

#include <Eigen/Core>

namespace spherewalk::render {

/// Bilinear value of an equirectangular picture in double precision, in [0, 255] per channel: the reference
/// that faster code is compared with. It wraps at the seam, and across a pole it goes on half way round,
/// where the sphere goes on. Range: pixel coordinates as geometry/equirect.h gives them.
Eigen::Vector3d bilinear(const RgbImage& photo, const Eigen::Vector2d& pixel);

} // namespace spherewalk::render
