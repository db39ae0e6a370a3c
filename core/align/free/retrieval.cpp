// SPDX-License-Identifier: GPL-3.0-or-later
#include "features/option_check.h"
#include "graph/pose_graph.h"
#include "pairs/disjoint_sets.h"

#include "spherewalk/align/free_places.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/parallel.h"

#include <algorithm>
#include <mutex>
#include <numeric>
#include <set>

namespace spherewalk::align {

namespace {

using PairSet = std::set<std::pair<int, int>>;

/// The other photos, the most alike first; of two as alike the first.
std::vector<int> mostAlike(const Likeness& alike, int photo) {
    std::vector<int> others(static_cast<std::size_t>(alike.photos()));
    std::iota(others.begin(), others.end(), 0);
    std::erase_if(others, [&](int other) { return other == photo || alike.votes(photo, other) == 0; });
    std::ranges::stable_sort(others, std::greater<>(), [&](int other) { return alike.votes(photo, other); });
    return others;
}

void add(int a, int b, PairSet& pairs) {
    pairs.emplace(std::min(a, b), std::max(a, b));
}

/// The links that join most at once: a spanning forest of the most alike. Source: Kruskal 1956.
void addForest(const Likeness& alike, PairSet& pairs) {
    std::vector<std::pair<int, int>> links;
    for (int a = 0; a < alike.photos(); ++a) {
        for (int b = a + 1; b < alike.photos(); ++b) {
            if (alike.votes(a, b) > 0) {
                links.emplace_back(a, b);
            }
        }
    }
    std::ranges::stable_sort(links, std::greater<>(),
                             [&](const auto& link) { return alike.votes(link.first, link.second); });
    DisjointSets sets(static_cast<std::size_t>(alike.photos()));
    for (const auto& [a, b] : links) {
        if (sets.of(a) != sets.of(b)) {
            sets.join(a, b);
            add(a, b, pairs);
        }
    }
}

/// Looks at so many features of all pairs of the chosen photos that do not look alike yet. Votes are told as
/// if the first look had found them.
void look(std::span<const Features> photos, const RetrievalOptions& options, int features,
          const std::vector<bool>& isChosen, Likeness& alike, ProgressSink& progress,
          const std::stop_token& stop) {
    MatchOptions match = options.match;
    match.firstLook = features;
    std::mutex mutex;
    int done = 0;
    parallelFor(alike.photos(), 1, options.threads, [&](int a, int /*end*/) {
        throwIfStopped(stop);
        for (int b = a + 1; b < alike.photos(); ++b) {
            const auto inA = static_cast<std::size_t>(a);
            const auto inB = static_cast<std::size_t>(b);
            if ((isChosen[inA] || isChosen[inB]) && alike.votes(a, b) == 0) {
                const auto rotation = coarseRotation(photos[inA], photos[inB], match);
                const int votes = rotation ? rotation->votes * options.match.firstLook / features : 0;
                alike.set(a, b, rotation ? std::max(1, votes) : 0);
            }
        }
        const std::scoped_lock lock(mutex);
        progress.progress(static_cast<double>(++done) / alike.photos(), "Looking for photos that look alike");
    });
}

} // namespace

void RetrievalOptions::validate() const {
    match.validate();
    require(partners >= 1 && partners <= 1000, "retrieval's", "partners", "from 1 to 1000");
    require(exhaustive >= 0 && exhaustive <= 1000, "retrieval's", "exhaustive", "from 0 to 1000");
    require(bridges >= 1 && bridges <= 1000, "retrieval's", "bridges", "from 1 to 1000");
    require(fewAlike >= 0 && fewAlike <= 1000, "retrieval's", "fewAlike", "from 0 to 1000");
    require(secondLook >= 50 && secondLook <= 50000, "retrieval's", "secondLook", "from 50 to 50000");
}

Likeness likeness(std::span<const Features> photos, const RetrievalOptions& options, ProgressSink& progress,
                  const std::stop_token& stop) {
    options.validate();
    Likeness alike(static_cast<int>(photos.size()));
    ProgressStep first(progress, 0, 0.7);
    look(photos, options, options.match.firstLook, std::vector<bool>(photos.size(), true), alike, first,
         stop);
    std::vector<bool> again;
    for (int photo = 0; photo < alike.photos(); ++photo) {
        again.push_back(static_cast<int>(mostAlike(alike, photo).size()) < options.fewAlike);
    }
    ProgressStep second(progress, 0.7, 1);
    look(photos, options, std::max(options.match.firstLook, options.secondLook), again, alike, second, stop);
    return alike;
}

std::vector<std::pair<int, int>> likelyPairs(const Likeness& alike, const RetrievalOptions& options) {
    options.validate();
    PairSet pairs;
    for (int photo = 0; photo < alike.photos(); ++photo) {
        if (alike.photos() <= options.exhaustive) {
            for (int other = photo + 1; other < alike.photos(); ++other) {
                add(photo, other, pairs);
            }
            continue;
        }
        const std::vector<int> others = mostAlike(alike, photo);
        for (std::size_t i = 0; i < std::min<std::size_t>(others.size(), options.partners); ++i) {
            add(photo, others[i], pairs);
        }
    }
    addForest(alike, pairs);
    return {pairs.begin(), pairs.end()};
}

std::vector<std::pair<int, int>> likelyBridges(const Likeness& alike, std::span<const PairEstimate> estimates,
                                               const RetrievalOptions& options) {
    options.validate();
    DisjointSets parts(static_cast<std::size_t>(alike.photos()));
    for (const Component& component : poseGraph(alike.photos(), estimates, 1).components) {
        for (const int photo : component.photos) {
            parts.join(photo, component.photos.front());
        }
    }
    PairSet compared;
    for (const PairEstimate& estimate : estimates) {
        add(estimate.a, estimate.b, compared);
    }
    PairSet bridges;
    for (int photo = 0; photo < alike.photos(); ++photo) {
        int found = 0;
        for (const int other : mostAlike(alike, photo)) {
            const std::pair<int, int> pair = std::minmax(photo, other);
            if (found < options.bridges && parts.of(photo) != parts.of(other) && !compared.contains(pair)) {
                bridges.insert(pair);
                ++found;
            }
        }
    }
    return {bridges.begin(), bridges.end()};
}

} // namespace spherewalk::align
