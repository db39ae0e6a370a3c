// SPDX-License-Identifier: GPL-3.0-or-later
#include "random.h"

#include "spherewalk/geometry/equirect.h"
#include "spherewalk/scene/room_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

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

void expectRoom(const std::optional<FittedRoom>& fitted, bool contradictsOutline = false) {
    ASSERT_TRUE(fitted);
    EXPECT_EQ(fitted->contradictsOutline, contradictsOutline);
    const render::RoomShape* found = &fitted->shape;
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
    expectRoom(fittedRoom(Photos(kRoom).posed, {{{0.1, -0.1}, {3.8, -0.1}, {3.8, 3.2}, {0.1, 3.2}}}));
}

// A glossy floor shows another room below it, a mirror one beside, and a few depths are endlessly wrong.
TEST(RoomFit, TakesNoMirrorImageForTheRoom) {
    Photos photos(kRoom);
    for (PhotoDepth& depth : photos.depths) {
        const int height = depth.inverseM.height();
        for (int y = 3 * height / 5; y < height; ++y) {
            for (int x = 0; x < depth.inverseM.width(); ++x) {
                float* inverse = depth.inverseM.at(x, y);
                *inverse *= x % 2 == 0 ? 0.32F : 1; // the ceiling's mirror image
                *inverse = x % 16 == 0 ? 0.015F : *inverse;
            }
        }
    }
    expectRoom(fittedRoom(photos.posed, {kRoom.outline, kRoom.ceilingM}));
    const auto undrawn = fittedRoom(photos.posed, {});
    ASSERT_TRUE(undrawn);
    EXPECT_GT(undrawn->shape.floorM, -2); // a camera stands at most 3 m above its floor
}

// A quarter of what is looked at towards the ceiling shows something 9 m above the lens, which would be fifty
// times as large there.
TEST(RoomFit, FindsTheCeilingThatNobodyDrewBelowWhatIsFalselyFar) {
    Photos photos(kRoom);
    for (PhotoDepth& depth : photos.depths) {
        for (int y = 0; y < depth.inverseM.height() / 4; ++y) {
            for (int x = 2; x < depth.inverseM.width(); x += 16) {
                *depth.inverseM.at(x, y) *= 1.3F / 9;
            }
        }
    }
    const auto found = fittedRoom(photos.posed, {});
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->shape.ceilingM, kRoom.ceilingM, 0.02);
}

TEST(RoomFit, KeepsWhatWasDrawnWhereTooLittleIsSeen) {
    Photos photos(kRoom);
    for (PhotoDepth& depth : photos.depths) {
        const int height = depth.sure.height();
        for (int y = 0; y < height; ++y) {
            if (y < 2 * height / 5 || y > 3 * height / 5) {
                std::fill_n(depth.sure.at(0, y), depth.sure.width(), std::uint8_t{0});
            }
        }
    }
    const auto found = fittedRoom(photos.posed, {kRoom.outline, 2.6});
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->shape.floorM, 0, 0.03);
    EXPECT_EQ(found->shape.ceilingM, 2.6);
}

TEST(RoomFit, KeepsApartTheSidesOfAThinWallBetweenRooms) {
    const render::RoomShape rooms{
        {{0, 0}, {4, 0}, {4, 3}, {2.05, 3}, {2.05, 0.8}, {1.95, 0.8}, {1.95, 3}, {0, 3}}, 0, 2.5};
    const Photos photos(rooms); // one on either side
    const auto found = fittedRoom(photos.posed, {rooms.outline, 2.5});
    ASSERT_TRUE(found);
    ASSERT_EQ(found->shape.outline.size(), rooms.outline.size());
    for (std::size_t i = 0; i < rooms.outline.size(); ++i) {
        EXPECT_LT((found->shape.outline[i] - rooms.outline[i]).norm(), 0.03) << i;
    }
}

TEST(RoomFit, MovesNoWallToAThingBeforeIt) {
    const render::RoomShape withPillar{
        {{0, 0}, {1.5, 0}, {1.5, 0.25}, {2, 0.25}, {2, 0}, {4, 0}, {4, 3}, {0, 3}}, 0, 2.5};
    Photos photos(withPillar);
    for (std::size_t i = 0; i < photos.depths.size(); ++i) { // of that wall, only the pillar is sure
        PhotoDepth& depth = photos.depths[i];
        const EquirectSize size{depth.sure.width(), depth.sure.height()};
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                const Eigen::Vector3d ray = direction(size, Eigen::Vector2d(x, y));
                const double distance = 1 / static_cast<double>(*depth.inverseM.at(x, y));
                *depth.sure.at(x, y) =
                    (photos.poses[i].translation + distance * ray).y() < 0.1 ? std::uint8_t{0} : 255;
            }
        }
    }
    const auto found = fittedRoom(photos.posed, {kRoom.outline, 2.5});
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->shape.outline[0].y(), 0, 0.01);
    EXPECT_NEAR(found->shape.outline[1].y(), 0, 0.01);
}

