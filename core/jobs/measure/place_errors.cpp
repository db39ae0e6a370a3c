// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/place_errors.h"

#include "spherewalk/base/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spherewalk::jobs {

void PlaceErrors::add(const PlaceErrors& other) {
    found.insert(found.end(), other.found.begin(), other.found.end());
    missed += other.missed;
}

double PlaceErrors::missedShare() const {
    return size() == 0 ? 0 : static_cast<double>(missed) / static_cast<double>(size());
}

std::vector<int> hundredths(const std::vector<compare::Displacement>& displacements) {
    std::vector<int> result;
    result.reserve(displacements.size());
    for (const compare::Displacement& displacement : displacements) {
        result.push_back(static_cast<int>(
            std::lround(std::min(100 * displacement.errorPx, double{PlaceErrors::kMostHundredths}))));
    }
    return result;
}

PlaceErrors placeErrors(const compare::PlaceDisplacements& places) {
    return {hundredths(places.found), places.missed};
}

std::optional<double> quantilePx(std::vector<int> hundredths, double share) {
    return quantilePx(PlaceErrors{std::move(hundredths), 0}, share);
}

std::optional<double> quantilePx(const PlaceErrors& errors, double share) {
    constexpr int kEndless = std::numeric_limits<int>::max();
    std::vector<int> all = errors.found;
    all.resize(errors.size(), kEndless);
    if (all.empty()) {
        return std::nullopt;
    }
    const int hundredths = quantileInPlace(all, share);
    return hundredths == kEndless ? HUGE_VAL : 0.01 * hundredths;
}

} // namespace spherewalk::jobs
