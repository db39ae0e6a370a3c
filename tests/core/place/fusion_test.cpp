// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "seen_room.h"

#include "spherewalk/geometry/equirect.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace spherewalk::place {
namespace {

using test::SeenRoom;

/// A ball of 25 cm in the middle of the room, at whose place photos see the room's far side.
const Eigen::Vector3d kBallM(1.5, 1, 0.4);
constexpr double kBallRadiusM = 0.25;

/// Puts the ball into a photo's depth.
void addBall(const Rigid3& roomFromPhoto, Image<float, 1>& inverseM) {
    const EquirectSize size{inverseM.width(), inverseM.height()};
    const Eigen::Vector3d centre = roomFromPhoto.inverse() * kBallM;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const double along = centre.dot(direction(size, Eigen::Vector2d(x, y)));
            const double discriminant = along * along - centre.squaredNorm() + kBallRadiusM * kBallRadiusM;
            if (along > 0 && discriminant > 0) {
                *inverseM.at(x, y) = static_cast<float>(1 / (along - std::sqrt(discriminant)));
            }
        }
    }
}

std::size_t verticesNearBall(const Surface& surface) {
    return static_cast<std::size_t>(
        std::count_if(surface.vertices.begin(), surface.vertices.end(), [](const SurfaceVertex& vertex) {
            return (vertex.pInRoom - kBallM).norm() < kBallRadiusM + 0.03;
        }));
}

SeenRoom roomWithABallIn(std::size_t photos) {
    const SeenRoom empty;
    return SeenRoom(Eigen::Vector3d::Zero(), [&](std::size_t photo, Image<float, 1>& inverseM, MaskImage&) {
        if (photo < photos) {
            addBall(empty.depths[photo].roomFromPhoto(), inverseM);
        }
    });
}

} // namespace

TEST(SeenDepth, KnowsHowFarWhatItShowsAndAPointAre) {
    const SeenRoom room;
    for (const SeenDepth& depth : room.depths) {
        for (const Eigen::Vector3d& wall : {Eigen::Vector3d(0, 0.4, 0.3), Eigen::Vector3d(1.2, 1.9, 0)}) {
            const Eigen::Vector3d eye = depth.roomFromPhoto().translation;
            const Eigen::Vector3d before = eye + 0.7 * (wall - eye);
            const Sight sight = depth.sight(before);
            EXPECT_NEAR(sight.pointM, (before - eye).norm(), 1e-5);
            EXPECT_NEAR(sight.rangeM, (wall - eye).norm(), 0.01);
        }
    }
}

TEST(SeenDepth, SaysWhatTheNearestPixelShowsWhereDistancesJump) {
    Image<float, 1> inverse(64, 32);
    MaskImage sure(64, 32);
    for (int y = 0; y < 32; ++y) {
        for (int x = 0; x < 64; ++x) {
            *inverse.at(x, y) = x < 32 ? 0.5F : 1.0F;
            *sure.at(x, y) = y < 16 ? 255 : 0;
        }
    }
    const SeenDepth depth(render::DepthMap(inverse, sure), {}, {}, 1);
    EXPECT_NEAR(depth.sight({-0.1, 1, 0.8}).rangeM, 2, 0.01);
    EXPECT_NEAR(depth.sight({-0.1, -1, 0.8}).rangeM, 1, 0.01);
    EXPECT_NEAR(depth.sight({1, 0.02, 0.8}).rangeM, 2, 0.01) << "between both halves";
    EXPECT_NEAR(depth.sight({1, -0.02, 0.8}).rangeM, 1, 0.01);
    EXPECT_TRUE(depth.sight({1, 0.02, 0.8}).isEdge);
    EXPECT_FALSE(depth.sight({-0.1, 1, 0.8}).isEdge);
    EXPECT_TRUE(depth.sight({-0.1, 1, 0.8}).isSure);
    EXPECT_FALSE(depth.sight({-0.1, 1, -0.8}).isSure);
    EXPECT_NEAR(depth.sight({-0.1, 1, -0.8}).rangeM, 2, 0.01);
    EXPECT_EQ(depth.rangeM(3, 20), 0);
    EXPECT_NEAR(depth.rangeM(3, 3), 2, 1e-3);
}

