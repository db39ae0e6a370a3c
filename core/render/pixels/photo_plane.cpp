// SPDX-License-Identifier: Apache-2.0
#include "pixels/photo_plane.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <sys/mman.h>
#include <unistd.h>

namespace spherewalk::render {

namespace {

/// About a row of a photo: rows of a view that leave give back one piece.
constexpr std::size_t kLeastUnit = std::size_t{16} << 10;

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

SparsePlane::SparsePlane(const EquirectSize& size) : m_layout(size) {
    const std::size_t bytes = m_layout.bytes();
    m_unitBytes = std::max(kLeastUnit, static_cast<std::size_t>(::sysconf(_SC_PAGESIZE)));
    const std::size_t units = (bytes + m_unitBytes - 1) / m_unitBytes;
    m_holders.resize(units);
    m_mappedBytes = (units + 1) * m_unitBytes; // one more, to begin at a multiple of the unit
    m_mapped = ::mmap(nullptr, m_mappedBytes, PROT_READ | PROT_WRITE,
                      MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (m_mapped == MAP_FAILED) {
        throw Error(ErrorKind::Full,
                    text("Could not make room for a photo of ", size.width, " x ", size.height,
                         " pixels; close other programs or lower the cache's budget."));
    }
    // A first view of a photo would wait for the system to find huge pages; a wish.
    ::madvise(m_mapped, m_mappedBytes, MADV_NOHUGEPAGE);
    const auto address = reinterpret_cast<std::uintptr_t>(m_mapped);
    const std::uintptr_t aligned = (address + m_unitBytes - 1) / m_unitBytes * m_unitBytes;
    m_values = static_cast<std::int8_t*>(m_mapped) + (aligned - address);
}

SparsePlane::~SparsePlane() {
    ::munmap(m_mapped, m_mappedBytes);
}

/// What the guard repeats of a rectangle lies within the rows of the rectangle and, next to a pole, in the
/// guard's rows, all along.
template <class Visit>
void SparsePlane::forEachUnit(const jpeg::PixelRect& pixels, Visit&& visit) const {
    constexpr int kGuard = PlaneLayout::kGuard;
    const int width = m_layout.size().width;
    const int height = m_layout.size().height;
    const auto visitRun = [&](int x, int endX, int y) {
        const std::size_t last = (m_layout.offset(endX - 1, y) + PlaneLayout::kPixelBytes - 1) / m_unitBytes;
        for (std::size_t unit = m_layout.offset(x, y) / m_unitBytes; unit <= last; ++unit) {
            visit(unit);
        }
    };
    for (int y = pixels.y; y < pixels.y + pixels.height; ++y) {
        visitRun(pixels.x, pixels.x + pixels.width, y);
        if (pixels.x < kGuard) {
            visitRun(width, width + kGuard, y);
        }
        if (pixels.x + pixels.width > width - kGuard) {
            visitRun(-kGuard, 0, y);
        }
    }
    for (int i = 1; i <= kGuard && pixels.y < kGuard; ++i) {
        visitRun(-kGuard, width + kGuard, -i);
    }
    for (int i = 0; i < kGuard && pixels.y + pixels.height > height - kGuard; ++i) {
        visitRun(-kGuard, width + kGuard, height + i);
    }
}

void SparsePlane::occupy(const jpeg::PixelRect& pixels) {
    forEachUnit(pixels, [&](std::size_t unit) { m_held += m_holders[unit]++ == 0 ? 1 : 0; });
}

void SparsePlane::vacate(std::span<const jpeg::PixelRect> pixels) {
    std::vector<std::size_t> free;
    for (const jpeg::PixelRect& rectangle : pixels) {
        forEachUnit(rectangle, [&](std::size_t unit) {
            if (--m_holders[unit] == 0) {
                free.push_back(unit);
            }
        });
    }
    m_held -= free.size();
    std::sort(free.begin(), free.end());
    // Neighbours go back in one call.
    for (std::size_t i = 0; i < free.size();) {
        std::size_t end = i + 1;
        while (end < free.size() && free[end] == free[end - 1] + 1) {
            ++end;
        }
        release(free[i], free[end - 1] + 1);
        i = end;
    }
}

void SparsePlane::release(std::size_t first, std::size_t end) {
    if (::madvise(m_values + first * m_unitBytes, (end - first) * m_unitBytes, MADV_DONTNEED) != 0) {
        throw Error(ErrorKind::Internal, "The system did not take back the memory of decoded tiles.");
    }
}

} // namespace spherewalk::render
