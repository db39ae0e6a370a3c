// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"

#include "spherewalk/sheet/marking_sheet.h"

#include <gtest/gtest.h>

#include <string_view>

namespace spherewalk::sheet {

namespace {

survey::Room room() {
    survey::Room result;
    result.outline = {{0, 0}, {5, 0}, {5, 4}, {0, 4}};
    result.ceilingM = 2.6;
    return result;
}

Bytes sheetAt(double stepM) {
    survey::PlanOptions options;
    options.stepM = stepM;
    options.railStops = 3;
    return markingSheet("lab", room(), options, survey::plan(room(), options));
}

int count(std::string_view text, std::string_view part) {
    int found = 0;
    for (std::size_t at = 0; (at = text.find(part, at)) != std::string_view::npos; ++at) {
        ++found;
    }
    return found;
}

int pages(const Bytes& pdf) {
    return count(textOf(pdf), "/Type /Page") - count(textOf(pdf), "/Type /Pages"); // the latter is their list
}

} // namespace

TEST(MarkingSheet, IsAPdfWithThePlanAndATable) {
    const Bytes pdf = sheetAt(0.6);
    EXPECT_TRUE(textOf(pdf).starts_with("%PDF-"));
    EXPECT_EQ(pages(pdf), 2);
}

TEST(MarkingSheet, BreaksALongTableIntoPages) {
    EXPECT_GT(pages(sheetAt(0.2)), 3);
}

TEST(MarkingSheet, IsTheSameForTheSamePlan) {
    EXPECT_EQ(sheetAt(0.6), sheetAt(0.6));
}

TEST(MarkingSheet, RefusesARoomThatCannotBe) {
    survey::Room broken = room();
    broken.outline.resize(2);
    test::expectError(ErrorKind::InvalidInput, "outline", [&] { markingSheet("lab", broken, {}, {}); });
}

} // namespace spherewalk::sheet
