// SPDX-License-Identifier: GPL-3.0-or-later
#include "free/placing.h"

#include "spherewalk/align/content_check.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::align {

namespace {

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
    if (isStep && places.scaleBy == ScaleBy::Floor) {
        measureByFloor(rooms.front(), *below, lensHeightM, places);
    }
}

} // namespace

PlaceAgreement::PlaceAgreement(const FreePlaces& places, std::span<const PhotoPair> pairs)
    : m_isInMetres(places.scaleBy != ScaleBy::Nothing) {
    std::vector<std::optional<Rigid3>> poses;
    for (const FreePlace& place : places.photos) {
        poses.push_back(place.roomFromPhoto);
        m_isPlaced.push_back(place.roomFromPhoto.has_value());
    }
    m_agreements = photoAgreements(poses, pairs, fittingMatches(poses, pairs));
}

std::vector<int> PlaceAgreement::parts(double leastShare) const {
    return agreeingParts(m_isPlaced, m_agreements, leastShare, m_isInMetres ? kBesideM : 0);
}

std::vector<PairEstimate> cutBetween(std::span<const int> parts, std::span<const PairEstimate> estimates) {
    std::vector<PairEstimate> cut(estimates.begin(), estimates.end());
    bool isAnyCut = false;
    for (PairEstimate& estimate : cut) {
        const int partOfA = parts[static_cast<std::size_t>(estimate.a)];
        const int partOfB = parts[static_cast<std::size_t>(estimate.b)];
        if (partOfA >= 0 && partOfB >= 0 && partOfA != partOfB) {
            estimate.verdict = PairVerdict::NoAgreement;
            isAnyCut = true;
        }
    }
    return isAnyCut ? cut : std::vector<PairEstimate>();
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
