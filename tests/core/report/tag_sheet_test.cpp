// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "pdf_reading.h"

#include "spherewalk/photo/april_tag.h"
#include "spherewalk/report/printed_sheets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace spherewalk::report {

using test::expectError;

namespace {

constexpr double kRoundMm = 0.03; ///< Coordinates in a PDF are rounded.

struct Box {
    Eigen::Vector2d least = Eigen::Vector2d::Constant(1e9);
    Eigen::Vector2d most = Eigen::Vector2d::Constant(-1e9);
};

Box boxOf(std::span<const test::PdfSegment> edges) {
    Box box;
    for (const test::PdfSegment& edge : edges) {
        box.least = box.least.cwiseMin(edge.from).cwiseMin(edge.to);
        box.most = box.most.cwiseMax(edge.from).cwiseMax(edge.to);
    }
    return box;
}

std::vector<test::PdfPage> pagesOf(std::span<const int> numbers, double sizeM) {
    return test::PdfReading(tagSheet("lab", numbers, sizeM)).pages();
}

bool says(const test::PdfPage& page, std::string_view words) {
    return std::ranges::any_of(
        page.words, [&](const test::PdfWords& one) { return one.words.find(words) != std::string::npos; });
}

/// The cells that the page leaves white in its black square, which has 8 x 8.
photo::TagCells whiteCells(const test::PdfPage& page, const Box& square) {
    photo::TagCells cells;
    const double cellMm = (square.most.x() - square.least.x()) / photo::kTagCells;
    const std::vector<test::PdfSegment>& edges = page.areas.at(1);
    EXPECT_EQ(edges.size() % 4, 0U);
    for (std::size_t i = 0; i + 4 <= edges.size(); i += 4) {
        const Box cell = boxOf(std::span(edges).subspan(i, 4));
        EXPECT_NEAR((cell.most - cell.least).x(), cellMm, kRoundMm);
        EXPECT_NEAR((cell.most - cell.least).y(), cellMm, kRoundMm);
        const Eigen::Vector2d at = (cell.least - square.least) / cellMm;
        cells.set(static_cast<std::size_t>(8 * std::lround(at.y()) + std::lround(at.x())));
    }
    return cells;
}

} // namespace

TEST(TagSheet, PrintsEachTagAtItsSizeWithItsNumberAndRim) {
    const std::array numbers{0, 17, 586};
    const auto pages = pagesOf(numbers, 0.16);
    ASSERT_EQ(pages.size(), 3U);
    for (std::size_t i = 0; i < pages.size(); ++i) {
        EXPECT_NEAR(pages[i].widthMm, 210, 0.1);
        EXPECT_NEAR(pages[i].heightMm, 297, 0.1);
        const Box square = boxOf(pages[i].areas.at(0));
        EXPECT_NEAR((square.most - square.least).x(), 160, kRoundMm);
        EXPECT_NEAR((square.most - square.least).y(), 160, kRoundMm);
        EXPECT_GT(square.least.x(), 20 - kRoundMm); // The rim is a cell wide.
        EXPECT_EQ(whiteCells(pages[i], square), photo::tagCells(numbers[i])) << numbers[i];
        EXPECT_TRUE(says(pages[i], text("AprilTag ", numbers[i], " (36h11). This side up.")));
        EXPECT_TRUE(says(pages[i], "160.0 mm wide"));
        // Nothing else lies on the tag or its rim.
        for (const test::PdfWords& words : pages[i].words) {
            EXPECT_TRUE(words.at.y() < square.least.y() - 20 || words.at.y() > square.most.y() + 20)
                << words.words;
        }
    }
}

TEST(TagSheet, HasABarOfTenCentimetres) {
    const std::array numbers{1};
    const test::PdfPage page = pagesOf(numbers, 0.1).front();
    EXPECT_TRUE(std::ranges::any_of(page.segments, [](const test::PdfSegment& line) {
        return std::abs((line.to - line.from).norm() - 100) < kRoundMm;
    }));
}

TEST(TagSheet, TakesLargerPaperForLargerTags) {
    const std::array numbers{1};
    EXPECT_NEAR(pagesOf(numbers, 0.2).front().widthMm, 297, 0.1);
    EXPECT_NEAR(pagesOf(numbers, 0.6).front().widthMm, 841, 0.1);
}

TEST(TagSheet, RefusesWhatCannotBePrinted) {
    const std::array unknown{587};
    const std::array one{1};
    expectError(ErrorKind::InvalidInput, "0 to 586", [&] { tagSheet("lab", unknown, 0.1); });
    expectError(ErrorKind::InvalidInput, "0.02 to 0.6", [&] { tagSheet("lab", one, 0.01); });
    expectError(ErrorKind::InvalidInput, "0.02 to 0.6", [&] { tagSheet("lab", one, std::nan("")); });
    expectError(ErrorKind::InvalidInput, "at least one", [] { tagSheet("lab", {}, 0.1); });
}

} // namespace spherewalk::report
