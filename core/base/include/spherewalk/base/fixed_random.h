// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

namespace spherewalk {

/// Random numbers that the seed decides and that are the same on every machine. The distributions of <random>
/// differ between standard libraries; these do not, except for the last bit of normal().
/// Threads: each thread needs its own object.
/// Source: SplitMix64 (Steele, Lea, Flood: Fast splittable pseudorandom number generators, 2014).
class FixedRandom {
  public:
    explicit FixedRandom(std::uint64_t seed) : m_state(seed) {}

    /// One of many independent sequences of the same seed.
    FixedRandom(std::uint64_t seed, std::uint64_t stream) : m_state(seed) {
        m_state = next() ^ (stream * 0xD1342543DE82EF95ULL);
        next();
    }

    /// 64 random bits.
    std::uint64_t next() {
        m_state += 0x9E3779B97F4A7C15ULL;
        std::uint64_t z = m_state;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
        return z ^ (z >> 31);
    }

    /// A number in [0, 1).
    double uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }

    /// A number in [least, greatest).
    double uniform(double least, double greatest) { return least + (greatest - least) * uniform(); }

    /// An index in [0, count). Range: count > 0.
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(next() % count); }

    /// A normal number with mean 0. Source: Box and Muller, 1958.
    double normal(double sigma = 1) {
        const double radius = std::sqrt(-2 * std::log(uniform(0x1p-53, 1)));
        return sigma * radius * std::cos(2 * std::numbers::pi * uniform());
    }

    /// Nearly a standard normal number: the sum of twelve uniform numbers, less 6. It lies in [-6, 6], and
    /// its bits are the same with every mathematical library.
    double sumNormal() {
        double sum = -6;
        for (int i = 0; i < 12; ++i) {
            sum += uniform();
        }
        return sum;
    }

    /// The numbers 0 ... count - 1 in random order. Range: count >= 0.
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

} // namespace spherewalk
