// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "photo_plane.h"

#include <cstdint>

namespace spherewalk::render::simd {

/// A cell's samples, in the fixed point and order of lattice.h, and where its pixels go.
struct CellSamples {
    const std::int32_t* u;
    const std::int32_t* v;
    int samplesPerAxis;
    std::uint8_t* out;    ///< red, green, blue of the cell's first pixel
    std::ptrdiff_t pitch; ///< bytes from one row of pixels to the next
    int width;            ///< pixels, at most 16
    int height;
    bool spill; ///< whether 4 bytes beyond a full row may be written, since the next cell writes them again
};

/// Asks for the photo's pixels that the cell will need, and does not wait for them.
void prefetch(const PlaneView& photo, const CellSamples& cell);

/// Each pixel is the mean of its samples, each of which is bilinear. Integer arithmetic, the same on every
/// machine: given the coordinates, a pixel is within 1.05 grey levels of the exact value, 0.5 of them
/// from the final rounding and 0.5 from horizontal weights being multiples of 1/255 (worst at an edge from
/// black to white).
void sampleBilinear(const PlaneView& photo, const CellSamples& cell);

/// The nearest pixel. Range: one sample a pixel.
void sampleNearest(const PlaneView& photo, const CellSamples& cell);

/// Catmull-Rom over sixteen pixels, weights of 14 bits at 1/256 pixel. Range: one sample a pixel.
void sampleBicubic(const PlaneView& photo, const CellSamples& cell);

} // namespace spherewalk::render::simd
