// SPDX-License-Identifier: GPL-3.0-or-later
#include "rooms.h"

#include "spherewalk/survey/plan_report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace spherewalk::survey {

using Eigen::Vector2d;

namespace {

/// The law's own notion of coverage, with an allowance for the raster.
bool covered(const Room& room, const PlanOptions& options, const Plan& plan, const Vector2d& point,
             double allowanceM) {
    return std::any_of(plan.stations.begin(), plan.stations.end(), [&](const Station& station) {
        const Vector2d at = station.positionM.head<2>();
        return (at - point).norm() <= options.stepM * std::sqrt(0.5) + allowanceM &&
               test::clearanceOf(room, at, point) > 0;
    });
}

} // namespace

TEST(PlanReport, CountsTheCostOfAPlan) {
    // Two lines of three stops in a rectangle; the second is walked back.
    const Room room = test::rectangularRoom(1, 0.8);
    const PlanOptions options{.stepM = 0.2, .railStops = 3, .secondsPerPhoto = 10, .secondsPerPlacement = 90};
    const PlanReport cost = report(room, options, plan(room, options));
    EXPECT_EQ(cost.stations, 6);
    EXPECT_EQ(cost.placements, 2);
    EXPECT_NEAR(cost.metresWalked, 0.4 + 0.2 + 0.4, 1e-9);
    EXPECT_NEAR(cost.minutes, (6 * 10 + 2 * 90) / 60.0, 1e-12);
    EXPECT_NEAR(cost.floorM2, 0.8, 1e-9);
}

TEST(PlanReport, TotalsAreThoseOfThePlansParts) {
    test::onRandomRooms(65, 12, [](const Room& room, const PlanOptions& options, auto&) {
        const Plan planned = plan(room, options);
        const PlanReport found = report(room, options, planned);
        const double seconds = options.secondsPerPhoto * static_cast<double>(planned.stations.size()) +
                               options.secondsPerPlacement * static_cast<double>(planned.placements.size());
        double alongRailsM = 0;
        for (const RailPlacement& rail : planned.placements) {
            alongRailsM += rail.stepM * (rail.stops - 1);
        }
        EXPECT_NEAR(found.minutes, seconds / 60, 1e-9);
        EXPECT_EQ(found.stations, static_cast<int>(planned.stations.size()));
        EXPECT_EQ(found.placements, static_cast<int>(planned.placements.size()));
        EXPECT_GE(found.metresWalked, alongRailsM - 1e-9);
        EXPECT_GE(found.uncoveredM2, 0);
        EXPECT_LE(found.uncoveredM2, found.floorM2 + 1e-9);
    });
}

TEST(PlanReport, ReportsTheMarginOfARectangleAsClearance) {
    const Room room = test::rectangularRoom(5, 4);
    const PlanReport found = report(room, {}, plan(room, {}));
    ASSERT_EQ(found.uncovered.size(), 1U);
    EXPECT_EQ(found.uncovered[0].reason, UncoveredReason::Clearance);
    // The stops' own rectangle and at most half a diagonal around it are covered.
    EXPECT_GT(found.uncoveredM2, 20 - (4.4 + 0.283) * (3.4 + 0.283));
    EXPECT_LT(found.uncoveredM2, 20 - 4.4 * 3.4);
    EXPECT_NEAR(found.floorM2, 20, 1e-9);
}

TEST(PlanReport, LeavesNoFloorOutSilently) {
    spherewalk::test::Random random(77);
    for (int i = 0; i < 40; ++i) {
        SCOPED_TRACE(testing::Message() << "seed " << random.seed() << " room " << i);
        const Room room = test::randomRoom(random);
        const PlanOptions options{.stepM = random.uniform(0.15, 0.6),
                                  .clearanceM = random.uniform(0.05, 0.4)};
        const Plan planned = plan(room, options);
        const PlanReport found = report(room, options, planned);
        int onFloor = 0;
        int uncovered = 0;
        const int tries = 8000;
        for (int k = 0; k < tries; ++k) {
            const Vector2d point(random.uniform(-3, 5), random.uniform(-6, 2));
            if (test::onFloor(room, point)) {
                ++onFloor;
                uncovered += covered(room, options, planned, point, 0) ? 0 : 1;
            }
        }
        const double perPoint = 64.0 / tries;
        // Four standard deviations of the counts, and the raster's own error along edges.
        const double allowance = 4 * std::sqrt(tries / 4.0) * perPoint + 0.3;
        EXPECT_NEAR(found.floorM2, onFloor * perPoint, allowance);
        EXPECT_NEAR(found.uncoveredM2, uncovered * perPoint, allowance);
        double sum = 0;
        for (const UncoveredArea& area : found.uncovered) {
            sum += area.areaM2;
            EXPECT_TRUE(test::onFloor(room, area.point));
            EXPECT_FALSE(covered(room, options, planned, area.point, -1e-4));
        }
        EXPECT_NEAR(sum, found.uncoveredM2, 1e-9);
        EXPECT_TRUE(std::is_sorted(
            found.uncovered.begin(), found.uncovered.end(),
            [](const UncoveredArea& a, const UncoveredArea& b) { return a.areaM2 > b.areaM2; }));
    }
}

