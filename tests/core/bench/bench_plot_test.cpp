// SPDX-License-Identifier: GPL-3.0-or-later
#include "made_report.h"
#include "markup.h"

#include "spherewalk/base/text.h"
#include "spherewalk/report/svg.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace spherewalk::bench {

namespace {

/// One element of a drawing.
struct Element {
    std::string tag;   ///< All that stands between its brackets.
    std::string words; ///< What follows up to the next element.

    bool is(const std::string& start) const { return tag.starts_with(start); }

    double number(const std::string& attribute) const {
        const std::string key = " " + attribute + "=\"";
        const std::size_t at = tag.find(key);
        return at == std::string::npos ? 0 : std::stod(tag.substr(at + key.size()));
    }
};

std::vector<Element> elementsOf(const std::string& svg, const std::string& start) {
    std::vector<Element> elements;
    for (std::size_t at = 0; (at = svg.find("<" + start, at)) != std::string::npos; ++at) {
        const std::size_t end = svg.find('>', at);
        elements.push_back(
            {svg.substr(at + 1, end - at - 1), svg.substr(end + 1, svg.find('<', end) - end - 1)});
    }
    return elements;
}

/// The names that stand in the chart of errors.
std::vector<report::SvgBox> labelsOfErrors(const std::string& svg) {
    std::vector<report::SvgBox> boxes;
    for (const Element& text : elementsOf(svg, "text class=\"label\"")) {
        const report::SvgPoint at{text.number("x"), text.number("y")};
        if (at.x > 75 && at.x < 475 && at.y > 92 && at.y < 377) {
            boxes.push_back(report::Svg::extent(at, text.words, report::Svg::Text::Label));
        }
    }
    return boxes;
}

class MadePlot : public testing::TestWithParam<unsigned> {
  protected:
    /// The time of a level view of 90 degrees.
    double timeOf(render::Sampling rung) const {
        return m_report.find(viewRowName(rung, {90, 0}), 1)->own.medianMs;
    }

    test::Random m_random{GetParam()};
    BenchReport m_report = test::MadeReport(m_random).fill();
    std::string m_plot = benchPlot(m_report);
};

} // namespace

TEST_P(MadePlot, IsWellFormed) {
    EXPECT_EQ(test::markupDefect(m_plot), "");
}

TEST_P(MadePlot, DrawsNothingOutsideOfItself) {
    for (const char* kind : {"line", "circle", "rect x", "text class"}) {
        const std::vector<Element> elements = elementsOf(m_plot, kind);
        EXPECT_FALSE(elements.empty()) << kind;
        for (const Element& one : elements) {
            for (const char* across : {"x", "x1", "x2", "cx"}) {
                EXPECT_GE(one.number(across), 0) << one.tag;
                EXPECT_LE(one.number(across) + one.number("width"), 1040) << one.tag;
            }
            for (const char* down : {"y", "y1", "y2", "cy"}) {
                EXPECT_GE(one.number(down), 0) << one.tag;
                EXPECT_LE(one.number(down) + one.number("height"), 450) << one.tag;
            }
        }
    }
}

TEST_P(MadePlot, PutsSlowerSamplingsToTheRightAndBetterOnesHigher) {
    const std::vector<Element> dots = elementsOf(m_plot, "circle");
    ASSERT_EQ(dots.size(), kRungs.size());
    for (std::size_t i = 0; i < dots.size(); ++i) {
        for (std::size_t k = 0; k < dots.size(); ++k) {
            if (timeOf(kRungs[i]) > timeOf(kRungs[k])) {
                EXPECT_GE(dots[i].number("cx"), dots[k].number("cx"));
            }
            if (m_report.fidelity[i].meanDb > m_report.fidelity[k].meanDb) {
                EXPECT_LE(dots[i].number("cy"), dots[k].number("cy"));
            }
        }
    }
}

TEST_P(MadePlot, HasBarsAsHighAsTheShareOfLateViews) {
    std::vector<Element> bars = elementsOf(m_plot, "rect x");
    std::erase_if(bars, [](const Element& one) { return one.number("y") > 380; }); // the legend's
    ASSERT_EQ(bars.size(), m_report.walk.size());
    const auto highest =
        std::max_element(m_report.walk.begin(), m_report.walk.end(),
                         [](const WalkRow& a, const WalkRow& b) { return a.lateShare < b.lateShare; });
    const double perShare =
        bars[static_cast<std::size_t>(highest - m_report.walk.begin())].number("height") / highest->lateShare;
    for (std::size_t i = 0; i < bars.size(); ++i) {
        const double expected = std::max(2.0, perShare * m_report.walk[i].lateShare);
        EXPECT_NEAR(bars[i].number("height"), expected, 0.3) << i;
        EXPECT_NEAR(bars[i].number("y") + bars[i].number("height"), 377, 0.15) << i; // on the axis
    }
}

TEST_P(MadePlot, LaysNoBarOverAnother) {
    std::vector<report::SvgBox> bars;
    for (const Element& one : elementsOf(m_plot, "rect x")) {
        bars.push_back({one.number("x"), one.number("y"), one.number("width"), one.number("height")});
    }
    for (std::size_t i = 0; i < bars.size(); ++i) {
        for (std::size_t k = i + 1; k < bars.size(); ++k) {
            EXPECT_FALSE(bars[i].overlaps(bars[k])) << i << " and " << k;
        }
    }
}

TEST_P(MadePlot, LaysNoNameOverAnother) {
    const std::vector<report::SvgBox> labels = labelsOfErrors(m_plot);
    EXPECT_EQ(labels.size(), kRungs.size() + 2); // and those of two peers
    for (std::size_t i = 0; i < labels.size(); ++i) {
        for (std::size_t k = i + 1; k < labels.size(); ++k) {
            EXPECT_FALSE(labels[i].overlaps(labels[k])) << i << " and " << k;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(BenchPlot, MadePlot, testing::Range(1U, 7U));

TEST(BenchPlot, IsWellFormedWhateverTheDatasetIsCalled) {
    test::Random random(15);
    BenchReport report = test::MadeReport(random).fill();
    report.measurand.dataset = "</text> & <b \"'\n";
    report.machine.processor = "]]> &amp; <!--";
    EXPECT_EQ(test::markupDefect(benchPlot(report)), "");
}

TEST(BenchPlot, OfOneSamplingHasOneDotWithinItsFrame) {
    BenchReport report;
    BenchRow& row = report.rows.emplace_back();
    row.name = "view.bilinear";
    row.own.medianMs = 0.5;
    report.fidelity = {{render::Sampling::Bilinear, 90, 100, 100}};
    const std::vector<Element> dots = elementsOf(benchPlot(report), "circle");
    ASSERT_EQ(dots.size(), 1U);
    EXPECT_GT(dots.front().number("cx"), 75);
    EXPECT_LT(dots.front().number("cx"), 475);
    EXPECT_GT(dots.front().number("cy"), 92);
    EXPECT_LT(dots.front().number("cy"), 377);
}

TEST(BenchPlot, ShowsWalksWithoutALateViewAsSlivers) {
    BenchReport report;
    report.walk = {{1, render::LatePolicy::Wait, true, 90, 0, 0, 4, 0},
                   {5, render::LatePolicy::Wait, true, 90, 0, 0, 4, 0}};
    std::vector<Element> bars = elementsOf(benchPlot(report), "rect x");
    std::erase_if(bars, [](const Element& one) { return one.number("y") > 380; });
    ASSERT_EQ(bars.size(), 2U);
    for (const Element& bar : bars) {
        EXPECT_EQ(bar.number("height"), 2);
    }
}

} // namespace spherewalk::bench
