// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/photo/metadata.h"

#include <Eigen/Geometry>

#include <optional>

namespace spherewalk::photo {

/// True if the picture's vertical axis is gravity, so that its pose must not be applied again. The maker note
/// decides; without it, a Theta that levels in the camera counts as level while its pose stays under half a
/// degree, and a Theta S or SC does not. Any other camera counts as level if its pose says so.
bool isLevel(const PhotoMetadata& metadata);

/// Takes the photo's panorama frame to one with the same heading whose z axis is up: the identity for a level
/// photo, nothing if it is not level and does not say its tilt.
/// Frames: panorama, x forward, y left, z up.
std::optional<Eigen::Quaterniond> levelFromPhoto(const PhotoMetadata& metadata);

} // namespace spherewalk::photo
