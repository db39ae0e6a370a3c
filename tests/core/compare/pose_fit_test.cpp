// SPDX-License-Identifier: GPL-3.0-or-later
#include "random.h"

#include "spherewalk/compare/pose_fit.h"
#include "spherewalk/geometry/rotation.h"

#include <gtest/gtest.h>

#include <numbers>

namespace spherewalk::compare {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

const CameraModel kCamera(CameraIntrinsics::pinhole(640, 480, 1.0));

Rigid3 anyPose(test::Random& random, const Vector3d& near = Vector3d::Zero()) {
    return {random.rotation(), near + random.vector()};
}

/// The pose, off by about this much.
Rigid3 disturbed(test::Random& random, const Rigid3& pose, double metres, Radians angle) {
    return pose * Rigid3{Eigen::Quaterniond(Eigen::AngleAxisd(angle.value(), random.direction())),
                         metres * random.direction()};
}

/// Points 1 to 5 m away, all over the picture, seen with an error of each pixel coordinate.
std::vector<SeenPoint> points(test::Random& random, const CameraModel& camera, const Rigid3& pose, int count,
                              double sigmaPx) {
    std::vector<SeenPoint> result;
    while (static_cast<int>(result.size()) < count) {
        const Vector2d pixel(random.uniform(0, camera.width() - 1), random.uniform(0, camera.height() - 1));
        if (const auto ray = camera.ray(pixel)) {
            result.push_back({pose * Vector3d(random.uniform(1, 5) * *ray),
                              pixel + sigmaPx * Vector2d(random.normal(), random.normal())});
        }
    }
    return result;
}

double errorM(const PoseFit& fit, const Rigid3& truth) {
    return (fit.roomFromCamera.translation - truth.translation).norm();
}

double errorRad(const PoseFit& fit, const Rigid3& truth) {
    return angleBetween(fit.roomFromCamera.rotation, truth.rotation).value();
}

} // namespace

TEST(PoseFit, FindsThePoseThatPointsWereSeenFrom) {
    test::Random random(1);
    for (int round = 0; round < 10; ++round) {
        const Rigid3 truth = anyPose(random);
        const PoseFit fit = fittedPose(points(random, kCamera, truth, 60, 0), kCamera,
                                       disturbed(random, truth, 0.1, Degrees(5)));
        ASSERT_TRUE(fit.isFitted) << fit.why;
        EXPECT_LT(errorM(fit, truth), 1e-6);
        EXPECT_LT(errorRad(fit, truth), 1e-6);
        EXPECT_EQ(fit.inliers, 60U);
    }
}

TEST(PoseFit, StatesHowFarItMayBeOff) {
    test::Random random(2);
    int isFar = 0;
    constexpr int kRounds = 40;
    for (int round = 0; round < kRounds; ++round) {
        const Rigid3 truth = anyPose(random);
        const PoseFit fit = fittedPose(points(random, kCamera, truth, 80, 1), kCamera,
                                       disturbed(random, truth, 0.1, Degrees(5)));
        ASSERT_TRUE(fit.isFitted) << fit.why;
        EXPECT_LT(errorM(fit, truth), 4 * fit.sigmaPositionM);
        EXPECT_LT(errorRad(fit, truth), 4 * fit.sigmaRotation.value());
        isFar += errorM(fit, truth) > 0.3 * fit.sigmaPositionM ? 1 : 0;
        EXPECT_NEAR(fit.residualPx, 1, 0.3);
    }
    EXPECT_GT(isFar, kRounds / 2); // it is not stated far too large
}

TEST(PoseFit, LeavesWrongPointsOut) {
    test::Random random(3);
    for (int round = 0; round < 10; ++round) {
        const Rigid3 truth = anyPose(random);
        std::vector<SeenPoint> seen = points(random, kCamera, truth, 100, 0.5);
        for (std::size_t i = 0; i < 50; ++i) {
            seen[i].pixel = {random.uniform(0, 639), random.uniform(0, 479)};
        }
        const PoseFit fit = fittedPose(seen, kCamera, disturbed(random, truth, 0.1, Degrees(5)));
        ASSERT_TRUE(fit.isFitted) << fit.why;
        EXPECT_LT(errorM(fit, truth), 0.01);
        EXPECT_LE(fit.inliers, 55U);
    }
}

TEST(PoseFit, IsAsGoodFarFromTheRoomsOrigin) {
    test::Random random(4);
    const Rigid3 truth = anyPose(random, {1e6, -1e6, 0});
    const PoseFit fit =
        fittedPose(points(random, kCamera, truth, 60, 0), kCamera, disturbed(random, truth, 0.1, Degrees(5)));
    ASSERT_TRUE(fit.isFitted) << fit.why;
    EXPECT_LT(errorM(fit, truth), 1e-6);
}

TEST(PoseFit, KnowsLensesThatDistort) {
    test::Random random(5);
    const CameraModel lens({640, 480, 260, 260, 319.5, 239.5, LensModel::Equidistant, {0.05, -0.01, 0, 0}});
    const Rigid3 truth = anyPose(random);
    const PoseFit fit =
        fittedPose(points(random, lens, truth, 80, 0), lens, disturbed(random, truth, 0.1, Degrees(5)));
    ASSERT_TRUE(fit.isFitted) << fit.why;
    EXPECT_LT(errorM(fit, truth), 1e-6);
}

