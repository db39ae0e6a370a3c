// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/content_witness.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/statistics.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace spherewalk::align {

namespace {

constexpr double kLeastParallaxSine = 0.009; ///< Half a degree: less gives no distance.
constexpr double kLeastRangeM = 0.1;
constexpr double kSeenChord = 0.014; ///< 0.8 degrees: things so near are the same thing.
constexpr int kLeastConfirming = 2;  ///< Neighbours that see a thing where the photo shows it.
constexpr double kPriorShare = 0.2;  ///< Evens out shares of few photos.
constexpr Radians kSameSide = Degrees(20);
constexpr double kSameSize = 1.5; ///< Between the distances from which two photos see a thing.
const double kBesideThing = std::cos(Radians(Degrees(2.5)).value());
constexpr double kAsFar = 1.2;
constexpr std::array<Degrees, 6> kAside = {Degrees(4),  Degrees(8),  Degrees(14),
                                           Degrees(22), Degrees(32), Degrees(180)};
constexpr double kPriorThings = 3; ///< Evens out what few things say of how far aside they are still known.

void checkPair(const PhotoPair& pair, const std::vector<bool>& isInlier, std::size_t photos) {
    if (std::min(pair.a, pair.b) < 0 || static_cast<std::size_t>(std::max(pair.a, pair.b)) >= photos) {
        throw Error(ErrorKind::InvalidInput, text("A pair names the photos ", pair.a, " and ", pair.b,
                                                  ", but there are ", photos, " photos."));
    }
    if (isInlier.size() != pair.matches.size()) {
        throw Error(ErrorKind::InvalidInput,
                    text("The pair of the photos ", pair.a, " and ", pair.b, " has ", pair.matches.size(),
                         " matches, but ", isInlier.size(), " are said to be inliers or not."));
    }
}

/// Turns the share of a neighbour's photos that show a thing into the chance that this photo shows it.
void setChances(std::span<Witness> witnesses) {
    double seen = 0;
    double shares = 0;
    for (const Witness& witness : witnesses) {
        seen += witness.isSeen ? 1 : 0;
        shares += witness.chance + kPriorShare;
    }
    for (Witness& witness : witnesses) {
        witness.chance = std::clamp(seen * (witness.chance + kPriorShare) / shares, 0.02, 0.95);
    }
}

/// What is seen from aside is found again less often, and furniture hides more of it.
void lowerChancesAside(std::span<Witness> witnesses) {
    Radians from;
    for (const Radians to : kAside) {
        const auto isHere = [&](const Witness& witness) {
            return witness.aside >= from && witness.aside < to;
        };
        double seen = kPriorThings;
        double expected = kPriorThings;
        for (const Witness& witness : witnesses) {
            if (isHere(witness)) {
                seen += witness.isSeen ? witness.weight : 0;
                expected += witness.weight * witness.chance;
            }
        }
        for (Witness& witness : witnesses) {
            if (isHere(witness)) {
                witness.chance *= std::min(1., seen / expected);
            }
        }
        from = to;
    }
}

} // namespace

Sightings::Sightings(std::span<const std::optional<Rigid3>> roomFromPhoto, std::span<const PhotoPair> pairs,
                     std::span<const std::vector<bool>> isInlier,
                     std::function<bool(const Eigen::Vector3d&)> isSearched)
    : m_roomFromPhoto(roomFromPhoto.begin(), roomFromPhoto.end()),
      m_of(roomFromPhoto.size()),
      m_neighbours(roomFromPhoto.size()),
      m_isSearched(std::move(isSearched)) {
    if (isInlier.size() != pairs.size()) {
        throw Error(ErrorKind::InvalidInput,
                    text("There are ", pairs.size(), " pairs, but inliers of ", isInlier.size(), " pairs."));
    }
    for (std::optional<Rigid3>& pose : m_roomFromPhoto) {
        if (pose && !(pose->rotation.coeffs().allFinite() && pose->translation.allFinite())) {
            pose.reset();
        }
    }
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const PhotoPair& pair = pairs[i];
        checkPair(pair, isInlier[i], roomFromPhoto.size());
        if (pair.a == pair.b || !m_roomFromPhoto[static_cast<std::size_t>(pair.a)] ||
            !m_roomFromPhoto[static_cast<std::size_t>(pair.b)]) {
            continue;
        }
        m_neighbours[static_cast<std::size_t>(pair.a)].push_back({pair.b, pair.look});
        m_neighbours[static_cast<std::size_t>(pair.b)].push_back({pair.a, pair.look});
        for (std::size_t match = 0; match < pair.matches.size(); ++match) {
            add(pair.a, {pair.b, pair.look}, pair.matches[match], true, isInlier[i][match]);
            add(pair.b, {pair.a, pair.look}, pair.matches[match], false, isInlier[i][match]);
        }
    }
    for (std::vector<Sighting>& sightings : m_of) {
        std::ranges::stable_sort(sightings, std::less(), &Sighting::feature);
    }
}