TEST(RoomFit, BelievesNoOutlineThatThePhotosContradict) {
    const Photos photos(kRoom);
    // The photos' own block, in place of the room; and the outline of a room somewhere else.
    expectRoom(fittedRoom(photos.posed, {{{1, 1}, {3, 1}, {3, 2}, {1, 2}}, 2.5}), true);
    expectRoom(fittedRoom(photos.posed, {{{101, 1}, {103, 1}, {103, 2}, {101, 2}}, 2.5}), true);
}

TEST(RoomFit, BelievesAnOutlineWhoseWallsHaveDoorsAndWindows) {
    Photos photos(kRoom);
    for (PhotoDepth& depth : photos.depths) {
        const int width = depth.inverseM.width();
        for (int y = 0; y < depth.inverseM.height(); ++y) {
            for (int x = 0; x < width; ++x) {
                *depth.inverseM.at(x, y) *= x % (width / 4) < width / 10 ? 0.3F : 1; // two fifths of all
            }
        }
    }
    const auto found = fittedRoom(photos.posed, {kRoom.outline, 2.5});
    ASSERT_TRUE(found);
    EXPECT_FALSE(found->contradictsOutline);
    EXPECT_TRUE(found->wallsSeenThrough.empty());
}

TEST(RoomFit, NamesADrawnWallThatPhotosSeeThrough) {
    Photos photos(kRoom);
    const Polygon tooShort = {{0, 0}, {2.9, 0}, {2.9, 3}, {0, 3}};
    const auto found = fittedRoom(photos.posed, {tooShort, 2.5});
    ASSERT_TRUE(found);
    EXPECT_FALSE(found->contradictsOutline);
    EXPECT_EQ(found->wallsSeenThrough, std::vector<std::size_t>{1});
    // A wall in two parts, one of which stands where no wall is; and walls that are moved.
    const Polygon step = {{0, 0}, {4, 0}, {4, 1.5}, {3.1, 1.5}, {3.1, 3}, {0, 3}};
    EXPECT_EQ(fittedRoom(photos.posed, {step, 2.5})->wallsSeenThrough, std::vector<std::size_t>{3});
    EXPECT_TRUE(fittedRoom(photos.posed, {{{0.1, -0.1}, {3.6, -0.1}, {3.6, 3.2}, {0.1, 3.2}}})
                    ->wallsSeenThrough.empty());
    // Bare walls show too little to say so.
    for (PhotoDepth& depth : photos.depths) {
        for (int y = 0; y < depth.sure.height(); ++y) {
            for (int x = 0; x < depth.sure.width(); ++x) {
                *depth.sure.at(x, y) = x % 8 < 4 || y % 8 < 4 ? 0 : 1;
            }
        }
    }
    EXPECT_TRUE(fittedRoom(photos.posed, {tooShort, 2.5})->wallsSeenThrough.empty());
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

namespace {

survey::Room square(double halfM, const Eigen::Vector2d& centre) {
    survey::Room room;
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
        room.outline.push_back(centre + halfM * Eigen::Vector2d(x, y));
    }
    room.ceilingM = 2 * halfM;
    return room;
}

} // namespace

// Seen from a cube's centre, 1 / distance is max |d_i| / half, whose mean over the sphere is
// (6 sqrt(2) / pi) atan(1 / sqrt(2)) / half (integrate over one face).
TEST(SphereRadius, IsTheHarmonicMeanDistanceInACube) {
    const double expected =
        1.5 / (6 * std::numbers::sqrt2 / std::numbers::pi * std::atan(1 / std::numbers::sqrt2) / 2);
    for (const Eigen::Vector2d& centre : {Eigen::Vector2d(0, 0), Eigen::Vector2d(1e6, -1e6)}) {
        const auto radius = sphereRadius(square(1.5, centre), {{centre.x(), centre.y(), 1.5}});
        ASSERT_TRUE(radius);
        EXPECT_NEAR(*radius, expected, 0.02 * expected);
    }
}

