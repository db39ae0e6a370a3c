// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/scene/room_fit.h"

#include <gtest/gtest.h>

namespace spherewalk::scene {

namespace {

const render::RoomShape kRoom{{{0, 0}, {4, 0}, {4, 3}, {0, 3}}, 0.0, 2.5};

/// What photos see of the empty room, all of it sure.
struct Photos {
    explicit Photos(const render::RoomShape& room) {
        for (const auto& [x, y] : {std::pair{1.5, 1.2}, {2.5, 1.7}}) {
            poses.push_back({Eigen::Quaterniond::Identity(), {x, y, 1.2}});
            const render::DepthMap map = roomDepth(room, poses.back(), 256);
            depths.push_back({map.inverseM(), map.sure()});
        }
        for (std::size_t i = 0; i < depths.size(); ++i) {
            posed.push_back({&depths[i], poses[i]});
        }
    }

    std::vector<Rigid3> poses;
    std::vector<PhotoDepth> depths;
    std::vector<PosedDepth> posed;
};

void expectRoom(const std::optional<render::RoomShape>& found) {
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->floorM, kRoom.floorM, 0.02);
    EXPECT_NEAR(found->ceilingM, kRoom.ceilingM, 0.02);
    ASSERT_EQ(found->outline.size(), 4U);
    for (const Eigen::Vector2d& corner : kRoom.outline) {
        double nearest = 100;
        for (const Eigen::Vector2d& other : found->outline) {
            nearest = std::min(nearest, (other - corner).norm());
        }
        EXPECT_LT(nearest, 0.04);
    }
}

} // namespace

TEST(RoomFit, FindsTheRoomWithoutADrawnOutline) {
    expectRoom(fittedRoom(Photos(kRoom).posed, {}));
}

TEST(RoomFit, MovesWallsThatWereDrawnAside) {
    expectRoom(fittedRoom(Photos(kRoom).posed, {{0.1, -0.1}, {3.8, -0.1}, {3.8, 3.2}, {0.1, 3.2}}));
}

TEST(RoomFit, FindsNothingWithoutSureDepths) {
    Photos photos(kRoom);
    for (PhotoDepth& depth : photos.depths) {
        depth.sure = MaskImage(256, 128);
    }
    EXPECT_FALSE(fittedRoom(photos.posed, {}));
}

TEST(SphereRadius, OfDepthsIsThatOfTheSphereTheyLieOn) {
    PhotoDepth depth{Image<float, 1>(64, 32), MaskImage(64, 32)};
    std::fill(depth.inverseM.values().begin(), depth.inverseM.values().end(), 0.4F);
    const std::vector<PosedDepth> posed{{&depth, {}}};
    EXPECT_NEAR(sphereRadius(posed).value_or(0), 2.5, 1e-6);
}

} // namespace spherewalk::scene
