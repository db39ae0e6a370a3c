// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/align/match.h"

#include "nearest.h"
#include "option_check.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <cmath>

namespace spherewalk::align {

namespace {} // namespace

void MatchOptions::validate() const {
    require(mostRatio > 0 && mostRatio <= 1, "matching's", "mostRatio", "above 0 and at most 1");
    require(reach >= Radians(Degrees(1)) && reach <= Radians(Degrees(180)), "matching's", "reach",
            "from 1 to 180 degrees");
    require(firstLook >= 50 && firstLook <= 50000, "matching's", "firstLook", "from 50 to 50000");
    require(leastVotes >= 3, "matching's", "leastVotes", "3 or more");
}

std::vector<Correspondence> matchFeatures(const Features& a, const Features& b, const MatchOptions& options,
                                          const std::optional<Eigen::Quaterniond>& guess) {
    options.validate();
    if (a.count() == 0 || b.count() == 0) {
        return {};
    }
    if (a.detector != b.detector || a.descriptorBytes != b.descriptorBytes) {
        throw Error(ErrorKind::InvalidInput,
                    "Could not match two photos: their features are of different kinds; find them alike.");
    }
    Search search;
    search.mostRatio = options.mostRatio;
    search.reachRad = options.reach.value();
    search.aFromB = guess;
    if (!guess && options.isGuided) {
        if (const auto rotation = coarseRotation(a, b, options)) {
            search.aFromB = rotation->aFromB;
        }
    }
    std::vector<Correspondence> matches;
    for (const auto& [i, j] : mutualNearest(a, b, search)) {
        const auto inA = static_cast<std::size_t>(i);
        const auto inB = static_cast<std::size_t>(j);
        const double sigmaRad =
            std::hypot(static_cast<double>(a.sigmasRad[inA]), static_cast<double>(b.sigmasRad[inB])) /
            std::sqrt(2.0);
        matches.push_back({a.bearings[inA].cast<double>().normalized(),
                           b.bearings[inB].cast<double>().normalized(), sigmaRad, i, j});
    }
    return matches;
}

} // namespace spherewalk::align
