// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "aligned_buffer.h"

#include "spherewalk/base/image.h"
#include "spherewalk/geometry/equirect.h"

#include <cstdint>
#include <span>

namespace spherewalk::render {

/// An equirectangular picture laid out for sampling: four bytes a pixel (red, green, blue, unused), each
/// value less 128 as a signed byte (so that one instruction multiplies it by an unsigned weight), and kGuard
/// pixels more on every side that repeat what the sphere shows there: across the seam the picture goes on,
/// across a pole it goes on half way round. Two neighbours are one load of eight bytes, and no sample needs a
/// branch. Threads: const, any number; writers to different rows may run at a time if none writes the first
/// or last kGuard rows.
class PhotoPlane {
  public:
    static constexpr int kGuard = 2;
    static constexpr int kPixelBytes = 3;
    static constexpr int kSlackBytes = 64;

    /// Whether this size can be a plane: twice as wide as high, 16 to 16384 wide (offsets fit in 32 bits).
    static bool fits(const EquirectSize& size);

    PhotoPlane() = default;

    /// All mid-grey. Errors: InvalidInput for a size that does not fit.
    explicit PhotoPlane(const EquirectSize& size);

    /// Errors: InvalidInput for a size that does not fit.
    explicit PhotoPlane(const RgbImage& picture);

    const EquirectSize& size() const { return m_size; }

    std::uint64_t bytes() const { return m_values.size(); }

    /// Puts pixels (red, green, blue, red ...) at (x, y), and wherever the guard repeats them. Range: all
    /// inside of the picture.
    void write(int x, int y, std::span<const std::uint8_t> rgb);

    bool canBeHalved() const { return m_size.height % 2 == 0 && fits({m_size.width / 2, m_size.height / 2}); }

    /// The 2x2 box averages, rounded: half as wide and high. Range: canBeHalved().
    PhotoPlane halved() const;

    /// Value of pixel (x, y), channel c, as stored. Range: -kGuard <= x < width + kGuard, and y likewise.
    std::int8_t stored(int x, int y, int c) const {
        return data()[offset(x, y) + static_cast<std::size_t>(c)];
    }

    /// Pixel (-kGuard, -kGuard); kSlackBytes beyond the last pixel may be read.
    const std::int8_t* data() const { return m_values.data(); }

    /// Pixels from one row to the next.
    int stride() const { return m_stride; }

  private:
    std::size_t offset(int x, int y) const {
        return (static_cast<std::size_t>(y + kGuard) * static_cast<std::size_t>(m_stride) +
                static_cast<std::size_t>(x + kGuard)) *
               kPixelBytes;
    }

    void put(int x, int y, const std::uint8_t* rgb);
    void putGuard(int x, int y, const std::uint8_t* rgb);

    EquirectSize m_size;
    int m_stride = 0;
    AlignedBuffer<std::int8_t> m_values;
};

} // namespace spherewalk::render
