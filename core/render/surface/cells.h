// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "pixels/fixed_point.h"

#include "spherewalk/base/image.h"
#include "spherewalk/base/parallel.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace spherewalk::render {

/// A surface as a camera sees it: 1 / s of each pixel. The seen point is s times the pixel's ray. Without
/// distortion the ray is (x, y, 1), so that s is the depth along the axis; through a lens it is a unit
/// vector. The value is 0 where no surface is seen. The buffer has whole cells; pixels beyond the view are 1
/// once something was drawn.
using InverseBuffer = Image<float, 1>;

/// Gives the buffer the size of a view. It is not cleared.
void fit(InverseBuffer& buffer, int width, int height);

/// The parts of a view with pixels that nothing covers yet. Threads: const functions may run on any number at
/// a time.
class OpenCells {
  public:
    static constexpr int kSubCell = 4; ///< Pixels along an axis of a cell's sub-cells: holes are thin.

    /// All cells are open.
    OpenCells(int width, int height);

    /// Closes the sub-cells without a 0. Returns how many pixels are 0.
    int update(const InverseBuffer& covered, WorkerPool& pool, int threads);

    bool any() const { return m_sums.back() > 0; }

    bool isAllOpen() const { return m_sums.back() == m_width * m_height * kSubCell * kSubCell; }

    bool isOpen(int column, int row) const {
        return m_cells[static_cast<std::size_t>(row * (m_width / kSubCells) + column)] > 0;
    }

    /// Makes the open cells of a row zero. The others are not read.
    void clear(int row, InverseBuffer& buffer) const;

    /// Whether an open sub-cell meets this part of the view. Units: pixels. Range: any.
    bool anyIn(float left, float top, float right, float bottom) const;

    /// The same for whole pixels of the view, the last ones included.
    bool anyIn(int left, int top, int right, int bottom) const {
        return sum(left / kSubCell, top / kSubCell, right / kSubCell + 1, bottom / kSubCell + 1) > 0;
    }

  private:
    static constexpr int kSubCells = kCell / kSubCell;

    int sum(int column, int row, int endColumn, int endRow) const {
        const auto at = [&](int x, int y) { return m_sums[static_cast<std::size_t>(y * (m_width + 1) + x)]; };
        return at(endColumn, endRow) - at(endColumn, row) - at(column, endRow) + at(column, row);
    }

    int m_width; ///< Sub-cells.
    int m_height;
    std::vector<int> m_sums;  ///< Open pixels above and to the left, with a row and a column of zeros.
    std::vector<int> m_cells; ///< Open pixels of each cell.
};

} // namespace spherewalk::render

/// Operations on the cells of a view from surfaces. They give the same bytes on every processor. pitch:
/// values from one row to the next.
namespace spherewalk::render::simd {

/// The least and the greatest value of a cell.
std::array<float, 2> range(const float* values, std::ptrdiff_t pitch);

/// The number of zeros in a cell. ofSubCells: it gets the numbers of the 4 x 4 sub-cells, row after row.
int zeros(const float* values, std::ptrdiff_t pitch, std::array<std::int32_t, 16>& ofSubCells);

/// Takes the values of `seen` where the cell has zeros, and sets these pixels' source to the photo. Returns
/// whether any pixel was taken.
bool takeUnseen(const float* seen, std::ptrdiff_t pitch, std::uint8_t photo, float* values,
                std::uint8_t* sources);

/// What became of a cell in which two photos are mixed.
struct Mixture {
    int open = 0;           ///< The number of pixels that the first photo does not see.
    bool hasOthers = false; ///< Some pixel is seen by the second photo alone.
    bool isMixed = false;   ///< Some pixel has a share of the second photo.
};

/// Mixes the 1 / s of a cell that two photos see. second: what the second photo sees. perFirst: its weight,
/// if the first photo's is 1. values: what the first photo sees; it gets the mixture. sources: they become 1
/// where the second photo alone sees something. shares: they get the second photo's share of each pixel that
/// both see, in 255 parts.
Mixture mixDistances(const float* second, std::ptrdiff_t pitch, float perFirst, float* values,
                     std::uint8_t* sources, std::uint8_t* shares);

/// How coordinates become places in a photo's plane, for one sample of each pixel.
struct SamplePlacing {
    std::int32_t addU;
    std::int32_t addV;
    std::int32_t first; ///< The least coordinate. A lesser u goes on at the other side of the photo.
    std::int32_t turn;
    std::int32_t lastV;
    std::int32_t rowBytes;
};

/// Computes places and fractions, as LatticeRow::places() has them, of rows of sixteen pixels. apart: each
/// row is written so many rows after the one before.
void placeRows(const SamplePlacing& placing, const std::int32_t* u, const std::int32_t* v, int rows,
               int apart, std::int32_t* places, std::int32_t* fractions);

/// How coordinates in a photo become places in a mask of the photo that may have another size.
struct MaskPlacing {
    float first; ///< The coordinate of the photo's left and upper edge.
    float scale; ///< Pixels of the mask in a unit of fixed point.
    std::int32_t width;
    std::int32_t height;
};

/// Computes the numbers of the nearest pixels in the mask, row after row, of the pixels of a cell.
void placeInMask(const MaskPlacing& placing, const std::int32_t* u, const std::int32_t* v,
                 std::int32_t* places);

/// Weighs the colours of a cell's pixels. own, other: the colour weights of the photo of each pixel and of
/// the second photo. Range: at least 1. shares: those of the second photo in 255 parts; they are weighted.
void weighShares(const std::uint8_t* own, const std::uint8_t* other, std::uint8_t* shares);

/// Takes coordinates of a cell's pixels where the pixels come from that photo. sources: 16 rows.
void takeOwn(const std::int32_t* ownU, const std::int32_t* ownV, const std::uint8_t* sources,
             std::ptrdiff_t pitch, std::uint8_t photo, std::int32_t* u, std::int32_t* v);

/// The bounds of the coordinates of a cell's pixels: least u, greatest u, least v, greatest v.
std::array<std::int32_t, 4> boxOfCell(const std::int32_t* u, const std::int32_t* v);

/// The same for the pixels that come from that photo. The greatest are 0 if there is none.
std::array<std::int32_t, 4> boxOfCell(const std::int32_t* u, const std::int32_t* v,
                                      const std::uint8_t* sources, std::ptrdiff_t pitch, std::uint8_t photo);

} // namespace spherewalk::render::simd