TEST(SphereRadius, GrowsWithTheRoom) {
    const auto small = sphereRadius(square(1, {0, 0}), {{0.3, 0.1, 1}});
    const auto large = sphereRadius(square(10, {0, 0}), {{3, 1, 10}});
    EXPECT_NEAR(*large / *small, 10, 1e-9);
}

TEST(SphereRadius, LeavesOutPointsThatAreNotInTheRoom) {
    const survey::Room room = square(1, {0, 0});
    EXPECT_FALSE(sphereRadius(room, {{5, 0, 1}, {0, 0, -1}, {0, 0, 2}, {1, 0, 1}}));
    EXPECT_EQ(sphereRadius(room, {{5, 0, 1}, {0, 0, 1}}), sphereRadius(room, {{0, 0, 1}}));
}

TEST(SphereRadius, BetweenFloorAndCeilingAloneIsTheirDistance) {
    // 1 / distance is |z| / half, and the mean of |z| over the sphere is 1/2.
    survey::Room hall = square(900, {0, 0});
    hall.ceilingM = 3;
    EXPECT_NEAR(sphereRadius(hall, {{0, 0, 1.5}}).value_or(0), 3, 0.02);
}

TEST(SphereRadius, OfSeveralPointsIsTheHarmonicMeanOfTheirRadii) {
    const survey::Room room = square(2, {0, 0});
    test::Random random(3);
    for (int example = 0; example < 20; ++example) {
        const Eigen::Vector3d p(random.uniform(-1.9, 1.9), random.uniform(-1.9, 1.9),
                                random.uniform(0.1, 3.9));
        const Eigen::Vector3d q(random.uniform(-1.9, 1.9), random.uniform(-1.9, 1.9),
                                random.uniform(0.1, 3.9));
        const double both = sphereRadius(room, {p, q}).value_or(0);
        EXPECT_NEAR(2 / both, 1 / *sphereRadius(room, {p}) + 1 / *sphereRadius(room, {q}), 1e-9);
    }
}

TEST(SphereRadius, OfARoomIsAboutThatOfItsDepths) {
    // Near the horizon walls alone are seen; the sphere of a cube is smaller than that of its walls.
    const Photos photos(kRoom);
    const double ofDepths = sphereRadius(photos.posed).value_or(0);
    EXPECT_GT(ofDepths, 1.2);
    EXPECT_LT(ofDepths, 2.5);
}

TEST(RoomFit, FindsRoomsOfAnySizeAndTurnThoughDepthsAreNoisy) {
    for (unsigned seed = 1; seed <= 8; ++seed) {
        test::Random random(seed);
        const double heading = random.uniform(0, 1.5);
        const Eigen::Vector2d along(std::cos(heading), std::sin(heading));
        const Eigen::Vector2d across(-along.y(), along.x());
        const Eigen::Vector2d origin(random.uniform(-50, 50), random.uniform(-50, 50));
        const double length = random.uniform(3.2, 6);
        const double width = random.uniform(2.6, 4);
        const render::RoomShape room{{origin, origin + length * along,
                                      origin + length * along + width * across, origin + width * across},
                                     random.uniform(-1, 1),
                                     random.uniform(3.4, 4)};
        std::vector<Rigid3> poses;
        std::vector<PhotoDepth> depths;
        for (const double share : {0.4, 0.6}) {
            const Eigen::Vector2d at = origin + share * length * along + 0.5 * width * across;
            poses.push_back({Eigen::Quaterniond::Identity(), {at.x(), at.y(), room.floorM + 1.2}});
            const render::DepthMap map = roomDepth(room, poses.back(), 256);
            depths.push_back({map.inverseM(), map.sure()});
            for (float& inverse : depths.back().inverseM.values()) {
                inverse *= 1 + static_cast<float>(random.normal(0.005));
            }
        }
        const std::vector<PosedDepth> posed{{&depths[0], poses[0]}, {&depths[1], poses[1]}};
        const auto found = fittedRoom(posed, {});
        ASSERT_TRUE(found) << "seed " << seed;
        EXPECT_NEAR(found->shape.floorM, room.floorM, 0.03) << "seed " << seed;
        EXPECT_NEAR(found->shape.ceilingM, room.ceilingM, 0.04) << "seed " << seed;
        for (const Eigen::Vector2d& corner : room.outline) {
            double nearest = 100;
            for (const Eigen::Vector2d& other : found->shape.outline) {
                nearest = std::min(nearest, (other - corner).norm());
            }
            EXPECT_LT(nearest, 0.08) << "seed " << seed;
        }
    }
}

} // namespace spherewalk::scene
