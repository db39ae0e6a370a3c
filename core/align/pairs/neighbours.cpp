// SPDX-License-Identifier: GPL-3.0-or-later
#include "features/option_check.h"
#include "pairs/disjoint_sets.h"

#include "spherewalk/align/match_pairs.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numbers>
#include <set>

namespace spherewalk::align {

namespace {

constexpr double kNeighbourPlaceM = 0.01;
constexpr double kSameDistanceM =
    0.03;                    ///< Of distances closer than this the direction decides, not the cart's scatter.
constexpr double kFar = 1.8; ///< Least distance of a far neighbour, in distances of the nearest.

using PairSet = std::set<std::pair<int, int>>;

struct Other {
    int index = 0;
    double distanceM = 0;
    double turn = 0; ///< Its direction as a share of the full turn, [0, 1).
};

/// The way from one photo to another across the floor.
Eigen::Vector2d across(std::span<const Eigen::Vector3d> positionsM, int from, int to) {
    return (positionsM[static_cast<std::size_t>(to)] - positionsM[static_cast<std::size_t>(from)]).head<2>();
}

/// All other photos up to a distance across the floor, the nearest first; of two as near the first.
std::vector<Other> othersOf(int photo, std::span<const Eigen::Vector3d> positionsM, double mostM) {
    std::vector<Other> others;
    for (int i = 0; i < static_cast<int>(positionsM.size()); ++i) {
        if (i == photo) {
            continue;
        }
        const Eigen::Vector2d to = across(positionsM, photo, i);
        if (to.norm() <= mostM) {
            const double turn = std::atan2(to.y(), to.x()) / (2 * std::numbers::pi);
            others.push_back({i, to.norm(), turn < 0 ? turn + 1 : turn});
        }
    }
    std::stable_sort(others.begin(), others.end(),
                     [](const Other& a, const Other& b) { return a.distanceM < b.distanceM; });
    return others;
}

void add(int a, int b, PairSet& pairs) {
    pairs.emplace(std::min(a, b), std::max(a, b));
}

/// The sector around one of `count` directions, the first of which is +x.
int sectorOf(const Other& other, int count) {
    return static_cast<int>(std::lround(other.turn * count)) % count;
}

/// The nearest photo of each sector. Of several about as near, the one closest to the sector's middle.
std::vector<const Other*> nearestOfSectors(const std::vector<Other>& others, int sectors, double leastM,
                                           double mostM) {
    const auto fromMiddle = [sectors](const Other& other) {
        const double place = other.turn * sectors;
        return std::abs(place - std::round(place));
    };
    std::vector<const Other*> chosen(static_cast<std::size_t>(sectors), nullptr);
    for (const Other& other : others) {
        if (other.distanceM < leastM || other.distanceM > mostM) {
            continue;
        }
        const Other*& present = chosen[static_cast<std::size_t>(sectorOf(other, sectors))];
        if (present == nullptr || (other.distanceM < present->distanceM + kSameDistanceM &&
                                   fromMiddle(other) < fromMiddle(*present) - 1e-9)) {
            present = &other;
        }
    }
    std::erase(chosen, nullptr);
    return chosen;
}

void addNeighboursOf(int photo, std::span<const Eigen::Vector3d> positionsM, const NeighbourOptions& options,
                     PairSet& pairs) {
    const std::vector<Other> others = othersOf(photo, positionsM, options.mostDistanceM);
    int atOnePlace = 0;
    double nearestM = 0;
    for (const Other& other : others) {
        if (other.distanceM > kNeighbourPlaceM) {
            nearestM = other.distanceM;
            break;
        }
        if (other.index > photo && atOnePlace++ < options.mostAtOnePlace) {
            add(photo, other.index, pairs);
        }
    }
    if (nearestM == 0) {
        return;
    }
    for (const Other* other : nearestOfSectors(others, options.directions, nearestM, options.mostDistanceM)) {
        add(photo, other->index, pairs);
    }
    if (options.farDirections > 0) {
        for (const Other* other :
             nearestOfSectors(others, options.farDirections, kFar * nearestM, options.mostDistanceM)) {
            add(photo, other->index, pairs);
        }
    }
}

struct Link {
    int a = -1;
    int b = -1;
    double distanceM = std::numeric_limits<double>::max();
};

/// The shortest connection of each component to any other. Empty if there is but one component.
std::map<int, Link> shortestLinks(std::span<const Eigen::Vector3d> positionsM, DisjointSets& components) {
    std::map<int, Link> links;
    const int count = static_cast<int>(positionsM.size());
    for (int a = 0; a < count; ++a) {
        const int ofA = components.of(a);
        for (int b = a + 1; b < count; ++b) {
            const int ofB = components.of(b);
            if (ofA == ofB) {
                continue;
            }
            const double distanceM = across(positionsM, a, b).norm();
            for (Link* link : {&links[ofA], &links[ofB]}) {
                if (distanceM < link->distanceM) {
                    *link = {a, b, distanceM};
                }
            }
        }
    }
    return links;
}

/// Boruvka's way: all components reach out at a time, until one is left.
void connect(std::span<const Eigen::Vector3d> positionsM, DisjointSets& components, PairSet& pairs) {
    for (auto links = shortestLinks(positionsM, components); !links.empty();
         links = shortestLinks(positionsM, components)) {
        for (const auto& [component, link] : links) {
            if (components.of(link.a) != components.of(link.b)) { // no other link has joined them since
                add(link.a, link.b, pairs);
                components.join(link.a, link.b);
            }
        }
    }
}

} // namespace

void NeighbourOptions::validate() const {
    require(directions >= 1 && directions <= 64, "neighbours'", "directions", "from 1 to 64");
    require(farDirections >= 0 && farDirections <= 64, "neighbours'", "farDirections", "from 0 to 64");
    require(mostAtOnePlace >= 1 && mostAtOnePlace <= 1000, "neighbours'", "mostAtOnePlace", "from 1 to 1000");
    require(mostDistanceM > 0 && std::isfinite(mostDistanceM), "neighbours'", "mostDistanceM", "above 0");
}

std::vector<std::pair<int, int>> neighbours(std::span<const Eigen::Vector3d> positionsM,
                                            const NeighbourOptions& options) {
    options.validate();
    if (!std::all_of(positionsM.begin(), positionsM.end(), [](const auto& p) { return p.allFinite(); })) {
        throw Error(ErrorKind::InvalidInput, "Could not find neighbouring photos: a position is not finite.");
    }
    PairSet pairs;
    DisjointSets components(positionsM.size());
    for (int photo = 0; photo < static_cast<int>(positionsM.size()); ++photo) {
        addNeighboursOf(photo, positionsM, options, pairs);
    }
    for (const auto& [a, b] : pairs) {
        components.join(a, b);
    }
    connect(positionsM, components, pairs);
    return {pairs.begin(), pairs.end()};
}

std::vector<std::pair<int, int>> loosePairs(int photos, std::span<const PairEstimate> estimates,
                                            int strongInliers) {
    constexpr int kEnoughStrong = 3;
    std::vector<int> strongOf(static_cast<std::size_t>(photos), 0);
    const auto isLoose = [&](int photo) { return strongOf[static_cast<std::size_t>(photo)] < kEnoughStrong; };
    for (const PairEstimate& estimate : estimates) {
        const bool isStrong =
            estimate.verdict == PairVerdict::Constraint && estimate.inliers >= strongInliers;
        for (const int photo : {estimate.a, estimate.b}) {
            strongOf[static_cast<std::size_t>(photo)] += isStrong ? 1 : 0;
        }
    }
    PairSet pairs;
    for (const PairEstimate& estimate : estimates) {
        if (isLoose(estimate.a) || isLoose(estimate.b)) {
            add(estimate.a, estimate.b, pairs);
        }
    }
    return {pairs.begin(), pairs.end()};
}

} // namespace spherewalk::align
