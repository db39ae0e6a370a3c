// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/survey/room.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace spherewalk::survey {

namespace {

constexpr double kHighestCeilingM = 1000;

[[noreturn]] void refuseRoom(const std::string& sentence) {
    throw Error(ErrorKind::InvalidInput, sentence);
}

void checkPolygon(const Polygon& polygon, const std::string& whose) {
    if (const auto wrong = defect(polygon)) {
        refuseRoom(text("The ", whose, " cannot be used: ", *wrong, "."));
    }
    for (const Eigen::Vector2d& corner : polygon) {
        if (corner.cwiseAbs().maxCoeff() > kFarthestCoordinateM) {
            refuseRoom(text("The ", whose, " cannot be used: a corner lies more than ", kFarthestCoordinateM,
                            " m from the origin; move the origin into the building."));
        }
    }
    if (std::abs(signedArea(polygon)) == 0) {
        refuseRoom(text("The ", whose, " cannot be used: it has no area."));
    }
}

/// True if the polygons have a point in common.
bool overlap(const Polygon& a, const Polygon& b) {
    if (contains(a, b.front()) || contains(b, a.front())) {
        return true;
    }
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (distanceToEdge(b, a[i], a[(i + 1) % a.size()]) == 0) {
            return true;
        }
    }
    return false;
}

void checkSize(const Polygon& outline) {
    const Bounds2 extent = bounds(outline);
    const double longest = (extent.greatest - extent.least).maxCoeff();
    if (longest > kLargestRoomM) {
        refuseRoom(text("The outline is ", fixed(longest, 0), " m long, more than the ", kLargestRoomM,
                        " m that one survey may have; check its unit (metres), or split the room."));
    }
}

Polygon parsePolygon(const JsonReader& corners, std::size_t& cornersLeft) {
    const std::size_t count = corners.arraySize();
    if (count > cornersLeft) {
        corners.fail(text("the room has more than the ", kMostRoomCorners, " corners allowed"));
    }
    cornersLeft -= count;
    Polygon polygon;
    polygon.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const JsonReader corner = corners.element(i);
        if (corner.arraySize() != 2) {
            corner.fail("expected a corner as [x, y]");
        }
        polygon.emplace_back(corner.element(0).asNumber(), corner.element(1).asNumber());
    }
    return polygon;
}

std::vector<RoomName> parseNames(const JsonReader& list) {
    std::vector<RoomName> names;
    const std::size_t count = list.arraySize(kMostRoomNames);
    for (std::size_t i = 0; i < count; ++i) {
        const JsonReader room = list.element(i);
        const JsonReader at = room.member("at");
        if (at.arraySize() != 2) {
            at.fail("expected a place as [x, y]");
        }
        names.push_back({room.string("name"), {at.element(0).asNumber(), at.element(1).asNumber()}});
    }
    return names;
}

void checkNames(const Room& room) {
    if (room.names.size() > kMostRoomNames) {
        refuseRoom(text("The plan names ", room.names.size(), " rooms, more than the ", kMostRoomNames,
                        " allowed."));
    }
    constexpr std::size_t kLongestName = 100;
    for (const RoomName& name : room.names) {
        if (name.name.empty() || name.name.size() > kLongestName ||
            printable(name.name, kLongestName) != name.name) {
            refuseRoom(text("A room cannot be called \"", printable(name.name), "\": give one line of up to ",
                            kLongestName, " letters."));
        }
        if (!name.at.allFinite() || !contains(room.outline, name.at)) {
            refuseRoom(text("The room \"", name.name,
                            "\" lies outside the outline; move its name into the room or remove it."));
        }
    }
}

Json namesJson(const std::vector<RoomName>& names) {
    Json list = Json::array();
    for (const RoomName& name : names) {
        list.push_back({{"name", name.name}, {"at", {name.at.x(), name.at.y()}}});
    }
    return list;
}

Json polygonJson(const Polygon& polygon) {
    Json corners = Json::array();
    for (const Eigen::Vector2d& corner : polygon) {
        corners.push_back(Json::array({corner.x(), corner.y()}));
    }
    return corners;
}

} // namespace

void Room::validate() const {
    std::size_t corners = outline.size();
    for (const Polygon& obstacle : obstacles) {
        corners += obstacle.size();
    }
    if (corners > kMostRoomCorners) {
        refuseRoom(text("The room has ", corners, " corners, more than the ", kMostRoomCorners,
                        " allowed; draw it more simply."));
    }
    checkPolygon(outline, "outline");
    checkSize(outline);
    for (std::size_t i = 0; i < obstacles.size(); ++i) {
        const std::string whose = text("obstacle ", i + 1);
        checkPolygon(obstacles[i], whose);
        if (!overlap(outline, obstacles[i])) {
            refuseRoom(text("The ", whose, " lies outside the outline; move it into the room or remove it."));
        }
    }
    if (!(ceilingM > 0 && ceilingM <= kHighestCeilingM)) {
        refuseRoom(text("The ceiling cannot be at ", ceilingM, " m: give its height above the floor, up to ",
                        kHighestCeilingM, " m."));
    }
    checkNames(*this);
}

Room unknownRoom() {
    constexpr double kHalfM = 3;
    Room room;
    room.outline = {{-kHalfM, -kHalfM}, {kHalfM, -kHalfM}, {kHalfM, kHalfM}, {-kHalfM, kHalfM}};
    room.ceilingM = 2.6;
    return room;
}

Outline parseOutline(const Json& value, const std::string& source) {
    const JsonReader document(value, source);
    std::size_t cornersLeft = kMostRoomCorners;
    if (value.is_array()) {
        return {.outline = parsePolygon(document, cornersLeft),
                .obstacles = {},
                .ceilingM = std::nullopt,
                .names = {}};
    }
    Outline result;
    result.outline = parsePolygon(document.member("outline"), cornersLeft);
    if (!document.isAbsent("obstacles")) {
        const JsonReader obstacles = document.member("obstacles");
        const std::size_t count = obstacles.arraySize(kMostRoomCorners);
        for (std::size_t i = 0; i < count; ++i) {
            result.obstacles.push_back(parsePolygon(obstacles.element(i), cornersLeft));
        }
    }
    if (!document.isAbsent("ceiling_m")) {
        result.ceilingM = document.number("ceiling_m");
    }
    if (!document.isAbsent("rooms")) {
        result.names = parseNames(document.member("rooms"));
    }
    return result;
}

Json outlineJson(const Room& room) {
    Json obstacles = Json::array();
    for (const Polygon& obstacle : room.obstacles) {
        obstacles.push_back(polygonJson(obstacle));
    }
    Json json = {
        {"outline", polygonJson(room.outline)}, {"obstacles", obstacles}, {"ceiling_m", room.ceilingM}};
    if (!room.names.empty()) {
        json["rooms"] = namesJson(room.names);
    }
    return json;
}

} // namespace spherewalk::survey
