// SPDX-License-Identifier: GPL-3.0-or-later
#include "rooms.h"

#include "spherewalk/base/text.h"
#include "spherewalk/survey/plan.h"
#include "spherewalk/survey/plan_report.h"
#include "spherewalk/survey/walking_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <numeric>
#include <set>

namespace spherewalk::survey {

using Eigen::Vector2d;

namespace {

std::vector<Room> severalRooms() {
    spherewalk::test::Random random(2026);
    std::vector<Room> rooms{test::rectangularRoom(5, 4), test::lShape(), test::uShape()};
    rooms.push_back(test::rectangularRoom(5, 4));
    rooms.back().obstacles = {test::rectangle(2, 1.5, 3, 2.5)};
    for (int i = 0; i < 40; ++i) {
        rooms.push_back(test::randomRoom(random));
    }
    return rooms;
}

struct Example {
    Room room;
    PlanOptions options;
    Plan planned;
};

const std::vector<Example>& examples() {
    static const std::vector<Example> all = [] {
        std::vector<Example> made;
        for (const Room& room : severalRooms()) {
            for (const PlanOptions& options :
                 {PlanOptions{},
                  PlanOptions{.stepM = 0.35, .heightsM = {0.8, 1.6}, .railStops = 4, .clearanceM = 0.21}}) {
                made.push_back({room, options, plan(room, options)});
            }
        }
        return made;
    }();
    return all;
}

/// Calls the law for several rooms with several options; failures name the example.
template <class Law>
void forSeveralRooms(Law&& law) {
    for (std::size_t i = 0; i < examples().size(); ++i) {
        SCOPED_TRACE(testing::Message() << "example " << i << " of seed 2026");
        law(examples()[i]);
    }
}

} // namespace

TEST(Plan, KeepsEveryStopInsideAndClear) {
    std::size_t stations = 0;
    forSeveralRooms([&](const Example& example) {
        const auto& [room, options, planned] = example;
        for (const Station& station : planned.stations) {
            const Vector2d point = station.positionM.head<2>();
            EXPECT_TRUE(test::onFloor(room, point));
            EXPECT_GE(test::clearanceOf(room, point, point), options.clearanceM - 1e-6);
            ++stations;
        }
    });
    EXPECT_GT(stations, 5000U);
}

TEST(Plan, KeepsEveryRailClear) {
    forSeveralRooms([&](const Example& example) {
        const auto& [room, options, planned] = example;
        for (const RailPlacement& rail : planned.placements) {
            EXPECT_GE(test::clearanceOf(room, rail.origin, rail.stop(rail.stops - 1)),
                      options.clearanceM - 1e-6);
            EXPECT_GE(rail.stops, 1);
            EXPECT_LE(rail.stops, options.railStops);
        }
    });
}

TEST(Plan, PutsNoTwoStationsAtOnePosition) {
    forSeveralRooms([&](const Example& example) {
        const auto& [room, options, planned] = example;
        std::set<std::array<long long, 3>> micrometres;
        for (const Station& station : planned.stations) {
            const Eigen::Vector3d& p = station.positionM;
            micrometres.insert(
                {std::llround(p.x() * 1e6), std::llround(p.y() * 1e6), std::llround(p.z() * 1e6)});
        }
        EXPECT_EQ(micrometres.size(), planned.stations.size());
    });
}

TEST(Plan, ListsEveryStopOfEveryPlacementOnceInWalkingOrder) {
    forSeveralRooms([&](const Example& example) {
        const auto& [room, options, planned] = example;
        std::size_t next = 0;
        for (std::size_t rail = 0; rail < planned.placements.size(); ++rail) {
            for (int k = 0; k < planned.placements[rail].stops; ++k) {
                for (const double height : options.heightsM) {
                    ASSERT_LT(next, planned.stations.size());
                    const Station& station = planned.stations[next++];
                    EXPECT_EQ(station.placement, static_cast<int>(rail));
                    EXPECT_EQ(station.stop, k);
                    EXPECT_EQ(station.positionM.head<2>(), planned.placements[rail].stop(k));
                    EXPECT_EQ(station.positionM.z(), height);
                }
            }
        }
        EXPECT_EQ(next, planned.stations.size());
    });
}

TEST(Plan, PutsAllStopsOnOneLattice) {
    forSeveralRooms([&](const Example& example) {
        const auto& [room, options, planned] = example;
        for (const Station& station : planned.stations) {
            const Vector2d steps =
                (station.positionM - planned.stations.front().positionM).head<2>() / options.stepM;
            EXPECT_NEAR(steps.x(), std::round(steps.x()), 1e-6);
            EXPECT_NEAR(steps.y(), std::round(steps.y()), 1e-6);
        }
    });
}

TEST(Plan, IsTheSameEveryTime) {
    const Plan a = plan(test::uShape(), {});
    const Plan b = plan(test::uShape(), {});
    ASSERT_EQ(a.stations.size(), b.stations.size());
    for (std::size_t i = 0; i < a.stations.size(); ++i) {
        EXPECT_EQ(a.stations[i].positionM, b.stations[i].positionM);
    }
}

TEST(Plan, MovesWithTheRoomByAMillionMetres) {
    const Vector2d by(1e6, -1e6);
    forSeveralRooms([&](const Example& example) {
        const auto& [room, options, planned] = example;
        const Plan there = plan(test::moved(room, by), options);
        ASSERT_EQ(planned.placements.size(), there.placements.size());
        ASSERT_EQ(planned.stations.size(), there.stations.size());
        for (std::size_t i = 0; i < planned.stations.size(); ++i) {
            const Eigen::Vector3d expected =
                planned.stations[i].positionM + Eigen::Vector3d(by.x(), by.y(), 0);
            ASSERT_LT((there.stations[i].positionM - expected).norm(), 1e-6) << "station " << i;
        }
    });
}

TEST(Plan, CentresTheStopsOfARectangle) {
    // 4.4 m and 3.4 m are free: 23 and 18 stops, with no and with equal margins.
    const Plan planned = plan(test::rectangularRoom(5, 4.1), {.stepM = 0.2});
    Vector2d least(1e9, 1e9);
    Vector2d greatest(-1e9, -1e9);
    for (const Station& station : planned.stations) {
        least = least.cwiseMin(station.positionM.head<2>());
        greatest = greatest.cwiseMax(station.positionM.head<2>());
    }
    EXPECT_EQ(planned.stations.size(), 23U * 18U);
    EXPECT_NEAR(least.x(), 0.3, 1e-9);
    EXPECT_NEAR(greatest.x(), 4.7, 1e-9);
    EXPECT_NEAR(least.y(), 0.35, 1e-9);
    EXPECT_NEAR(greatest.y(), 3.75, 1e-9);
}

TEST(Plan, LaysRailsAlongTheAxisThatNeedsFewer) {
    // 10 stops by 6: along x 6 * 2 rails, along y 10 * 1.
    const Plan planned = plan(test::rectangularRoom(2.4, 1.6), {.stepM = 0.2, .railStops = 6});
    ASSERT_EQ(planned.stations.size(), 60U);
    EXPECT_EQ(planned.placements.size(), 10U);
    EXPECT_NEAR(std::abs(planned.placements.front().heading.value()), std::numbers::pi / 2, 1e-12);
}

TEST(Plan, SplitsLinesEvenly) {
    const Plan planned = plan(test::rectangularRoom(2 + 0.6, 0.7), {.stepM = 0.2, .railStops = 6});
    std::vector<int> stops;
    for (const RailPlacement& rail : planned.placements) {
        stops.push_back(rail.stops);
    }
    std::sort(stops.begin(), stops.end());
    EXPECT_EQ(stops, (std::vector<int>{5, 6})) << "11 stops";
}

TEST(Plan, ShiftsTheLatticeIntoANarrowBay) {
    // The bay's only line for stops is 0.1 m wide, and misses the lattice that is centred in the room.
    const Room room{
        .outline = {{0, 0}, {4, 0}, {4, 1.15}, {6, 1.15}, {6, 1.85}, {4, 1.85}, {4, 3.3}, {0, 3.3}},
        .obstacles = {},
        .ceilingM = 2.6};
    const Plan planned = plan(room, {.stepM = 0.4});
    const auto inBay = std::count_if(planned.stations.begin(), planned.stations.end(),
                                     [](const Station& station) { return station.positionM.x() > 4.2; });
    EXPECT_GE(inBay, 4);
}

TEST(Plan, IsEmptyInACorridorNarrowerThanTwiceTheClearance) {
    const Plan planned = plan(test::rectangularRoom(5, 0.59), {});
    EXPECT_TRUE(planned.stations.empty());
    EXPECT_TRUE(planned.placements.empty());
}

TEST(Plan, WalksAUOneArmAfterTheOther) {
    const Plan planned = plan(test::uShape(), {});
    int changes = 0;
    int arm = 0;
    for (const Station& station : planned.stations) {
        const int now = station.positionM.y() < 1.5 ? 0 : station.positionM.x() < 3 ? 1 : 2;
        changes += now != arm && now != 0 && arm != 0 ? 1 : 0;
        arm = now;
    }
    EXPECT_LE(changes, 0) << "the rail is carried straight from one arm to the other";
}

TEST(Plan, WalksNotMuchFartherThanTheShortestWay) {
    struct Case {
        Room room;
        PlanOptions options;
    };

    std::vector<Case> cases{{test::rectangularRoom(1.8, 1.6), {.stepM = 0.4, .railStops = 2}},
                            {test::rectangularRoom(3.2, 1.3), {.stepM = 0.4, .railStops = 4}},
                            {test::lShape(), {.stepM = 0.9, .railStops = 3}},
                            {test::uShape(), {.stepM = 1.2, .railStops = 3}}};
    spherewalk::test::Random random(8);
    while (cases.size() < 16) {
        const Case irregular{test::randomRoom(random), {.stepM = 0.7, .railStops = 3}};
        const std::size_t rails = plan(irregular.room, irregular.options).placements.size();
        if (rails >= 5 && rails <= 8) {
            cases.push_back(irregular);
        }
    }
    for (const Case& example : cases) {
        const Plan planned = plan(example.room, example.options);
        const std::size_t n = planned.placements.size();
        ASSERT_GE(n, 4U);
        ASSERT_LE(n, 8U);
        const WalkingDistance walking(example.room);
        const auto end = [&](std::size_t rail, bool last) {
            const RailPlacement& p = planned.placements[rail];
            return p.stop(last ? p.stops - 1 : 0);
        };
        std::vector<std::size_t> order(n);
        std::iota(order.begin(), order.end(), 0);
        // Table of all distances, then every order with every choice of directions.
        std::vector<std::vector<double>> table(2 * n, std::vector<double>(2 * n));
        for (std::size_t a = 0; a < 2 * n; ++a) {
            for (std::size_t b = 0; b < 2 * n; ++b) {
                table[a][b] = walking.between(end(a / 2, a % 2 != 0), end(b / 2, b % 2 != 0));
            }
        }
        double own = 0;
        for (std::size_t i = 1; i < n; ++i) {
            own += table[2 * (i - 1) + 1][2 * i];
        }
        double shortest = INFINITY;
        do {
            // Best directions for this order: entering rail i at its end e.
            std::array<double, 2> best{0, 0};
            for (std::size_t i = 1; i < n; ++i) {
                std::array<double, 2> next{INFINITY, INFINITY};
                for (std::size_t from = 0; from < 2; ++from) {
                    for (std::size_t to = 0; to < 2; ++to) {
                        next[to] = std::min(
                            next[to], best[from] + table[2 * order[i - 1] + (1 - from)][2 * order[i] + to]);
                    }
                }
                best = next;
            }
            shortest = std::min({shortest, best[0], best[1]});
        } while (std::next_permutation(order.begin(), order.end()));
        std::cout << n << " rails: carried " << own << " m, at best " << shortest << " m\n";
        EXPECT_GE(own, shortest - 1e-6);
        EXPECT_LE(own, shortest * 1.15);
    }
}

TEST(Plan, CarriesRailsNotMuchFartherThanTheGapsBetweenLines) {
    // A hall beyond the thorough search: a perfect sweep moves one step at each of its rails.
    const Room hall = test::rectangularRoom(40, 30);
    const PlanOptions options{.stepM = 0.4};
    const Plan planned = plan(hall, options);
    const PlanReport cost = report(hall, options, planned);
    const double perfect = options.stepM * double(planned.stations.size() - 1);
    ASSERT_GT(planned.placements.size(), 500U);
    std::cout << planned.placements.size() << " rails: walked " << cost.metresWalked << " m, at best "
              << perfect << " m\n";
    EXPECT_LE(cost.metresWalked, perfect * 1.05);
}

TEST(StationName, CountsFromOneAndNamesTheHeightOnlyIfThereAreSeveral) {
    const Plan one = plan(test::rectangularRoom(2, 2), {});
    EXPECT_EQ(stationName(one, 0), "rail 1, stop 1");
    EXPECT_EQ(stationName(one, 7),
              text("rail ", one.stations[7].placement + 1, ", stop ", one.stations[7].stop + 1));
    const Plan two = plan(test::rectangularRoom(2, 2), {.heightsM = {1.2, 1.8}});
    EXPECT_EQ(stationName(two, 0), "rail 1, stop 1 at 1.20 m");
    EXPECT_EQ(stationName(two, 1), "rail 1, stop 1 at 1.80 m");
}

TEST(StationName, SaysWhereAnUnplannedStationIs) {
    Plan imported;
    imported.stations.push_back({.placement = -1, .stop = 0, .positionM = {1.2, -0.001, 1.5}});
    EXPECT_EQ(stationName(imported, 0), "unplanned position (1.20, -0.00)");
}

TEST(StationName, IsDifferentForEveryStation) {
    forSeveralRooms([](const Example& example) {
        const auto& [room, options, planned] = example;
        const std::vector<std::string> names = stationNames(planned);
        EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
    });
}

} // namespace spherewalk::survey
