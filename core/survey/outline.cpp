// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/survey/outline.h"

#include "spherewalk/base/text.h"

namespace spherewalk::survey {

namespace {

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

Json polygonJson(const Polygon& polygon) {
    Json corners = Json::array();
    for (const Eigen::Vector2d& corner : polygon) {
        corners.push_back(Json::array({corner.x(), corner.y()}));
    }
    return corners;
}

} // namespace

Outline parseOutline(const Json& value, const std::string& source) {
    const JsonReader document(value, source);
    std::size_t cornersLeft = kMostRoomCorners;
    if (value.is_array()) {
        return {.outline = parsePolygon(document, cornersLeft), .obstacles = {}, .ceilingM = std::nullopt};
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
    return result;
}

Json outlineJson(const Room& room) {
    Json obstacles = Json::array();
    for (const Polygon& obstacle : room.obstacles) {
        obstacles.push_back(polygonJson(obstacle));
    }
    return {{"outline", polygonJson(room.outline)}, {"obstacles", obstacles}, {"ceiling_m", room.ceilingM}};
}

} // namespace spherewalk::survey
