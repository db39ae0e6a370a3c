// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/scene/sphere.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace spherewalk::scene {

namespace {

survey::Room square(double halfM, const Eigen::Vector2d& centre) {
    survey::Room room;
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
        room.outline.push_back(centre + halfM * Eigen::Vector2d(x, y));
    }
    room.ceilingM = 2 * halfM;
    return room;
}

} // namespace

// Seen from a cube's centre, 1 / distance is max |d_i| / half, whose mean over the sphere is
// (6 sqrt(2) / pi) atan(1 / sqrt(2)) / half (integrate over one face).
TEST(SphereRadius, IsTheHarmonicMeanDistanceInACube) {
    const double expected =
        1.5 / (6 * std::numbers::sqrt2 / std::numbers::pi * std::atan(1 / std::numbers::sqrt2) / 2);
    for (const Eigen::Vector2d& centre : {Eigen::Vector2d(0, 0), Eigen::Vector2d(1e6, -1e6)}) {
        const auto radius = sphereRadius(square(1.5, centre), {{centre.x(), centre.y(), 1.5}});
        ASSERT_TRUE(radius);
        EXPECT_NEAR(*radius, expected, 0.02 * expected);
    }
}

TEST(SphereRadius, GrowsWithTheRoom) {
    const auto small = sphereRadius(square(1, {0, 0}), {{0.3, 0.1, 1}});
    const auto large = sphereRadius(square(10, {0, 0}), {{3, 1, 10}});
    EXPECT_NEAR(*large / *small, 10, 1e-9);
}

TEST(SphereRadius, LeavesOutPointsThatAreNotInTheRoom) {
    const survey::Room room = square(1, {0, 0});
    EXPECT_FALSE(sphereRadius(room, {{5, 0, 1}, {0, 0, -1}, {0, 0, 2}, {1, 0, 1}}));
    EXPECT_EQ(sphereRadius(room, {{5, 0, 1}, {0, 0, 1}}), sphereRadius(room, {{0, 0, 1}}));
}

} // namespace spherewalk::scene
