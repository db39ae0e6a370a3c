// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "photo_plane.h"

#include "spherewalk/render/sampling.h"

#include <array>
#include <cstdint>

namespace spherewalk::render::simd {

/// A cell's samples, places and fractions as LatticeScratch::places() has them, and where its pixels go.
struct CellSamples {
    const std::int32_t* places;
    const std::int32_t* fractions;
    int samplesPerAxis;
    std::uint8_t* out;    ///< red, green, blue of the cell's first pixel
    std::ptrdiff_t pitch; ///< bytes from one row of pixels to the next
    int width;            ///< pixels, at most 16
    int height;
    bool spill; ///< whether 4 bytes beyond a full row may be written, since the next cell writes them again

    /// Places of the next cell: while a row is sampled, memory is asked for that cell's row; null for none.
    const std::int32_t* next = nullptr;
    int nextStep = 1; ///< how far apart the samples are that need different memory, 1 to 16
};

/// CellSamples::nextStep of a cell with so many places in a photo with that stride (PlaneView).
int stepToOtherMemory(const std::int32_t* places, int count, int stride);

/// Sixteen bytes, what Highway shuffles within.
using Block = std::array<std::uint8_t, 16>;

/// The cell's pixels by that sampling: Nearest and Bicubic, else Bilinear.
void sample(const PlaneView& photo, Sampling sampling, const CellSamples& cell);

/// What is to be added to fixed-point coordinates, so that cutting bits off rounds as the sampling needs.
struct Rounding {
    std::int32_t u = 0;
    std::int32_t v = 0;
};

Rounding rounding(Sampling sampling);

/// Each pixel is the mean of its samples, each of which is bilinear. Integer arithmetic, the same on every
/// machine: given the coordinates, a pixel is within 1.05 grey levels of the exact value, 0.5 of them
/// from the final rounding and 0.5 from horizontal weights being multiples of 1/255 (worst at an edge from
/// black to white).
void sampleBilinear(const PlaneView& photo, const CellSamples& cell);

/// The pixels at the places. Range: one sample a pixel.
void sampleNearest(const PlaneView& photo, const CellSamples& cell);

/// Catmull-Rom over sixteen pixels, weights of 14 bits at 1/256 pixel. Range: one sample a pixel.
void sampleBicubic(const PlaneView& photo, const CellSamples& cell);

} // namespace spherewalk::render::simd
