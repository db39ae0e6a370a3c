// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/jpeg/region.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace spherewalk::render {

/// Address space for all of a photo as RGBX pixels, of which only the parts in use take memory. A sampler
/// reads it like an ordinary picture: row pointers, no tile arithmetic, no copy. (The way considered besides,
/// tiles apart from each other, would have the sampler find a tile for every pixel and join neighbours at
/// every tile's edge; it was not built.) The price: a page is a thousand pixels of a row, so that a view
/// holds up to twice the memory of its own pixels. Memory is counted and given back by pages of the system: a
/// page is held while any part in it is occupied. Rows are an odd number of cache lines apart, so that a view
/// that runs down the photo's columns does not meet the same cache set again and again. Threads: the owner's
/// business.
class SparsePlane {
  public:
    /// Columns behind the right edge that repeat the left ones: what lies across the seam.
    static constexpr int kApron = 16;

    /// Takes address space only. Errors: Full, if the system gives none.
    SparsePlane(int width, int height);
    ~SparsePlane();
    SparsePlane(const SparsePlane&) = delete;
    SparsePlane& operator=(const SparsePlane&) = delete;

    std::size_t strideBytes() const { return m_stride; }

    std::uint8_t* at(int x, int y) const {
        return m_pixels + static_cast<std::size_t>(y) * m_stride + static_cast<std::size_t>(x) * 4;
    }

    /// Bytes of the pages that are held.
    std::uint64_t residentBytes() const { return m_held * m_pageBytes; }

    /// Holds the rectangle's pages; those not held before read as zero.
    void occupy(const jpeg::PixelRect& pixels);

    /// Lets go of rectangles that were occupied; pages that no other holds go back to the system.
    void vacate(std::span<const jpeg::PixelRect> pixels);

  private:
    template <class Visit>
    void forEachPage(const jpeg::PixelRect& pixels, Visit&& visit) const;
    void release(std::size_t firstPage, std::size_t endPage);

    std::size_t m_pageBytes;
    std::size_t m_stride;
    std::size_t m_size;
    std::uint8_t* m_pixels = nullptr;
    std::vector<std::uint16_t> m_holders; ///< of each page
    std::size_t m_held = 0;
};

} // namespace spherewalk::render
