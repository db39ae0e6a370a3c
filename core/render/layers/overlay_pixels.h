// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "layers/overlay_layer.h"

#include <cstddef>
#include <cstdint>
#include <span>

/// Rows of an overlay's pixels that hide all that is behind them. The bytes are the same on every processor.
namespace spherewalk::render::simd {

/// Copies the colours of so many pixels. rgba: the first one. rgb: three bytes a pixel are written.
void copyColours(const std::uint8_t* rgba, int count, std::uint8_t* rgb);

/// Writes the colours at positions between pixels, bilinearly. Range: all four pixels about each position lie
/// in the picture. rgb: three bytes a position are written.
void coloursBetween(const RgbaImage& picture, std::span<const OverlayMap::Position> positions,
                    std::uint8_t* rgb);

} // namespace spherewalk::render::simd
