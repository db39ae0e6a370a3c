// SPDX-License-Identifier: GPL-3.0-or-later
#include "rooms.h"

#include "spherewalk/survey/marking.h"

#include <gtest/gtest.h>

#include <cmath>

namespace spherewalk::survey {

using Eigen::Vector2d;

namespace {

Room concaveRoom() {
    Room room;
    room.outline = {{0, 0}, {6, 0}, {6, 2.5}, {3, 2.5}, {3, 5}, {0, 5}};
    room.obstacles = {{{1, 1}, {1.8, 1}, {1.8, 1.6}, {1, 1.6}}};
    room.ceilingM = 2.6;
    return room;
}

/// A room with four cupboards, one in the line of sight of each corner from the middle.
Room roomOfFourCupboards() {
    Room room = test::rectangularRoom(4, 4);
    for (const Vector2d& at : {Vector2d(1, 1), Vector2d(3, 1), Vector2d(3, 3), Vector2d(1, 3)}) {
        room.obstacles.push_back(
            {at + Vector2d(-.3, -.3), at + Vector2d(.3, -.3), at + Vector2d(.3, .3), at + Vector2d(-.3, .3)});
    }
    return room;
}

Plan planOf(const Room& room) {
    PlanOptions options;
    options.stepM = 0.4;
    return plan(room, options);
}

/// Where two tapes meet, both ways.
std::array<Vector2d, 2> meetings(const Vector2d& a, double fromA, const Vector2d& b, double fromB) {
    const double apart = (b - a).norm();
    const Vector2d along = (b - a) / apart;
    const double x = (fromA * fromA - fromB * fromB + apart * apart) / (2 * apart);
    const double y = std::sqrt(std::max(0.0, fromA * fromA - x * x));
    const Vector2d across(-along.y(), along.x());
    return {a + x * along + y * across, a + x * along - y * across};
}

std::vector<MarkedPoint> allPoints(const Room& room) {
    std::vector<MarkedPoint> result;
    for (const RailMark& mark : railMarks(room, planOf(room))) {
        result.push_back(mark.first);
        result.push_back(mark.last);
    }
    return result;
}

} // namespace

TEST(Marking, TapesMeetInThePointAndNowhereElseInTheRoom) {
    const Room room = concaveRoom();
    for (const MarkedPoint& mark : allPoints(room)) {
        ASSERT_EQ(mark.tapes.size(), 2U);
        const Vector2d& a = room.outline[static_cast<std::size_t>(mark.tapes[0].from.index)];
        const Vector2d& b = room.outline[static_cast<std::size_t>(mark.tapes[1].from.index)];
        int inRoom = 0;
        double nearest = INFINITY;
        for (const Vector2d& meeting : meetings(a, mark.tapes[0].metres, b, mark.tapes[1].metres)) {
            inRoom += contains(room.outline, meeting) ? 1 : 0;
            nearest = std::min(nearest, (meeting - mark.point).norm());
        }
        EXPECT_EQ(inRoom, 1);
        EXPECT_LT(nearest, 1e-6);
    }
}

TEST(Marking, TapesRunOverFreeFloor) {
    const Room room = concaveRoom();
    for (const MarkedPoint& mark : allPoints(room)) {
        for (const TapeDistance& tape : mark.tapes) {
            const Vector2d& corner = room.outline[static_cast<std::size_t>(tape.from.index)];
            const Vector2d begin = corner + 0.02 * (mark.point - corner).normalized();
            EXPECT_GT(distanceToEdge(room.obstacles[0], begin, mark.point), 0);
            EXPECT_GT(distanceToEdge(room.outline, begin, mark.point), 0);
        }
    }
}

TEST(Marking, ARoomFarFromTheOriginGetsTheSameTapes) {
    Room far = concaveRoom();
    const Vector2d shift(1e6, -2e6);
    const auto move = [&](Polygon& polygon) {
        for (Vector2d& corner : polygon) {
            corner += shift;
        }
    };
    move(far.outline);
    move(far.obstacles[0]);
    const auto here = allPoints(concaveRoom());
    const auto there = allPoints(far);
    ASSERT_EQ(here.size(), there.size());
    for (std::size_t i = 0; i < here.size(); ++i) {
        ASSERT_EQ(here[i].tapes.size(), there[i].tapes.size());
        for (std::size_t k = 0; k < here[i].tapes.size(); ++k) {
            EXPECT_EQ(here[i].tapes[k].from, there[i].tapes[k].from);
            EXPECT_NEAR(here[i].tapes[k].metres, there[i].tapes[k].metres, 1e-6);
        }
    }
}

TEST(Marking, APointThatNoCornerSeesIsMeasuredSquareFromWalls) {
    const Room room = roomOfFourCupboards();
    Plan one;
    one.placements = {{{2, 2}, Radians(0), 1, 0.4}};
    const auto marks = railMarks(room, one);
    ASSERT_EQ(marks.size(), 1U);
    ASSERT_EQ(marks[0].first.tapes.size(), 2U);
    for (const TapeDistance& tape : marks[0].first.tapes) {
        EXPECT_EQ(tape.from.kind, TapeOrigin::Kind::Wall);
        EXPECT_NEAR(tape.metres, 2, 1e-9);
    }
    EXPECT_NEAR(*marks[0].first.errorM, std::sqrt(2) * kReadingErrorM, 1e-9);
    EXPECT_EQ(wallName(room, 0), "A-B");
    EXPECT_EQ(wallName(room, 3), "D-A");
}

TEST(Marking, APointInsideOfAnObstacleGetsNoTape) {
    Room room = test::rectangularRoom(4, 4);
    room.obstacles = {test::rectangle(1, 1, 3, 3)};
    Plan one;
    one.placements = {{{2, 2}, Radians(0), 1, 0.4}};
    const auto marks = railMarks(room, one);
    EXPECT_TRUE(marks[0].first.tapes.empty());
    EXPECT_FALSE(marks[0].first.errorM);
}

TEST(Marking, APointThatNoCornerSeesHangsOnTheRailBefore) {
    const Room room = roomOfFourCupboards();
    Plan two;
    two.placements = {{{0.6, 2}, Radians(0), 1, 0.4}, {{2, 2}, Radians(0), 1, 0.4}};
    const std::vector<RailMark> marks = railMarks(room, two);
    for (const TapeDistance& tape : marks[0].first.tapes) {
        EXPECT_EQ(tape.from.kind, TapeOrigin::Kind::Corner);
    }
    two.placements.insert(two.placements.begin(), {{2, 0.6}, Radians(0), 1, 0.4});
    const std::vector<RailMark> hung = railMarks(room, two);
    ASSERT_EQ(hung[2].first.tapes.size(), 2U);
    for (const TapeDistance& tape : hung[2].first.tapes) {
        EXPECT_NE(tape.from.kind, TapeOrigin::Kind::Corner);
        EXPECT_LT(tape.from.index, 2);
        EXPECT_NEAR((placeOf(tape.from, hung[2].first.point, room, two) - hung[2].first.point).norm(),
                    tape.metres, 1e-9);
    }
}

TEST(Marking, MeasuresFromTheOriginsThatItNames) {
    test::onRandomRooms(64, 20, [](const Room& room, const PlanOptions& options, auto&) {
        const Plan planned = plan(room, options);
        const std::vector<RailMark> marks = railMarks(room, planned);
        ASSERT_EQ(marks.size(), planned.placements.size());
        for (const RailMark& mark : marks) {
            const RailPlacement& rail = planned.placements[static_cast<std::size_t>(mark.placement)];
            EXPECT_EQ(mark.first.point, rail.origin);
            EXPECT_EQ(mark.last.point, rail.stop(rail.stops - 1));
            for (const MarkedPoint* point : {&mark.first, &mark.last}) {
                EXPECT_EQ(point->tapes.empty(), !point->errorM.has_value());
                for (const TapeDistance& tape : point->tapes) {
                    EXPECT_NEAR(tape.metres,
                                (point->point - placeOf(tape.from, point->point, room, planned)).norm(),
                                1e-8);
                    EXPECT_GE(*point->errorM, kReadingErrorM); // no better than a single tape
                }
            }
        }
    });
}

TEST(Marking, LettersStandOnTheFloorAndNearestToTheirOwnCorner) {
    test::onRandomRooms(65, 40, [](const Room& room, const PlanOptions& options, auto&) {
        const std::vector<Vector2d> labels = cornerLabels(room, plan(room, options), 0.35, 0.1);
        ASSERT_EQ(labels.size(), room.outline.size());
        for (std::size_t i = 0; i < labels.size(); ++i) {
            EXPECT_TRUE(contains(room.outline, labels[i])) << i;
            for (const Polygon& obstacle : room.obstacles) {
                EXPECT_FALSE(contains(obstacle, labels[i])) << i;
            }
            for (std::size_t k = 0; k < labels.size(); ++k) {
                EXPECT_LE((labels[i] - room.outline[i]).norm(), (labels[i] - room.outline[k]).norm());
            }
        }
    });
}

TEST(Marking, LettersOfAThinWallKeepApartFromEachOther) {
    Room room;
    room.outline = {{0, 0}, {3, 0}, {3, 3}, {3.1, 3}, {3.1, 0}, {6, 0}, {6, 4}, {0, 4}};
    room.ceilingM = 2.6;
    const std::vector<Vector2d> labels = cornerLabels(room, {}, 0.35, 0.1);
    for (std::size_t i = 0; i < labels.size(); ++i) {
        for (std::size_t k = i + 1; k < labels.size(); ++k) {
            EXPECT_GT((labels[i] - labels[k]).norm(), 0.2) << i << ' ' << k;
        }
    }
}

TEST(Marking, ChecksWithAThirdCorner) {
    const Room room = concaveRoom();
    int checked = 0;
    for (const MarkedPoint& mark : allPoints(room)) {
        if (!mark.check) {
            continue;
        }
        ++checked;
        for (const TapeDistance& tape : mark.tapes) {
            EXPECT_NE(tape.from, mark.check->from);
        }
        const Vector2d& corner = room.outline[static_cast<std::size_t>(mark.check->from.index)];
        EXPECT_NEAR(mark.check->metres, (mark.point - corner).norm(), 1e-8);
    }
    EXPECT_GT(checked, 0);
}

TEST(Marking, NamesCornersAsSheetsDo) {
    EXPECT_EQ(cornerName(0), "A");
    EXPECT_EQ(cornerName(25), "Z");
    EXPECT_EQ(cornerName(26), "AA");
    EXPECT_EQ(cornerName(27), "AB");
}

} // namespace spherewalk::survey
