// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera/transform_tree.h"
#include "random.h"

#include "spherewalk/geometry/rotation.h"

#include <gtest/gtest.h>

#include <limits>

namespace spherewalk::ros {

using namespace std::chrono_literals;
using simulator::Refusal;

namespace {

Rigid3 shifted(double x, double y = 0, double z = 0) {
    return {Eigen::Quaterniond::Identity(), {x, y, z}};
}

Rigid3 turned(double yawRad) {
    return {yawRotation(Radians(yawRad)), Eigen::Vector3d::Zero()};
}

class TransformTreeTest : public testing::Test {
  protected:
    void put(const char* parent, const char* child, Stamp stamp, const Rigid3& pose, bool isStatic = false) {
        const auto refused = tree.put({parent, child, stamp, pose}, isStatic);
        EXPECT_FALSE(refused) << refused->sentence;
    }

    void expectRefused(Refusal kind, const Transform& transform) {
        const auto refused = tree.put(transform, false);
        ASSERT_TRUE(refused);
        EXPECT_EQ(refused->kind, kind) << refused->sentence;
    }

    TransformTree tree;
};

} // namespace

TEST_F(TransformTreeTest, ComposesUpwardsAndDownwards) {
    put("world", "map", 0s, shifted(10), true);
    put("world", "odom", 1s, turned(std::numbers::pi / 2));
    put("odom", "camera", 1s, shifted(1));
    ASSERT_EQ(tree.newest("map", "camera"), 1s);
    const auto pose = tree.at("map", "camera", 1s);
    ASSERT_TRUE(pose);
    EXPECT_TRUE(pose->translation.isApprox(Eigen::Vector3d(-10, 1, 0), 1e-12)) << pose->translation;
    const auto back = tree.at("camera", "map", 1s);
    EXPECT_TRUE((*back * pose->translation).isZero(1e-12));
}

TEST_F(TransformTreeTest, KnowsTheNewestTimeOfAllThatMoves) {
    put("map", "odom", 1s, shifted(1));
    put("odom", "base", 1s, shifted(1));
    put("odom", "base", 1200ms, shifted(2));
    put("base", "camera", 0s, shifted(0, 0, 1), true);
    EXPECT_EQ(tree.newest("map", "camera"), 1s);
    put("map", "odom", 1100ms, shifted(2));
    EXPECT_EQ(tree.newest("map", "camera"), 1100ms);
    const auto pose = tree.at("map", "camera", 1100ms);
    ASSERT_TRUE(pose);
    EXPECT_TRUE(pose->translation.isApprox(Eigen::Vector3d(3.5, 0, 1), 1e-12)) << "half way between two";
    EXPECT_FALSE(tree.at("map", "camera", 1200ms)) << "nothing is foretold";
    EXPECT_FALSE(tree.at("map", "camera", 999ms));
}

TEST_F(TransformTreeTest, WhatStandsStillIsKnownAtAnyTime) {
    put("map", "camera", 5s, shifted(1), true);
    EXPECT_EQ(tree.newest("map", "camera"), Stamp::max());
    EXPECT_TRUE(tree.at("map", "camera", 0s));
    EXPECT_EQ(tree.newest("map", "map"), Stamp::max());
}

TEST_F(TransformTreeTest, FramesThatAreNotConnectedHaveNoPose) {
    put("map", "base", 1s, shifted(1));
    put("other", "camera", 1s, shifted(1));
    EXPECT_FALSE(tree.newest("map", "camera"));
    EXPECT_FALSE(tree.newest("map", "unknown"));
    EXPECT_FALSE(tree.at("map", "camera", 1s));
}

TEST_F(TransformTreeTest, OfARingTheNewestHolds) {
    put("map", "base", 1s, shifted(1));
    put("base", "camera", 1s, shifted(1));
    put("camera", "map", 2s, shifted(5));
    EXPECT_EQ(tree.at("map", "camera", 2s)->translation.x(), -5);
    put("map", "base", 3s, shifted(1));
    put("base", "camera", 3s, shifted(1));
    EXPECT_EQ(tree.at("map", "camera", 3s)->translation.x(), 2);
}

TEST_F(TransformTreeTest, BeginsAnewWhenTimeGoesBack) {
    put("map", "camera", 100s, shifted(1));
    put("map", "camera", 99500ms, shifted(2));
    EXPECT_EQ(tree.newest("map", "camera"), 100s) << "merely late";
    put("map", "camera", 1s, shifted(3));
    EXPECT_EQ(tree.newest("map", "camera"), 1s) << "a reset";
}

TEST_F(TransformTreeTest, ForgetsWhatIsOld) {
    for (int second = 0; second <= 20; ++second) {
        put("map", "camera", std::chrono::seconds(second), shifted(second));
    }
    EXPECT_TRUE(tree.at("map", "camera", 10s));
    EXPECT_FALSE(tree.at("map", "camera", 9s));
}

TEST_F(TransformTreeTest, TakesNamesWithASlashInFront) {
    put("/map", "/camera", 1s, shifted(1));
    EXPECT_TRUE(tree.at("map", "camera", 1s));
}

TEST_F(TransformTreeTest, RefusesWhatIsNone) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    expectRefused(Refusal::Place, {"map", "camera", 1s, shifted(kNan)});
    expectRefused(Refusal::Place, {"map", "camera", 1s, shifted(std::numeric_limits<double>::infinity())});
    expectRefused(Refusal::Rotation, {"map", "camera", 1s, {{kNan, 0, 0, 0}, {0, 0, 0}}});
    expectRefused(Refusal::Rotation, {"map", "camera", 1s, {{0, 0, 0, 0}, {0, 0, 0}}});
    expectRefused(Refusal::Time, {"map", "camera", -1ns, shifted(1)});
    expectRefused(Refusal::FrameId, {"", "camera", 1s, shifted(1)});
    expectRefused(Refusal::FrameId, {"/", "camera", 1s, shifted(1)});
    expectRefused(Refusal::FrameId, {"camera", "/camera", 1s, shifted(1)});
    EXPECT_FALSE(tree.newest("map", "camera"));
}

TEST_F(TransformTreeTest, DoesNotGrowForEver) {
    for (int i = 0; i < 10000; ++i) {
        put("map", ("f" + std::to_string(i)).c_str(), 1s, shifted(1));
    }
    expectRefused(Refusal::FrameId, {"map", "one more", 1s, shifted(1)});
    put("map", "f7", 2s, shifted(1));
}

} // namespace spherewalk::ros
