// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "rooms.h"

#include <cmath>

namespace spherewalk::survey {

using spherewalk::test::expectError;

namespace {

void expectRefused(const Room& room, const std::string& part) {
    expectError(ErrorKind::InvalidInput, part, [&] { room.validate(); });
}

void expectRefused(const PlanOptions& options, const std::string& part) {
    expectError(ErrorKind::InvalidInput, part, [&] { options.validate(test::rectangularRoom(5, 4)); });
}

} // namespace

TEST(Room, AcceptsConcaveOutlinesWithObstaclesAtTheWall) {
    Room room = test::uShape();
    room.obstacles = {test::rectangle(-0.1, 2, 0.3, 3), test::rectangle(2, 0.2, 3, 0.8)};
    EXPECT_NO_THROW(room.validate());
}

TEST(Room, RefusesAnOutlineThatCrossesItself) {
    expectRefused({{{0, 0}, {2, 2}, {2, 0}, {0, 2}}, {}, 2.6},
                  "The outline cannot be used: the wall after corner 1 crosses the wall after corner 3.");
}

TEST(Room, RefusesAnOutlineOfTwoCorners) {
    expectRefused({{{0, 0}, {2, 2}}, {}, 2.6}, "The outline cannot be used: it has 2 corners");
}

TEST(Room, RefusesCoordinatesThatAreNoNumbers) {
    expectRefused({{{0, 0}, {2, NAN}, {2, 2}}, {}, 2.6}, "a coordinate is not a number");
}

TEST(Room, RefusesCoordinatesTooFarToBeExact) {
    expectRefused(test::moved(test::rectangularRoom(3, 3), {1e9, 0}), "move the origin into the building");
}

TEST(Room, RefusesARoomInMillimetres) {
    expectRefused(test::rectangularRoom(5000, 4000), "check its unit (metres)");
}

TEST(Room, RefusesTooManyCorners) {
    Room room = test::rectangularRoom(5, 4);
    for (int i = 0; i < 700; ++i) {
        room.obstacles.push_back({{1, 1}, {2, 1}, {1, 2}});
    }
    expectRefused(room, "The room has 2104 corners, more than the 2000 allowed");
}

TEST(Room, RefusesACeilingThatIsNotAboveTheFloor) {
    for (const double ceiling : {0.0, -1.0, double(NAN), double(INFINITY)}) {
        Room room = test::rectangularRoom(5, 4);
        room.ceilingM = ceiling;
        expectRefused(room, "The ceiling cannot be at");
    }
}

TEST(Room, NamesTheObstacleThatIsOutsideOrDefective) {
    Room room = test::rectangularRoom(5, 4);
    room.obstacles = {test::rectangle(1, 1, 2, 2), test::rectangle(6, 1, 7, 2)};
    expectRefused(room, "The obstacle 2 lies outside the outline");
    room.obstacles = {{{1, 1}, {2, 2}, {2, 1}, {1, 2}}};
    expectRefused(room, "The obstacle 1 cannot be used");
}

TEST(PlanOptions, RefusesStepsThatAreNoDistance) {
    for (const double step : {0.0, -0.2, double(NAN), double(INFINITY), 0.001, 1000.0}) {
        expectRefused({.stepM = step}, "cannot be used: give 0.01 to 100 m");
    }
}

TEST(PlanOptions, RefusesHeightsOutsideTheRoom) {
    for (const double height : {0.0, -1.0, 2.6, 3.0, double(NAN)}) {
        expectRefused({.heightsM = {1.2, height}}, "The lens cannot be at");
    }
}

TEST(PlanOptions, RefusesNoHeightAndTheSameHeightTwice) {
    expectRefused({.heightsM = {}}, "A plan needs from one to 50 heights of the lens, not 0.");
    expectRefused({.heightsM = {1.2, 0.8, 1.2}}, "The height of 1.2 m is listed twice");
}

TEST(PlanOptions, RefusesOtherNumbersOutsideTheirRange) {
    expectRefused({.railStops = 0}, "A rail with 0 stops cannot be used");
    expectRefused({.clearanceM = NAN}, "The clearance of nan m cannot be used");
    expectRefused({.clearanceM = 0}, "The clearance of 0 m cannot be used");
    expectRefused({.secondsPerPhoto = -1}, "The pace per photo of -1 s cannot be used");
    expectRefused({.secondsPerPlacement = NAN}, "The pace per rail placement");
}

TEST(PlanOptions, SaysWhichStepWouldFitWhenThereAreTooManyStations) {
    // The first is refused for its stations, the second, a hall, for its lattice alone.
    for (const double side : {9.0, 1000.0}) {
        const Room room = test::rectangularRoom(side, side);
        PlanOptions options{.stepM = 0.01};
        try {
            plan(room, options);
            FAIL() << "a step of a centimetre was accepted";
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::InvalidInput);
            const std::string& sentence = error.sentence();
            const std::string before = "A step of ";
            const std::size_t at = sentence.rfind(before) + before.size();
            options.stepM = std::stod(sentence.substr(at));
            EXPECT_GT(options.stepM, 0.01) << sentence;
            EXPECT_NO_THROW(options.validate(room)) << sentence;
        }
        if (side < 10) {
            const std::size_t stations = plan(room, options).stations.size();
            EXPECT_LE(stations, std::size_t(kMostStations));
            EXPECT_GT(stations, std::size_t(kMostStations / 4)) << "the step is coarser than needed";
        }
    }
}

} // namespace spherewalk::survey