void Sightings::add(int photo, Neighbour other, const Correspondence& match, bool isFromA, bool isInlier) {
    const int feature = isFromA ? match.featureA : match.featureB;
    if (feature < 0 || !match.inA.allFinite() || !match.inB.allFinite()) {
        return;
    }
    Sighting sighting{feature,
                      other,
                      isFromA ? match.featureB : match.featureA,
                      isFromA ? &match.inA : &match.inB,
                      isFromA ? &match.inB : &match.inA,
                      isInlier};
    sighting.rangeM = isInlier ? rangeM(photo, other.photo, *sighting.own, *sighting.others) : 0;
    m_of[static_cast<std::size_t>(photo)].push_back(sighting);
}

/// The distance along the own bearing to where the two bearings come nearest to each other; 0 if unknown.
double Sightings::rangeM(int photo, int other, const Eigen::Vector3d& own,
                         const Eigen::Vector3d& others) const {
    const Rigid3& roomFromOwn = *m_roomFromPhoto[static_cast<std::size_t>(photo)];
    const Rigid3& roomFromOther = *m_roomFromPhoto[static_cast<std::size_t>(other)];
    const Eigen::Vector3d ray = roomFromOwn.rotation * own;
    const Eigen::Vector3d otherRay = roomFromOther.rotation * others;
    const Eigen::Vector3d baselineM = roomFromOther.translation - roomFromOwn.translation;
    const double cosine = ray.dot(otherRay);
    const double sineSquared = ray.cross(otherRay).squaredNorm();
    if (!(sineSquared > kLeastParallaxSine * kLeastParallaxSine)) {
        return 0;
    }
    const double alongOwn = (ray.dot(baselineM) - cosine * otherRay.dot(baselineM)) / sineSquared;
    const double alongOther = (cosine * ray.dot(baselineM) - otherRay.dot(baselineM)) / sineSquared;
    return std::min(alongOwn, alongOther) > kLeastRangeM ? alongOwn : 0;
}

double Sightings::usualRangeM(int photo) const {
    std::vector<double> ranges;
    for (const Sighting& sighting : m_of[static_cast<std::size_t>(photo)]) {
        if (sighting.rangeM > 0) {
            ranges.push_back(sighting.rangeM);
        }
    }
    return ranges.empty() ? 0 : median(std::move(ranges));
}

Eigen::Vector3d Sightings::positionInPhoto(int photo, int other) const {
    return m_roomFromPhoto[static_cast<std::size_t>(photo)]->inverse() *
           m_roomFromPhoto[static_cast<std::size_t>(other)]->translation;
}

PhotoWitnesses Sightings::witnesses(int photo) const {
    PhotoWitnesses result;
    for (const Neighbour& neighbour : m_neighbours[static_cast<std::size_t>(photo)]) {
        const std::size_t first = result.witnesses.size();
        witness(photo, neighbour, result);
        setChances(std::span(result.witnesses).subspan(first));
        ++result.neighbours;
    }
    lowerChancesAside(result.witnesses);
    return result;
}

template <class Use>
void Sightings::forEachFeature(int photo, const Use& use) const {
    const std::vector<Sighting>& all = m_of[static_cast<std::size_t>(photo)];
    for (auto from = all.begin(); from != all.end();) {
        const auto to = std::find_if(
            from, all.end(), [&](const Sighting& sighting) { return sighting.feature != from->feature; });
        use(std::span<const Sighting>(from, to));
        from = to;
    }
}

void Sightings::witness(int photo, Neighbour neighbour, PhotoWitnesses& result) const {
    forEachFeature(neighbour.photo, [&](std::span<const Sighting> ofFeature) {
        if (const std::optional<Witness> found = witness(photo, neighbour, ofFeature, result)) {
            result.witnesses.push_back(*found);
        }
    });
}

ExpectedThings Sightings::expected(int photo, int neighbour) const {
    PhotoWitnesses found;
    witness(photo, {neighbour}, found);
    ExpectedThings things;
    for (const Witness& witness : found.witnesses) {
        things.expected += witness.chance;
        things.seen += witness.isSeen ? 1 : 0;
    }
    return things;
}

std::vector<Sightings::Thing> Sightings::things(int photo, int other) const {
    const Rigid3& roomFromPhoto = *m_roomFromPhoto[static_cast<std::size_t>(photo)];
    std::vector<Thing> result;
    forEachFeature(photo, [&](std::span<const Sighting> ofFeature) {
        std::vector<double> rangesM;
        bool isShared = false;
        for (const Sighting& sighting : ofFeature) {
            if (sighting.other.photo == other) {
                isShared = isShared || sighting.isInlier;
            } else if (sighting.rangeM > 0) {
                rangesM.push_back(sighting.rangeM);
            }
        }
        if (rangesM.size() >= kLeastConfirming) {
            result.push_back({roomFromPhoto * (median(rangesM) * *ofFeature[0].own), isShared});
        }
    });
    return result;
}

