// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"

#include "spherewalk/render/scene_depth.h"

#include <gtest/gtest.h>

#include <cmath>

namespace spherewalk::render {

namespace {

const RoomShape kBox{{{0, 0}, {4, 0}, {4, 3}, {0, 3}}, 0, 2.5};

} // namespace

TEST(RoomShape, IsAsFarAsItsNearestSide) {
    const Eigen::Vector3d from(1, 1, 1);
    EXPECT_NEAR(inverseDistance(kBox, from, {1, 0, 0}), 1 / 3.0, 1e-12);
    EXPECT_NEAR(inverseDistance(kBox, from, {0, 2, 0}), 1 / 2.0, 1e-12);
    EXPECT_NEAR(inverseDistance(kBox, from, {0, 0, -1}), 1, 1e-12);
    EXPECT_NEAR(inverseDistance(kBox, from, {0, 0, 1}), 1 / 1.5, 1e-12);
}

TEST(RoomShape, IsFiniteFromAWallACornerAndOutside) {
    for (const Eigen::Vector3d& from : {Eigen::Vector3d(0, 1, 1), Eigen::Vector3d(0, 0, 0),
                                        Eigen::Vector3d(9, 9, 1), Eigen::Vector3d(1, 1, 9)}) {
        const DepthMap map = roomDepth(kBox, {Eigen::Quaterniond::Identity(), from}, 64);
        for (const float value : map.inverseM().values()) {
            EXPECT_TRUE(std::isfinite(value) && value > 0);
        }
    }
}

TEST(RoomShape, RefusesWhatIsNoRoom) {
    test::expectError(ErrorKind::InvalidInput, "three corners", [] {
        RoomShape{{{0, 0}, {1, 0}}, 0, 2}.validate();
    });
    test::expectError(ErrorKind::InvalidInput, "above its floor", [] {
        RoomShape{{{0, 0}, {1, 0}, {0, 1}}, 2, 1}.validate();
    });
}

} // namespace spherewalk::render
