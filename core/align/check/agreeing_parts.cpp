// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/align/agreeing_parts.h"

#include "check/content_witness.h"
#include "pairs/disjoint_sets.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <utility>

namespace spherewalk::align {

namespace {

constexpr double kLeastExpected = 20;   ///< Fewer things say nothing for or against a pair.
constexpr double kClearlyExpected = 50; ///< So many things that are not there contradict a pair.
constexpr double kContradicted = 0.05;  ///< Share of the expected things.

/// What two photos show of each other's things.
struct Agreement {
    int a = 0;
    int b = 0;
    double expected = 0;
    double share = 0; ///< Of the expected things, those that are seen where they belong.

    bool isContradiction() const { return expected >= kClearlyExpected && share < kContradicted; }
};

std::vector<Agreement> agreements(const Sightings& sightings, std::span<const PhotoPair> pairs,
                                  double shareOfFew) {
    std::vector<Agreement> all;
    for (const PhotoPair& pair : pairs) {
        if (pair.a == pair.b || !sightings.isPlaced(pair.a) || !sightings.isPlaced(pair.b)) {
            continue;
        }
        const ExpectedThings inA = sightings.expected(pair.a, pair.b);
        const ExpectedThings inB = sightings.expected(pair.b, pair.a);
        const double expected = inA.expected + inB.expected;
        const double share = expected < kLeastExpected ? shareOfFew : (inA.seen + inB.seen) / expected;
        all.push_back({pair.a, pair.b, expected, share});
    }
    return all;
}

/// Joins the pairs that agree most first, and never two photos that contradict each other.
DisjointSets joined(std::size_t photos, std::vector<Agreement> agreements, double leastShare) {
    std::vector<Agreement> contradictions;
    std::ranges::copy_if(agreements, std::back_inserter(contradictions), &Agreement::isContradiction);
    std::ranges::stable_sort(agreements, std::greater<>(), &Agreement::share);
    DisjointSets sets(photos);
    for (const Agreement& agreement : agreements) {
        const std::pair joins(sets.of(agreement.a), sets.of(agreement.b));
        const bool isContradicted = std::ranges::any_of(contradictions, [&](const Agreement& other) {
            const std::pair apart(sets.of(other.a), sets.of(other.b));
            return apart == joins || apart == std::pair(joins.second, joins.first);
        });
        if (agreement.share >= leastShare && !isContradicted) {
            sets.join(agreement.a, agreement.b);
        }
    }
    return sets;
}

} // namespace

std::vector<int> agreeingParts(std::span<const std::optional<Rigid3>> roomFromPhoto,
                               std::span<const PhotoPair> pairs, std::span<const std::vector<bool>> isInlier,
                               double leastShare) {
    const Sightings sightings(roomFromPhoto, pairs, isInlier);
    DisjointSets sets = joined(roomFromPhoto.size(), agreements(sightings, pairs, leastShare), leastShare);
    std::map<int, std::vector<int>> parts;
    for (int photo = 0; photo < static_cast<int>(roomFromPhoto.size()); ++photo) {
        if (sightings.isPlaced(photo)) {
            parts[sets.of(photo)].push_back(photo);
        }
    }
    std::vector<std::vector<int>> sorted;
    for (auto& [first, photos] : parts) {
        sorted.push_back(std::move(photos));
    }
    std::ranges::stable_sort(sorted, [](const auto& a, const auto& b) {
        return a.size() != b.size() ? a.size() > b.size() : a.front() < b.front();
    });
    std::vector<int> partOf(roomFromPhoto.size(), -1);
    for (std::size_t part = 0; part < sorted.size(); ++part) {
        for (const int photo : sorted[part]) {
            partOf[static_cast<std::size_t>(photo)] = static_cast<int>(part);
        }
    }
    return partOf;
}

} // namespace spherewalk::align
