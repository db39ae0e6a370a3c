// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "pixels/aligned_buffer.h"

#include "spherewalk/base/image.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/jpeg/region.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace spherewalk::render {

/// How an equirectangular picture lies in memory for sampling. A pixel has three bytes: red, green, blue.
/// Each value less 128 is a signed byte, so that one instruction multiplies it by an unsigned weight. A guard
/// of kGuard pixels on every side repeats what the sphere shows there: across the seam the picture goes on,
/// and across a pole it goes on half way round. Two neighbours are one load of eight bytes, and no sample
/// needs a branch. Rows are an odd number of cache lines apart, so that they do not fall on the same few sets
/// of the cache.
class PlaneLayout {
  public:
    static constexpr int kGuard = 2;
    static constexpr int kPixelBytes = 3;
    static constexpr int kSlackBytes = 64; ///< So many bytes beyond the last pixel may be read.

    /// Whether this size can be a plane: twice as wide as high, 16 to 16384 wide (offsets fit in 32 bits).
    static bool fits(const EquirectSize& size);

    PlaneLayout() = default;

    /// Errors: Unsupported for a size that does not fit.
    explicit PlaneLayout(const EquirectSize& size);

    const EquirectSize& size() const { return m_size; }

    /// Pixels from one row to the next.
    int stride() const { return m_stride; }

    std::size_t bytes() const;

    /// The offset of pixel (x, y) in bytes. Range: -kGuard <= x < width + kGuard, and y likewise.
    std::size_t offset(int x, int y) const {
        return (static_cast<std::size_t>(y + kGuard) * static_cast<std::size_t>(m_stride) +
                static_cast<std::size_t>(x + kGuard)) *
               kPixelBytes;
    }

    /// Writes pixels (red, green, blue, red ...) at (x, y) and wherever the guard repeats them. Range: all
    /// lie in the picture. Threads: several may write different pixels at a time.
    void write(std::int8_t* plane, int x, int y, std::span<const std::uint8_t> rgb) const;

  private:
    void putGuard(std::int8_t* plane, int x, int y, const std::uint8_t* rgb) const;

    EquirectSize m_size;
    int m_stride = 0;
};

/// A picture in that layout. Owner: the memory belongs to another object. Threads: const functions may run on
/// any number at a time.
class PlaneView {
  public:
    PlaneView(const PlaneLayout& layout, const std::int8_t* data) : m_layout(layout), m_data(data) {}

    const EquirectSize& size() const { return m_layout.size(); }

    int stride() const { return m_layout.stride(); }

    /// The memory of pixel (-kGuard, -kGuard).
    const std::int8_t* data() const { return m_data; }

    /// The stored value of channel c of pixel (x, y): less 128. Range: -kGuard <= x < width + kGuard, and y
    /// likewise.
    std::int8_t stored(int x, int y, int c) const {
        return m_data[m_layout.offset(x, y) + static_cast<std::size_t>(c)];
    }

  private:
    PlaneLayout m_layout;
    const std::int8_t* m_data;
};

/// A whole picture in that layout, with its memory.
class PhotoPlane {
  public:
    /// A grey picture. Errors: Unsupported for a size that does not fit.
    explicit PhotoPlane(const EquirectSize& size);

    /// Errors: Unsupported for a size that does not fit.
    explicit PhotoPlane(const RgbImage& picture);

    void write(int x, int y, std::span<const std::uint8_t> rgb) {
        m_layout.write(m_values.data(), x, y, rgb);
    }

    /// Valid while the plane lives.
    PlaneView view() const { return {m_layout, m_values.data()}; }

  private:
    PlaneLayout m_layout;
    AlignedBuffer<std::int8_t> m_values;
};

/// Address space for all of a photo, of which only the parts in use take memory. A sampler reads it like a
/// whole picture, without tile arithmetic and without a copy. (If tiles lay apart, the sampler would have to
/// find a tile for every pixel and to join neighbours at tiles' edges.)
///
/// Memory is counted and given back in units of about a photo's row. A unit is held while any part of it is
/// occupied. Threads: the owner guards it; several may write different pixels at a time.
class SparsePlane {
  public:
    /// Takes address space only. Errors: Unsupported for a size that does not fit; Full if the system gives
    /// none.
    explicit SparsePlane(const EquirectSize& size);
    ~SparsePlane();
    SparsePlane(const SparsePlane&) = delete;
    SparsePlane& operator=(const SparsePlane&) = delete;

    /// The picture. Pixels that are not occupied may have any values.
    PlaneView view() const { return {m_layout, m_values}; }

    /// Writes as PlaneLayout::write(). Range: pixels of occupied rectangles.
    void write(int x, int y, std::span<const std::uint8_t> rgb) { m_layout.write(m_values, x, y, rgb); }

    /// The size of the units that are held.
    std::uint64_t residentBytes() const { return m_held * m_unitBytes; }

    /// Holds the units of the rectangle's pixels and of the guard that repeats them.
    void occupy(const jpeg::PixelRect& pixels);

    /// Lets go of rectangles that were occupied. Units that no other rectangle holds go back to the system.
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
    std::vector<std::uint32_t> m_holders; ///< How many rectangles hold each unit.
    std::size_t m_held = 0;
};

} // namespace spherewalk::render
