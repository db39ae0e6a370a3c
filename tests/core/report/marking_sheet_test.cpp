// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "pdf_reading.h"

#include "spherewalk/base/text.h"
#include "spherewalk/report/page_layout.h"
#include "spherewalk/report/printed_sheets.h"
#include "spherewalk/survey/marking.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string_view>

namespace spherewalk::report {

namespace {

survey::Room sheetRoom() {
    survey::Room result;
    result.outline = {{0, 0}, {5, 0}, {5, 4}, {0, 4}};
    result.ceilingM = 2.6;
    return result;
}

Bytes sheetAt(double stepM) {
    survey::PlanOptions options;
    options.stepM = stepM;
    options.railStops = 3;
    return markingSheet("lab", sheetRoom(), options, survey::plan(sheetRoom(), options));
}

constexpr double kLineMm = 0.03; ///< Coordinates in a PDF are rounded.

bool isAt(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return (a - b).norm() < kLineMm;
}

/// A sheet, and what it was made from.
struct Sheet {
    survey::Room room = sheetRoom();
    survey::PlanOptions options{0.6, {1.2}, 3};
    survey::Plan plan = survey::plan(room, options);
    SheetWords words;

    std::vector<test::PdfPage> pages() const {
        const Bytes bytes = markingSheet("lab", room, options, plan, words);
        return test::PdfReading(bytes).pages();
    }

    Eigen::Vector2d onPaper(const Eigen::Vector2d& inRoom) const {
        return layoutOf(room.outline).paperFromRoom(inRoom);
    }

    bool hasLine(const test::PdfPage& page, const Eigen::Vector2d& a, const Eigen::Vector2d& b) const {
        return std::any_of(page.segments.begin(), page.segments.end(), [&](const test::PdfSegment& one) {
            return (isAt(one.from, onPaper(a)) && isAt(one.to, onPaper(b))) ||
                   (isAt(one.from, onPaper(b)) && isAt(one.to, onPaper(a)));
        });
    }
};

std::vector<test::PdfWords> allOf(const test::PdfPage& page, const std::string& words) {
    std::vector<test::PdfWords> result;
    std::copy_if(page.words.begin(), page.words.end(), std::back_inserter(result),
                 [&](const test::PdfWords& one) { return one.words == words; });
    return result;
}

} // namespace

TEST(MarkingSheet, DrawsWallsAndObstaclesToScale) {
    Sheet sheet;
    sheet.room.outline = {{-1, 2}, {4, 2}, {4, 6}, {1, 6}, {1, 5}, {-1, 5}};
    sheet.room.obstacles = {{{2, 3}, {3, 3}, {2.5, 4}}};
    sheet.plan = survey::plan(sheet.room, sheet.options);
    const std::vector<test::PdfPage> pages = sheet.pages();
    for (const Polygon& polygon : {sheet.room.outline, sheet.room.obstacles.front()}) {
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            EXPECT_TRUE(sheet.hasLine(pages.front(), polygon[i], polygon[(i + 1) % polygon.size()])) << i;
        }
    }
    EXPECT_FALSE(sheet.hasLine(pages.front(), {-1, 2}, {4, 6})); // no wall
}

TEST(MarkingSheet, HasAScaleBarOfTenCentimetres) {
    const Sheet sheet;
    const test::PdfPage page = sheet.pages().front();
    const double y = page.heightMm - kMarginMm - 6;
    int ticks = 0;
    bool hasBar = false;
    for (const test::PdfSegment& one : page.segments) {
        if (isAt(one.from, {kMarginMm, y}) && isAt(one.to, {kMarginMm + 100, y})) {
            hasBar = true;
        } else if (std::abs(one.from.y() - y) < kLineMm) {
            EXPECT_NEAR(one.from.x(), kMarginMm + 10.0 * ticks++, kLineMm);
            EXPECT_NEAR(one.to.x(), one.from.x(), kLineMm);
        }
    }
    EXPECT_TRUE(hasBar);
    EXPECT_EQ(ticks, 11);
    const std::string scale = "Scale 1:" + std::to_string(layoutOf(sheet.room.outline).scale) + ".";
    EXPECT_TRUE(std::any_of(page.words.begin(), page.words.end(),
                            [&](const test::PdfWords& one) { return one.words.starts_with(scale); }));
}

