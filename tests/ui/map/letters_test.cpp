// SPDX-License-Identifier: GPL-3.0-or-later
// Two people mark a flat out: one reads the sheet, the other one the window.
#include "pdf_reading.h"
#include "ui/map/station_words.h"

#include "spherewalk/report/printed_sheets.h"

#include <QRegularExpression>
#include <gtest/gtest.h>

#include <set>

namespace spherewalk::ui {

namespace {

/// Three rooms between walls of 10 cm, with doorways.
survey::Room flat() {
    survey::Room room;
    room.outline = {{0, 0},     {4, 0},   {4, 1.5},   {4.1, 1.5}, {4.1, 0}, {8.1, 0},   {8.1, 1.5},
                    {8.2, 1.5}, {8.2, 0}, {12, 0},    {12, 4},    {8.2, 4}, {8.2, 2.4}, {8.1, 2.4},
                    {8.1, 4},   {4.1, 4}, {4.1, 2.4}, {4, 2.4},   {4, 4},   {0, 4}};
    room.ceilingM = 2.6;
    return room;
}

/// The tapes of a point as a sheet writes them, from what the window says: "B 2.729 m · E 1.250 m (check
/// ...)".
std::set<std::string> tapesIn(const QString& words) {
    static const QRegularExpression pair("([A-Z]+(?:-[A-Z]+)?|(?:ring|arrow) \\d+) ([0-9.]+) m · "
                                         "([A-Z]+(?:-[A-Z]+)?|(?:ring|arrow) \\d+) ([0-9.]+) m");
    std::set<std::string> found;
    for (const QRegularExpressionMatch& tapes : pair.globalMatch(words)) {
        found.insert(QString("%1  %2     %3  %4")
                         .arg(tapes.captured(1), tapes.captured(2), tapes.captured(3), tapes.captured(4))
                         .toStdString());
    }
    return found;
}

} // namespace

TEST(Letters, AreTheSameInTheWindowAndOnTheSheet) {
    for (const double stepM : {0.4, 0.7, 1.0}) {
        const survey::PlanOptions options{.stepM = stepM, .railStops = 4};
        const survey::Plan plan = survey::plan(flat(), options);
        const Bytes pdf = report::markingSheet("flat", flat(), options, plan);
        std::multiset<std::string> onSheet;
        for (const test::PdfPage& page : test::PdfReading(pdf).pages()) {
            for (const test::PdfWords& words : page.words) {
                onSheet.insert(words.words);
            }
        }
        std::set<std::string> inWindow;
        for (const survey::RailMark& rail : survey::railMarks(flat(), plan)) {
            inWindow.merge(tapesIn(railWords(rail, flat())));
        }
        EXPECT_GE(inWindow.size(), plan.placements.size());
        for (const std::string& tapes : inWindow) {
            EXPECT_GE(onSheet.count(tapes), 1U) << tapes;
        }
    }
}

} // namespace spherewalk::ui
