// SPDX-License-Identifier: GPL-3.0-or-later
#include "rails.h"
#include "rooms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace spherewalk::survey {

using Eigen::Vector2d;

TEST(StopGrid, HasFreePointsOnTheFloorThatKeepTheClearance) {
    test::onRandomRooms(61, 40, [](const Room& room, const PlanOptions& options, auto&) {
        const Floor floor(room);
        const StopGrid grid = bestStopGrid(floor, options);
        int free = 0;
        for (int row = 0; row < grid.rows; ++row) {
            for (int column = 0; column < grid.columns; ++column) {
                const Vector2d point = floor.anchor() + grid.at(column, row);
                const bool isClear = test::onFloor(room, point) &&
                                     test::clearanceOf(room, point, point) >= options.clearanceM - 1e-6;
                EXPECT_TRUE(isClear || !grid.isFree(column, row)) << column << ", " << row;
                free += grid.isFree(column, row) ? 1 : 0;
            }
        }
        EXPECT_EQ(grid.freeCount(), free);
    });
}

TEST(StopGrid, LeavesOutWhatObstaclesEnclose) {
    Room room = test::rectangularRoom(6, 4);
    // Four cupboards around a court of a square metre.
    room.obstacles = {test::rectangle(2, 1, 4, 1.3), test::rectangle(2, 2.3, 4, 2.6),
                      test::rectangle(2, 1.2, 2.5, 2.4), test::rectangle(3.5, 1.2, 4, 2.4)};
    const Floor floor(room);
    PlanOptions options;
    options.clearanceM = 0.1;
    const StopGrid grid = bestStopGrid(floor, options);
    EXPECT_GT(grid.freeCount(), 100);
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            const Vector2d point = grid.at(column, row);
            const bool isInside = point.x() > 2 && point.x() < 4 && point.y() > 1 && point.y() < 2.6;
            EXPECT_FALSE(isInside && grid.isFree(column, row)) << point.transpose();
        }
    }
}

TEST(Rails, HoldEveryFreePointOnceAlongEitherAxis) {
    test::onRandomRooms(62, 30, [](const Room& room, const PlanOptions& options, auto&) {
        const Floor floor(room);
        const StopGrid grid = bestStopGrid(floor, options);
        for (const bool alongX : {true, false}) {
            std::vector<int> held(grid.free.size());
            for (const Rail& rail : railsAlong(alongX, grid, floor, options)) {
                EXPECT_GE(rail.stops, 1);
                EXPECT_LE(rail.stops, options.railStops);
                for (int k = 0; k < rail.stops; ++k) {
                    const int column = rail.column + (alongX ? k : 0);
                    const int row = rail.row + (alongX ? 0 : k);
                    EXPECT_TRUE(grid.isFree(column, row));
                    ++held[static_cast<std::size_t>(row * grid.columns + column)];
                }
            }
            EXPECT_TRUE(std::equal(held.begin(), held.end(), grid.free.begin()));
        }
    });
}

TEST(Route, WalksEveryRailOnceAndCarriesAsFarAsItsParts) {
    test::onRandomRooms(63, 20, [](const Room& room, const PlanOptions& options, auto&) {
        const Plan planned = plan(room, options);
        const WalkingDistance walking(room);
        std::vector<RailEnds> ends;
        for (const RailPlacement& rail : planned.placements) {
            const int line = static_cast<int>(ends.size());
            ends.push_back({rail.origin, rail.stop(rail.stops - 1), line, 0, rail.stops});
        }
        const std::vector<Leg> route = shortRoute(ends, walking);
        std::vector<int> order;
        double carriedM = 0;
        Vector2d at = Vector2d::Zero();
        for (const Leg& leg : route) {
            const RailEnds& rail = ends[static_cast<std::size_t>(leg.rail)];
            carriedM += order.empty() ? 0 : walking.between(at, leg.backwards ? rail.last : rail.first);
            at = leg.backwards ? rail.first : rail.last;
            order.push_back(leg.rail);
        }
        EXPECT_NEAR(carryingDistance(ends, route, walking), carriedM, 1e-6);
        std::ranges::sort(order);
        std::vector<int> every(ends.size());
        std::iota(every.begin(), every.end(), 0);
        EXPECT_EQ(order, every);
    });
}

} // namespace spherewalk::survey
