// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/compare/picture_matches.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace spherewalk::jobs {

/// How far places are displaced, and how many were not found again. Units: hundredths of a pixel.
struct PlaceErrors {
    std::vector<int> found; ///< At most kMostHundredths each.
    std::size_t missed = 0;

    static constexpr int kMostHundredths = 10'000'000;

    std::size_t size() const { return found.size() + missed; }

    void add(const PlaceErrors& other);

    /// Of all places; 0 if there are none.
    double missedShare() const;
};

std::vector<int> hundredths(const std::vector<compare::Displacement>& displacements);
PlaceErrors placeErrors(const compare::PlaceDisplacements& places);

/// The quantile in pixels of displacements in hundredths of a pixel; nothing if there are none. Range: share
/// from 0 to 1.
std::optional<double> quantilePx(std::vector<int> hundredths, double share);

/// The same of all places, where a place that was missed is endlessly far off.
std::optional<double> quantilePx(const PlaceErrors& errors, double share);

} // namespace spherewalk::jobs