TEST(SeenDepth, BeginsAtTheLensThatSees) {
    Image<float, 1> inverse(64, 32);
    std::fill(inverse.values().begin(), inverse.values().end(), 0.5F);
    const SeenDepth depth(render::DepthMap(inverse), {}, {0.1}, 1);
    EXPECT_NEAR(depth.sight({1.1, 0, 0}).pointM, 1, 1e-6);
    EXPECT_NEAR(depth.sight({-1.1, 0, 0}).pointM, 1, 1e-6);
    EXPECT_NEAR(depth.point(32, 16, 2).x(), 2.1, 0.02);
    EXPECT_NEAR(depth.point(0, 16, 2).x(), -2.1, 0.02);
}

TEST(SeenDepth, TellsWhatItShowsOutsideOfTheRoom) {
    const SeenRoom seen;
    Image<float, 1> far(64, 32);
    std::fill(far.values().begin(), far.values().end(), 0.2F);
    for (const SeenDepth& depth : seen.depths) {
        const Rigid3& pose = depth.roomFromPhoto();
        const double exact = std::numeric_limits<double>::infinity();
        const render::DepthMap walls = render::roomDepth(seen.shape, pose, SeenRoom::kWidth);
        const SeenDepth inside(walls, pose, {}, exact, &seen.shape);
        const SeenDepth outside(render::DepthMap(far), pose, {}, exact, &seen.shape);
        for (int i = 0; i < 24; ++i) {
            const Eigen::Vector3d point(1.5 + 0.4 * std::cos(i), 1 + 0.4 * std::sin(i), 0.1 * i);
            EXPECT_FALSE(inside.sight(point).isOutside());
            EXPECT_TRUE(outside.sight(point).isOutside());
            EXPECT_FALSE(SeenDepth(render::DepthMap(far), pose, {}, exact).sight(point).isOutside());
        }
        const Rigid3 elsewhere{pose.rotation, pose.translation + Eigen::Vector3d(10, 0, 0)};
        const SeenDepth other(render::DepthMap(far), elsewhere, {}, exact, &seen.shape);
        EXPECT_FALSE(other.sight({1.5, 1, 1}).isOutside()) << "the photo itself stands outside";
    }
}

TEST(SeenDepth, TrustsADepthLessTheFartherAndTheShorterItsBaseline) {
    Image<float, 1> inverse(64, 32);
    const SeenDepth wide(render::DepthMap(inverse), {}, {}, 1);
    const SeenDepth narrow(render::DepthMap(inverse), {}, {}, 0.2);
    EXPECT_LT(wide.sigmaM(1), wide.sigmaM(2));
    EXPECT_LT(wide.sigmaM(2), narrow.sigmaM(2));
}

TEST(Baselines, AreThoseOfTheSixNearestPhotosElsewhere) {
    std::vector<Rigid3> poses;
    for (const double x : {0.0, 0.01, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0}) {
        poses.push_back({Eigen::Quaterniond::Identity(), {x, 0, 0}});
    }
    EXPECT_NEAR(baselinesM(poses)[0], 3.5, 1e-12);
    EXPECT_EQ(baselinesM(std::span(poses).first(2))[0], 0) << "the other one stands too near";
    EXPECT_EQ(baselinesM(std::span(poses).first(1))[0], 0);
}

TEST(Fusion, FindsTheRoom) {
    const SeenRoom room;
    const Surface surface = room.surface();
    ASSERT_GT(surface.vertices.size(), 10000U);
    double worst = 0;
    int firm = 0;
    for (const SurfaceVertex& vertex : surface.vertices) {
        worst = std::max(worst, room.distanceM(vertex.pInRoom));
        firm += vertex.photos > 0 && vertex.confidence > 0.9F ? 1 : 0;
    }
    EXPECT_GT(firm, 0.95 * static_cast<double>(surface.vertices.size())) << "all but corners";
    EXPECT_LT(worst, 0.03);
    EXPECT_NEAR(surface.areaM2(), 2 * (3 * 2 + 3 * 2.5 + 2 * 2.5), 1.5);
    EXPECT_GT(seenShare(surface, room.depths, 2 * SeenRoom::kVoxelM), 0.97);
}

TEST(Fusion, FindsTheSameRoomFarFromTheOrigin) {
    const Eigen::Vector3d away(1e6, -2e6, 40);
    const Surface near = SeenRoom().surface();
    const Surface far = SeenRoom(away).surface();
    ASSERT_NEAR(static_cast<double>(far.vertices.size()), static_cast<double>(near.vertices.size()), 50);
    const SeenRoom room(away);
    for (const SurfaceVertex& vertex : far.vertices) {
        ASSERT_LT(room.distanceM(vertex.pInRoom), 0.03);
    }
}

