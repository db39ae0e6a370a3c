// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "pixels/fixed_point.h"
#include "pixels/photo_plane.h"

#include "spherewalk/render/ladder.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace spherewalk::render::simd {

/// The samples of a cell and the memory of its pixels. Places and fractions are as LatticeRow::places()
/// gives.
struct CellSamples {
    const std::int32_t* places;
    const std::int32_t* fractions;
    int samplesPerAxis;
    std::uint8_t* out;    ///< Red, green and blue of the cell's first pixel.
    std::ptrdiff_t pitch; ///< Bytes from one row of pixels to the next.
    int width;            ///< Pixels, at most 16.
    int height;
    bool spill; ///< Whether 4 bytes beyond a full row may be written, since the next cell writes them again.

    /// The places of the next cell, or null. While a row is sampled, memory is asked for that cell's row.
    const std::int32_t* next = nullptr;
    int nextStep = 1; ///< Every so many samples of the next cell need other memory, 1 to 16.
};

/// CellSamples::nextStep for a cell with so many places. stride: as PlaneView::stride() of the photo.
int stepToOtherMemory(const std::int32_t* places, int count, int stride);

/// Sixteen bytes, within which Highway shuffles.
using Block = std::array<std::uint8_t, 16>;

/// The placing in a photo's plane for this sampling.
Placing placing(const PlaneView& photo, Sampling sampling);

/// Computes the cell's pixels by that sampling: Nearest, Bicubic, or Bilinear for all others.
void sample(const PlaneView& photo, Sampling sampling, const CellSamples& cell);

/// Each pixel is the mean of its bilinear samples. The arithmetic is integer, the same on every machine.
/// Given the coordinates, a pixel is within 1.05 grey levels of the exact value. The final rounding makes 0.5
/// of them. Horizontal weights, which are multiples of 1/255, make 0.5 at an edge from black to white.
void sampleBilinear(const PlaneView& photo, const CellSamples& cell);

/// The pixels at the places. Range: one sample a pixel.
void sampleNearest(const PlaneView& photo, const CellSamples& cell);

/// Catmull-Rom over sixteen pixels, with weights of 14 bits at 1/256 pixel. Range: one sample a pixel.
void sampleBicubic(const PlaneView& photo, const CellSamples& cell);

} // namespace spherewalk::render::simd
