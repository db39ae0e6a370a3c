// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/survey/room.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace spherewalk::survey {

namespace {

constexpr double kHighestCeilingM = 1000;

[[noreturn]] void refuse(const std::string& sentence) {
    throw Error(ErrorKind::InvalidInput, sentence);
}

void checkPolygon(const Polygon& polygon, const std::string& whose) {
    if (const auto wrong = defect(polygon)) {
        refuse(text("The ", whose, " cannot be used: ", *wrong, "."));
    }
    for (const Eigen::Vector2d& corner : polygon) {
        if (corner.cwiseAbs().maxCoeff() > kFarthestCoordinateM) {
            refuse(text("The ", whose, " cannot be used: a corner lies more than ", kFarthestCoordinateM,
                        " m from the origin; move the origin into the building."));
        }
    }
    if (std::abs(signedArea(polygon)) == 0) {
        refuse(text("The ", whose, " cannot be used: it has no area."));
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
        refuse(text("The outline is ", fixed(longest, 0), " m long, more than the ", kLargestRoomM,
                    " m that one survey may have; check its unit (metres), or split the room."));
    }
}

} // namespace

void Room::validate() const {
    std::size_t corners = outline.size();
    for (const Polygon& obstacle : obstacles) {
        corners += obstacle.size();
    }
    if (corners > kMostRoomCorners) {
        refuse(text("The room has ", corners, " corners, more than the ", kMostRoomCorners,
                    " allowed; draw it more simply."));
    }
    checkPolygon(outline, "outline");
    checkSize(outline);
    for (std::size_t i = 0; i < obstacles.size(); ++i) {
        const std::string whose = text("obstacle ", i + 1);
        checkPolygon(obstacles[i], whose);
        if (!overlap(outline, obstacles[i])) {
            refuse(text("The ", whose, " lies outside the outline; move it into the room or remove it."));
        }
    }
    if (!(ceilingM > 0 && ceilingM <= kHighestCeilingM)) {
        refuse(text("The ceiling cannot be at ", ceilingM, " m: give its height above the floor, up to ",
                    kHighestCeilingM, " m."));
    }
}

} // namespace spherewalk::survey
