// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/measure/error_colour.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::measure {

namespace {

using Colour = std::array<double, 3>;

// Source: Brewer, RdYlBu: the ends and the middle.
constexpr Colour kWithin{49, 54, 149};
constexpr Colour kAtTolerance{255, 255, 191};
constexpr Colour kBeyond{165, 0, 38};

std::string hex(const Colour& colour) {
    constexpr const char* kDigits = "0123456789abcdef";
    std::string result = "#";
    for (const double part : colour) {
        const auto byte = static_cast<unsigned>(std::lround(part));
        result += kDigits[byte / 16];
        result += kDigits[byte % 16];
    }
    return result;
}

} // namespace

std::string errorColour(std::optional<double> errorPx, double tolerancePx) {
    if (!errorPx || !std::isfinite(*errorPx)) {
        return "#b0b0b0";
    }
    const double share = std::clamp(0.5 * std::log2(std::max(*errorPx, 1e-9) / tolerancePx), -1.0, 1.0);
    const Colour& end = share < 0 ? kWithin : kBeyond;
    Colour mixed{};
    for (std::size_t i = 0; i < mixed.size(); ++i) {
        mixed[i] = kAtTolerance[i] + std::abs(share) * (end[i] - kAtTolerance[i]);
    }
    return hex(mixed);
}

} // namespace spherewalk::measure
