// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/compare/steadiness.h"

#include "spherewalk/base/statistics.h"

#include <map>
#include <utility>
#include <vector>

namespace spherewalk::compare {

namespace {

constexpr std::size_t kFewestThings = 12;

/// Where each feature of one picture is in another, by its place.
using Places = std::map<std::pair<double, double>, Eigen::Vector2d>;

Places placesIn(const PictureFeatures& from, const PictureFeatures& to) {
    Places places;
    for (const PictureMatch& match : witnessedMatches(from, to)) {
        places.emplace(std::pair(match.inA.x(), match.inA.y()), match.inB);
    }
    return places;
}

} // namespace

Steadiness steadiness(const Frame& before, const Frame& after) {
    const Places viewBefore = placesIn(before.truth, before.view);
    const Places viewAfter = placesIn(after.truth, after.view);
    std::vector<double> changes;
    for (const PictureMatch& thing : witnessedMatches(before.truth, after.truth)) {
        const auto first = viewBefore.find({thing.inA.x(), thing.inA.y()});
        const auto second = viewAfter.find({thing.inB.x(), thing.inB.y()});
        if (first != viewBefore.end() && second != viewAfter.end()) {
            changes.push_back(((second->second - thing.inB) - (first->second - thing.inA)).norm());
        }
    }
    Steadiness result;
    result.things = changes.size();
    if (changes.size() >= kFewestThings) {
        result.medianPx = quantileInPlace(changes, 0.5);
        result.p95Px = quantileInPlace(changes, 0.95);
    }
    return result;
}

} // namespace spherewalk::compare
