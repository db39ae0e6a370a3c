// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "pdf_reading.h"
#include "random.h"
#include "temporary_folder.h"

#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/report/document.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <sstream>
#include <string_view>

namespace spherewalk::report {

namespace {

const std::string kSquare = R"(<svg xmlns="http://www.w3.org/2000/svg" width="40" height="30"><rect width="9"
height="9"/></svg>)";
const std::string kTall = R"(<svg xmlns="http://www.w3.org/2000/svg" width="300" height="600"/>)";

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

} // namespace

TEST(Document, BecomesTheSamePdfEachTime) {
    const Bytes first = pdf(ofEverything(3));
    EXPECT_TRUE(textOf(first).starts_with("%PDF-"));
    EXPECT_EQ(first, pdf(ofEverything(3)));
    EXPECT_NE(textOf(first).find("DCTDecode"), std::string_view::npos); // pictures stay small
}

TEST(Document, GoesOnOnFurtherPages) {
    EXPECT_EQ(test::pageCount(pdf(ofEverything(3))), 1U);
    EXPECT_GT(test::pageCount(pdf(ofEverything(200))), 3U);
}

TEST(Document, RefusesADrawingThatIsNone) {
    test::expectError(ErrorKind::Internal, "drawing", [] { pdf({"T", {Drawing{"no svg"}}}); });
}

TEST(Table, AlignsItsColumnsForAScreen) {
    const Table table{{"", "ms"}, {{"long name", "1.5"}, {"a", "10.25"}}};
    EXPECT_EQ(table.text(), "                 ms\n  long name     1.5\n  a           10.25\n");
    const Table left{{"a", "b", "c"}, {{"1", "22", "333"}}, 2};
    EXPECT_EQ(left.text(), "  a   b      c\n  1   22   333\n");
}

TEST(Table, MayHaveNoTitlesAndRowsOfAnyLength) {
    EXPECT_EQ((Table{{}, {{"name", "1"}, {"a"}, {}}, 1}).text(), "  name   1\n  a\n\n");
    EXPECT_EQ((Table{{"one"}, {{"1", "2", "3"}}, 1}).text(), "  one\n  1     2   3\n");
    EXPECT_EQ(Table{}.text(), "");
}

TEST(Table, LinesHaveOneWidthAndNoBlanksAtTheirEnds) {
    test::Random random(3);
    SCOPED_TRACE(random.seed());
    for (int round = 0; round < 100; ++round) {
        Table table;
        const int columns = random.integer(1, 6);
        for (int row = 0; row < 5; ++row) {
            std::vector<std::string> cells;
            for (int i = 0; i < columns; ++i) {
                cells.emplace_back(static_cast<std::size_t>(random.integer(1, 12)), 'x');
            }
            table.rows.push_back(cells);
        }
        table.leftColumns = static_cast<std::size_t>(random.integer(0, columns - 1));
        std::istringstream lines(table.text());
        std::set<std::size_t> widths;
        for (std::string line; std::getline(lines, line);) {
            EXPECT_EQ(line.find_first_not_of(' ') >= 2, true);
            EXPECT_NE(line.back(), ' ');
            widths.insert(line.size());
        }
        EXPECT_EQ(widths.size(), 1U); // since the last column is flush right
    }
}

TEST(ReportFolder, HoldsAPageAPdfAndTheFigures) {
    const test::TemporaryFolder folder;
    const auto out = folder / "neu" / "report";
    writeReportFolder(ofEverything(2), {{"figure", 3}}, out);
    const std::string page(textOf(readFile(out / "report.html")));
    EXPECT_TRUE(page.starts_with("<!DOCTYPE html>"));
    EXPECT_TRUE(page.ends_with("</html>\n"));
    for (const char* part :
         {"<title>Title</title>", "<h1>Title</h1>", "<h2>Heading</h2>", "<p>Words and words.</p>",
          "<th class=\"left\">one</th><th>two</th>", "<td class=\"left\">a</td><td>1</td>",
          "<figcaption>left</figcaption>", "src=\"report-2.jpg\""}) {
        EXPECT_EQ(count(page, part) > 0, true) << part;
    }
    EXPECT_EQ(count(page, "<tr>"), count(page, "</tr>"));
    EXPECT_EQ(count(page, "<tr>"), 3U);
    EXPECT_EQ(count(page, kSquare), 1U); // drawings stand in the page itself
    EXPECT_EQ(textOf(readFile(out / "report.pdf")), textOf(pdf(ofEverything(2))));
    EXPECT_EQ(Json::parse(textOf(readFile(out / "report.json")))["figure"], 3);
    EXPECT_EQ(jpeg::decode(readFile(out / "report-1.jpg"), "a picture").width(), 8);
    EXPECT_FALSE(std::filesystem::exists(out / "report-3.jpg"));
}

TEST(ReportFolder, EscapesWordsAndFillsShortRows) {
    const test::TemporaryFolder folder;
    Document document{"a < b", {Heading{"<h>"}, Paragraph{"\"p\" & q"}, Table{{"<t>", "u"}, {{"<c>"}}}}};
    writeReportFolder(document, {}, folder.path());
    const std::string page(textOf(readFile(folder / "report.html")));
    for (const char* part :
         {"<h1>a &lt; b</h1>", "<h2>&lt;h&gt;</h2>", "<p>&quot;p&quot; &amp; q</p>",
          "<th class=\"left\">&lt;t&gt;</th><th>u</th>", "<td class=\"left\">&lt;c&gt;</td><td></td>"}) {
        EXPECT_EQ(count(page, part), 1U) << part;
    }
}

TEST(ReportFolder, ReplacesAnEarlierReport) {
    const test::TemporaryFolder folder;
    writeReportFolder({"first", {}}, {{"n", 1}}, folder.path());
    writeReportFolder({"second", {}}, {{"n", 2}}, folder.path());
    EXPECT_EQ(count(textOf(readFile(folder / "report.html")), "first"), 0U);
    EXPECT_EQ(Json::parse(textOf(readFile(folder / "report.json")))["n"], 2);
}

TEST(Document, KeepsAHeadingWithWhatFollowsIt) {
    // So many paragraphs that the last heading would stand alone at the foot of the first page.
    for (int paragraphs = 1; paragraphs < 60; ++paragraphs) {
        Document document{"T", {}};
        for (int i = 0; i < paragraphs; ++i) {
            document.blocks.emplace_back(Paragraph{"p"});
        }
        const std::size_t without = test::pageCount(pdf(document));
        document.blocks.emplace_back(Heading{"H"});
        document.blocks.emplace_back(Drawing{kTall});
        const std::size_t with = test::pageCount(pdf(document));
        EXPECT_LE(with, without + 1) << paragraphs;
        EXPECT_GE(with, without) << paragraphs;
    }
}

TEST(Document, SetsAWideTableOnThePage) {
    Table wide;
    for (int i = 0; i < 25; ++i) {
        wide.titles.push_back("a long title " + std::to_string(i));
    }
    wide.rows.push_back(wide.titles);
    EXPECT_EQ(test::pageCount(pdf({"T", {wide}})), 1U);
}

} // namespace spherewalk::report
