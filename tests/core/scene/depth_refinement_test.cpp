// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "sweep_cost.h"

#include "spherewalk/practice/practice_room.h"
#include "spherewalk/scene/depth_sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace spherewalk::scene {

namespace {

constexpr int kRefinedWidth = 256;

/// Photos of the practice room with their true depths.
struct KnownRoom {
    std::vector<Rigid3> poses;
    std::vector<RgbImage> pictures;
    std::vector<PhotoDepth> depths;

    static const KnownRoom& made() {
        static const KnownRoom room = [] {
            const practice::PracticeRoom practice;
            KnownRoom made;
            double yaw = 0;
            for (const auto& [x, y] : {std::pair{2.5, 2.0}, {2.9, 2.0}, {2.1, 2.0}, {2.5, 2.4}, {2.5, 1.6}}) {
                made.poses.push_back(
                    {Eigen::Quaterniond(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ())), {x, y, 1.2}});
                made.pictures.push_back(
                    practice.spherical(made.poses.back(), {2 * kRefinedWidth, kRefinedWidth}));
                made.depths.push_back(
                    exact(practice.sphericalRange(made.poses.back(), {kRefinedWidth, kRefinedWidth / 2})));
                yaw += 0.9;
            }
            return made;
        }();
        return room;
    }

    static PhotoDepth exact(const DepthImage& range) {
        PhotoDepth depth{Image<float, 1>(range.width(), range.height()),
                         MaskImage(range.width(), range.height())};
        std::transform(range.values().begin(), range.values().end(), depth.inverseM.values().begin(),
                       [](float m) { return 1 / m; });
        std::fill(depth.sure.values().begin(), depth.sure.values().end(), std::uint8_t{255});
        return depth;
    }

    KnownPhoto photo(std::size_t i) const { return {{&pictures[i], poses[i]}, &depths[i]}; }

    KnownPhoto photo(std::size_t i, const PhotoDepth& depth) const {
        return {{&pictures[i], poses[i]}, &depth};
    }

    std::vector<KnownPhoto> others() const { return {photo(1), photo(2), photo(3), photo(4)}; }
};

/// The share of the pixels between two rows whose 1 / distance is off by less than 3 %.
double shareRight(const PhotoDepth& depth, const PhotoDepth& truth) {
    int right = 0;
    int all = 0;
    for (int y = depth.inverseM.height() / 8; y < depth.inverseM.height() * 7 / 8; ++y) {
        for (int x = 0; x < depth.inverseM.width(); ++x) {
            const float exact = *truth.inverseM.at(x, y);
            right += std::abs(*depth.inverseM.at(x, y) - exact) < 0.03F * exact ? 1 : 0;
            ++all;
        }
    }
    return static_cast<double>(right) / all;
}

/// A depth that says the same distance everywhere and is sure of nothing.
PhotoDepth unknown() {
    PhotoDepth depth{Image<float, 1>(kRefinedWidth, kRefinedWidth / 2),
                     MaskImage(kRefinedWidth, kRefinedWidth / 2)};
    std::fill(depth.inverseM.values().begin(), depth.inverseM.values().end(), 0.9F);
    return depth;
}

} // namespace

TEST(DepthRefinement, TakesOverWhatNeighboursKnow) {
    const KnownRoom& room = KnownRoom::made();
    const PhotoDepth before = unknown();
    ASSERT_LT(shareRight(before, room.depths[0]), 0.1);
    const PhotoDepth refined = refinedDepth(room.photo(0, before), room.others(), nullptr);
    EXPECT_GT(shareRight(refined, room.depths[0]), 0.7); // the rest keeps what it was
    EXPECT_GT(std::count(refined.sure.values().begin(), refined.sure.values().end(), 255), 0);
}

TEST(DepthRefinement, LeavesATrueDepthAsItIs) {
    const KnownRoom& room = KnownRoom::made();
    EXPECT_GT(shareRight(refinedDepth(room.photo(0), room.others(), nullptr), room.depths[0]), 0.93);
}

