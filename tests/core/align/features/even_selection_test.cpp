// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "features/keypoints.h"
#include "features/sphere_view.h"
#include "random.h"

#include "spherewalk/align/match_pairs.h"
#include "spherewalk/align/solve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <vector>

namespace spherewalk::align {

using Eigen::Vector3d;

namespace {

std::vector<Spot> anySpots(int count, double ownRad, test::Random& random) {
    std::vector<Spot> spots;
    for (int i = 0; i < count; ++i) {
        spots.push_back({random.direction(), static_cast<float>(random.uniform(0, 1)), ownRad});
    }
    return spots;
}

const Spot& at(const std::vector<Spot>& spots, int index) {
    return spots[static_cast<std::size_t>(index)];
}

/// Expects that options with this change are refused by their name.
template <class Options, class Change>
void expectRefused(const char* option, const Change& change) {
    Options options;
    options.validate();
    change(options);
    test::expectError(ErrorKind::InvalidInput, option, [&] { options.validate(); });
}

} // namespace

TEST(EvenSelection, HoldsEachSpotOnceAndNoMoreThanAsked) {
    test::Random random(700);
    SCOPED_TRACE(random.seed());
    for (int round = 0; round < 30; ++round) {
        const std::vector<Spot> spots = anySpots(random.integer(0, 400), 0, random);
        const int most = random.integer(0, 500);
        const std::vector<int> selected = evenSelection(spots, most);
        EXPECT_EQ(selected.size(), std::min(spots.size(), static_cast<std::size_t>(most)));
        EXPECT_EQ(std::set<int>(selected.begin(), selected.end()).size(), selected.size());
    }
}

TEST(EvenSelection, OfFewerIsTheBeginningOfASelectionOfMore) {
    test::Random random(701);
    SCOPED_TRACE(random.seed());
    const std::vector<Spot> spots = anySpots(300, 0.01, random);
    const std::vector<int> all = evenSelection(spots, 300);
    for (const int most : {1, 7, 100}) {
        const std::vector<int> some = evenSelection(spots, most);
        EXPECT_TRUE(std::equal(some.begin(), some.end(), all.begin())) << most;
    }
}

TEST(EvenSelection, KeepsTheStrongestOfSpotsThatAreOneThing) {
    test::Random random(702);
    SCOPED_TRACE(random.seed());
    const std::vector<Spot> spots = anySpots(500, 0.05, random);
    const std::vector<int> selected = evenSelection(spots, 500);
    for (std::size_t i = 0; i < selected.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            EXPECT_GE((at(spots, selected[i]).bearing - at(spots, selected[k]).bearing).norm(), 0.05);
        }
    }
    for (int i = 0; i < 500; ++i) {
        const bool isCovered = std::ranges::any_of(selected, [&](int kept) {
            return (at(spots, kept).bearing - at(spots, i).bearing).norm() < 0.05 &&
                   at(spots, kept).response >= at(spots, i).response;
        });
        EXPECT_TRUE(isCovered) << "spot " << i << " is neither selected nor beside a stronger one";
    }
}

TEST(EvenSelection, TakesAWeakSpotAloneBeforeTheSecondOfACrowd) {
    test::Random random(703);
    SCOPED_TRACE(random.seed());
    std::vector<Spot> spots;
    for (int i = 0; i < 50; ++i) {
        const Vector3d bearing = Vector3d(1, 0.2, 0.1) + random.vector(0.003);
        spots.push_back({bearing.normalized(), static_cast<float>(random.uniform(0.5, 1)), 0});
    }
    spots.push_back({-Vector3d::UnitX(), 0.01F, 0});
    const std::vector<int> selected = evenSelection(spots, 5); // a crowd may lie in up to four regions
    EXPECT_TRUE(std::ranges::find(selected, 50) != selected.end());
}

TEST(EvenSelection, ReachesAllPartsOfTheSphereAlike) {
    test::Random random(704);
    SCOPED_TRACE(random.seed());
    std::vector<Spot> spots = anySpots(4000, 0, random);
    for (Spot& spot : spots) {
        spot.response += spot.bearing.x() > 0 ? 1.0F : 0.0F; // one half shows the strong ones
    }
    int front = 0;
    for (const int index : evenSelection(spots, 400)) {
        front += at(spots, index).bearing.x() > 0 ? 1 : 0;
    }
    EXPECT_NEAR(front, 200, 40);
}

