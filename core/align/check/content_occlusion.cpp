// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/content_witness.h"

#include "spherewalk/geometry/rotation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace spherewalk::align {

namespace {

constexpr double kLeastAsideM = 0.03;
constexpr double kLeastViewerShare = 0.04; ///< Fewer sightings may be wrong matches.
constexpr Radians kWidestGap = Degrees(200);
constexpr double kNearer = 0.93;
constexpr double kLeastNearerWeight = 1.5;
constexpr Radians kBeside = Degrees(6);

/// The photos that see the missed things, each with the weight of the things that it sees.
std::map<int, double> viewersOf(const PhotoWitnesses& witnesses, const PhotoRegion& region) {
    std::map<int, double> weights;
    double sum = 0;
    for (const Witness& witness : witnesses.witnesses) {
        if (!witness.isSeen && isWithin(witness, region)) {
            for (const int viewer : witness.viewers) {
                weights[viewer] += witness.weight;
                sum += witness.weight;
            }
        }
    }
    std::erase_if(weights, [&](const auto& viewer) { return viewer.second < kLeastViewerShare * sum; });
    return weights;
}

} // namespace

bool isWithin(const Witness& witness, const PhotoRegion& region, double times) {
    return angleBetween(witness.expected, region.middle) < region.radius * times;
}

bool isSeenFromOneSide(const PhotoWitnesses& witnesses, const PhotoRegion& region, int photo,
                       const Sightings& sightings) {
    const Eigen::Vector3d left = region.middle.unitOrthogonal();
    const Eigen::Vector3d up = region.middle.cross(left);
    std::vector<double> angles;
    for (const auto& [viewer, weight] : viewersOf(witnesses, region)) {
        const Eigen::Vector3d position = sightings.positionInPhoto(photo, viewer);
        const Eigen::Vector2d aside(left.dot(position), up.dot(position));
        if (aside.norm() > kLeastAsideM) {
            angles.push_back(std::atan2(aside.y(), aside.x()));
        }
    }
    if (angles.empty()) {
        return true;
    }
    std::ranges::sort(angles);
    double widest = angles.front() + 2 * std::numbers::pi - angles.back();
    for (std::size_t i = 1; i < angles.size(); ++i) {
        widest = std::max(widest, angles[i] - angles[i - 1]);
    }
    return widest > kWidestGap.value();
}

bool hasNearerThings(const PhotoWitnesses& witnesses, const PhotoRegion& region) {
    std::vector<double> missedM;
    for (const Witness& witness : witnesses.witnesses) {
        if (!witness.isSeen && isWithin(witness, region)) {
            missedM.push_back(witness.rangeM);
        }
    }
    if (missedM.empty()) {
        return false;
    }
    const auto middle = missedM.begin() + static_cast<std::ptrdiff_t>(missedM.size() / 2);
    std::ranges::nth_element(missedM, middle);
    double nearer = 0;
    for (const Witness& witness : witnesses.witnesses) {
        nearer += witness.isSeen && witness.rangeM < kNearer * *middle &&
                          angleBetween(witness.expected, region.middle) < region.radius + kBeside
                      ? witness.weight
                      : 0;
    }
    return nearer > kLeastNearerWeight;
}

} // namespace spherewalk::align
