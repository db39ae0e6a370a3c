// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "random.h"
#include "room/picture_comparison.h"

#include "spherewalk/geometry/rotation.h"
#include "spherewalk/practice/practice_room.h"

#include <algorithm>
#include <numbers>

namespace spherewalk::practice {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;
using test::psnr;

constexpr EquirectSize kSmall{512, 256};

const PracticeRoom& room() {
    static const PracticeRoom shared;
    return shared;
}

/// Where every direction sees something.
Rigid3 middle() {
    return {rotation({Radians(0.7), Radians(0.02), Radians(-0.03)}), {2.1, 1.8, 1.2}};
}

Rigid3 opticalPose(const Vector3d& position, double yaw, double pitch) {
    return {rotation({Radians(yaw), Radians(pitch), Radians(0)}) * bodyFromOptical(), position};
}

TEST(PracticeRoom, FloorCeilingAndWallsAreWhereTheOptionsSay) {
    // Straight up, and through spots of the walls that nothing covers.
    EXPECT_NEAR(room().cast({2.1, 3.1, 1.2}, Vector3d::UnitZ(), 1e-3).rangeM, 1.4, 1e-12);
    EXPECT_NEAR(room().cast({2.1, 3.1, 1.2}, -Vector3d::UnitZ(), 1e-3).rangeM, 1.2, 1e-12);
    EXPECT_NEAR(room().cast({2.1, 1.8, 2.4}, Vector3d::UnitX(), 1e-3).rangeM, 2.9, 1e-12);
    EXPECT_NEAR(room().cast({2.1, 1.8, 2.4}, -Vector3d::UnitX(), 1e-3).rangeM, 2.1, 1e-12);
    EXPECT_NEAR(room().cast({2.1, 1.8, 2.4}, Vector3d::UnitY(), 1e-3).rangeM, 2.2, 1e-12);
    EXPECT_NEAR(room().cast({2.1, 1.8, 2.4}, -Vector3d::UnitY(), 1e-3).rangeM, 1.8, 1e-12);
    const Vector3d slanted = Vector3d(1, 0, 1).normalized();
    EXPECT_NEAR(room().cast({2.1, 3.1, 1.2}, slanted, 1e-3).rangeM, 1.4 * std::sqrt(2.0), 1e-12);
}

TEST(PracticeRoom, ObjectsAreMetAtTheirAnalyticDistance) {
    PracticeRoomOptions options;
    options.objects = {
        {PracticeObject::Shape::Sphere, {2.5, 1.0, 1.2}, {0.2, 0.2, 0.2}, {}, {255, 0, 0}},
        {PracticeObject::Shape::Box, {1.2, 2.2, 1.2}, {0.1, 0.3, 0.2}, Radians(pi / 6), {0, 255, 0}}};
    const PracticeRoom withObjects(options);
    const Vector3d eye(2.1, 1.8, 1.2);
    const Vector3d towards = Vector3d(2.5, 1.0, 1.2) - eye;
    EXPECT_NEAR(withObjects.cast(eye, towards, 1e-3).rangeM, towards.norm() - 0.2, 1e-12);
    // The box's +x face, seen along its own normal.
    const Vector3d normal(std::cos(pi / 6), std::sin(pi / 6), 0);
    const Vector3d before = Vector3d(1.2, 2.2, 1.2) + 0.75 * normal;
    EXPECT_NEAR(withObjects.cast(before, -normal, 1e-3).rangeM, 0.65, 1e-12);
    EXPECT_EQ(withObjects.cast(before, normal, 1e-3, Content::Objects).rangeM,
              std::numeric_limits<double>::infinity());
}

TEST(PracticeRoom, AWalkIsClearOfFurnitureAndGoesThroughDoors) {
    PracticeRoomOptions options;
    options.style = RoomStyle::Flat;
    options.sizeM = {8, 6, 2.5};
    const PracticeRoom flat(options);
    const std::vector<Eigen::Vector3d> walk = walkThrough(flat, 0.5, 1.2);
    ASSERT_GT(walk.size(), 40U);
    int throughWalls = 0;
    double wayM = 0;
    for (std::size_t i = 0; i < walk.size(); ++i) {
        EXPECT_GT(flat.surfaceDistanceM(walk[i]), 0.3);
        EXPECT_EQ(std::ranges::count(walk, walk[i]), 1);
        if (i > 0) {
            const Eigen::Vector3d step = walk[i] - walk[i - 1];
            wayM += step.norm() / static_cast<double>(walk.size() - 1);
            throughWalls += flat.cast(walk[i - 1], step, 1e-3).rangeM < step.norm() ? 1 : 0;
        }
    }
    EXPECT_LT(wayM, 0.8);
    EXPECT_LT(throughWalls, 4);
}

TEST(PracticeRoom, ViewDepthIsTheRangeAlongTheAxis) {
    CameraIntrinsics intrinsics = CameraIntrinsics::pinhole(64, 48, 1.3);
    intrinsics.lens = LensModel::PlumbBob;
    intrinsics.distortion = {-0.2, 0.05, 0.001, -0.002, 0.0};
    const CameraModel camera(intrinsics);
    const Rigid3 pose = opticalPose({2.1, 1.8, 1.3}, 2.3, 0.2);
    const DepthImage depth = room().viewDepth(camera, pose);
    for (int y = 0; y < 48; y += 5) {
        for (int x = 0; x < 64; x += 5) {
            const auto ray = camera.ray({x, y});
            ASSERT_TRUE(ray);
            const double range = room().cast(pose.translation, pose.rotation * *ray, 1e-3).rangeM;
            EXPECT_NEAR(*depth.at(x, y), range * ray->z(), 1e-6 * range) << x << ", " << y;
        }
    }
}

TEST(PracticeRoom, SphericalRangeFollowsTheEquirectangularConvention) {
    const Rigid3 pose = middle();
    const DepthImage range = room().sphericalRange(pose, kSmall);
    for (int y = 3; y < kSmall.height; y += 31) {
        for (int x = 5; x < kSmall.width; x += 37) {
            const Vector3d ray = pose.rotation * direction(kSmall, {x, y});
            EXPECT_NEAR(*range.at(x, y), room().cast(pose.translation, ray, 1e-3).rangeM, 1e-5)
                << x << ", " << y;
        }
    }
}

TEST(PracticeRoom, AColouredBallLandsOnThePixelOfItsDirection) {
    test::Random random(4);
    SCOPED_TRACE(random.seed());
    for (int i = 0; i < 8; ++i) {
        const Vector3d eye(2.1, 1.8, 1.2);
        PracticeRoomOptions options;
        PracticeObject ball;
        ball.centreM = eye + 0.7 * random.direction();
        ball.halfSizeM = {0.04, 0.04, 0.04};
        ball.colour = {0, 0, 255};
        options.objects = {ball};
        const PracticeRoom withBall(options);
        const Rigid3 pose{random.rotation(), eye};
        const RgbImage with = withBall.spherical(pose, kSmall);
        const RgbImage without = withBall.spherical(pose, kSmall, {Content::Room, 0});
        // The centre of what changed, as directions: no trouble at the seam or the poles.
        Vector3d sum = Vector3d::Zero();
        for (int y = 0; y < kSmall.height; ++y) {
            for (int x = 0; x < kSmall.width; ++x) {
                if (!std::equal(with.at(x, y), with.at(x, y) + 3, without.at(x, y))) {
                    sum += direction(kSmall, {x, y}) * std::sin(pi * (y + 0.5) / kSmall.height);
                }
            }
        }
        const Vector3d expected = pose.rotation.conjugate() * (ball.centreM - eye);
        EXPECT_LT(Degrees(angleBetween(sum, expected)).value(), 0.5) << i;
    }
}

TEST(PracticeRoom, ViewAgreesWithTheSphericalPictureAndNoOtherConventionDoes) {
    const Rigid3 photo = middle();
    const RgbImage sphere = room().spherical(photo, {2048, 1024});
    const CameraModel camera(CameraIntrinsics::pinhole(160, 120, 1.2));
    const Rigid3 pose = opticalPose(photo.translation, 2.8, 0.25);
    const RgbImage seen = room().view(camera, pose);
    const auto resampled = [&](const Eigen::Matrix3d& wrong) {
        RgbImage picture(160, 120);
        for (int y = 0; y < 120; ++y) {
            for (int x = 0; x < 160; ++x) {
                std::array<double, 3> sum{};
                for (int k = 0; k < 9; ++k) {
                    const Vector3d ray = *camera.ray({x + (k % 3 - 1) / 3.0, y + (k / 3 - 1) / 3.0});
                    const Vector3d inPhoto = photo.rotation.conjugate() * (pose.rotation * (wrong * ray));
                    const auto colour = test::sampled(sphere, inPhoto);
                    for (std::size_t c = 0; c < 3; ++c) {
                        sum[c] += colour[c] / 9;
                    }
                }
                for (int c = 0; c < 3; ++c) {
                    picture.at(x, y)[c] = static_cast<std::uint8_t>(sum[std::size_t(c)] + 0.5);
                }
            }
        }
        return picture;
    };
    EXPECT_GT(psnr(resampled(Eigen::Matrix3d::Identity()), seen), 36);
    EXPECT_LT(psnr(resampled(Vector3d(-1, 1, 1).asDiagonal()), seen), 20) << "mirrored";
    EXPECT_LT(psnr(resampled(Vector3d(-1, 1, -1).asDiagonal()), seen), 20) << "turned by 180 degrees";
    EXPECT_LT(psnr(resampled(Vector3d(-1, -1, 1).asDiagonal()), seen), 20) << "upside down";
}

TEST(PracticeRoom, PicturesAreTheSameForAnyNumberOfThreads) {
    const CameraModel camera(CameraIntrinsics::pinhole(200, 150, 1.5));
    const Rigid3 pose = opticalPose({2.1, 1.8, 1.3}, 0.4, 0.1);
    const RgbImage sphere = room().spherical(middle(), kSmall, {Content::Room, 1});
    const RgbImage seen = room().view(camera, pose, {Content::Room, 1});
    for (const int threads : {2, 3}) {
        EXPECT_EQ(room().spherical(middle(), kSmall, {Content::Room, threads}), sphere) << threads;
        EXPECT_EQ(room().view(camera, pose, {Content::Room, threads}), seen) << threads;
    }
}

TEST(PracticeRoom, ARoomFarAwayLooksTheSame) {
    const Vector3d far(1e6, -2e6, 35);
    PracticeRoomOptions options;
    options.originM = far;
    const PracticeRoom farRoom(options);
    Rigid3 pose = middle();
    const RgbImage here = room().spherical(pose, kSmall);
    const DepthImage rangeHere = room().sphericalRange(pose, kSmall);
    pose.translation += far;
    EXPECT_GT(psnr(farRoom.spherical(pose, kSmall), here), 60);
    const DepthImage rangeThere = farRoom.sphericalRange(pose, kSmall);
    int different = 0;
    for (std::size_t i = 0; i < rangeHere.values().size(); ++i) {
        different += std::abs(rangeThere.values()[i] - rangeHere.values()[i]) > 1e-6F ? 1 : 0;
    }
    EXPECT_LT(different, 5); // a ray that grazes an edge may fall to its other side
}

TEST(PracticeRoom, PixelsAreAveragesOfTheirAreas) {
    const RgbImage coarse = room().spherical(middle(), {1024, 512});
    const RgbImage fine = test::reduced(room().spherical(middle(), {4096, 2048}), 4);
    EXPECT_GT(psnr(coarse, fine), 38);
}

TEST(PracticeRoom, SeamAndPolesAreLikeAnyOtherPlace) {
    // Turned by half a picture, the seam falls where the middle was.
    const Rigid3 pose = middle();
    Rigid3 turned = pose;
    turned.rotation = pose.rotation * yawRotation(Radians(pi));
    const RgbImage first = room().spherical(pose, kSmall);
    const RgbImage second = room().spherical(turned, kSmall);
    RgbImage rolled(kSmall.width, kSmall.height);
    for (int y = 0; y < kSmall.height; ++y) {
        for (int x = 0; x < kSmall.width; ++x) {
            std::copy_n(second.at((x + kSmall.width / 2) % kSmall.width, y), 3, rolled.at(x, y));
        }
    }
    EXPECT_GT(psnr(rolled, first), 45);
    // At a pole all pixels of the row see nearly the same spot.
    for (const int y : {0, kSmall.height - 1}) {
        for (int x = 0; x < kSmall.width; ++x) {
            const int next = (x + 1) % kSmall.width;
            for (int c = 0; c < 3; ++c) {
                EXPECT_LE(std::abs(first.at(x, y)[c] - first.at(next, y)[c]), 24) << x << ", " << y;
            }
        }
    }
}

TEST(PracticeRoom, AnObjectChangesNoPixelBesidesItsOwn) {
    PracticeRoomOptions options;
    PracticeObject box;
    box.shape = PracticeObject::Shape::Box;
    box.centreM = {3.0, 2.2, 0.9};
    box.halfSizeM = {0.15, 0.1, 0.2};
    options.objects = {box};
    const PracticeRoom withBox(options);
    const CameraModel camera(CameraIntrinsics::pinhole(200, 150, 1.2));
    const Rigid3 pose = opticalPose({1.6, 1.9, 1.2}, 0.1, 0.1);
    const RgbImage with = withBox.view(camera, pose);
    const RgbImage without = withBox.view(camera, pose, {Content::Room, 0});
    const DepthImage ownDepth = withBox.viewDepth(camera, pose, {Content::Objects, 0});
    const DepthImage allDepth = withBox.viewDepth(camera, pose);
    int covered = 0;
    for (int y = 1; y + 1 < 150; ++y) {
        for (int x = 1; x + 1 < 200; ++x) {
            const bool isObject = std::isfinite(*ownDepth.at(x, y));
            covered += isObject ? 1 : 0;
            bool isNear = isObject;
            for (const auto& [dx, dy] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
                isNear = isNear || std::isfinite(*ownDepth.at(x + dx, y + dy));
            }
            if (isObject) {
                EXPECT_LE(*allDepth.at(x, y), *ownDepth.at(x, y));
            }
            if (!isNear) {
                EXPECT_TRUE(std::equal(with.at(x, y), with.at(x, y) + 3, without.at(x, y))) << x << ", " << y;
            }
        }
    }
    EXPECT_GT(covered, 300);
}

TEST(PracticeRoom, PlanHoldsUsableFurnitureAndAFreeMiddle) {
    PracticeRoomOptions options;
    options.originM = {100, 50, 0};
    const RoomPlan plan = PracticeRoom(options).plan();
    EXPECT_FALSE(defect(plan.outline));
    EXPECT_NEAR(signedArea(plan.outline), 20, 1e-9);
    EXPECT_EQ(plan.ceilingM, 2.6);
    EXPECT_GE(plan.obstacles.size(), 8U);
    for (const Polygon& obstacle : plan.obstacles) {
        EXPECT_FALSE(defect(obstacle));
        EXPECT_FALSE(contains(obstacle, {102.0, 51.9}));
        for (const Eigen::Vector2d& vertex : obstacle) {
            EXPECT_TRUE(contains(plan.outline, vertex));
        }
    }
}

TEST(PracticeRoom, RefusesWhatCannotBeARoom) {
    PracticeRoomOptions options;
    options.sizeM = {1, 4, 2.6};
    test::expectError(ErrorKind::InvalidInput, "size", [&] { PracticeRoom{options}; });
    options = {};
    options.originM.x() = std::numeric_limits<double>::quiet_NaN();
    test::expectError(ErrorKind::InvalidInput, "corner", [&] { PracticeRoom{options}; });
    options = {};
    options.objects.resize(1);
    options.objects[0].centreM = {-1, 1, 1};
    test::expectError(ErrorKind::InvalidInput, "object", [&] { PracticeRoom{options}; });
}

TEST(PracticeRoom, RefusesPicturesWithoutASize) {
    test::expectError(ErrorKind::InvalidInput, "pixels", [] { room().spherical(middle(), {0, 256}); });
    test::expectError(ErrorKind::InvalidInput, "pixels", [] { room().sphericalRange(middle(), {512, -1}); });
}

TEST(PracticeRoom, DrawingStopsWhenAsked) {
    std::stop_source stop;
    stop.request_stop();
    test::expectError(ErrorKind::Stopped, "",
                      [&] { room().spherical(middle(), kSmall, {}, noProgress(), stop.get_token()); });
}

TEST(PracticeRoom, RaysFromOutsideAndFromWallsGiveNumbers) {
    test::Random random(7);
    SCOPED_TRACE(random.seed());
    for (int i = 0; i < 2000; ++i) {
        Vector3d eye(random.uniform(-1, 6), random.uniform(-1, 5), random.uniform(-1, 4));
        if (i % 3 == 0) {
            eye[i % 2] = 0; // on a wall
        }
        Vector3d ray = random.direction();
        ray[i % 3] = i % 5 == 0 ? 0 : ray[i % 3];
        const Sample sample = room().cast(eye, ray, 1e-3);
        EXPECT_FALSE(std::isnan(sample.rangeM));
        EXPECT_GE(sample.rangeM, 0);
        for (const float channel : sample.colour) {
            EXPECT_TRUE(channel >= 0 && channel <= 255) << channel;
        }
    }
}

} // namespace

