// SPDX-License-Identifier: GPL-3.0-or-later
// What makes the bare room and the flat hard: no texture, burnt light, glass, mirrors, walls between rooms.
#include "expect_error.h"

#include "spherewalk/practice/practice_room.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace spherewalk::practice {
namespace {

using Eigen::Vector3d;

constexpr double kPixel = 2e-3; ///< Radians.
const Vector3d kEye(2.4, 2.2, 1.3);

PracticeRoom roomOf(RoomStyle style, const Vector3d& size) {
    PracticeRoomOptions options;
    options.style = style;
    options.sizeM = size;
    return PracticeRoom(options);
}

PracticeRoom bareRoom() {
    return roomOf(RoomStyle::Bare, {5, 4, 2.6});
}

PracticeRoom flatOfTwo() {
    return roomOf(RoomStyle::Flat, {8, 6, 2.5});
}

/// The largest difference of neighbouring brightness, in grey levels, on a path of points on a surface.
float roughness(const PracticeRoom& room, const Vector3d& from, const Vector3d& to) {
    float most = 0;
    float last = -1;
    for (int i = 0; i <= 60; ++i) {
        const Vector3d at = from + (to - from) * i / 60.0;
        const float green = room.cast(kEye, at - kEye, kPixel).colour[1];
        most = last < 0 ? 0 : std::max(most, std::abs(green - last));
        last = green;
    }
    return most;
}

TEST(BareRoom, ItsCeilingHasNoTexture) {
    const Vector3d from(0.8, 3.2, 2.6);
    const Vector3d to(1.8, 3.4, 2.6);
    EXPECT_LT(roughness(bareRoom(), from, to), 1);
    EXPECT_GT(roughness(roomOf(RoomStyle::Lively, {5, 4, 2.6}), from, to), 1);
}

TEST(BareRoom, ItsWindowIsBurntOut) {
    const PracticeRoom room = bareRoom();
    for (const double along : {-0.5, -0.2, 0.3, 0.6}) {
        const Sample sky = room.cast(kEye, Vector3d(0, 2 + along, 1.45) - kEye, kPixel);
        EXPECT_EQ(sky.colour[1], 255) << along;
    }
}

TEST(BareRoom, AMirrorShowsTheRoomAndIsAsFarAsItself) {
    const PracticeRoom room = bareRoom();
    const Vector3d mirror(2.3, 0.02, 1.4);
    const Sample seen = room.cast(kEye, mirror - kEye, kPixel);
    EXPECT_NEAR(seen.rangeM, (mirror - kEye).norm(), 1e-9);
    Vector3d behind = mirror - kEye;
    behind.y() = -behind.y();
    const Sample reflected = room.cast(mirror + Vector3d(0, 1e-6, 0), behind, kPixel);
    EXPECT_NEAR(seen.colour[1], reflected.colour[1], 25);
}

TEST(BareRoom, APaneReflectsAndHasNoDistance) {
    const PracticeRoom room = bareRoom();
    const Vector3d onPane(2.95, 3.25, 1.5);
    const Vector3d direction = onPane - kEye;
    const Sample through = room.cast(kEye, direction, kPixel);
    EXPECT_GT(through.rangeM, direction.norm() + 0.5);
    const Sample without = room.cast(onPane + Vector3d(0.02, 0, 0), direction, kPixel);
    EXPECT_NEAR(through.rangeM, (onPane - kEye).norm() + without.rangeM, 0.05);
    EXPECT_NE(through.colour, without.colour);
}

TEST(BareRoom, SomethingComesCloserThan45CentimetresToAFreePlace) {
    const PracticeRoom room = bareRoom();
    const Vector3d eye(1.35, 3.15, 1.25);
    for (const Polygon& obstacle : room.plan().obstacles) {
        EXPECT_FALSE(contains(obstacle, eye.head<2>()));
    }
    EXPECT_LT(room.cast(eye, Vector3d(0, 1, 0), kPixel).rangeM, 0.45);
}

TEST(Flat, NobodySeesThroughItsWalls) {
    const PracticeRoom room = flatOfTwo();
    const Vector3d inFirst(3.5, 4, 1.3);
    const Vector3d inSecond(4.5, 4, 1.3);
    EXPECT_NEAR(room.cast(inFirst, Vector3d(1, 0, 0), kPixel).rangeM, 0.45, 1e-9);
    EXPECT_NEAR(room.cast(inSecond, Vector3d(-1, 0, 0), kPixel).rangeM, 0.45, 1e-9);
    EXPECT_NEAR(room.cast({3.2, 0.7, 1.3}, Vector3d(0, 1, 0), kPixel).rangeM, 0.7, 1e-9);
}

TEST(Flat, EachRoomIsSeenThroughItsDoorway) {
    const PracticeRoom room = flatOfTwo();
    for (const double door : {2.0, 6.0}) {
        EXPECT_GT(room.cast({door, 0.7, 1.3}, Vector3d(0, 1, 0), kPixel).rangeM, 2);
        const Vector3d lintel(door, 1.4, 2.3);
        const Vector3d eye(door, 0.7, 1.3);
        EXPECT_NEAR(room.cast(eye, lintel - eye, kPixel).rangeM, (lintel - eye).norm(), 1e-9);
    }
}

TEST(Flat, ItsWallsAreObstaclesOfThePlan) {
    const RoomPlan plan = flatOfTwo().plan();
    const auto isWall = [&](const Eigen::Vector2d& at) {
        return std::any_of(plan.obstacles.begin(), plan.obstacles.end(),
                           [&](const Polygon& obstacle) { return contains(obstacle, at); });
    };
    EXPECT_TRUE(isWall({4, 3}));
    EXPECT_TRUE(isWall({0.5, 1.45}));
    EXPECT_FALSE(isWall({2, 1.45})) << "a doorway";
    EXPECT_FALSE(isWall({6, 1.45})) << "a doorway";
}

TEST(Flat, NeedsSpaceForTwoRooms) {
    test::expectError(ErrorKind::InvalidInput, "a flat needs", [] { roomOf(RoomStyle::Flat, {5, 4, 2.6}); });
}

} // namespace
} // namespace spherewalk::practice
