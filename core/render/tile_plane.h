// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "photo_plane.h"

#include "spherewalk/jpeg/region.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace spherewalk::render {

/// Address space for all of a photo, of which only the parts in use take memory. A sampler reads it like a
/// whole picture: no tile arithmetic, no copy. (The way considered besides, tiles apart from each other,
/// would have the sampler find a tile for every pixel and join neighbours at every tile's edge; it was not
/// built.)
///
/// Memory is counted and given back in units of about a photo's row, and a unit is held while any part in it
/// is occupied. Threads: the owner's business; writers of different pixels may run at a time.
class SparsePlane {
  public:
    /// Takes address space only. Errors: Unsupported for a size that does not fit; Full, if the system gives
    /// none.
    explicit SparsePlane(const EquirectSize& size);
    ~SparsePlane();
    SparsePlane(const SparsePlane&) = delete;
    SparsePlane& operator=(const SparsePlane&) = delete;

    /// Pixels that are not occupied are anything.
    PlaneView view() const { return {m_layout, m_values}; }

    /// As PlaneLayout::write(). Range: pixels of occupied rectangles.
    void write(int x, int y, std::span<const std::uint8_t> rgb) { m_layout.write(m_values, x, y, rgb); }

    /// Bytes of the units that are held.
    std::uint64_t residentBytes() const { return m_held * m_unitBytes; }

    /// Holds the units of the rectangle's pixels and of what the guard repeats of them.
    void occupy(const jpeg::PixelRect& pixels);

    /// Lets go of rectangles that were occupied; units that no other holds go back to the system.
    void vacate(std::span<const jpeg::PixelRect> pixels);

  private:
    template <class Visit>
    void forEachUnit(const jpeg::PixelRect& pixels, Visit&& visit) const;
    void release(std::size_t first, std::size_t end);

    PlaneLayout m_layout;
    std::size_t m_unitBytes = 0;
    void* m_mapped = nullptr;
    std::size_t m_mappedBytes = 0;
    std::int8_t* m_values = nullptr;
    std::vector<std::uint32_t> m_holders; ///< of each unit
    std::size_t m_held = 0;
};

} // namespace spherewalk::render
