// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/survey/room_parts.h"

#include "floor.h"

#include "spherewalk/survey/walking_distance.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace spherewalk::survey {

/// The places of the names, and what is needed to walk to them.
struct RoomParts::Places {
    explicit Places(const Room& room) : floor(room), walking(room) {
        for (const RoomName& name : room.names) {
            const auto known = std::find(names.begin(), names.end(), name.name);
            rooms.push_back(static_cast<std::size_t>(known - names.begin()));
            if (known == names.end()) {
                names.push_back(name.name);
            }
            places.push_back(walking.place(name.at));
        }
    }

    bool sees(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const {
        return floor.sees(from - floor.anchor(), to - floor.anchor());
    }

    Floor floor;
    WalkingDistance walking;
    std::vector<std::string> names;
    std::vector<std::size_t> rooms; ///< Index into `names`, one for each of `places`.
    std::vector<WalkingDistance::Place> places;
};

RoomParts::RoomParts(const Room& room) : m_places(std::make_unique<Places>(room)) {
}

RoomParts::~RoomParts() = default;
RoomParts::RoomParts(RoomParts&&) noexcept = default;
RoomParts& RoomParts::operator=(RoomParts&&) noexcept = default;

const std::vector<std::string>& RoomParts::names() const {
    return m_places->names;
}

std::optional<std::size_t> RoomParts::at(const Eigen::Vector2d& place) const {
    std::optional<std::size_t> nearest;
    std::pair<bool, double> least{true, std::numeric_limits<double>::infinity()}; // hidden, distance
    const WalkingDistance::Place from = m_places->walking.place(place);
    for (std::size_t i = 0; i < m_places->places.size(); ++i) {
        const WalkingDistance::Place& to = m_places->places[i];
        const std::pair<bool, double> way{!m_places->sees(place, to.point),
                                          m_places->walking.between(from, to)};
        if (!nearest || way < least) {
            nearest = m_places->rooms[i];
            least = way;
        }
    }
    return nearest;
}

std::vector<std::size_t> RoomParts::ofRails(const Plan& plan) const {
    std::vector<std::size_t> rooms;
    for (const RailPlacement& rail : plan.placements) {
        if (const auto room = at(rail.stop(rail.stops / 2))) {
            rooms.push_back(*room);
        }
    }
    return rooms;
}

Plan roomByRoom(Plan plan, const Room& room) {
    if (room.names.empty()) {
        return plan;
    }
    const RoomParts parts(room);
    const std::vector<std::size_t> rooms = parts.ofRails(plan);
    std::vector<std::size_t> turn(parts.names().size(), rooms.size()); // of a room: where it first comes
    for (std::size_t i = rooms.size(); i-- > 0;) {
        turn[rooms[i]] = i;
    }
    std::vector<std::size_t> order(rooms.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return turn[rooms[a]] < turn[rooms[b]]; });
    Plan result;
    result.isByHand = plan.isByHand;
    std::vector<int> place(order.size());
    for (const std::size_t rail : order) {
        place[rail] = static_cast<int>(result.placements.size());
        result.placements.push_back(plan.placements[rail]);
    }
    for (Station& station : plan.stations) {
        station.placement = place[static_cast<std::size_t>(station.placement)];
    }
    std::stable_sort(plan.stations.begin(), plan.stations.end(),
                     [](const Station& a, const Station& b) { return a.placement < b.placement; });
    result.stations = std::move(plan.stations);
    return result;
}

} // namespace spherewalk::survey