TEST(MarkingSheet, MarksEachStopWhereItIs) {
    const Sheet sheet;
    const test::PdfPage page = sheet.pages().front();
    std::size_t stops = 0;
    for (const survey::RailPlacement& rail : sheet.plan.placements) {
        for (int k = 0; k < rail.stops; ++k, ++stops) {
            EXPECT_EQ(std::count_if(page.rounds.begin(), page.rounds.end(),
                                    [&](const test::PdfRound& round) {
                                        return isAt(round.centre, sheet.onPaper(rail.stop(k))) &&
                                               round.isFilled == (k > 0); // a ring for the first
                                    }),
                      1);
        }
    }
    EXPECT_EQ(page.rounds.size(), stops);
    EXPECT_GT(stops, 10U);
}

TEST(MarkingSheet, NamesLengthsOutsideOfTheRoom) {
    const Sheet sheet;
    const test::PdfPage page = sheet.pages().front();
    Polygon walls;
    for (const Eigen::Vector2d& corner : sheet.room.outline) {
        walls.push_back(sheet.onPaper(corner));
    }
    for (const auto& [words, times] : {std::pair("5.00 m", 2U), {"4.00 m", 2U}}) {
        const std::vector<test::PdfWords> found = allOf(page, words);
        EXPECT_EQ(found.size(), times) << words;
        for (const test::PdfWords& one : found) {
            for (const double share : {0.0, 0.5, 1.0}) {
                EXPECT_FALSE(contains(walls, one.at + Eigen::Vector2d(share * one.widthMm, -1))) << words;
            }
            EXPECT_GE(one.at.x(), 0) << words;
            EXPECT_LE(one.rightMm(), page.widthMm) << words;
        }
    }
}

TEST(MarkingSheet, NamesEachCornerOfAThinWallOnItsOwnSide) {
    for (const double depth : {4.0, 9.0}) { // in two scales
        Sheet sheet;
        const double door = 0.4 * depth;
        sheet.room.outline = {{0, 0},          {3, 0},        {3, door},  {3.1, door},
                              {3.1, 0},        {6, 0},        {6, depth}, {3.1, depth},
                              {3.1, door + 1}, {3, door + 1}, {3, depth}, {0, depth}};
        sheet.plan = survey::plan(sheet.room, sheet.options);
        const test::PdfPage page = sheet.pages().front();
        Polygon walls;
        for (const Eigen::Vector2d& corner : sheet.room.outline) {
            walls.push_back(sheet.onPaper(corner));
        }
        for (std::size_t i = 0; i < walls.size(); ++i) {
            const std::string name = survey::cornerName(static_cast<int>(i));
            const std::vector<test::PdfWords> found = allOf(page, name);
            ASSERT_EQ(found.size(), 1U) << name;
            const Eigen::Vector2d middle = found[0].at + Eigen::Vector2d(0.5 * found[0].widthMm, -1.3);
            const auto nearest =
                std::min_element(walls.begin(), walls.end(), [&](const auto& a, const auto& b) {
                    return (a - middle).norm() < (b - middle).norm();
                });
            EXPECT_EQ(nearest - walls.begin(), static_cast<std::ptrdiff_t>(i)) << name;
            for (const double x : {0.0, 1.0}) {
                for (const double y : {0.0, -0.7}) {
                    EXPECT_TRUE(contains(
                        walls, found[0].at + Eigen::Vector2d(x * found[0].widthMm, y * found[0].heightMm)))
                        << name;
                }
            }
            EXPECT_TRUE(std::any_of(page.segments.begin(), page.segments.end(), [&](const auto& one) {
                return isAt(one.from, walls[i]) && (one.to - middle).norm() < 2.5;
            })) << name; // it is joined to its corner
        }
    }
}

TEST(MarkingSheet, NamesTheLengthsOfAThinWallOnTheirOwnSides) {
    Sheet sheet;
    sheet.room.outline = {{0, 0}, {3, 0}, {3, 3}, {3.1, 3}, {3.1, 0}, {6, 0}, {6, 4}, {0, 4}};
    sheet.plan = survey::plan(sheet.room, sheet.options);
    const std::vector<test::PdfWords> lengths = allOf(sheet.pages().front(), "3.00 m");
    const double wall = sheet.onPaper({3.05, 0}).x();
    ASSERT_EQ(lengths.size(), 3U); // also that of A to B
    EXPECT_EQ(
        std::count_if(lengths.begin(), lengths.end(), [&](const auto& one) { return one.at.x() > wall; }), 1);
    for (const test::PdfWords& one : lengths) {
        EXPECT_TRUE(one.rightMm() < wall || one.at.x() > wall);
    }
}

