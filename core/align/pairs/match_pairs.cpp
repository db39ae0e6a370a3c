// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/align/match_pairs.h"

#include "features/keypoints.h"
#include "features/option_check.h"
#include "pairs/nearest.h"

#include "spherewalk/base/enum_names.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/base/text.h"

#include <cmath>
#include <mutex>

namespace spherewalk::align {

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
                           b.bearings[inB].cast<double>().normalized(), sigmaRad, a.thing(i), b.thing(j)});
    }
    return matches;
}

std::vector<PhotoPair> matchPairs(std::span<const Features> photos,
                                  std::span<const std::pair<int, int>> pairs, const MatchOptions& options,
                                  int threads, ProgressSink& progress, const std::stop_token& stop) {
    options.validate();
    const int count = static_cast<int>(photos.size());
    for (const auto& [a, b] : pairs) {
        if (a < 0 || a >= b || b >= count) {
            throw Error(ErrorKind::InvalidInput, text("Could not match photos ", a, " and ", b, " of ", count,
                                                      ": the first must come before the second."));
        }
    }
    std::vector<PhotoPair> matched(pairs.size());
    std::mutex mutex;
    std::size_t done = 0;
    parallelFor(static_cast<int>(pairs.size()), 1, threads, [&](int i, int /*end*/) {
        throwIfStopped(stop);
        const auto& [a, b] = pairs[static_cast<std::size_t>(i)];
        matched[static_cast<std::size_t>(i)] = {
            a, b,
            matchFeatures(photos[static_cast<std::size_t>(a)], photos[static_cast<std::size_t>(b)], options)};
        const std::scoped_lock lock(mutex);
        progress.progress(static_cast<double>(++done) / static_cast<double>(pairs.size()), "Matching photos");
    });
    return matched;
}

namespace {

/// The numbers of the features of another look at a photo; known ones keep theirs.
std::vector<int> numbered(const Features& features, std::vector<Eigen::Vector3f>& known) {
    constexpr double kReachRad = 0.009; // What features of other sizes at one thing are apart.
    std::vector<Eigen::Vector3f> all = known;
    all.insert(all.end(), features.bearings.begin(), features.bearings.end());
    const std::vector<int> first = firstNear(all, kReachRad);
    std::vector<int> numbers;
    for (int i = 0; i < features.count(); ++i) {
        const auto thing = static_cast<std::size_t>(features.thing(i));
        if (thing < numbers.size()) {
            numbers.push_back(numbers[thing]);
            continue;
        }
        const auto near = static_cast<std::size_t>(first[all.size() - features.bearings.size() + thing]);
        const bool isKnown = near + features.bearings.size() < all.size();
        numbers.push_back(isKnown ? static_cast<int>(near) : static_cast<int>(known.size()));
        if (!isKnown) {
            known.push_back(features.bearings[thing]);
        }
    }
    return numbers;
}

} // namespace

void renumber(std::span<const Features> looked, std::span<const int> photos, int look,
              std::vector<std::vector<Eigen::Vector3f>>& known, std::span<PhotoPair> pairs) {
    std::vector<std::vector<int>> numbers;
    for (std::size_t i = 0; i < photos.size(); ++i) {
        numbers.push_back(numbered(looked[i], known[static_cast<std::size_t>(photos[i])]));
    }
    for (PhotoPair& pair : pairs) {
        const auto a = static_cast<std::size_t>(pair.a);
        const auto b = static_cast<std::size_t>(pair.b);
        for (Correspondence& match : pair.matches) {
            match.featureA = numbers[a][static_cast<std::size_t>(match.featureA)];
            match.featureB = numbers[b][static_cast<std::size_t>(match.featureB)];
        }
        pair.a = photos[a];
        pair.b = photos[b];
        pair.look = look;
    }
}

namespace {

constexpr EnumNames<Effort, 4> kEffortNames{
    {{Effort::Draft, "draft"}, {Effort::Normal, "normal"}, {Effort::Fine, "fine"}, {Effort::Exact, "exact"}}};

} // namespace

std::string_view name(Effort effort) {
    return nameOf(kEffortNames, effort);
}

Effort effortNamed(std::string_view name) {
    return valueOf(kEffortNames, "The effort", name);
}

EffortOptions optionsFor(Effort effort) {
    EffortOptions options;
    switch (effort) {
    case Effort::Draft:
        options.features.detector = Detector::Orb;
        options.features.width = 1024;
        options.features.most = 1000;
        break;
    case Effort::Normal:
        options.features.width = 1280;
        options.features.most = 2000;
        options.features.leastContrast = 0.03;
        break;
    case Effort::Fine:
        options.features.width = 2048;
        options.features.most = 4000;
        options.features.leastContrast = 0.02;
        options.neighbours.farDirections = 4;
        break;
    case Effort::Exact:
        options.features.width = 2688;
        options.features.most = 8000;
        options.features.leastContrast = 0.015;
        options.neighbours.farDirections = 8;
        break;
    }
    return options;
}

EffortOptions wideOptions() {
    EffortOptions options = optionsFor(Effort::Fine);
    options.features.isWide = true;
    options.features.most = 2000;
    options.match.isGuided = false; // Near things move far between photos metres apart.
    options.pair.leastSine = 0.03;
    options.pair.reach = Radians(0.8); // The floor moves so, seen from 1.2 m farther.
    return options;
}

} // namespace spherewalk::align
