// SPDX-License-Identifier: Apache-2.0
#include "tile_plane.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <sys/mman.h>
#include <unistd.h>

namespace spherewalk::render {

namespace {

std::size_t oddLines(std::size_t bytes) {
    constexpr std::size_t kLine = 64;
    return ((bytes + kLine - 1) / kLine | 1) * kLine;
}

} // namespace

SparsePlane::SparsePlane(int width, int height)
    : m_pageBytes(static_cast<std::size_t>(::sysconf(_SC_PAGESIZE))),
      m_stride(oddLines(static_cast<std::size_t>(width + kApron) * 4)),
      m_size((m_stride * static_cast<std::size_t>(height) + m_pageBytes - 1) / m_pageBytes * m_pageBytes),
      m_holders(m_size / m_pageBytes) {
    void* memory =
        ::mmap(nullptr, m_size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (memory == MAP_FAILED) {
        throw Error(ErrorKind::Full, text("Could not make room for a photo of ", width, " x ", height,
                                          " pixels; close other programs or lower the cache's budget."));
    }
    // A huge page would hold two megabytes for the sake of one tile.
    ::madvise(memory, m_size, MADV_NOHUGEPAGE);
    m_pixels = static_cast<std::uint8_t*>(memory);
}

SparsePlane::~SparsePlane() {
    ::munmap(m_pixels, m_size);
}

template <class Visit>
void SparsePlane::forEachPage(const jpeg::PixelRect& pixels, Visit&& visit) const {
    for (int y = pixels.y; y < pixels.y + pixels.height; ++y) {
        const auto begin = static_cast<std::size_t>(at(pixels.x, y) - m_pixels);
        const std::size_t last = (begin + static_cast<std::size_t>(pixels.width) * 4 - 1) / m_pageBytes;
        for (std::size_t page = begin / m_pageBytes; page <= last; ++page) {
            visit(page);
        }
    }
}

void SparsePlane::occupy(const jpeg::PixelRect& pixels) {
    forEachPage(pixels, [&](std::size_t page) { m_held += m_holders[page]++ == 0 ? 1 : 0; });
}

void SparsePlane::vacate(std::span<const jpeg::PixelRect> pixels) {
    std::vector<std::size_t> free;
    for (const jpeg::PixelRect& rectangle : pixels) {
        forEachPage(rectangle, [&](std::size_t page) {
            if (--m_holders[page] == 0) {
                free.push_back(page);
            }
        });
    }
    m_held -= free.size();
    std::sort(free.begin(), free.end());
    // Neighbouring pages go back in one call.
    for (std::size_t i = 0; i < free.size();) {
        std::size_t end = i + 1;
        while (end < free.size() && free[end] == free[end - 1] + 1) {
            ++end;
        }
        release(free[i], free[end - 1] + 1);
        i = end;
    }
}

void SparsePlane::release(std::size_t firstPage, std::size_t endPage) {
    if (::madvise(m_pixels + firstPage * m_pageBytes, (endPage - firstPage) * m_pageBytes, MADV_DONTNEED) !=
        0) {
        throw Error(ErrorKind::Internal, "The system did not take back the memory of decoded tiles.");
    }
}

} // namespace spherewalk::render
