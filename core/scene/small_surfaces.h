// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plane_filters.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace spherewalk::scene {

/// Surfaces by themselves: pixels that are joined, one of four beside each other.
class Surfaces {
  public:
    explicit Surfaces(const Plane& inverseM) : m_inverseM(inverseM), m_isSeen(inverseM.values().size()) {}

    /// Calls visit(pixels) for each surface.
    template <class Visit>
    void forEach(const Visit& visit) {
        for (std::size_t i = 0; i < m_isSeen.size(); ++i) {
            if (m_isSeen[i] == 0) {
                grow(i);
                visit(m_pixels);
            }
        }
    }

  private:
    void grow(std::size_t first) {
        m_pixels.assign(1, first);
        m_isSeen[first] = 1;
        const int width = m_inverseM.width();
        for (std::size_t next = 0; next < m_pixels.size();) {
            const std::size_t from = m_pixels[next++]; // join() adds pixels
            const int x = static_cast<int>(from) % width;
            const int y = static_cast<int>(from) / width;
            join(from, (x + 1) % width, y);
            join(from, (x + width - 1) % width, y);
            join(from, x, std::min(y + 1, m_inverseM.height() - 1));
            join(from, x, std::max(y - 1, 0));
        }
    }

    void join(std::size_t from, int x, int y) {
        const auto to = static_cast<std::size_t>(y) * static_cast<std::size_t>(m_inverseM.width()) +
                        static_cast<std::size_t>(x);
        const float a = m_inverseM.values()[from];
        const float b = m_inverseM.values()[to];
        if (m_isSeen[to] == 0 && std::fabs(a - b) < kTorn * std::max(a, b)) {
            m_isSeen[to] = 1;
            m_pixels.push_back(to);
        }
    }

    const Plane& m_inverseM;
    std::vector<std::uint8_t> m_isSeen;
    std::vector<std::size_t> m_pixels;
};

/// Calls visit(pixels) for each surface that is too small to stand by itself.
template <class Visit>
void forEachSpeck(const Plane& inverseM, const Visit& visit) {
    constexpr int kFewestTogether = 12; ///< Pixels of a surface, in a depth of the usual width.
    const double scale = inverseM.width() / double{kUsualWidth};
    const double fewest = std::max(2.0, kFewestTogether * scale * scale);
    Surfaces(inverseM).forEach([&](const std::vector<std::size_t>& pixels) {
        if (static_cast<double>(pixels.size()) < fewest) {
            visit(pixels);
        }
    });
}

} // namespace spherewalk::scene
