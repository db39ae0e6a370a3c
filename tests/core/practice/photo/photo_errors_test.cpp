// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"

#include "spherewalk/geometry/rotation.h"
#include "spherewalk/practice/practice_camera.h"

#include <cmath>
#include <numbers>

namespace spherewalk::practice {
namespace {

TEST(PhotoErrors, HaveTheSpreadThatWasAsked) {
    PhotoErrors errors;
    errors.seed = 11;
    const Eigen::Vector3d nominal(1, 2, 3);
    constexpr int kShots = 4000;
    double pitch = 0;
    double roll = 0;
    double shift = 0;
    std::array<int, 8> octants{};
    for (int shot = 1; shot <= kShots; ++shot) {
        const Rigid3 pose = errors.truePose(nominal, shot);
        const YawPitchRoll angles = yawPitchRoll(pose.rotation);
        pitch += angles.pitch.value() * angles.pitch.value();
        roll += angles.roll.value() * angles.roll.value();
        shift += (pose.translation - nominal).squaredNorm();
        const double turn = (angles.yaw.value() + std::numbers::pi) / (2 * std::numbers::pi);
        ++octants[std::min<std::size_t>(7, std::size_t(turn * 8))];
    }
    EXPECT_NEAR(Degrees(Radians(std::sqrt(pitch / kShots))).value(), 0.5, 0.03);
    EXPECT_NEAR(Degrees(Radians(std::sqrt(roll / kShots))).value(), 0.5, 0.03);
    EXPECT_NEAR(std::sqrt(shift / kShots / 3), 0.003, 0.0002);
    for (const int count : octants) {
        EXPECT_NEAR(count, kShots / 8, 100);
    }
}

TEST(PhotoErrors, DependOnSeedAndShotAlone) {
    PhotoErrors errors;
    const Rigid3 first = errors.truePose({0, 0, 0}, 7);
    EXPECT_EQ(errors.truePose({0, 0, 0}, 7).translation, first.translation);
    EXPECT_NE(errors.truePose({0, 0, 0}, 8).translation, first.translation);
    errors.seed = 2;
    EXPECT_NE(errors.truePose({0, 0, 0}, 7).translation, first.translation);
}

TEST(PhotoErrors, OfZeroLeaveThePoseAlone) {
    PhotoErrors errors;
    errors.anyYaw = false;
    errors.tiltSigma = Radians(0);
    errors.positionSigmaM = 0;
    const Rigid3 pose = errors.truePose({1e6, 2, 3}, 3);
    EXPECT_EQ(pose.translation, Eigen::Vector3d(1e6, 2, 3));
    EXPECT_EQ(angleBetween(pose.rotation, Eigen::Quaterniond::Identity()).value(), 0);
}

} // namespace
} // namespace spherewalk::practice
