// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/align/features.h"

#include <Eigen/Geometry>

#include <optional>
#include <utility>
#include <vector>

namespace spherewalk::align {

/// Which descriptors are compared.
struct Search {
    int most = 1 << 30; ///< Only so many first features of each photo.
    double mostRatio = 0.8;
    std::optional<Eigen::Quaterniond> aFromB; ///< If given, only bearings within reach after it count.
    double reachRad = 0;
};

/// Pairs (feature of a, feature of b) of things that are each other's nearest, and nearer than both second
/// nearest things by the ratio; in the order of a's things.
std::vector<std::pair<int, int>> mutualNearest(const Features& a, const Features& b, const Search& search);

} // namespace spherewalk::align
