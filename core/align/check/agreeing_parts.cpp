// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/align/agreeing_parts.h"

#include "check/content_witness.h"
#include "pairs/disjoint_sets.h"

#include "spherewalk/base/statistics.h"

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
/// Lenses that stand so near to each other, as a share of how far they usually see, are hardly in two rooms.
constexpr double kOneRoomShare = 0.8;
constexpr double kBesideShare = 0.5; ///< Of what most photos beside each other show.

bool isBeside(const PhotoAgreement& pair, double besideM) {
    return pair.apartM < besideM && pair.expected >= kClearlyExpected;
}

/// Whether hardly anything is there that either photo lets expect, and no wall explains it.
bool isUnlike(const PhotoAgreement& pair) {
    return pair.apartM < kOneRoomShare * pair.rangeM && pair.expected >= kClearlyExpected &&
           pair.seen < kContradicted * pair.expected;
}

/// Photos that stand farther apart see too little from the same side.
constexpr double kNearM = 1;
constexpr double kLeastInSight = 50;  ///< Number of things, of each photo.
constexpr double kInSightShare = 0.6; ///< Of what most photos as far apart share.
/// Two pairs contradict together that share so little of what is in sight, and of what is expected.
constexpr double kTogetherInSightShare = 0.85;
constexpr double kTogetherShare = 0.6;
constexpr double kAsFarM = 0.2;         ///< By which distances between photos differ that are called alike.
constexpr std::size_t kLeastBeside = 5; ///< Fewer pairs do not tell what is usual.
/// Of the usual share of what is in sight: photos that share so much are of one place. Between parts of one
/// place the median of the pairs is 0.90 to 1.14, between rooms with the same furniture 0.59 to 0.83.
constexpr double kAlikeInSight = 0.9;

/// What photos beside each other usually show of each other; 0 if few photos are. Where photos are dense,
/// neighbours stand as near as these, and it is about 1; else it is more.
double usualShareBeside(std::span<const PhotoAgreement> agreements, double besideM) {
    std::vector<double> shares;
    for (const PhotoAgreement& pair : agreements) {
        if (isBeside(pair, besideM)) {
            shares.push_back(pair.betterShare);
        }
    }
    return shares.size() < kLeastBeside ? 0 : median(std::move(shares));
}

/// What photos as far apart usually share of what both have in sight; 0 if there are few.
double usualShareInSight(std::span<const PhotoAgreement> agreements, double apartM) {
    std::vector<double> shares;
    for (const PhotoAgreement& pair : agreements) {
        if (pair.shareInSight < 1 && std::fabs(pair.apartM - apartM) < kAsFarM) {
            shares.push_back(pair.shareInSight);
        }
    }
    return shares.size() < kLeastBeside ? 0 : median(std::move(shares));
}

/// What two photos say of whether they show one place.
struct Testimony {
    double against = 0;       ///< 1 forbids to join them, and so do two halves.
    double inSight = 0;       ///< Share of what is in sight, over the usual one; 0 where that tells nothing.
    bool contradicts = false; ///< Whether one of them lacks what should stand around it, a wall or not.
};

std::map<std::pair<int, int>, Testimony> testimonyIn(std::span<const PhotoAgreement> agreements,
                                                     double besideM) {
    const double usualBeside = usualShareBeside(agreements, besideM);
    std::map<std::pair<int, int>, Testimony> testimony;
    for (const PhotoAgreement& pair : agreements) {
        const double usual = besideM > 0 ? usualShareInSight(agreements, pair.apartM) : 0;
        const double inSight = usual > 0 && pair.shareInSight < 1 ? pair.shareInSight / usual : 0;
        const bool showsLittle = isBeside(pair, besideM) && pair.betterShare < kBesideShare * usualBeside;
        const bool isClear = isUnlike(pair) || pair.shareInSight < kInSightShare * usual;
        const bool isHalf = pair.shareInSight < kTogetherInSightShare * usual &&
                            pair.expected >= kClearlyExpected && pair.seen < kTogetherShare * pair.expected;
        const double against = isClear || (showsLittle && inSight < kAlikeInSight) ? 1 : isHalf ? 0.5 : 0;
        Testimony& said = testimony[std::minmax(pair.a, pair.b)];
        said.against = std::max(said.against, against);
        said.inSight = std::max(said.inSight, inSight);
        said.contradicts = said.contradicts || isClear || showsLittle;
    }
    return testimony;
}

double betterShare(const ExpectedThings& inA, const ExpectedThings& inB) {
    double better = 0;
    for (const ExpectedThings& things : {inA, inB}) {
        better = std::max(better, things.expected < kLeastExpected ? 1 : things.seen / things.expected);
    }
    return better;
}

/// The better side of what is seen of each other's things in sight; 1 if there are few.
double shareInSight(const Sightings& sightings, int a, int b) {
    const ExpectedThings ofB = sightings.inSight(a, b);
    const ExpectedThings ofA = sightings.inSight(b, a);
    return std::min(ofA.expected, ofB.expected) < kLeastInSight
               ? 1
               : std::max(ofA.seen / ofA.expected, ofB.seen / ofB.expected);
}