TEST(DepthRefinement, TakesNothingFromANeighbourThatIsSureOfNothing) {
    const KnownRoom& room = KnownRoom::made();
    const PhotoDepth nothing = unknown();
    const PhotoDepth before = unknown();
    const std::vector<KnownPhoto> others{room.photo(1, nothing), room.photo(3, nothing)};
    const PhotoDepth refined = refinedDepth(room.photo(0, before), others, nullptr);
    EXPECT_EQ(std::count(refined.sure.values().begin(), refined.sure.values().end(), 255), 0);
    EXPECT_TRUE(std::all_of(refined.inverseM.values().begin(), refined.inverseM.values().end(),
                            [](float value) { return std::abs(value - 0.9F) < 1e-3F; }));
}

TEST(DepthRefinement, LeavesBareSurfacesAsTheyAre) {
    const KnownRoom& room = KnownRoom::made();
    std::mt19937 random(3);
    std::vector<RgbImage> walls(3, RgbImage(2 * kRefinedWidth, kRefinedWidth));
    for (RgbImage& wall : walls) {
        for (std::uint8_t& value : wall.values()) {
            value = static_cast<std::uint8_t>(200 + random() % 9);
        }
    }
    PhotoDepth other = unknown();
    for (float& value : other.inverseM.values()) {
        value = 0.3F + 0.001F * static_cast<float>(random() % 1000);
    }
    std::fill(other.sure.values().begin(), other.sure.values().end(), std::uint8_t{255});
    const PhotoDepth before = unknown();
    const std::vector<KnownPhoto> others{{{&walls[1], room.poses[1]}, &other},
                                         {{&walls[2], room.poses[2]}, &other}};
    const PhotoDepth refined = refinedDepth({{walls.data(), room.poses[0]}, &before}, others, nullptr);
    EXPECT_TRUE(std::all_of(refined.inverseM.values().begin(), refined.inverseM.values().end(),
                            [](float value) { return std::abs(value - 0.9F) < 1e-3F; }));
}

TEST(DepthRefinement, IsTheSameForAnyNumberOfThreads) {
    const KnownRoom& room = KnownRoom::made();
    const PhotoDepth before = unknown();
    const PhotoDepth one = refinedDepth(room.photo(0, before), room.others(), nullptr, 1);
    const PhotoDepth three = refinedDepth(room.photo(0, before), room.others(), nullptr, 3);
    EXPECT_EQ(one.inverseM, three.inverseM);
    EXPECT_EQ(one.sure, three.sure);
}

namespace {

/// The true depth, of which only a band about the horizon is sure; the rest says nothing.
PhotoDepth sureAboutTheHorizon(const PhotoDepth& truth) {
    PhotoDepth depth = unknown();
    for (int y = depth.sure.height() * 3 / 8; y < depth.sure.height() * 5 / 8; ++y) {
        std::copy_n(truth.inverseM.at(0, y), depth.sure.width(), depth.inverseM.at(0, y));
        std::fill_n(depth.sure.at(0, y), depth.sure.width(), std::uint8_t{255});
    }
    return depth;
}

double shareRightAbove(const PhotoDepth& depth, const PhotoDepth& truth) {
    int right = 0;
    const int rows = depth.inverseM.height() / 4;
    for (int i = 0; i < rows * depth.inverseM.width(); ++i) {
        const float exact = truth.inverseM.values()[static_cast<std::size_t>(i)];
        right +=
            std::abs(depth.inverseM.values()[static_cast<std::size_t>(i)] - exact) < 0.05F * exact ? 1 : 0;
    }
    return static_cast<double>(right) / (rows * depth.inverseM.width());
}

} // namespace

TEST(DepthRefinement, IsTheRoomFarFromWhatIsSureUnlessThePhotoContradictsIt) {
    const KnownRoom& room = KnownRoom::made();
    const PhotoDepth before = sureAboutTheHorizon(room.depths[0]);
    const PhotoDepth nothing = unknown();
    const std::vector<KnownPhoto> others{room.photo(1, nothing), room.photo(2, nothing)};
    const render::RoomShape shape{{{0, 0}, {5, 0}, {5, 4}, {0, 4}}, 0, 2.6};
    const render::RoomShape wider{{{-1, -1}, {6, -1}, {6, 5}, {-1, 5}}, 0, 2.6};
    const PhotoDepth without = refinedDepth(room.photo(0, before), others, nullptr);
    const PhotoDepth within = refinedDepth(room.photo(0, before), others, &shape);
    EXPECT_GT(shareRightAbove(within, room.depths[0]), 0.9);
    EXPECT_LT(shareRightAbove(without, room.depths[0]), 0.6);
    EXPECT_EQ(within.sure, without.sure);
    EXPECT_EQ(refinedDepth(room.photo(0, before), others, &wider).inverseM, without.inverseM);
}

