// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/align/neighbours.h"

#include "option_check.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

namespace spherewalk::align {

namespace {

constexpr double kOnePlaceM = 0.01;
constexpr double kSameDistanceM = 0.03; ///< below, the direction decides and not the cart's scatter
constexpr double kFar = 1.8;            ///< times the nearest's distance

using Pairs = std::set<std::pair<int, int>>;

struct Other {
    int index = 0;
    double distanceM = 0;
    double turn = 0; ///< its direction as a share of the full turn, [0, 1)
};

/// From one photo to another, across the floor.
Eigen::Vector2d across(std::span<const Eigen::Vector3d> positionsM, int from, int to) {
    return (positionsM[static_cast<std::size_t>(to)] - positionsM[static_cast<std::size_t>(from)]).head<2>();
}

/// All others across the floor up to a distance, nearest first; of two as near the first.
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

void add(int a, int b, Pairs& pairs) {
    pairs.emplace(std::min(a, b), std::max(a, b));
}

/// The sector around one of `count` directions, the first of which is +x.
int sectorOf(const Other& other, int count) {
    return static_cast<int>(std::lround(other.turn * count)) % count;
}

/// Of each sector the nearest; of those about as near the one closest to the sector's middle.
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
                     Pairs& pairs) {
    const std::vector<Other> others = othersOf(photo, positionsM, options.mostDistanceM);
    int atOnePlace = 0;
    double nearestM = 0;
    for (const Other& other : others) {
        if (other.distanceM > kOnePlaceM) {
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

/// Which photos are connected so far.
class Parts {
  public:
    explicit Parts(std::size_t photos) : m_parent(photos) { std::iota(m_parent.begin(), m_parent.end(), 0); }

    int of(int photo) {
        int& parent = m_parent[static_cast<std::size_t>(photo)];
        return parent == photo ? photo : parent = of(parent);
    }

    void join(int a, int b) { m_parent[static_cast<std::size_t>(of(a))] = of(b); }

  private:
    std::vector<int> m_parent;
};

struct Link {
    int a = -1;
    int b = -1;
    double distanceM = std::numeric_limits<double>::max();
};

/// Of each part the shortest connection to any other one. Empty if there is but one part.
std::map<int, Link> shortestLinks(std::span<const Eigen::Vector3d> positionsM, Parts& parts) {
    std::map<int, Link> links;
    const int count = static_cast<int>(positionsM.size());
    for (int a = 0; a < count; ++a) {
        const int partA = parts.of(a);
        for (int b = a + 1; b < count; ++b) {
            const int partB = parts.of(b);
            if (partA == partB) {
                continue;
            }
            const double distanceM = across(positionsM, a, b).norm();
            for (Link* link : {&links[partA], &links[partB]}) {
                if (distanceM < link->distanceM) {
                    *link = {a, b, distanceM};
                }
            }
        }
    }
    return links;
}

/// Boruvka's way: all parts reach out at a time, until one is left.
void connect(std::span<const Eigen::Vector3d> positionsM, Parts& parts, Pairs& pairs) {
    for (auto links = shortestLinks(positionsM, parts); !links.empty();
         links = shortestLinks(positionsM, parts)) {
        for (const auto& [part, link] : links) {
            if (parts.of(link.a) != parts.of(link.b)) { // not joined by another part's link since
                add(link.a, link.b, pairs);
                parts.join(link.a, link.b);
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
    Pairs pairs;
    Parts parts(positionsM.size());
    for (int photo = 0; photo < static_cast<int>(positionsM.size()); ++photo) {
        addNeighboursOf(photo, positionsM, options, pairs);
    }
    for (const auto& [a, b] : pairs) {
        parts.join(a, b);
    }
    connect(positionsM, parts, pairs);
    return {pairs.begin(), pairs.end()};
}

} // namespace spherewalk::align