TEST(PracticeRoom, ABallThatCastsAShadowDarkensWhatIsNear) {
    PracticeRoomOptions options;
    PracticeObject ball;
    ball.centreM = {2.5, 2.0, 0.08};
    ball.halfSizeM = Eigen::Vector3d::Constant(0.08);
    options.objects = {ball};
    const PracticeRoom without(options);
    options.objects.front().castsShadow = true;
    const PracticeRoom with(options);
    const auto onFloor = [](const PracticeRoom& room, double x) {
        const Eigen::Vector3d eye(x, 2.6, 1.2);
        return room.cast(eye, Eigen::Vector3d(x, 2.0, 0) - eye, 0.002).colour[1];
    };
    EXPECT_LT(onFloor(with, 2.4), 0.95F * onFloor(without, 2.4));
    EXPECT_LT(onFloor(with, 2.4), onFloor(with, 2.3) - onFloor(without, 2.3) + onFloor(without, 2.4));
    EXPECT_EQ(onFloor(with, 0.4), onFloor(without, 0.4)); // too far away
    options.objects.front().shape = PracticeObject::Shape::Box;
    test::expectError(ErrorKind::InvalidInput, "only spheres can cast shadows",
                      [&] { PracticeRoom room(options); });
}

} // namespace spherewalk::practice
