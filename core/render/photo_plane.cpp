// SPDX-License-Identifier: Apache-2.0
#include "photo_plane.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>

namespace spherewalk::render {

namespace {

std::int8_t lessHalf(int value) {
    return static_cast<std::int8_t>(value - 128);
}

} // namespace

bool PlaneLayout::fits(const EquirectSize& size) {
    return size.width == 2 * size.height && size.width >= 16 && size.width <= 16384;
}

PlaneLayout::PlaneLayout(const EquirectSize& size) : m_size(size) {
    if (!fits(size)) {
        throw Error(
            ErrorKind::Unsupported,
            text("A photo of ", size.width, " x ", size.height,
                 " pixels cannot be sampled: it must be twice as wide as high, and 16 to 16384 wide."));
    }
    constexpr int kStep = 64;
    m_stride = ((size.width + 2 * kGuard + kStep - 1) / kStep | 1) * kStep;
}

std::size_t PlaneLayout::bytes() const {
    return static_cast<std::size_t>(m_stride) * kPixelBytes *
               static_cast<std::size_t>(m_size.height + 2 * kGuard) +
           kSlackBytes;
}

/// Puts the pixel wherever the guard repeats pixel (x, y), and not at (x, y) itself.
void PlaneLayout::putGuard(std::int8_t* plane, int x, int y, const std::uint8_t* rgb) const {
    const int width = m_size.width;
    const int height = m_size.height;
    const auto putWrapped = [&](int atX, int atY) {
        const int wrapped = atX % width;
        for (const int column : {wrapped - width, wrapped, wrapped + width}) {
            if (column >= -kGuard && column < width + kGuard && !(column == x && atY == y)) {
                std::transform(rgb, rgb + kPixelBytes, plane + offset(column, atY), lessHalf);
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

void PlaneLayout::write(std::int8_t* plane, int x, int y, std::span<const std::uint8_t> rgb) const {
    const int count = static_cast<int>(rgb.size() / kPixelBytes);
    std::transform(rgb.begin(), rgb.end(), plane + offset(x, y), lessHalf);
    const bool nearPole = y < kGuard || y >= m_size.height - kGuard;
    for (int i = 0; i < count; ++i) {
        if (nearPole || x + i < kGuard || x + i >= m_size.width - kGuard) {
            putGuard(plane, x + i, y, rgb.data() + kPixelBytes * i);
        } else {
            i = std::max(i, m_size.width - kGuard - x - 1); // only the row's ends are repeated
        }
    }
}

PhotoPlane::PhotoPlane(const EquirectSize& size) : m_layout(size), m_values(m_layout.bytes()) {
}

PhotoPlane::PhotoPlane(const RgbImage& picture)
    : PhotoPlane(EquirectSize{picture.width(), picture.height()}) {
    for (int y = 0; y < picture.height(); ++y) {
        write(0, y, picture.row(y));
    }
}

} // namespace spherewalk::render