TEST(MarkingSheet, TellsAThirdTapeAsACheckAndCoordinatesForALaser) {
    const Sheet sheet;
    const std::vector<survey::RailMark> marks = survey::railMarks(sheet.room, sheet.plan);
    ASSERT_TRUE(marks.front().first.check);
    const survey::TapeDistance check = *marks.front().first.check;
    const Eigen::Vector2d& at = marks.front().first.point;
    const std::string words =
        text("check ", survey::cornerName(check.from.index), "  ", fixed(check.metres, 3), "   x ",
             fixed(at.x(), 3), ", y ", fixed(at.y(), 3));
    EXPECT_EQ(allOf(sheet.pages().at(1), words).size(), 1U) << words;
}

TEST(MarkingSheet, EachColumnOfATableKeepsToItself) {
    Sheet sheet;
    sheet.room.outline = {{0, 0}, {15, 0}, {15, 14}, {0, 14}};
    sheet.room.obstacles = {{{5, 5}, {10, 5}, {10, 10}, {5, 10}}};
    sheet.plan = survey::plan(sheet.room, sheet.options);
    const std::vector<test::PdfPage> pages = sheet.pages();
    for (std::size_t i = 1; i < pages.size(); ++i) {
        for (const test::PdfWords& one : pages[i].words) {
            EXPECT_LE(one.rightMm(), pages[i].widthMm - kMarginMm + 1) << one.words;
            for (const test::PdfWords& other : pages[i].words) {
                if (std::abs(other.at.y() - one.at.y()) < kLineMm && other.at.x() > one.at.x() &&
                    one.at.y() > 90) { // below the map
                    EXPECT_LT(one.rightMm(), other.at.x()) << one.words << " | " << other.words;
                }
            }
        }
    }
}

TEST(MarkingSheet, HasABoxToTickForEachRail) {
    const Sheet sheet;
    const test::PdfPage page = sheet.pages().at(1);
    std::size_t boxes = 0;
    for (const test::PdfSegment& one : page.segments) {
        const bool isUpright = std::abs(one.from.x() - kMarginMm) < kLineMm &&
                               isAt(one.from, one.to) == false && std::abs(one.to.x() - kMarginMm) < kLineMm;
        boxes += isUpright && std::abs((one.from - one.to).norm() - 3) < kLineMm ? 1 : 0;
    }
    EXPECT_EQ(boxes, sheet.plan.placements.size());
}

TEST(MarkingSheet, DrawsTheRailsOfATableOnASmallMap) {
    const Sheet sheet;
    const test::PdfPage page = sheet.pages().at(1);
    std::size_t starts = 0;
    for (const test::PdfRound& round : page.rounds) {
        starts += round.isFilled ? 1 : 0;
        EXPECT_LT(round.centre.y(), 80);
    }
    EXPECT_EQ(starts, sheet.plan.placements.size());
}

TEST(MarkingSheet, HasItsTablesRoomByRoom) {
    Sheet sheet;
    sheet.room.outline = {{0, 0},   {4, 0},   {4, 1.5},   {4.1, 1.5}, {4.1, 0}, {8.1, 0},
                          {8.1, 4}, {4.1, 4}, {4.1, 2.4}, {4, 2.4},   {4, 4},   {0, 4}};
    sheet.room.names = {{"bedroom", {6.1, 2}}, {"kitchen", {2, 2}}};
    sheet.plan = survey::plan(sheet.room, sheet.options);
    const std::vector<test::PdfPage> pages = sheet.pages();
    EXPECT_EQ(allOf(pages.front(), "kitchen").size(), 1U); // on the plan
    std::vector<std::string> titles;
    for (std::size_t i = 1; i < pages.size(); ++i) {
        for (const char* room : {"bedroom", "kitchen"}) {
            if (!allOf(pages[i], room + (". " + sheet.words.tableTitle)).empty()) {
                titles.emplace_back(room);
            }
        }
    }
    EXPECT_EQ(titles.size(), pages.size() - 1);
    titles.erase(std::unique(titles.begin(), titles.end()), titles.end());
    EXPECT_EQ(titles.size(), 2U);
}

TEST(MarkingSheet, LeavesOutLengthsThatHaveNoRoom) {
    Sheet sheet;
    sheet.room.outline = {{0, 0}, {5, 0}, {5, 4}, {0.3, 4}, {0.3, 3}, {0, 3}};
    sheet.plan = survey::plan(sheet.room, sheet.options);
    const test::PdfPage page = sheet.pages().front();
    EXPECT_EQ(allOf(page, "0.30 m").size(), 0U);
    EXPECT_EQ(allOf(page, "4.70 m").size(), 1U);
}