TEST(DepthRefinement, IsNotTornWherePhotosAgreedOnAReflectionInACeilingThatNothingIsSureOf) {
    const KnownRoom& room = KnownRoom::made();
    const PhotoDepth nothing = unknown();
    const std::vector<KnownPhoto> others{room.photo(1, nothing), room.photo(2, nothing)};
    PhotoDepth before = room.depths[0];
    for (int y = 0; y < before.sure.height() * 3 / 8; ++y) {
        std::fill_n(before.sure.at(0, y), before.sure.width(), std::uint8_t{0});
    }
    constexpr int kRow = 14;
    for (int y = kRow - 4; y < kRow + 4; ++y) {
        std::for_each_n(before.inverseM.at(60, y), 30, [](float& inverse) { inverse *= 0.75F; });
    }
    const PhotoDepth refined = refinedDepth(room.photo(0, before), others, nullptr);
    for (int x = 50; x < 100; ++x) {
        const float here = *refined.inverseM.at(x, kRow);
        const float beside = *refined.inverseM.at(x + 1, kRow);
        EXPECT_LT(std::abs(here - beside), 0.08F * std::max(here, beside)) << x;
    }
}

TEST(DepthRefinement, LeavesADepthWithoutNeighboursAsItIs) {
    const KnownRoom& room = KnownRoom::made();
    EXPECT_EQ(refinedDepth(room.photo(0), {}, nullptr).inverseM, room.depths[0].inverseM);
}

TEST(DepthRefinement, RefusesDepthsOfAnotherSize) {
    const KnownRoom& room = KnownRoom::made();
    const PhotoDepth small{Image<float, 1>(128, 64), MaskImage(128, 64)};
    const std::vector<KnownPhoto> others{room.photo(1, small)};
    test::expectError(ErrorKind::InvalidInput, "another size",
                      [&] { refinedDepth(room.photo(0), others, nullptr); });
}

TEST(DepthRefinement, StopsWhenAsked) {
    const KnownRoom& room = KnownRoom::made();
    std::stop_source stop;
    stop.request_stop();
    test::expectError(ErrorKind::Stopped, "",
                      [&] { refinedDepth(room.photo(0), room.others(), nullptr, 1, stop.get_token()); });
}

namespace {

/// The mean cost of a photo's true distances, for a neighbour whose own depth is this everywhere.
double meanCost(float neighboursInverseM) {
    const KnownRoom& room = KnownRoom::made();
    PhotoDepth depth = unknown();
    std::fill(depth.inverseM.values().begin(), depth.inverseM.values().end(), neighboursInverseM);
    const std::vector<PosedPicture> neighbour{room.photo(1).photo};
    const Image<float, 1>* known = &depth.inverseM;
    const SweepCost cost(room.photo(0).photo, neighbour, 0.5, kRefinedWidth, 2, {}, {&known, 1});
    Image<float, 1> costs(kRefinedWidth, kRefinedWidth / 2);
    cost.all({&room.depths[0].inverseM, 1}, 2, {}, {&costs, 1});
    double sum = 0;
    for (const float value : costs.values()) {
        sum += static_cast<double>(value);
    }
    return sum / static_cast<double>(costs.values().size());
}

} // namespace

TEST(SweepCost, AsksNoNeighbourFromWhichSomethingHidesThePlace) {
    EXPECT_FLOAT_EQ(static_cast<float>(meanCost(20)), 30); // all is hidden, whatever the pictures show
}

TEST(SweepCost, IsHigherWhereANeighbourSeesThroughThePlace) {
    const KnownRoom& room = KnownRoom::made();
    const std::vector<PosedPicture> neighbour{room.photo(1).photo};
    const SweepCost blind(room.photo(0).photo, neighbour, 0.5, kRefinedWidth, 2);
    Image<float, 1> costs(kRefinedWidth, kRefinedWidth / 2);
    blind.all({&room.depths[0].inverseM, 1}, 2, {}, {&costs, 1});
    double sum = 0;
    for (const float value : costs.values()) {
        sum += static_cast<double>(value);
    }
    EXPECT_NEAR(meanCost(1e-3F), sum / static_cast<double>(costs.values().size()) + 6, 1e-3);
}

} // namespace spherewalk::scene
