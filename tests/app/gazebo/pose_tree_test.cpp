// SPDX-License-Identifier: GPL-3.0-or-later
#include "pose_tree.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace spherewalk::gazebo {
namespace {

using namespace std::chrono_literals;
using simulator::Stamp;
using testing::HasSubstr;

NamedPose at(const std::string& parent, const std::string& child, Stamp stamp, double x) {
    return {child, parent, stamp, {Eigen::Quaterniond::Identity(), Eigen::Vector3d(x, 0, 0)}};
}

/// Where the message puts the frame, along x.
std::optional<double> x(PoseTree& tree, const std::vector<NamedPose>& poses) {
    const std::optional<Rigid3> pose = tree.add(poses);
    return pose ? std::optional(pose->translation.x()) : std::nullopt;
}

TEST(PoseTree, PutsAScopedFrameTogetherOnceAllOfItsStampHasCome) {
    PoseTree tree("robot::base::eye");
    EXPECT_FALSE(x(tree, {at("robot::base", "robot::base::eye", 1s, 1)}));
    EXPECT_FALSE(x(tree, {at("robot", "robot::base", 1s, 10)}));
    EXPECT_FALSE(x(tree, {at("robot", "robot::wheel", 1s, 7)}));
    EXPECT_EQ(x(tree, {at("world", "robot", 1s, 100)}), 111);
    EXPECT_FALSE(x(tree, {at("robot::base", "robot::base::eye", 2s, 2)}));
    EXPECT_FALSE(x(tree, {at("robot", "robot::base", 2s, 20)}));
    EXPECT_EQ(x(tree, {at("world", "robot", 2s, 200)}), 222);
    EXPECT_EQ(tree.missedSteps(), 0U);
}

TEST(PoseTree, RotationsAreComposedFromTheWorldInwards) {
    PoseTree tree("robot::eye");
    NamedPose robot = at("world", "robot", 1s, 5);
    robot.parentFromChild.rotation = Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ());
    const auto pose = tree.add({robot, at("robot", "robot::eye", 1s, 1)});
    ASSERT_TRUE(pose);
    EXPECT_TRUE(pose->translation.isApprox(Eigen::Vector3d(5, 1, 0)));
}

TEST(PoseTree, WhatDoesNotMoveNeedNotComeAgain) {
    PoseTree tree("robot::eye");
    EXPECT_FALSE(x(tree, {at("robot", "robot::eye", 0s, 1)}));
    EXPECT_EQ(x(tree, {at("world", "robot", 1s, 100)}), std::nullopt); // the eye may still come
    EXPECT_EQ(x(tree, {at("world", "robot", 2s, 200)}), 201);
    EXPECT_EQ(x(tree, {at("world", "robot", 3s, 300)}), 301);
    EXPECT_EQ(x(tree, {at("world", "robot", 3s, 300)}), std::nullopt);
}

TEST(PoseTree, AModelWhosePlaceIsUnknownIsNotTheWorld) {
    PoseTree tree("robot::eye");
    for (int i = 1; i < 6; ++i) {
        EXPECT_FALSE(x(tree, {at("robot", "robot::eye", i * 1s, 1)}));
    }
    EXPECT_EQ(tree.missedSteps(), 4U);
    EXPECT_THAT(tree.trouble(), HasSubstr("publish the model's pose"));
}

TEST(PoseTree, BareNamesAreFoundScopeByScope) {
    PoseTree tree("robot::eye");
    EXPECT_EQ(x(tree, {at("", "eye", 1s, 1), at("", "robot", 1s, 10), at("", "table", 1s, 3)}), 11);
}

TEST(PoseTree, OfTwoOfTheSameBareNameNoneIsTaken) {
    PoseTree tree("robot::eye");
    for (int i = 1; i < 4; ++i) {
        EXPECT_FALSE(
            x(tree, {at("", "eye", i * 1s, 1), at("", "eye", i * 1s, 2), at("", "robot", i * 1s, 10)}));
    }
    EXPECT_THAT(tree.trouble(), HasSubstr("More than one thing is called eye"));
}

TEST(PoseTree, TimeThatGoesBackBeginsAnew) {
    PoseTree tree("eye");
    EXPECT_EQ(x(tree, {at("world", "eye", 5s, 1)}), 1);
    EXPECT_EQ(x(tree, {at("world", "eye", 1s, 2)}), 2);
}

TEST(PoseTree, RingsOfParentsAndEndlessNamesDoNoHarm) {
    PoseTree tree("a");
    EXPECT_FALSE(x(tree, {at("b", "a", 1s, 1), at("a", "b", 1s, 1)}));
    for (int i = 0; i < 20'000; ++i) {
        tree.add({at("world", std::to_string(i), 2s, 1)});
    }
    EXPECT_EQ(x(tree, {at("world", "a", 3s, 4)}), 4);
}

} // namespace
} // namespace spherewalk::gazebo
