// SPDX-License-Identifier: GPL-3.0-or-later
#include "rooms.h"

#include "spherewalk/base/error.h"
#include "spherewalk/survey/laid_rails.h"
#include "spherewalk/survey/plan_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace spherewalk::survey {

using Eigen::Vector2d;
using testing::HasSubstr;

namespace {

constexpr double kTightM = 1e-9;

const Room kRoom = test::rectangularRoom(5, 4);
const PlanOptions kOptions{.stepM = 0.4, .heightsM = {1.0, 1.6}};

RailPlacement railAlongX(double x, double y, int stops) {
    return {{x, y}, Radians(0), stops, 0.4};
}

std::string refusal(const Room& room, const std::vector<RailPlacement>& rails) {
    try {
        planOfLaid(room, kOptions, rails);
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::InvalidInput);
        return error.sentence();
    }
    return "";
}

void expectSame(const RailPlacement& a, const RailPlacement& b) {
    ASSERT_EQ(a.stops, b.stops);
    for (int k = 0; k < a.stops; ++k) {
        EXPECT_LT((a.stop(k) - b.stop(k)).norm(), kTightM) << k;
    }
}

double nearestStop(const Vector2d& at, const RailPlacement& rail) {
    double least = 1e9;
    for (int k = 0; k < rail.stops; ++k) {
        least = std::min(least, (rail.stop(k) - at).norm());
    }
    return least;
}

} // namespace

TEST(LaidRails, MakeAPlanInTheirOrderWithAStationForEachStopAndHeight) {
    const RailPlacement slanted{{3, 1}, Radians(0.7), 3, 0.4};
    const Plan plan = planOfLaid(kRoom, kOptions, std::vector{slanted, railAlongX(1, 3, 2)});
    EXPECT_TRUE(plan.isByHand);
    ASSERT_EQ(plan.stations.size(), 10U);
    EXPECT_EQ(stationName(plan, 9), "rail 2, stop 2 at 1.60 m");
    EXPECT_LT(
        (plan.stations[5].positionM - Eigen::Vector3d(slanted.stop(2).x(), slanted.stop(2).y(), 1.6)).norm(),
        kTightM);
    EXPECT_EQ(report(kRoom, kOptions, plan).stations, 10);
}

TEST(LaidRails, AreRefusedOffTheFloorThroughWallsAndAtOnePlace) {
    EXPECT_EQ(refusal(kRoom, {railAlongX(1, 1, 6), railAlongX(1, 2, 3)}), "");
    EXPECT_THAT(refusal(kRoom, {railAlongX(1, 1, 6), railAlongX(4, 2, 6)}),
                HasSubstr("Rail 2 cannot lie there"));
    EXPECT_THAT(refusal(kRoom, {railAlongX(0.5, 4, 2)}), HasSubstr("Rail 1 cannot lie there"));
    Room withShelf = kRoom;
    withShelf.obstacles = {test::rectangle(2.1, 0.9, 2.2, 1.1)}; // between two stops
    EXPECT_THAT(refusal(withShelf, {railAlongX(1, 1, 6)}), HasSubstr("an obstacle"));
    EXPECT_EQ(refusal(kRoom, {railAlongX(1, 1, 3), railAlongX(1, 2, 3), {{1.8, 1}, Radians(1.5), 3, 0.4}}),
              "Rails 1 and 3 have a stop at the same place; move one of them.");
    EXPECT_THAT(refusal(kRoom, {{{NAN, 1}, Radians(0), 2, 0.4}}), HasSubstr("Rail 1 cannot lie there"));
}

TEST(LaidRails, ArePulledByEitherEndWhileTheOtherStays) {
    const RailPlacement rail = railAlongX(1, 1, 4);
    const RailPlacement longer = pulled(rail, RailEnd::Last, {1 + 0.4 * 6 * 0.8, 1 + 0.4 * 6 * 0.6});
    EXPECT_EQ(longer.stops, 7);
    EXPECT_LT((longer.stop(6) - Vector2d(2.92, 2.44)).norm(), kTightM);
    const RailPlacement byFirst = pulled(rail, RailEnd::First, {2.2, 1.8});
    EXPECT_EQ(byFirst.stops, 3);
    EXPECT_LT((byFirst.stop(2) - rail.stop(3)).norm(), kTightM) << "the last stop stays the last";
    EXPECT_LT((byFirst.origin - Vector2d(2.2, 1.8)).norm(), kTightM);
    EXPECT_EQ(pulled(rail, RailEnd::Last, {1.1, 1.1}).stops, 1);
    EXPECT_EQ(pulled(rail, RailEnd::Last, {1e9, 1}).stops, kMostRailStops);
}

