// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "aligned_buffer.h"

#include "spherewalk/base/image.h"
#include "spherewalk/geometry/equirect.h"

#include <cstdint>
#include <span>

namespace spherewalk::render {

/// How an equirectangular picture lies in memory for sampling: three bytes a pixel (red, green, blue), each
/// value less 128 as a signed byte (so that one instruction multiplies it by an unsigned weight), and kGuard
/// pixels more on every side that repeat what the sphere shows there: across the seam the picture goes on,
/// across a pole it goes on half way round. Two neighbours are one load of eight bytes, and no sample needs a
/// branch. Rows are an odd number of cache lines apart: they do not fall on the same few sets of the cache.
class PlaneLayout {
  public:
    static constexpr int kGuard = 2;
    static constexpr int kPixelBytes = 3;
    static constexpr int kSlackBytes = 64; ///< that may be read beyond the last pixel

    /// Whether this size can be a plane: twice as wide as high, 16 to 16384 wide (offsets fit in 32 bits).
    static bool fits(const EquirectSize& size);

    PlaneLayout() = default;

    /// Errors: Unsupported for a size that does not fit.
    explicit PlaneLayout(const EquirectSize& size);

    const EquirectSize& size() const { return m_size; }

    /// Pixels from one row to the next.
    int stride() const { return m_stride; }

    std::size_t bytes() const;

    /// Of pixel (x, y), in bytes. Range: -kGuard <= x < width + kGuard, and y likewise.
    std::size_t offset(int x, int y) const {
        return (static_cast<std::size_t>(y + kGuard) * static_cast<std::size_t>(m_stride) +
                static_cast<std::size_t>(x + kGuard)) *
               kPixelBytes;
    }

    /// Puts pixels (red, green, blue, red ...) at (x, y), and wherever the guard repeats them. Range: all
    /// inside of the picture. Threads: any that write different pixels.
    void write(std::int8_t* plane, int x, int y, std::span<const std::uint8_t> rgb) const;

  private:
    void putGuard(std::int8_t* plane, int x, int y, const std::uint8_t* rgb) const;

    EquirectSize m_size;
    int m_stride = 0;
};

/// A picture in that layout, somebody else's. Threads: const, any number.
class PlaneView {
  public:
    PlaneView(const PlaneLayout& layout, const std::int8_t* data) : m_layout(layout), m_data(data) {}

    const EquirectSize& size() const { return m_layout.size(); }

    int stride() const { return m_layout.stride(); }

    /// Pixel (-kGuard, -kGuard).
    const std::int8_t* data() const { return m_data; }

    /// Value of pixel (x, y), channel c, as stored. Range: -kGuard <= x < width + kGuard, and y likewise.
    std::int8_t stored(int x, int y, int c) const {
        return m_data[m_layout.offset(x, y) + static_cast<std::size_t>(c)];
    }

  private:
    PlaneLayout m_layout;
    const std::int8_t* m_data;
};

/// A whole picture in that layout.
class PhotoPlane {
  public:
    /// All mid-grey. Errors: Unsupported for a size that does not fit.
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

} // namespace spherewalk::render
