// SPDX-License-Identifier: GPL-3.0-or-later
#include "rooms.h"

#include "spherewalk/survey/walking_distance.h"

#include <gtest/gtest.h>

namespace spherewalk::survey {

using Eigen::Vector2d;

TEST(WalkingDistance, IsStraightWhereNothingIsBetween) {
    const WalkingDistance walking(test::rectangularRoom(5, 4));
    EXPECT_DOUBLE_EQ(walking.between({1, 1}, {4, 3}), std::hypot(3, 2));
}

TEST(WalkingDistance, GoesAroundBothInnerCornersOfAU) {
    const WalkingDistance walking(test::uShape());
    const double around = std::hypot(0.5, 2.5) + 3 + std::hypot(0.5, 2.5);
    EXPECT_NEAR(walking.between({1, 4}, {5, 4}), around, 0.1);
    EXPECT_GT(walking.between({1, 4}, {5, 4}), around);
}

TEST(WalkingDistance, GoesAroundAnObstacleOnItsShorterSide) {
    Room room = test::rectangularRoom(6, 4);
    room.obstacles = {test::rectangle(2, 0.5, 4, 2.5)};
    const double above = std::hypot(1, 0.5) + 2 + std::hypot(1, 0.5);
    EXPECT_NEAR(WalkingDistance(room).between({1, 2}, {5, 2}), above, 0.1);
}

TEST(WalkingDistance, IsSymmetricNeverShorterThanStraightAndKeepsTheTriangle) {
    spherewalk::test::Random random(11);
    for (int i = 0; i < 60; ++i) {
        SCOPED_TRACE(testing::Message() << "seed " << random.seed() << " room " << i);
        const Room room = test::randomRoom(random);
        const WalkingDistance walking(room);
        std::vector<Vector2d> points;
        while (points.size() < 3) {
            const Vector2d point(random.uniform(-3, 5), random.uniform(-6, 2));
            if (test::onFloor(room, point)) {
                points.push_back(point);
            }
        }
        const double ab = walking.between(points[0], points[1]);
        EXPECT_NEAR(ab, walking.between(points[1], points[0]), 1e-9);
        EXPECT_GE(ab, (points[0] - points[1]).norm() - 1e-9);
        // A detour around a corner keeps two centimetres off it, once per corner passed.
        EXPECT_LE(ab, walking.between(points[0], points[2]) + walking.between(points[2], points[1]) + 0.3);
    }
}

} // namespace spherewalk::survey
