// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "layers/overlay_layer.h"
#include "sphere/exact_view.h"

#include "spherewalk/geometry/camera_model.h"

#include <cstddef>
#include <cstdint>
#include <span>

/// Rows of what is laid over a view, several pixels at a time. The bytes are the same on every processor.
namespace spherewalk::render::simd {

/// Copies the colours of so many pixels of an overlay that hides all behind it. rgba: the first one. rgb:
/// three bytes a pixel are written.
void copyColours(const std::uint8_t* rgba, int count, std::uint8_t* rgb);

/// Writes an overlay's colours at positions between pixels, bilinearly. Range: all four pixels about each
/// position lie in the picture. rgb: three bytes a position are written.
void coloursBetween(const RgbaImage& picture, std::span<const OverlayMap::Position> positions,
                    std::uint8_t* rgb);

/// The depths, along the axis, of a row of a pinhole's pixels in the sphere. They are computed in double
/// precision. inCamera: the camera in the optical frame.
void sphereDepths(const CameraIntrinsics& camera, const DisplacedCamera& inCamera, double radiusM, int y,
                  std::span<float> depths);

} // namespace spherewalk::render::simd