TEST(MarkingSheet, TellsTapesThatMeetAtTheStops) {
    const Sheet sheet;
    const std::vector<test::PdfPage> pages = sheet.pages();
    std::size_t tapes = 0;
    for (std::size_t i = 0; i < sheet.plan.placements.size(); ++i) {
        const survey::RailPlacement& rail = sheet.plan.placements[i];
        std::vector<test::PdfWords> number = allOf(pages[1], std::to_string(i + 1));
        std::erase_if(number, [](const test::PdfWords& one) { return one.at.x() > kMarginMm + 5; });
        ASSERT_EQ(number.size(), 1U) << i;
        for (const test::PdfWords& one : pages[1].words) {
            char corner = 0;
            double metres = 0;
            std::istringstream text(one.words);
            const bool isFirst = one.at.x() < kMarginMm + 60;
            const Eigen::Vector2d stop = rail.stop(isFirst ? 0 : rail.stops - 1);
            while (std::abs(one.at.y() - number.front().at.y()) < kLineMm && text >> corner >> metres &&
                   corner >= 'A' && corner <= 'D') {
                const Eigen::Vector2d from = sheet.room.outline[static_cast<std::size_t>(corner - 'A')];
                EXPECT_NEAR((stop - from).norm(), metres, 0.0006) << one.words;
                ++tapes;
            }
        }
    }
    EXPECT_EQ(tapes, 4 * sheet.plan.placements.size()); // two tapes for either end
}

TEST(MarkingSheet, SaysWhereAPointIsThatNoTapeReaches) {
    Sheet sheet;
    sheet.room.obstacles = {{{1, 1}, {3, 1}, {3, 3}, {1, 3}}};
    sheet.plan.placements = {{{2, 2}, Radians(0), 1, 0.6}}; // inside of the obstacle
    sheet.plan.stations = {{0, 0, {2, 2, 1.2}}};
    const test::PdfPage page = sheet.pages().at(1);
    EXPECT_EQ(allOf(page, "nothing in sight to measure from").size(), 1U); // no last stop
    EXPECT_EQ(allOf(page, "x 2.000, y 2.000").size(), 1U);
}

TEST(MarkingSheet, SpeaksWithTheWordsThatItIsGiven) {
    Sheet sheet;
    sheet.words.title = "%1: Plan";
    sheet.words.summary = "%2 Schienen, %1 Orte";
    sheet.words.page = "Seite %1";
    const std::vector<test::PdfPage> pages = sheet.pages();
    EXPECT_EQ(allOf(pages[0], "lab: Plan").size(), 1U);
    EXPECT_EQ(allOf(pages[0],
                    text(sheet.plan.placements.size(), " Schienen, ", sheet.plan.stations.size(), " Orte"))
                  .size(),
              1U);
    EXPECT_EQ(allOf(pages[1], "Seite 2").size(), 1U);
}

TEST(MarkingSheet, HasItsPlanAsTheRoomLiesAndItsTablesUpright) {
    Sheet sheet;
    for (const bool isDeep : {false, true}) {
        sheet.room.outline = isDeep ? Polygon{{0, 0}, {4, 0}, {4, 9}, {0, 9}} : sheetRoom().outline;
        sheet.plan = survey::plan(sheet.room, sheet.options);
        const std::vector<test::PdfPage> pages = sheet.pages();
        EXPECT_NEAR(pages[0].widthMm, isDeep ? 210 : 297, 0.1);
        for (std::size_t i = 1; i < pages.size(); ++i) {
            EXPECT_NEAR(pages[i].widthMm, 210, 0.1);
            EXPECT_NEAR(pages[i].heightMm, 297, 0.1);
        }
    }
}

TEST(MarkingSheet, IsAPdfWithThePlanAndATable) {
    const Bytes pdf = sheetAt(0.6);
    EXPECT_TRUE(textOf(pdf).starts_with("%PDF-"));
    EXPECT_EQ(test::pageCount(pdf), 2U);
}

TEST(MarkingSheet, BreaksALongTableIntoPages) {
    EXPECT_GT(test::pageCount(sheetAt(0.2)), 3U);
}

TEST(MarkingSheet, IsTheSameForTheSamePlan) {
    EXPECT_EQ(sheetAt(0.6), sheetAt(0.6));
}

TEST(MarkingSheet, RefusesARoomThatCannotBe) {
    survey::Room broken = sheetRoom();
    broken.outline.resize(2);
    test::expectError(ErrorKind::InvalidInput, "outline", [&] { markingSheet("lab", broken, {}, {}); });
}

} // namespace spherewalk::report
