// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdf_page.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/photo/april_tag.h"
#include "spherewalk/report/printed_sheets.h"

#include <array>
#include <cmath>
#include <vector>

namespace spherewalk::report {

namespace {

using Eigen::Vector2d;

constexpr double kWordsMm = 4.5;
constexpr double kHeadMm = 38; ///< Above and below the tag, for words and the bar.
constexpr double kBarMm = 100;

Polygon square(const Vector2d& at, double sideMm) {
    return {at, at + Vector2d(sideMm, 0), at + Vector2d(sideMm, sideMm), at + Vector2d(0, sideMm)};
}

/// The smallest upright sheet that holds the tag with its rim and the words. Source: ISO 216.
Paper paperFor(double sizeMm) {
    constexpr std::array<Paper, 5> kPapers{{{210, 297}, {297, 420}, {420, 594}, {594, 841}, {841, 1189}}};
    const double rimMm = sizeMm * (photo::kTagCells + 2) / photo::kTagCells;
    for (const Paper& paper : kPapers) {
        if (rimMm <= paper.widthMm && rimMm + 2 * kHeadMm <= paper.heightMm) {
            return paper;
        }
    }
    return kPapers.back();
}

void drawTag(PdfPages& pages, const Vector2d& at, double sizeMm, int number) {
    const photo::TagCells cells = photo::tagCells(number);
    const double cellMm = sizeMm / photo::kTagCells;
    std::vector<Polygon> white;
    for (int row = 0; row < photo::kTagCells; ++row) {
        for (int column = 0; column < photo::kTagCells; ++column) {
            const int cell = row * photo::kTagCells + column;
            if (cells[static_cast<std::size_t>(cell)]) {
                white.push_back(square(at + cellMm * Vector2d(column, row), cellMm));
            }
        }
    }
    pages.setGrey(0);
    pages.filled(std::vector<Polygon>{square(at, sizeMm)});
    pages.setGrey(1);
    pages.filled(white);
    pages.setGrey(0);
}

void drawArrow(PdfPages& pages, const Vector2d& tip) {
    pages.setLine(0.6);
    pages.line(tip, tip + Vector2d(0, 9));
    pages.line(tip, tip + Vector2d(-3, 4));
    pages.line(tip, tip + Vector2d(3, 4));
}

void drawBar(PdfPages& pages, const Vector2d& at, double sizeMm) {
    pages.setLine(0.4);
    pages.line(at, at + Vector2d(kBarMm, 0));
    for (int cm = 0; cm <= 10; ++cm) {
        pages.line(at + Vector2d(10.0 * cm, 0), at + Vector2d(10.0 * cm, cm % 5 == 0 ? -3 : -1.5));
    }
    pages.words(at + Vector2d(0, 6),
                text("Print at 100 %: this bar is 10 cm long, and the black square is ", fixed(sizeMm, 1),
                     " mm wide."),
                3.2);
    pages.words(at + Vector2d(0, 11),
                "Measure the printed square. Give what you measure, in metres, to align --tag-size.", 3.2);
}

} // namespace

Bytes tagSheet(const std::string& title, std::span<const int> numbers, double sizeM) {
    if (numbers.empty() || !(sizeM >= 0.02 && sizeM <= 0.6)) {
        throw Error(ErrorKind::InvalidInput, text("Could not draw ", numbers.size(), " AprilTags of ", sizeM,
                                                  " m: give at least one, of 0.02 to 0.6 m."));
    }
    const double sizeMm = 1000 * sizeM;
    const Paper paper = paperFor(sizeMm);
    PdfPages pages(paper);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (i > 0) {
            pages.nextPage(paper);
        }
        const Vector2d corner((paper.widthMm - sizeMm) / 2, (paper.heightMm - sizeMm) / 2);
        const double middle = paper.widthMm / 2;
        drawTag(pages, corner, sizeMm, numbers[i]);
        pages.words({middle, kMarginMm + kWordsMm},
                    text("AprilTag ", numbers[i], " (36h11). This side up. ", title), kWordsMm, Align::Centre,
                    true);
        pages.words({middle, kMarginMm + 2.2 * kWordsMm},
                    "Keep it flat. Leave the white rim. Hang each number once, where nobody moves it.", 3.2,
                    Align::Centre);
        drawArrow(pages, {middle, kMarginMm + 2.9 * kWordsMm});
        drawBar(pages, {middle - kBarMm / 2, paper.heightMm - kMarginMm - 12}, sizeMm);
    }
    return pages.finish();
}

} // namespace spherewalk::report
