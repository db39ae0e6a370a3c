// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"

#include "spherewalk/sheet/document.h"

#include <gtest/gtest.h>

#include <string_view>

namespace spherewalk::sheet {

namespace {

const std::string kSquare = R"(<svg xmlns="http://www.w3.org/2000/svg" width="40" height="30"><rect width="9"
height="9"/></svg>)";

Document ofEverything(std::size_t rows) {
    Table table{{"one", "two"}, {}};
    table.rows.resize(rows, {"a", "1"});
    return {"Title",
            {Heading{"Heading"}, Paragraph{"Words and words."}, table, Drawing{kSquare},
             PictureRow{{RgbImage(8, 6), RgbImage(8, 6)}, {"left", "right"}}}};
}

std::size_t count(std::string_view all, std::string_view part) {
    std::size_t found = 0;
    for (std::size_t at = 0; (at = all.find(part, at)) != std::string_view::npos; at += part.size()) {
        ++found;
    }
    return found;
}

std::size_t pages(const Bytes& pdf) {
    return count(textOf(pdf), "/Type /Page") - count(textOf(pdf), "/Type /Pages"); // the latter is their list
}

} // namespace

TEST(Document, BecomesTheSamePdfEachTime) {
    const Bytes first = pdf(ofEverything(3));
    EXPECT_TRUE(textOf(first).starts_with("%PDF-"));
    EXPECT_EQ(first, pdf(ofEverything(3)));
    EXPECT_NE(textOf(first).find("DCTDecode"), std::string_view::npos); // pictures stay small
}

TEST(Document, GoesOnOnFurtherPages) {
    EXPECT_EQ(pages(pdf(ofEverything(3))), 1U);
    EXPECT_GT(pages(pdf(ofEverything(200))), 3U);
}

TEST(Document, RefusesADrawingThatIsNone) {
    test::expectError(ErrorKind::Internal, "drawing", [] { pdf({"T", {Drawing{"no svg"}}}); });
}

} // namespace spherewalk::sheet
