// SPDX-License-Identifier: GPL-3.0-or-later
#include "free/placing.h"

#include "spherewalk/align/content_check.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::align {

namespace {

/// Below this share of what neighbours let expect, two parts of a survey are two places.
constexpr double kOnePlaceShare = 0.3;
constexpr int kLookalikeRounds = 3; ///< Of placing without pairs that what is there twice explains.
/// Doorways and steps of two metres may show as little of what neighbours let expect.
constexpr double kSurePlaceShare = 0.5;
/// Within a room, photos show more of what each other sees.
constexpr double kRoomShare = 1;
constexpr std::size_t kLeastInRoom = 4;
constexpr Radians kLean = Degrees(0.1);
constexpr double kSigmas = 3;
constexpr double kLeastStepM = 0.01;

/// The photos of a room and the points that lie nearest to them.
struct Room {
    std::vector<std::size_t> photos;
    std::vector<Eigen::Vector3d> positionsM;
    std::vector<Eigen::Vector3d> pointsM;

    Eigen::Vector3d middle() const {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (const Eigen::Vector3d& position : positionsM) {
            sum += position;
        }
        return sum / static_cast<double>(positionsM.size());
    }
};

std::vector<Room> roomsOf(const FreePlaces& places, std::span<const int> roomOf) {
    std::vector<Room> rooms;
    for (const int room : roomOf) {
        rooms.resize(std::max(rooms.size(), static_cast<std::size_t>(room + 1)));
    }
    if (rooms.empty()) {
        return rooms;
    }
    for (std::size_t i = 0; i < roomOf.size(); ++i) {
        if (roomOf[i] >= 0) {
            Room& room = rooms[static_cast<std::size_t>(roomOf[i])];
            room.photos.push_back(i);
            room.positionsM.push_back(places.photos[i].roomFromPhoto->translation);
        }
    }
    for (const Eigen::Vector3d& point : places.pointsM) {
        const auto distance = [&](const Room& room) {
            double nearest = 1e300;
            for (const Eigen::Vector3d& position : room.positionsM) {
                nearest = std::min(nearest, (position - point).norm());
            }
            return nearest;
        };
        std::ranges::min_element(rooms, {}, distance)->pointsM.push_back(point);
    }
    return rooms;
}

std::optional<FloorPlane> floorOf(const Room& room) {
    return room.photos.size() < kLeastInRoom
               ? std::nullopt
               : floorBelow(room.positionsM, room.pointsM, Eigen::Vector3d::UnitZ(), Degrees(3));
}

/// Height of the floor at a place.
double heightAt(const FloorPlane& floor, const Eigen::Vector3d& placeM) {
    return (floor.at - floor.up.x() * placeM.x() - floor.up.y() * placeM.y()) / floor.up.z();
}

std::string stepOf(const Room& room, const FloorPlane& floor, const Room& largest, const FloorPlane& below) {
    const Eigen::Vector3d middle = room.middle();
    const double stepM = heightAt(floor, middle) - heightAt(below, largest.middle());
    const double sigmaM = std::hypot(
        floor.heightSigma, below.heightSigma,
        std::hypot(kUnevenFloor * below.lensHeight, kLean.value() * (middle - largest.middle()).norm()));
    if (std::abs(stepM) < std::max(kLeastStepM, kSigmas * sigmaM)) {
        return {};
    }
    return text("The floor around it lies ", fixed(100 * std::abs(stepM), 1), " cm ",
                stepM > 0 ? "above" : "below",
                " that of the largest part: if there is no step, lengths around it are ",
                fixed(100 * std::abs(stepM) / below.lensHeight, 1), " % too ", stepM > 0 ? "short" : "long",
                ". Take photos between it and the others.");
}

void doubt(FreePlace& place, const std::string& sentence) {
    place.doubt = place.doubt.empty() ? sentence : place.doubt;
}

/// Gives lengths and heights as the floor of the largest room has them. The lowest floor of all, which gave
/// them, may be that of a room whose lengths are wrong.
void measureByFloor(const Room& room, const FloorPlane& floor, double lensHeightM, FreePlaces& places) {
    const double scale = lensHeightM / floor.lensHeight;
    const double floorAt = heightAt(floor, room.middle());
    const auto measured = [&](Eigen::Vector3d& at) {
        at = scale * (at - floorAt * Eigen::Vector3d::UnitZ());
    };
    for (FreePlace& place : places.photos) {
        if (place.roomFromPhoto) {
            measured(place.roomFromPhoto->translation);
        }
        place.lenses.aheadM *= scale;
        place.sigmaM *= scale;
    }
    std::ranges::for_each(places.pointsM, measured);
    for (Eigen::Vector2d& corner : places.outline) {
        corner *= scale;
    }
    places.ceilingM = scale * (places.ceilingM - floorAt);
}

void tellSteps(const std::vector<Room>& rooms, double lensHeightM, FreePlaces& places) {
    if (rooms.size() < 2) {
        return;
    }
    const std::optional<FloorPlane> below = floorOf(rooms.front());
    bool isStep = false;
    for (const Room& room : std::span(rooms).subspan(1)) {
        const std::optional<FloorPlane> floor = below ? floorOf(room) : std::nullopt;
        const std::string step = floor ? stepOf(room, *floor, rooms.front(), *below) : "";
        isStep = isStep || !step.empty();
        for (const std::size_t photo : room.photos) {
            doubt(places.photos[photo], step);
        }
    }
    if (isStep && (places.scaleBy == ScaleBy::Floor || places.scaleBy == ScaleBy::Guess)) {
        measureByFloor(rooms.front(), *below, lensHeightM, places);
    }
}

std::vector<PairVerdict> verdictsOf(std::span<const PairEstimate> estimates) {
    std::vector<PairVerdict> verdicts;
    for (const PairEstimate& estimate : estimates) {
        verdicts.push_back(estimate.verdict);
    }
    return verdicts;
}

bool isCut(const std::vector<int>& parts) {
    return std::ranges::any_of(parts, [](int part) { return part > 0; });
}

/// Lets no pair join photos of different parts.
std::vector<PairEstimate> cutBetween(std::span<const int> parts, std::vector<PairEstimate> estimates) {
    for (PairEstimate& estimate : estimates) {
        const int partOfA = parts[static_cast<std::size_t>(estimate.a)];
        const int partOfB = parts[static_cast<std::size_t>(estimate.b)];
        if (partOfA >= 0 && partOfB >= 0 && partOfA != partOfB) {
            estimate.verdict = PairVerdict::NoAgreement;
        }
    }
    return estimates;
}

} // namespace

