// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

/// What a view from surfaces does with its cells of 16 x 16 pixels. The same bytes on every processor.
namespace spherewalk::render::simd {

/// Least and greatest value of a cell.
std::array<float, 2> range(const float* values, std::ptrdiff_t pitch);

/// How many values are 0 in each 4 x 4 part of a cell of 16 x 16 pixels, row after row; and of all of it.
int zeros(const float* values, std::ptrdiff_t pitch, std::array<std::int32_t, 16>& ofParts);

/// Takes the values of `seen` for a cell's zeros, and the photo as these pixels' source. Back: whether there
/// was one.
bool takeUnseen(const float* seen, std::ptrdiff_t pitch, std::uint8_t photo, float* values,
                std::uint8_t* sources);

/// How coordinates become places in a photo's plane, for one part of each pixel.
struct PartPlacing {
    std::int32_t addU;
    std::int32_t addV;
    std::int32_t first; ///< least coordinate; what is less in u goes on at the other side
    std::int32_t turn;
    std::int32_t lastV;
    std::int32_t rowBytes;
};

/// Places and fractions, as LatticeScratch::places(), of rows of sixteen pixels, each of which is written
/// `apart` rows after the one before.
void placeRows(const PartPlacing& placing, const std::int32_t* u, const std::int32_t* v, int rows, int apart,
               std::int32_t* places, std::int32_t* fractions);

/// Takes coordinates of a cell's pixels where these are taken from that photo. sources: of 16 rows.
void takeOwn(const std::int32_t* ownU, const std::int32_t* ownV, const std::uint8_t* sources,
             std::ptrdiff_t pitch, std::uint8_t photo, std::int32_t* u, std::int32_t* v);

/// Least and greatest coordinates of the pixels of a cell: u, u, v, v.
std::array<std::int32_t, 4> boxOfCell(const std::int32_t* u, const std::int32_t* v);

/// Of those that are taken from that photo; the greatest are 0 if there is none.
std::array<std::int32_t, 4> boxOfCell(const std::int32_t* u, const std::int32_t* v,
                                      const std::uint8_t* sources, std::ptrdiff_t pitch, std::uint8_t photo);

} // namespace spherewalk::render::simd
