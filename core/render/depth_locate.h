// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

/// Where in a photo the pixels of a view are, whose distances are known. The same bytes on every processor.
namespace spherewalk::render::simd {

/// A photo as its coordinates are computed: the direction in it is m * ray + inverse * offset.
struct PhotoTarget {
    std::array<float, 9> m;
    std::array<float, 3> offset;
    float perRadian; ///< pixels
    float lastU;     ///< greatest coordinates, guard included
    float lastV;
};

/// One component of the rays of a cell of 16 x 16 pixels.
struct CellRays {
    const float* first;
    std::ptrdiff_t pitch; ///< from one row to the next
};

/// Coordinates in the lattice's fixed point of a cell's pixels, row after row.
void locate(const PhotoTarget& target, const std::array<CellRays, 3>& rays, const float* inverse,
            std::ptrdiff_t pitch, std::int32_t* u, std::int32_t* v);

} // namespace spherewalk::render::simd
