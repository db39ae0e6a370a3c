// SPDX-License-Identifier: Apache-2.0
#include "sensor/effects.h"

#include <cmath>
#include <numbers>

namespace spherewalk::render {

namespace {

/// The share of a normal number's magnitudes that are below this one.
double shareBelow(double magnitude) {
    return std::erf(magnitude / std::numbers::sqrt2);
}

double shareDensity(double magnitude) {
    return std::sqrt(2 / std::numbers::pi) * std::exp(-0.5 * magnitude * magnitude);
}

} // namespace

NormalNoise::NormalNoise(std::uint64_t seed, std::uint64_t frame, std::uint64_t purpose)
    : m_key(mixed(seed + kGamma)) {
    static const Quantiles kQuantiles = makeQuantiles();
    m_key = mixed(m_key ^ mixed(frame + 2 * kGamma));
    m_key = mixed(m_key ^ mixed(purpose + 3 * kGamma));
    m_quantiles = &kQuantiles;
}

/// The quantiles by Newton's method. The last one is infinite; in its place stands the one that gives the
/// table the variance 1. Values are rounded to 2^-16, so that the last bit of the C library does not count.
NormalNoise::Quantiles NormalNoise::makeQuantiles() {
    constexpr double kRound = 65536;
    Quantiles quantiles{};
    double value = 0;
    double sum = 0; // of squares, over cells: (a^2 + a b + b^2) / 3 between a and b
    for (int cell = 0; cell + 1 < kCells; ++cell) {
        const double before = value;
        const double share = (cell + 1.0) / kCells;
        for (int step = 0; step < 8; ++step) {
            value += (share - shareBelow(value)) / shareDensity(value);
        }
        sum += (before * before + before * value + value * value) / 3;
        quantiles[static_cast<std::size_t>(cell) + 1] =
            static_cast<float>(static_cast<double>(std::lround(value * kRound)) / kRound);
    }
    const double missing = 3 * (kCells - sum); // a^2 + a b + b^2 of the last cell
    const double last = 0.5 * (std::sqrt(4 * missing - 3 * value * value) - value);
    quantiles.back() = static_cast<float>(static_cast<double>(std::lround(last * kRound)) / kRound);
    return quantiles;
}

} // namespace spherewalk::render