PlaceAgreement::PlaceAgreement(const FreePlaces& places, std::span<const PhotoPair> pairs)
    : m_isInMetres(places.scaleBy != ScaleBy::Nothing) {
    std::vector<std::optional<Rigid3>> poses;
    for (const FreePlace& place : places.photos) {
        poses.push_back(place.roomFromPhoto);
        m_isPlaced.push_back(place.roomFromPhoto.has_value());
    }
    const std::vector<std::vector<bool>> fitting = fittingMatches(poses, pairs);
    for (const std::vector<bool>& matches : fitting) {
        m_fitting.push_back(static_cast<int>(std::ranges::count(matches, true)));
    }
    m_agreements = photoAgreements(poses, pairs, fitting);
}

std::vector<int> PlaceAgreement::parts(double leastShare) const {
    return agreeingParts(m_isPlaced, m_agreements, leastShare, m_isInMetres ? kBesideM : 0);
}

std::vector<PairEstimate> PlaceAgreement::withoutLookalikes(std::span<const PairEstimate> estimates) const {
    constexpr double kBorneOut = 0.5; // Share of the matches that the photos agreed on.
    const auto contradicting = contradictingPhotos(m_agreements, m_isInMetres ? kBesideM : 0);
    std::vector<PairEstimate> fewer(estimates.begin(), estimates.end());
    bool isAnyLeftOut = false;
    for (std::size_t i = 0; i < fewer.size(); ++i) {
        PairEstimate& estimate = fewer[i];
        if (estimate.verdict == PairVerdict::Constraint && m_fitting[i] > kBorneOut * estimate.inliers &&
            std::ranges::binary_search(contradicting,
                                       std::pair<int, int>(std::minmax(estimate.a, estimate.b)))) {
            estimate.verdict = PairVerdict::NoAgreement;
            isAnyLeftOut = true;
        }
    }
    return isAnyLeftOut ? fewer : std::vector<PairEstimate>();
}

CertainPairs certainPairs(std::vector<PairEstimate> estimates,
                          const std::function<PlaceAgreement(std::span<const PairEstimate>)>& placed) {
    std::vector<PairVerdict> last; // By which the photos were last placed.
    const auto agreementOf = [&](std::span<const PairEstimate> some) {
        last = verdictsOf(some);
        return placed(some);
    };
    PlaceAgreement agreement = agreementOf(estimates);
    std::vector<int> parts = agreement.parts(kOnePlaceShare);
    for (int round = 0; round < kLookalikeRounds && isCut(parts); ++round) {
        std::vector<PairEstimate> fewer = agreement.withoutLookalikes(estimates);
        if (fewer.empty()) {
            break;
        }
        agreement = agreementOf(fewer);
        std::vector<int> larger = agreement.parts(kOnePlaceShare);
        if (std::ranges::count(larger, 0) <= std::ranges::count(parts, 0)) {
            break;
        }
        estimates = std::move(fewer);
        parts = std::move(larger);
    }
    parts = rejoinedParts(std::move(parts), [&](const std::vector<int>& trial) {
        return agreementOf(cutBetween(trial, estimates)).parts(kOnePlaceShare);
    });
    estimates = cutBetween(parts, std::move(estimates));
    if (verdictsOf(estimates) != last) {
        placed(estimates);
    }
    return {std::move(parts), std::move(estimates)};
}

void doubtLooseParts(FreePlaces& places, const PlaceAgreement& agreement, double lensHeightM) {
    tellSteps(roomsOf(places, agreement.parts(kRoomShare)), lensHeightM, places);
    const std::vector<int> sure = agreement.parts(kSurePlaceShare);
    for (std::size_t i = 0; i < sure.size(); ++i) {
        if (sure[i] > 0) {
            doubt(places.photos[i],
                  "Little of what the largest part lets expect around it is there, so how it "
                  "stands to the others is not certain: take photos between it and them.");
        }
    }
}

} // namespace spherewalk::align
