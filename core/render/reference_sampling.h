// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "photo_plane.h"

#include "spherewalk/render/bilinear.h"

namespace spherewalk::render {

/// Bilinear value in [0, 255] per channel. Range: pixel coordinates as geometry/equirect.h gives them.
Eigen::Vector3d bilinear(const PlaneView& photo, const Eigen::Vector2d& pixel);

} // namespace spherewalk::render