TEST(PlanReport, SaysThatAnEmptyCorridorIsAllClearance) {
    const Room room = test::rectangularRoom(5, 0.59);
    const PlanReport found = report(room, {}, plan(room, {}));
    EXPECT_EQ(found.stations, 0);
    EXPECT_EQ(found.metresWalked, 0);
    ASSERT_EQ(found.uncovered.size(), 1U);
    EXPECT_NEAR(found.uncoveredM2, 5 * 0.59, 1e-9);
    EXPECT_EQ(found.uncovered[0].reason, UncoveredReason::Clearance);
    EXPECT_EQ(reasonText(found.uncovered[0].reason, {}), "it is closer than 0.30 m to a wall or an obstacle");
}

TEST(PlanReport, NamesABayThatTheLatticeMisses) {
    // Two bays whose lines for stops lie two and a half steps apart: the lattice can reach one of them.
    const Room room{.outline = {{0, 0},
                                {4, 0},
                                {4, 0.65},
                                {24, 0.65},
                                {24, 1.35},
                                {4, 1.35},
                                {4, 2.15},
                                {24, 2.15},
                                {24, 2.85},
                                {4, 2.85},
                                {4, 4},
                                {0, 4}},
                    .obstacles = {},
                    .ceilingM = 2.6};
    const PlanOptions options{.stepM = 0.6, .heightsM = {1.2}, .clearanceM = 0.3};
    const PlanReport found = report(room, options, plan(room, options));
    const auto isMissed = [](const UncoveredArea& area) {
        return area.reason == UncoveredReason::BetweenStops;
    };
    const auto missed = std::find_if(found.uncovered.begin(), found.uncovered.end(), isMissed);
    ASSERT_NE(missed, found.uncovered.end());
    EXPECT_EQ(std::count_if(found.uncovered.begin(), found.uncovered.end(), isMissed), 1);
    EXPECT_GT(missed->point.x(), 4);
    EXPECT_GT(missed->areaM2, 20 * 0.05);
    EXPECT_EQ(reasonText(missed->reason, options), "no stop of the grid falls there; try a finer step");
}

TEST(PlanReport, LeavesOutAndNamesAPocketThatObstaclesEnclose) {
    Room room = test::rectangularRoom(6, 4);
    // A screen across the corner: the pocket behind it has room for stops, but no way in.
    room.obstacles = {test::rectangle(-0.1, 2, 2.1, 2.1), test::rectangle(2, 2, 2.1, 4.1)};
    const Plan planned = plan(room, {});
    for (const Station& station : planned.stations) {
        EXPECT_FALSE(station.positionM.x() < 2 && station.positionM.y() > 2.1);
    }
    const PlanReport found = report(room, {}, planned);
    const auto pocket =
        std::find_if(found.uncovered.begin(), found.uncovered.end(),
                     [](const UncoveredArea& area) { return area.reason == UncoveredReason::Enclosed; });
    ASSERT_NE(pocket, found.uncovered.end());
    EXPECT_NEAR(pocket->areaM2, 2 * 1.9, 0.1);
    EXPECT_EQ(reasonText(pocket->reason, {}), "obstacles cut it off from the rest of the floor");
    room.obstacles.pop_back();
    const Plan open = plan(room, {});
    EXPECT_TRUE(std::any_of(open.stations.begin(), open.stations.end(), [](const Station& station) {
        return station.positionM.x() < 2 && station.positionM.y() > 2.1;
    }));
}

TEST(PlanReport, DoesNotCountFloorBehindAWallAsCovered) {
    // A screen thinner than the reach of the stops stands between the only stop and the floor behind it.
    const Room room{.outline = test::rectangle(0, 0, 2, 1),
                    .obstacles = {test::rectangle(1, -0.1, 1.01, 1.1)},
                    .ceilingM = 2.6};
    Plan planned;
    planned.stations.push_back({.placement = -1, .stop = 0, .positionM = {0.8, 0.5, 1.2}});
    const PlanOptions options{.stepM = 1, .clearanceM = 0.05};
    const PlanReport found = report(room, options, planned);
    EXPECT_GT(found.uncoveredM2, 0.99);
}

TEST(PlanReport, IsTheSameAtAMillionMetres) {
    spherewalk::test::Random random(5);
    for (int i = 0; i < 10; ++i) {
        const Room room = test::randomRoom(random);
        const Room far = test::moved(room, {1e6, 1e6});
        const PlanReport here = report(room, {}, plan(room, {}));
        const PlanReport there = report(far, {}, plan(far, {}));
        EXPECT_NEAR(here.metresWalked, there.metresWalked, 1e-5);
        EXPECT_NEAR(here.uncoveredM2, there.uncoveredM2, 0.01);
        EXPECT_EQ(here.stations, there.stations);
    }
}

} // namespace spherewalk::survey
