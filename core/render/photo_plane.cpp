// SPDX-License-Identifier: Apache-2.0
#include "photo_plane.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <vector>

namespace spherewalk::render {

namespace {

std::int8_t lessHalf(int value) {
    return static_cast<std::int8_t>(value - 128);
}

} // namespace

bool PhotoPlane::fits(const EquirectSize& size) {
    return size.width == 2 * size.height && size.width >= 16 && size.width <= 16384;
}

PhotoPlane::PhotoPlane(const EquirectSize& size) : m_size(size) {
    if (!fits(size)) {
        throw Error(
            ErrorKind::InvalidInput,
            text("A photo of ", size.width, " x ", size.height,
                 " pixels cannot be sampled: it must be twice as wide as high, and 16 to 16384 wide."));
    }
    // Rows are an odd number of cache lines: they do not fall on the same few sets of the cache.
    constexpr int kStep = 64;
    m_stride = ((size.width + 2 * kGuard + kStep - 1) / kStep | 1) * kStep;
    m_values = AlignedBuffer<std::int8_t>(static_cast<std::size_t>(m_stride) * kPixelBytes *
                                              static_cast<std::size_t>(size.height + 2 * kGuard) +
                                          kSlackBytes);
}

PhotoPlane::PhotoPlane(const RgbImage& picture)
    : PhotoPlane(EquirectSize{picture.width(), picture.height()}) {
    for (int y = 0; y < picture.height(); ++y) {
        write(0, y, picture.row(y));
    }
}

void PhotoPlane::put(int x, int y, const std::uint8_t* rgb) {
    std::int8_t* pixel = m_values.data() + offset(x, y);
    for (int c = 0; c < 3; ++c) {
        pixel[c] = lessHalf(rgb[c]);
    }
}

/// Puts the pixel wherever the guard repeats pixel (x, y), and not at (x, y) itself.
void PhotoPlane::putGuard(int x, int y, const std::uint8_t* rgb) {
    const int width = m_size.width;
    const int height = m_size.height;
    const auto putWrapped = [&](int atX, int atY) {
        const int wrapped = atX % width;
        for (const int column : {wrapped - width, wrapped, wrapped + width}) {
            if (column >= -kGuard && column < width + kGuard && !(column == x && atY == y)) {
                put(column, atY, rgb);
            }
        }
    };
    putWrapped(x, y);
    if (y < kGuard) {
        putWrapped(x + width / 2, -1 - y);
    }
    if (y >= height - kGuard) {
        putWrapped(x + width / 2, 2 * height - 1 - y);
    }
}

void PhotoPlane::write(int x, int y, std::span<const std::uint8_t> rgb) {
    const int count = static_cast<int>(rgb.size() / 3);
    std::int8_t* to = m_values.data() + offset(x, y);
    for (std::size_t i = 0; i < rgb.size(); ++i) {
        to[i] = lessHalf(rgb[i]);
    }
    const bool nearPole = y < kGuard || y >= m_size.height - kGuard;
    for (int i = 0; i < count; ++i) {
        if (nearPole || x + i < kGuard || x + i >= m_size.width - kGuard) {
            putGuard(x + i, y, rgb.data() + 3 * i);
        } else {
            i = std::max(i, m_size.width - kGuard - x - 1); // only the row's ends are repeated
        }
    }
}

PhotoPlane PhotoPlane::halved() const {
    PhotoPlane half(EquirectSize{m_size.width / 2, m_size.height / 2});
    std::vector<std::uint8_t> row(static_cast<std::size_t>(3 * half.m_size.width));
    for (int y = 0; y < half.m_size.height; ++y) {
        const std::int8_t* upper = data() + offset(0, 2 * y);
        const std::int8_t* lower = data() + offset(0, 2 * y + 1);
        for (int x = 0; x < half.m_size.width; ++x) {
            for (int c = 0; c < 3; ++c) {
                const int i = 2 * x * kPixelBytes + c;
                const int sum = upper[i] + upper[i + kPixelBytes] + lower[i] + lower[i + kPixelBytes];
                row[static_cast<std::size_t>(3 * x + c)] = static_cast<std::uint8_t>((sum + 512 + 2) / 4);
            }
        }
        half.write(0, y, row);
    }
    return half;
}

} // namespace spherewalk::render