TEST(PoseFit, RefusesTooFewPoints) {
    test::Random random(6);
    const Rigid3 truth = anyPose(random);
    const PoseFit fit = fittedPose(points(random, kCamera, truth, 8, 0), kCamera, truth);
    EXPECT_FALSE(fit.isFitted);
    EXPECT_NE(fit.why.find("Only"), std::string::npos);
    EXPECT_EQ(fit.roomFromCamera.translation, truth.translation);
}

TEST(PoseFit, RefusesPointsThatAgreeOnNothing) {
    test::Random random(7);
    const Rigid3 truth = anyPose(random);
    std::vector<SeenPoint> seen = points(random, kCamera, truth, 100, 0);
    for (SeenPoint& point : seen) {
        point.pixel = {random.uniform(0, 639), random.uniform(0, 479)};
    }
    EXPECT_FALSE(fittedPose(seen, kCamera, truth).isFitted);
}

TEST(PoseFit, RefusesPointsOnOneLine) {
    test::Random random(8);
    const Rigid3 truth{};
    std::vector<SeenPoint> seen;
    for (int i = 0; i < 50; ++i) {
        const Vector3d place(0.01 * i - 0.25, 0.1, 2);
        const Vector2d noise(random.normal(0.3), random.normal(0.3));
        seen.push_back({place, *kCamera.project(place) + noise});
    }
    const PoseFit fit = fittedPose(seen, kCamera, truth);
    EXPECT_FALSE(fit.isFitted);
    EXPECT_FALSE(fit.why.empty());
}

TEST(PoseFit, RefusesPointsThatLieCloseTogether) {
    test::Random random(9);
    const Rigid3 truth{};
    std::vector<SeenPoint> seen;
    for (int i = 0; i < 50; ++i) {
        const Vector3d place = Vector3d(0.3, 0.1, 4) + 0.05 * random.direction();
        seen.push_back({place, *kCamera.project(place) + Vector2d(random.normal(0.5), random.normal(0.5))});
    }
    const PoseFit fit = fittedPose(seen, kCamera, truth);
    EXPECT_FALSE(fit.isFitted);
    EXPECT_FALSE(fit.why.empty());
}

TEST(PoseFit, RefusesAPoseThatIsTooFarFromTheApproximateOne) {
    test::Random random(10);
    const Rigid3 truth = anyPose(random);
    const std::vector<SeenPoint> seen = points(random, kCamera, truth, 60, 0);
    EXPECT_FALSE(
        fittedPose(seen, kCamera, truth * Rigid3{Eigen::Quaterniond::Identity(), {1, 0, 0}}).isFitted);
}

TEST(PoseFit, LeavesOutPointsThatAreNone) {
    test::Random random(11);
    const Rigid3 truth = anyPose(random);
    std::vector<SeenPoint> seen = points(random, kCamera, truth, 60, 0);
    seen.push_back({Vector3d::Constant(std::nan("")), {1, 1}});
    seen.push_back({Vector3d::Zero(), {HUGE_VAL, 1}});
    const PoseFit fit = fittedPose(seen, kCamera, truth);
    ASSERT_TRUE(fit.isFitted) << fit.why;
    EXPECT_EQ(fit.points, 60U);
}

TEST(PlaceShown, IsThePointOfAPlaneAtAnyPartOfAPixel) {
    // A plane that recedes to the right: 1 / z is even over the picture.
    const Rigid3 pose{yawRotation(Degrees(30)), {1, 2, 3}};
    const Vector3d normal = Vector3d(0.5, 0.1, 1).normalized();
    const auto onPlane = [&](const Vector2d& pixel) {
        const Vector3d ray = *kCamera.ray(pixel);
        return Vector3d(2 / normal.dot(ray) * ray);
    };
    DepthImage depth(640, 480);
    for (int y = 0; y < 480; ++y) {
        for (int x = 0; x < 640; ++x) {
            *depth.at(x, y) = static_cast<float>(onPlane(Vector2d(x, y)).z());
        }
    }
    test::Random random(12);
    for (int i = 0; i < 100; ++i) {
        const Vector2d pixel(random.uniform(0, 638.9), random.uniform(0, 478.9));
        const auto place = placeShown(depth, kCamera, pose, pixel);
        ASSERT_TRUE(place);
        EXPECT_LT((*place - pose * onPlane(pixel)).norm(), 1e-5);
    }
}

TEST(PlaceShown, IsNothingWhereDepthJumpsOrIsNotKnown) {
    DepthImage depth(640, 480);
    std::fill(depth.values().begin(), depth.values().end(), 2.0F);
    *depth.at(100, 100) = 3;
    *depth.at(200, 200) = HUGE_VALF;
    EXPECT_TRUE(placeShown(depth, kCamera, {}, {50.5, 50.5}));
    EXPECT_FALSE(placeShown(depth, kCamera, {}, {99.5, 99.5}));
    EXPECT_FALSE(placeShown(depth, kCamera, {}, {200.2, 199.5}));
    EXPECT_FALSE(placeShown(depth, kCamera, {}, {639.5, 3}));
    EXPECT_FALSE(placeShown(depth, kCamera, {}, {-0.5, 3}));
}

} // namespace spherewalk::compare