TEST(LaidRails, TurnAroundTheirMiddle) {
    const RailPlacement rail = railAlongX(1, 1, 4);
    const RailPlacement upright = turned(rail, Radians(std::numbers::pi / 2));
    EXPECT_LT((upright.origin - Vector2d(1.6, 0.4)).norm(), kTightM);
    RailPlacement around = rail;
    for (int i = 0; i < 360; ++i) {
        around = turned(around, Degrees(1));
    }
    expectSame(around, rail);
}

TEST(LaidRails, KeepAllStopsWhenSplitAndAllOthersWhenOneIsRemoved) {
    const RailPlacement rail{{1, 1}, Radians(2), 5, 0.4, true};
    for (int stop = 0; stop < rail.stops; ++stop) {
        std::vector<Vector2d> left;
        for (const RailPlacement& part : withoutStop(rail, stop)) {
            EXPECT_TRUE(part.isLocked);
            for (int k = 0; k < part.stops; ++k) {
                left.push_back(part.stop(k));
            }
        }
        ASSERT_EQ(left.size(), 4U);
        for (int k = 0; k < 4; ++k) {
            EXPECT_LT((left[static_cast<std::size_t>(k)] - rail.stop(k < stop ? k : k + 1)).norm(), kTightM);
        }
    }
    EXPECT_TRUE(withoutStop(railAlongX(1, 1, 1), 0).empty());
    const std::vector<RailPlacement> parts = split(rail, 2);
    expectSame(parts[0], withStops(rail, 2));
    EXPECT_LT((parts[1].origin - rail.stop(2)).norm(), kTightM);
    EXPECT_EQ(parts[1].stops, 3);
}

TEST(LaidRails, StayWhenTheRestIsLaidAroundThem) {
    const std::vector<RailPlacement> locked{{{1.3, 1.1}, Radians(0.4), 5, 0.4, true},
                                            {{3.5, 3.2}, Radians(-2), 3, 0.4, true}};
    const Plan rest = plan(kRoom, kOptions, locked);
    const Plan alone = plan(kRoom, kOptions);
    EXPECT_TRUE(rest.isByHand);
    EXPECT_FALSE(alone.isByHand);
    for (const RailPlacement& rail : locked) {
        const auto kept = std::ranges::find_if(rest.placements, [&](const RailPlacement& one) {
            return one.isLocked && one.stops == rail.stops &&
                   std::min((one.origin - rail.origin).norm(),
                            (one.stop(one.stops - 1) - rail.origin).norm()) < kTightM;
        });
        EXPECT_NE(kept, rest.placements.end());
    }
    int free = 0;
    for (const RailPlacement& rail : rest.placements) {
        for (int k = 0; k < rail.stops && !rail.isLocked; ++k) {
            ++free;
            for (const RailPlacement& one : locked) {
                EXPECT_GE(nearestStop(rail.stop(k), one), 0.2 - 1e-6);
            }
        }
    }
    EXPECT_GT(free, static_cast<int>(alone.stations.size()) / 2 - 2 * 8)
        << "each takes two points of the grid at most";
    EXPECT_LE(report(kRoom, kOptions, rest).uncoveredM2, report(kRoom, kOptions, alone).uncoveredM2 + 0.2);
    EXPECT_THROW(plan(kRoom, kOptions, std::vector{railAlongX(4, 2, 6)}), Error);
}

TEST(LaidRails, AreRightAMillionMetresAway) {
    Room far = kRoom;
    for (Vector2d& corner : far.outline) {
        corner += Vector2d(1e6, -1e6);
    }
    const RailPlacement rail{{1e6 + 1, -1e6 + 1}, Radians(0.3), 5, 0.4};
    const Plan planned = planOfLaid(far, kOptions, std::vector{rail});
    const RailPlacement back = turned(turned(rail, Radians(1)), Radians(-1));
    EXPECT_EQ(planned.stations.size(), 10U);
    EXPECT_LT((back.origin - rail.origin).norm(), 1e-9);
}

} // namespace spherewalk::survey