/// Where a texture repeats itself, features are taken for others, and some pairs contradict a true place.
/// inSight: of the pairs between two sets that tell.
bool isOutvoted(double against, std::vector<double> inSight) {
    constexpr double kPairsForOne = 3;
    return inSight.size() >= kLeastBeside && static_cast<double>(inSight.size()) >= kPairsForOne * against &&
           median(std::move(inSight)) >= kAlikeInSight;
}

/// Joins the pairs that agree most first, and never two photos that contradict each other.
DisjointSets joined(std::size_t photos, std::span<const PhotoAgreement> agreements, double leastShare,
                    double besideM) {
    const auto share = [leastShare](const PhotoAgreement& pair) {
        return pair.expected < kLeastExpected ? leastShare : pair.seen / pair.expected;
    };
    std::vector<PhotoAgreement> sorted(agreements.begin(), agreements.end());
    const auto testimony = testimonyIn(agreements, besideM);
    std::ranges::stable_sort(sorted, std::greater<>(), share);
    DisjointSets sets(photos);
    for (const PhotoAgreement& pair : sorted) {
        const std::pair joins(sets.of(pair.a), sets.of(pair.b));
        if (share(pair) < leastShare || joins.first == joins.second) {
            continue;
        }
        double against = 0;
        std::vector<double> inSight;
        for (const auto& [both, said] : testimony) {
            const std::pair apart(sets.of(both.first), sets.of(both.second));
            if (apart == joins || apart == std::pair(joins.second, joins.first)) {
                against += said.against;
                if (said.inSight > 0) {
                    inSight.push_back(said.inSight);
                }
            }
        }
        if (against < 1 || isOutvoted(against, std::move(inSight))) {
            sets.join(pair.a, pair.b);
        }
    }
    return sets;
}

} // namespace

std::vector<PhotoAgreement> photoAgreements(std::span<const std::optional<Rigid3>> roomFromPhoto,
                                            std::span<const PhotoPair> pairs,
                                            std::span<const std::vector<bool>> isInlier) {
    const Sightings sightings(roomFromPhoto, pairs, isInlier);
    std::vector<double> rangesM; // One a photo.
    for (std::size_t i = 0; i < roomFromPhoto.size(); ++i) {
        rangesM.push_back(sightings.usualRangeM(static_cast<int>(i)));
    }
    std::vector<PhotoAgreement> all;
    for (const PhotoPair& pair : pairs) {
        if (pair.a != pair.b && sightings.isPlaced(pair.a) && sightings.isPlaced(pair.b)) {
            const ExpectedThings inA = sightings.expected(pair.a, pair.b);
            const ExpectedThings inB = sightings.expected(pair.b, pair.a);
            const Eigen::Vector3d apart = roomFromPhoto[static_cast<std::size_t>(pair.a)]->translation -
                                          roomFromPhoto[static_cast<std::size_t>(pair.b)]->translation;
            PhotoAgreement agreement{pair.a,
                                     pair.b,
                                     inA.expected + inB.expected,
                                     inA.seen + inB.seen,
                                     apart.norm(),
                                     betterShare(inA, inB),
                                     std::max(rangesM[static_cast<std::size_t>(pair.a)],
                                              rangesM[static_cast<std::size_t>(pair.b)])};
            if (agreement.apartM < kNearM) {
                agreement.shareInSight = shareInSight(sightings, pair.a, pair.b);
            }
            all.push_back(agreement);
        }
    }
    return all;
}

std::vector<int> agreeingParts(const std::vector<bool>& isPlaced, std::span<const PhotoAgreement> agreements,
                               double leastShare, double besideM) {
    DisjointSets sets = joined(isPlaced.size(), agreements, leastShare, besideM);
    std::map<int, std::vector<int>> parts;
    for (int photo = 0; photo < static_cast<int>(isPlaced.size()); ++photo) {
        if (isPlaced[static_cast<std::size_t>(photo)]) {
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
    std::vector<int> partOf(isPlaced.size(), -1);
    for (std::size_t part = 0; part < sorted.size(); ++part) {
        for (const int photo : sorted[part]) {
            partOf[static_cast<std::size_t>(photo)] = static_cast<int>(part);
        }
    }
    return partOf;
}

std::vector<std::pair<int, int>> contradictingPhotos(std::span<const PhotoAgreement> agreements,
                                                     double besideM) {
    std::vector<std::pair<int, int>> photos;
    for (const auto& [both, said] : testimonyIn(agreements, besideM)) {
        if (said.contradicts) {
            photos.push_back(both);
        }
    }
    return photos;
}

std::vector<int>
rejoinedParts(std::vector<int> parts,
              const std::function<std::vector<int>(const std::vector<int>& parts)>& partsWhereCut) {
    constexpr int kLeastPhotos = 3;
    const auto hasOthers = [](const std::vector<int>& some) {
        return std::ranges::any_of(some, [](int part) { return part > 0; });
    };
    for (int part = 1; std::ranges::count(parts, part) >= kLeastPhotos; ++part) {
        std::vector<int> trial = parts;
        std::ranges::replace(trial, part, 0);
        if (!hasOthers(trial)) {
            break; // All together do not agree: that is how the parts were found.
        }
        const std::vector<int> agreeing = partsWhereCut(trial);
        bool isOne = true;
        for (std::size_t photo = 0; photo < trial.size(); ++photo) {
            isOne = isOne && (trial[photo] != 0 || agreeing[photo] == 0);
        }
        parts = isOne ? trial : parts;
    }
    return parts;
}

} // namespace spherewalk::align
