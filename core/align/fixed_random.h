// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace spherewalk::align {

/// Numbers that look random and are the same on every machine, unlike those of the standard distributions.
/// Source: SplitMix64 (Steele, Lea, Flood 2014).
class FixedRandom {
  public:
    explicit FixedRandom(std::uint64_t seed) : m_state(seed) {}

    std::uint64_t next() {
        m_state += 0x9E3779B97F4A7C15ULL;
        std::uint64_t z = m_state;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
        return z ^ (z >> 31);
    }

    /// In [0, 1).
    double uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }

    /// In [0, count). Range: count > 0.
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(next() % count); }

    /// Near enough a standard normal number: the sum of twelve uniform ones.
    double normal() {
        double sum = -6;
        for (int i = 0; i < 12; ++i) {
            sum += uniform();
        }
        return sum;
    }

    /// 0 ... count - 1 in mixed order.
    std::vector<int> permutation(int count) {
        std::vector<int> order(static_cast<std::size_t>(count));
        std::iota(order.begin(), order.end(), 0);
        for (std::size_t i = order.size(); i > 1; --i) {
            std::swap(order[i - 1], order[below(i)]);
        }
        return order;
    }

  private:
    std::uint64_t m_state;
};

} // namespace spherewalk::align