ExpectedThings Sightings::inSight(int photo, int neighbour) const {
    const Eigen::Vector3d placeM = m_roomFromPhoto[static_cast<std::size_t>(photo)]->translation;
    const Eigen::Vector3d otherPlaceM = m_roomFromPhoto[static_cast<std::size_t>(neighbour)]->translation;
    std::vector<Eigen::Vector3d> own; // from the photo's place
    for (const Thing& thing : things(photo, neighbour)) {
        own.emplace_back(thing.pInRoom - placeM);
    }
    ExpectedThings result;
    for (const Thing& thing : things(neighbour, photo)) {
        const Eigen::Vector3d fromPhoto = thing.pInRoom - placeM;
        const Eigen::Vector3d fromOther = thing.pInRoom - otherPlaceM;
        const double rangeShare = fromPhoto.norm() / fromOther.norm();
        if (angleBetween(fromPhoto, fromOther) > kSameSide || rangeShare > kSameSize ||
            rangeShare < 1 / kSameSize) {
            continue;
        }
        const auto beside = [&](const Eigen::Vector3d& each) {
            return each.dot(fromPhoto) > kBesideThing * each.norm() * fromPhoto.norm();
        };
        const auto asFar = [&](const Eigen::Vector3d& each) {
            const double share = each.norm() / fromPhoto.norm();
            return share < kAsFar && share > 1 / kAsFar;
        };
        const auto isInSight = [&] {
            int found = 0;
            for (const Eigen::Vector3d& each : own) {
                if (beside(each)) {
                    if (!asFar(each)) {
                        return false;
                    }
                    ++found;
                }
            }
            return found >= kLeastConfirming;
        };
        result.seen += thing.isShared ? 1 : 0;
        result.expected += thing.isShared || isInSight() ? 1 : 0;
    }
    return result;
}

bool Sightings::standsThere(int photo, int feature) const {
    const std::vector<Sighting>& all = m_of[static_cast<std::size_t>(photo)];
    int there = 0;
    for (auto sighting = std::ranges::lower_bound(all, feature, std::less(), &Sighting::feature);
         sighting != all.end() && sighting->feature == feature; ++sighting) {
        there += sighting->rangeM > 0 ? 1 : 0;
    }
    return there >= kLeastConfirming;
}

/// The witness that one feature of the neighbour gives, by all photos that it was found in.
std::optional<Witness> Sightings::witness(int photo, Neighbour neighbour, std::span<const Sighting> ofFeature,
                                          PhotoWitnesses& result) const {
    const Sighting* inPhoto = nullptr;
    std::vector<double> rangesM;
    for (const Sighting& sighting : ofFeature) {
        if (sighting.other.photo == photo) {
            inPhoto = &sighting;
        } else if (sighting.rangeM > 0 && sighting.other.isOf(neighbour.look)) {
            rangesM.push_back(sighting.rangeM);
        }
    }
    if (rangesM.empty()) {
        if (inPhoto != nullptr && inPhoto->isInlier) {
            result.agreed.push_back(*inPhoto->others);
        }
        return std::nullopt;
    }
    const auto confirming = static_cast<double>(rangesM.size());
    const Rigid3& roomFromPhoto = *m_roomFromPhoto[static_cast<std::size_t>(photo)];
    const Eigen::Vector3d pInRoom =
        *m_roomFromPhoto[static_cast<std::size_t>(neighbour.photo)] * (median(rangesM) * *ofFeature[0].own);
    Witness witness;
    const Eigen::Vector3d pInPhoto = roomFromPhoto.inverse() * pInRoom;
    witness.rangeM = pInPhoto.norm();
    witness.expected = pInPhoto.normalized();
    witness.aside =
        angleBetween(pInRoom - roomFromPhoto.translation,
                     pInRoom - m_roomFromPhoto[static_cast<std::size_t>(neighbour.photo)]->translation);
    if (m_isSearched && !m_isSearched(witness.expected)) {
        return std::nullopt;
    }
    const auto asked =
        std::ranges::count_if(m_neighbours[static_cast<std::size_t>(neighbour.photo)],
                              [&neighbour](const Neighbour& each) { return each.isOf(neighbour.look); });
    witness.chance = confirming / static_cast<double>(asked);
    witness.weight = 1 / (1 + confirming);
    if (inPhoto != nullptr) {
        witness.isSeen = (*inPhoto->others - witness.expected).norm() < kSeenChord;
        if (!witness.isSeen && !standsThere(photo, inPhoto->featureOfOther)) {
            witness.elsewhere = *inPhoto->others;
            witness.featureElsewhere = inPhoto->featureOfOther;
        }
    }
    if (!witness.isSeen) {
        witness.viewers.push_back(neighbour.photo);
        for (const Sighting& sighting : ofFeature) {
            if (sighting.rangeM > 0 && sighting.other.photo != photo && sighting.other.isOf(neighbour.look)) {
                witness.viewers.push_back(sighting.other.photo);
            }
        }
    }
    return witness;
}

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