TEST(Fusion, DoesNotDependOnTheNumberOfThreads) {
    const SeenRoom room;
    const Volume one = room.volume(1);
    const Volume several = room.volume(3);
    ASSERT_EQ(one.blockCount(), several.blockCount());
    for (std::size_t i = 0; i < one.blockCount(); ++i) {
        ASSERT_EQ(one.corner(i), several.corner(i));
        ASSERT_EQ(std::memcmp(&one.block(i), &several.block(i), sizeof(Volume::Block)), 0);
    }
}

TEST(Fusion, LetsPhotosThatLookThroughOutvoteOneThatIsWrong) {
    EXPECT_GT(verticesNearBall(roomWithABallIn(4).surface()), 100U);
    EXPECT_EQ(verticesNearBall(roomWithABallIn(1).surface()), 0U);
}

TEST(Fusion, SaysHowManyPhotosShowASurface) {
    const Surface surface = roomWithABallIn(3).surface();
    int most = 0;
    for (const SurfaceVertex& vertex : surface.vertices) {
        if ((vertex.pInRoom - kBallM).norm() < kBallRadiusM + 0.03 && vertex.pInRoom.z() > 0.45) {
            most = std::max<int>(most, vertex.photos);
            EXPECT_LT(vertex.confidence, 0.99F) << "one photo looks through";
        }
    }
    EXPECT_EQ(most, 3);
}

TEST(Fusion, LeavesHolesWhereNothingIsSure) {
    const auto hideLowerHalf = [](std::size_t, Image<float, 1>&, MaskImage& sure) {
        for (int y = sure.height() / 2; y < sure.height(); ++y) {
            std::fill(sure.row(y).begin(), sure.row(y).end(), 0);
        }
    };
    const SeenRoom room(Eigen::Vector3d::Zero(), hideLowerHalf, 1);
    const Surface surface = room.surface();
    ASSERT_FALSE(surface.vertices.empty());
    for (const SurfaceVertex& vertex : surface.vertices) {
        EXPECT_GT(vertex.pInRoom.z(), 1.1);
    }
    EXPECT_NEAR(seenShare(surface, room.depths, 2 * SeenRoom::kVoxelM), 0.5, 0.05);
}

TEST(Fusion, OfPhotosThatAreSureOfNothingHasNoSurface) {
    const auto hideAll = [](std::size_t, Image<float, 1>&, MaskImage& sure) {
        std::fill(sure.values().begin(), sure.values().end(), 0);
    };
    const SeenRoom room(Eigen::Vector3d::Zero(), hideAll);
    EXPECT_EQ(room.volume().blockCount(), 0U);
    EXPECT_TRUE(room.surface().vertices.empty());
    EXPECT_EQ(seenShare(room.surface(), room.depths, 0.08), 0);
}

TEST(Fusion, RefusesWhatItCannotDo) {
    const SeenRoom room;
    const auto fuse = [&](double voxelM) { fused(room.depths, {voxelM}, noProgress(), {}); };
    test::expectError(ErrorKind::InvalidInput, "voxel must be", [&] { fuse(0); });
    test::expectError(ErrorKind::InvalidInput, "voxel must be", [&] { fuse(NAN); });
    test::expectError(ErrorKind::InvalidInput, "no photo", [&] { fused({}, {}, noProgress(), {}); });
    const SeenRoom away(Eigen::Vector3d(1e6, 0, 0));
    const std::vector<SeenDepth> apart = {room.depths[0], away.depths[0]};
    test::expectError(ErrorKind::InvalidInput, "away from the first",
                      [&] { fused(apart, {0.04}, noProgress(), {}); });
}

TEST(Fusion, StopsWhenAsked) {
    std::stop_source stop;
    stop.request_stop();
    const SeenRoom room;
    Surface surface = room.surface();
    test::expectError(ErrorKind::Stopped, "",
                      [&] { fused(room.depths, {}, noProgress(), stop.get_token()); });
    test::expectError(ErrorKind::Stopped, "", [&] { surfaceOf(room.volume(), 0, stop.get_token()); });
    test::expectError(ErrorKind::Stopped, "", [&] { surface.weigh(room.depths, 0.04, 0, stop.get_token()); });
    test::expectError(ErrorKind::Stopped, "",
                      [&] { seenShare(surface, room.depths, 0.08, 0, stop.get_token()); });
}

} // namespace spherewalk::place
