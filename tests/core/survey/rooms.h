// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "random.h"

#include "spherewalk/survey/plan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace spherewalk::survey::test {

inline Polygon rectangle(double x0, double y0, double x1, double y1) {
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

inline Room rectangularRoom(double width, double depth) {
    return {.outline = rectangle(0, 0, width, depth), .obstacles = {}, .ceilingM = 2.6};
}

inline Room lShape() {
    return {.outline = {{0, 0}, {5, 0}, {5, 2}, {2, 2}, {2, 4}, {0, 4}}, .obstacles = {}, .ceilingM = 2.6};
}

inline Room uShape() {
    return {.outline = {{0, 0}, {6, 0}, {6, 5}, {4.5, 5}, {4.5, 1.5}, {1.5, 1.5}, {1.5, 5}, {0, 5}},
            .obstacles = {},
            .ceilingM = 2.6};
}

/// A star-shaped outline around its middle: simple, and usually concave.
inline Polygon randomPolygon(spherewalk::test::Random& random, Eigen::Vector2d middle, double least,
                             double greatest) {
    const int corners = random.integer(5, 12);
    Polygon polygon;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * (i + random.uniform(-0.3, 0.3)) / corners;
        polygon.push_back(middle + random.uniform(least, greatest) *
                                       Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
    return polygon;
}

inline Room randomRoom(spherewalk::test::Random& random) {
    Room room{.outline = randomPolygon(random, {1, -2}, 1.2, 4), .obstacles = {}, .ceilingM = 2.6};
    for (int i = random.integer(0, 2); i > 0; --i) {
        const Eigen::Vector2d middle(1 + random.uniform(-0.8, 0.8), -2 + random.uniform(-0.8, 0.8));
        room.obstacles.push_back(randomPolygon(random, middle, 0.1, 0.5));
    }
    return room;
}

inline Room moved(Room room, const Eigen::Vector2d& by) {
    for (Eigen::Vector2d& corner : room.outline) {
        corner += by;
    }
    for (Polygon& obstacle : room.obstacles) {
        for (Eigen::Vector2d& corner : obstacle) {
            corner += by;
        }
    }
    return room;
}

inline PlanOptions anyPlanOptions(spherewalk::test::Random& random) {
    PlanOptions options;
    options.stepM = random.uniform(0.25, 0.6);
    options.clearanceM = random.uniform(0.05, 0.4);
    options.railStops = random.integer(2, 7);
    options.secondsPerPhoto = random.uniform(1, 20);
    options.secondsPerPlacement = random.uniform(0, 100);
    return options;
}

/// Runs the law on random rooms, of which every second one lies 10^6 m from the origin.
template <class Law>
void onRandomRooms(unsigned seed, int rooms, Law&& law) {
    spherewalk::test::Random random(seed);
    for (int i = 0; i < rooms; ++i) {
        SCOPED_TRACE(testing::Message() << "seed " << seed << " room " << i);
        const Eigen::Vector2d away = i % 2 == 0 ? Eigen::Vector2d(0, 0) : Eigen::Vector2d(1e6, -1e6);
        law(moved(randomRoom(random), away), anyPlanOptions(random), random);
    }
}

/// True inside the outline and outside the obstacles.
inline bool onFloor(const Room& room, const Eigen::Vector2d& point) {
    bool result = contains(room.outline, point);
    for (const Polygon& obstacle : room.obstacles) {
        result = result && !contains(obstacle, point);
    }
    return result;
}

/// The least distance from the segment to a wall or obstacle.
inline double clearanceOf(const Room& room, const Eigen::Vector2d& begin, const Eigen::Vector2d& end) {
    double least = distanceToEdge(room.outline, begin, end);
    for (const Polygon& obstacle : room.obstacles) {
        least = std::min(least, distanceToEdge(obstacle, begin, end));
    }
    return least;
}

} // namespace spherewalk::survey::test
