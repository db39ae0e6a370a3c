// SPDX-License-Identifier: GPL-3.0-or-later
// What holds for rays and pictures of every practice room.
#include "random.h"

#include "spherewalk/practice/practice_room.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace spherewalk::practice {
namespace {

using Eigen::Vector3d;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

PracticeRoomOptions randomRoom(test::Random& random) {
    PracticeRoomOptions options;
    options.originM = random.vector(5);
    options.sizeM = {random.uniform(4, 8), random.uniform(3.5, 8), random.uniform(2.3, 4)};
    return options;
}

std::vector<std::uint8_t> valuesOf(const RgbImage& picture) {
    return {picture.values().begin(), picture.values().end()};
}

/// A place in the free middle of the room.
Vector3d placeIn(const PracticeRoomOptions& options, test::Random& random) {
    const Vector3d share(random.uniform(0.4, 0.6), random.uniform(0.4, 0.6), random.uniform(0.35, 0.6));
    return options.originM + share.cwiseProduct(options.sizeM);
}

/// How far it is to the walls, the floor or the ceiling of the empty room.
double distanceToShell(const PracticeRoomOptions& options, const Vector3d& eye, const Vector3d& direction) {
    double nearest = kInfinity;
    for (int axis = 0; axis < 3; ++axis) {
        const double wall = options.originM[axis] + (direction[axis] > 0 ? options.sizeM[axis] : 0);
        if (direction[axis] != 0) {
            nearest = std::min(nearest, (wall - eye[axis]) / direction[axis]);
        }
    }
    return nearest;
}

TEST(PracticeRoomLaws, NoRayGoesThroughAWall) {
    test::Random random(41);
    SCOPED_TRACE(random.seed());
    for (int i = 0; i < 6; ++i) {
        const PracticeRoomOptions options = randomRoom(random);
        const PracticeRoom room(options);
        int onShell = 0;
        for (int k = 0; k < 400; ++k) {
            const Vector3d eye = placeIn(options, random);
            const Vector3d direction = random.direction();
            const double range = room.cast(eye, direction, 1e-3).rangeM;
            const double shell = distanceToShell(options, eye, direction);
            EXPECT_GT(range, 0);
            EXPECT_LE(range, shell + 1e-9);
            onShell += range > shell - 1e-9 ? 1 : 0;
        }
        EXPECT_GT(onShell, 100) << "most of what one sees is the room itself";
        EXPECT_LT(onShell, 400) << "and some of it furniture";
    }
}

TEST(PracticeRoomLaws, ARayDoesNotDependOnTheLengthOfItsDirection) {
    test::Random random(42);
    SCOPED_TRACE(random.seed());
    const PracticeRoom room;
    for (int i = 0; i < 200; ++i) {
        const Vector3d eye = placeIn(room.options(), random);
        const Vector3d direction = random.direction();
        const Sample one = room.cast(eye, direction, 1e-3);
        const Sample longer = room.cast(eye, direction * random.uniform(0.01, 100), 1e-3);
        EXPECT_NEAR(longer.rangeM, one.rangeM, 1e-9);
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_NEAR(longer.colour[c], one.colour[c], 1e-2);
        }
    }
}

TEST(PracticeRoomLaws, AStepAlongARayShortensItByTheStep) {
    test::Random random(43);
    SCOPED_TRACE(random.seed());
    const PracticeRoom room;
    for (int i = 0; i < 200; ++i) {
        const Vector3d eye = placeIn(room.options(), random);
        const Vector3d direction = random.direction();
        const double range = room.cast(eye, direction, 1e-3).rangeM;
        const double step = random.uniform(0.05, 0.9) * range;
        EXPECT_NEAR(room.cast(eye + step * direction, direction, 1e-3).rangeM, range - step, 1e-9);
    }
}

TEST(PracticeRoomLaws, TheSameOptionsGiveTheSamePicture) {
    test::Random random(44);
    SCOPED_TRACE(random.seed());
    const PracticeRoomOptions options = randomRoom(random);
    const Rigid3 pose{random.rotation(), placeIn(options, random)};
    const RgbImage first = PracticeRoom(options).spherical(pose, {128, 64});
    const RgbImage second = PracticeRoom(options).spherical(pose, {128, 64});
    EXPECT_EQ(valuesOf(first), valuesOf(second));
}