TEST(SphereViews, OwnEveryDirectionOfTheSphereOnce) {
    constexpr int kWidth = 384;
    const GreyImage photo(kWidth, kWidth / 2);
    double owned = 0;
    for (const SphereView& view : sphereViews(photo, kWidth, Degrees(-90), true)) {
        for (int y = 0; y < view.picture().height(); ++y) {
            for (int x = 0; x < view.picture().width(); ++x) {
                const double side = view.pixelRad(x, y);
                owned += view.owns(x, y) ? side * side : 0;
            }
        }
    }
    EXPECT_NEAR(owned, 4 * std::numbers::pi, 0.01 * 4 * std::numbers::pi);
}

TEST(SphereViews, DistortNoAngles) {
    test::Random random(705);
    SCOPED_TRACE(random.seed());
    constexpr double kStepPx = 0.01;
    const GreyImage photo(256, 128);
    for (const SphereView& view : sphereViews(photo, 256, Degrees(-90), true)) {
        for (int i = 0; i < 200; ++i) {
            const double x = random.uniform(0, view.picture().width());
            const double y = random.uniform(0, view.picture().height());
            const Vector3d middle = view.bearing(x, y);
            const Vector3d right = (view.bearing(x + kStepPx, y) - middle) / kStepPx;
            const Vector3d down = (view.bearing(x, y + kStepPx) - middle) / kStepPx;
            const double side = view.pixelRad(x, y);
            EXPECT_NEAR(middle.norm(), 1, 1e-12);
            EXPECT_NEAR(right.norm() / side, 1, 1e-3);
            EXPECT_NEAR(down.norm() / side, 1, 1e-3);
            EXPECT_NEAR(right.dot(down) / (side * side), 0, 1e-3);
        }
    }
}

TEST(AlignOptions, AreRefusedOutOfRangeByTheirNames) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    for (const int width : {0, 224, 300, 8224, -1280}) {
        expectRefused<FeatureOptions>("width", [&](FeatureOptions& options) { options.width = width; });
    }
    for (const int bad : {0, -1, 50001}) {
        expectRefused<FeatureOptions>("most", [&](FeatureOptions& options) { options.most = bad; });
        expectRefused<MatchOptions>("firstLook", [&](MatchOptions& options) { options.firstLook = bad; });
        expectRefused<NeighbourOptions>("directions",
                                        [&](NeighbourOptions& options) { options.directions = bad; });
        expectRefused<NeighbourOptions>("mostAtOnePlace",
                                        [&](NeighbourOptions& options) { options.mostAtOnePlace = bad; });
    }
    for (const double bad : {0.0, -0.1, kNan, HUGE_VAL}) {
        expectRefused<FeatureOptions>("leastContrast",
                                      [&](FeatureOptions& options) { options.leastContrast = bad; });
        expectRefused<MatchOptions>("mostRatio", [&](MatchOptions& options) { options.mostRatio = bad; });
        expectRefused<MatchOptions>("reach", [&](MatchOptions& options) { options.reach = Radians(bad); });
        expectRefused<NeighbourOptions>("mostDistanceM",
                                        [&](NeighbourOptions& options) { options.mostDistanceM = bad; });
        expectRefused<SolveOptions>("held-out", [&](SolveOptions& options) { options.heldOutShare = bad; });
    }
    for (const double bad : {-2.0, kNan, 100.0}) {
        expectRefused<FeatureOptions>(
            "lowestElevation", [&](FeatureOptions& options) { options.lowestElevation = Radians(bad); });
        expectRefused<SolveOptions>("rail's place",
                                    [&](SolveOptions& options) { options.placementSigmaM = bad; });
        expectRefused<SolveOptions>("rail's heading",
                                    [&](SolveOptions& options) { options.placementSigma = Radians(bad); });
    }
    expectRefused<MatchOptions>("leastVotes", [](MatchOptions& options) { options.leastVotes = 2; });
    expectRefused<NeighbourOptions>("farDirections",
                                    [](NeighbourOptions& options) { options.farDirections = -1; });
    expectRefused<SolveOptions>("threads", [](SolveOptions& options) { options.threads = -1; });
}

TEST(AlignNames, OfModelsAndEffortsAreReadAsTheyAreWritten) {
    for (const Model model : {Model::Auto, Model::Yaw, Model::Tilt, Model::Placement, Model::Position}) {
        EXPECT_EQ(modelNamed(name(model)), model);
    }
    test::expectError(ErrorKind::InvalidInput, "placement and position", [] { modelNamed("Yaw"); });
    test::expectError(ErrorKind::InvalidInput, "fine and exact", [] { effortNamed(""); });
}

} // namespace spherewalk::align
