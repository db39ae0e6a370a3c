// SPDX-License-Identifier: GPL-3.0-or-later
// What overlays of balls and of meshes have in common.
#pragma once

#include "spherewalk/render/overlay.h"

#include <array>
#include <cstdint>

namespace spherewalk::jobs {

/// Pixels that may show an object.
struct PixelBox {
    int left = 0;
    int top = 0;
    int right = 0; ///< exclusive
    int bottom = 0;
};

/// The pixels around the corners of a cube about a ball; all of the picture if one of them has no pixel.
PixelBox boxAround(const Eigen::Vector3d& pInCamera, double radius, const CameraModel& camera);

/// An overlay of the camera's size that shows nothing.
render::Overlay emptyOverlay(const CameraModel& camera);

/// Gives a pixel the colour of an object. Range: brightness in [0, 1]. pixel: red, green, blue and alpha.
void shade(const std::array<std::uint8_t, 3>& colour, double brightness, std::uint8_t* pixel);

} // namespace spherewalk::jobs
