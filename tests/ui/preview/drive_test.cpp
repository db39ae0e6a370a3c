// SPDX-License-Identifier: GPL-3.0-or-later
#include "random.h"
#include "ui/preview/robot.h"

#include <gtest/gtest.h>

#include <numbers>

namespace spherewalk::ui {

namespace {

const Polygon kRoom{{0, 0}, {4, 0}, {4, 3}, {2, 3}, {2, 1.5}, {0, 1.5}}; // concave
const std::vector<Polygon> kObstacles{{{1, 0.5}, {1.5, 0.5}, {1.5, 1}, {1, 1}}};

} // namespace

TEST(Drive, GoesAheadSidewaysAndRound) {
    const Drive drive;
    const RobotPlace north{{1, 1}, Degrees(90)};
    EXPECT_LT((drive.after(north, {.forward = 1}, 0.5).pInRoom - Eigen::Vector2d(1, 1.4)).norm(), 1e-12);
    EXPECT_LT((drive.after(north, {.left = 1}, 0.5).pInRoom - Eigen::Vector2d(0.6, 1)).norm(), 1e-12);
    EXPECT_NEAR(Degrees(drive.after(north, {.turnLeft = 1}, 2).yaw).value(), -150, 1e-9);
}

TEST(Drive, NeverLeavesTheFloor) {
    test::Random random(91);
    const Drive drive(kRoom, kObstacles);
    RobotPlace robot{{0.5, 0.5}, Radians(0)};
    for (int i = 0; i < 5000; ++i) {
        robot =
            drive.after(robot, {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)}, 0.1);
        ASSERT_TRUE(drive.isFloor(robot.pInRoom)) << i << " seed " << random.seed();
    }
}

TEST(Drive, SlidesAlongAWall) {
    const Drive drive(kRoom, {});
    const RobotPlace robot = drive.after({{3.99, 1}, Degrees(45)}, {.forward = 1}, 0.1);
    EXPECT_EQ(robot.pInRoom.x(), 3.99);
    EXPECT_GT(robot.pInRoom.y(), 1.05);
}

TEST(Drive, LetsARobotOutOfWhereNoFloorIs) {
    const Drive drive(kRoom, kObstacles);
    EXPECT_GT(drive.after({{1.2, 0.7}, Radians(0)}, {.forward = 1}, 0.1).pInRoom.x(), 1.25);
}

TEST(Drive, CarriesTheCameraAtItsHeightLookingDown) {
    const Rigid3 pose = roomFromOptical({{1, 2}, Degrees(90)}, {0.8, Degrees(30)});
    EXPECT_EQ(pose.translation, Eigen::Vector3d(1, 2, 0.8));
    const Eigen::Vector3d ahead = pose.rotation * Eigen::Vector3d::UnitZ();
    EXPECT_LT((ahead - Eigen::Vector3d(0, std::cos(std::numbers::pi / 6), -0.5)).norm(), 1e-12);
    const Eigen::Vector3d right = pose.rotation * Eigen::Vector3d::UnitX();
    EXPECT_LT((right - Eigen::Vector3d(1, 0, 0)).norm(), 1e-12);
}

TEST(CameraMount, ALevelCameraLooksAlongTheHeading) {
    const Rigid3 pose = roomFromOptical({{1, 2}, Degrees(90)}, {1.5, Radians(0)});
    EXPECT_LT((pose.translation - Eigen::Vector3d(1, 2, 1.5)).norm(), 1e-12);
    EXPECT_LT((pose.rotation * Eigen::Vector3d::UnitZ() - Eigen::Vector3d::UnitY()).norm(), 1e-12);
    EXPECT_LT((pose.rotation * Eigen::Vector3d::UnitY() + Eigen::Vector3d::UnitZ()).norm(), 1e-12);
}

TEST(CameraMount, TheCameraTurnsWithTheRobotAndStaysUpright) {
    for (const double heading : {-180.0, -90.0, 0.0, 37.0, 179.9}) {
        const Rigid3 pose = roomFromOptical({{3, -2}, Degrees(heading)}, {0.7, Degrees(20)});
        const Eigen::Vector3d ahead = pose.rotation * Eigen::Vector3d::UnitZ();
        EXPECT_NEAR(std::cos(std::atan2(ahead.y(), ahead.x()) - Radians(Degrees(heading)).value()), 1, 1e-12);
        EXPECT_NEAR((pose.rotation * Eigen::Vector3d::UnitX()).z(), 0, 1e-12) << "the horizon is level";
        EXPECT_NEAR(pose.rotation.norm(), 1, 1e-12);
    }
}

TEST(CameraMount, ATiltedCameraLooksBelowTheHorizon) {
    const Rigid3 pose = roomFromOptical({{0, 0}, Radians(0)}, {1, Degrees(30)});
    EXPECT_NEAR((pose.rotation * Eigen::Vector3d::UnitZ()).z(), -0.5, 1e-12);
}

} // namespace spherewalk::ui