TEST(PracticeRoomLaws, APictureWithoutObjectsIsThatOfTheRoom) {
    test::Random random(45);
    SCOPED_TRACE(random.seed());
    const PracticeRoom room;
    const Rigid3 pose{random.rotation(), placeIn(room.options(), random)};
    EXPECT_EQ(valuesOf(room.spherical(pose, {128, 64})),
              valuesOf(room.spherical(pose, {128, 64}, {Content::Room, 0})));
    const RgbImage objects = room.spherical(pose, {128, 64}, {Content::Objects, 0});
    EXPECT_TRUE(
        std::all_of(objects.values().begin(), objects.values().end(), [](int value) { return value == 0; }));
    const DepthImage range = room.sphericalRange(pose, {64, 32}, {Content::Objects, 0});
    EXPECT_TRUE(
        std::all_of(range.values().begin(), range.values().end(), [](float m) { return m == INFINITY; }));
}

TEST(PracticeRoomLaws, AnObjectHidesWhatIsBehindIt) {
    test::Random random(46);
    SCOPED_TRACE(random.seed());
    PracticeRoomOptions options;
    PracticeObject ball;
    ball.centreM = {2.5, 2, 1.2};
    ball.halfSizeM = Vector3d::Constant(0.15);
    options.objects = {ball};
    const PracticeRoom room(options);
    for (int i = 0; i < 500; ++i) {
        const Vector3d eye = ball.centreM + random.uniform(0.3, 0.8) * random.direction();
        const Vector3d direction = random.direction();
        const double all = room.cast(eye, direction, 1e-3).rangeM;
        const double behind = room.cast(eye, direction, 1e-3, Content::Room).rangeM;
        const double alone = room.cast(eye, direction, 1e-3, Content::Objects).rangeM;
        EXPECT_EQ(all, std::min(behind, alone));
        const double off = (ball.centreM - eye).cross(direction).norm();
        const bool isAhead = (ball.centreM - eye).dot(direction) > 0;
        EXPECT_EQ(alone < kInfinity, isAhead && off < 0.15) << "off by " << off;
    }
}

TEST(PracticeRoomLaws, ALighterColourGivesALighterPixel) {
    const Vector3d eye(2.1, 1.8, 1.2);
    const Vector3d towards(0.4, 0.3, 0);
    std::array<float, 3> last{};
    for (const int shade : {10, 60, 110, 160, 210, 250}) {
        PracticeRoomOptions options;
        PracticeObject box;
        box.shape = PracticeObject::Shape::Box;
        box.centreM = eye + towards;
        const auto value = static_cast<std::uint8_t>(shade);
        box.colour = {value, value, value};
        options.objects = {box};
        const std::array<float, 3> colour = PracticeRoom(options).cast(eye, towards, 1e-3).colour;
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_GT(colour[c], last[c]) << shade;
            EXPECT_LE(colour[c], 255);
        }
        last = colour;
    }
}

TEST(PracticeRoomLaws, FurnitureStandsWhereThePlanSays) {
    test::Random random(47);
    SCOPED_TRACE(random.seed());
    for (int i = 0; i < 4; ++i) {
        const PracticeRoomOptions options = randomRoom(random);
        const PracticeRoom room(options);
        const RoomPlan plan = room.plan();
        EXPECT_NEAR(plan.ceilingM, options.sizeM.z(), 1e-12);
        for (const Polygon& obstacle : plan.obstacles) {
            Eigen::Vector2d middle = Eigen::Vector2d::Zero();
            for (const Eigen::Vector2d& corner : obstacle) {
                middle += corner / static_cast<double>(obstacle.size());
            }
            const Vector3d eye(middle.x(), middle.y(), options.originM.z() + options.sizeM.z() - 0.01);
            const double down = room.cast(eye, -Vector3d::UnitZ(), 1e-3).rangeM;
            EXPECT_LT(down, options.sizeM.z() - 0.02) << "the floor lies under an obstacle";
        }
    }
}

} // namespace
} // namespace spherewalk::practice
