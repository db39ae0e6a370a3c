// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace spherewalk::practice {

/// Random numbers that are the same everywhere, unlike those of <random>'s distributions. Source: Steele,
/// Lea, Flood: Fast splittable pseudorandom number generators (SplitMix64); normal numbers by Box and Muller.
class Prng {
  public:
    /// A stream of its own for each pair.
    Prng(std::uint64_t seed, std::uint64_t stream) : m_state(seed) {
        m_state = next() ^ (stream * 0xd1342543de82ef95ULL);
        next();
    }

    std::uint64_t next() {
        std::uint64_t z = m_state += 0x9e3779b97f4a7c15ULL;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
        return z ^ (z >> 31);
    }

    /// In [least, greatest).
    double uniform(double least, double greatest) {
        return least + (greatest - least) * (static_cast<double>(next() >> 11) * 0x1p-53);
    }

    double normal(double sigma) {
        const double radius = std::sqrt(-2 * std::log(uniform(0x1p-53, 1)));
        return sigma * radius * std::cos(2 * std::numbers::pi * uniform(0, 1));
    }

  private:
    std::uint64_t m_state;
};

} // namespace spherewalk::practice
