// SPDX-License-Identifier: GPL-3.0-or-later
#include "random.h"

#include "spherewalk/base/text.h"
#include "spherewalk/report/chart.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::report {

TEST(PlotAxis, TicksEncloseTheRangeAndAreFew) {
    test::Random random(5);
    SCOPED_TRACE(random.seed());
    for (int i = 0; i < 500; ++i) {
        const double least = random.uniform(-50, 50);
        const double greatest = least + std::pow(10, random.uniform(-2, 3));
        const std::vector<double> even = evenTicks(least, greatest, 8);
        ASSERT_GE(even.size(), 2U);
        EXPECT_LE(even.size(), 9U);
        EXPECT_LE(even.front(), least + 1e-6);
        EXPECT_GE(even.back(), greatest - 1e-6);
        EXPECT_TRUE(std::is_sorted(even.begin(), even.end()));
        const double small = std::pow(10, random.uniform(-3, 2));
        const std::vector<double> logarithmic = logarithmicTicks(small, small * random.uniform(1, 300));
        ASSERT_GE(logarithmic.size(), 2U);
        EXPECT_LE(logarithmic.front(), small * (1 + 1e-6));
        EXPECT_GE(logarithmic[1] * (1 + 1e-6), small);
    }
    EXPECT_EQ(evenTicks(0, 100, 6), (std::vector<double>{0, 20, 40, 60, 80, 100}));
    EXPECT_EQ(logarithmicTicks(0.3, 4), (std::vector<double>{0.2, 0.5, 1, 2, 5}));
}

TEST(PlotAxis, TicksAreRoundNumbersThatReadWell) {
    EXPECT_EQ(evenTicks(0, 0.5, 8), (std::vector<double>{0, 0.1, 0.2, 0.3, 0.4, 0.5}));
    EXPECT_EQ(logarithmicTicks(2e-5, 1e-3), (std::vector<double>{2e-5, 5e-5, 1e-4, 2e-4, 5e-4, 1e-3}));
    test::Random random(6);
    SCOPED_TRACE(random.seed());
    for (int i = 0; i < 500; ++i) {
        const double least = random.uniform(-50, 50);
        for (const double tick : evenTicks(least, least + std::pow(10, random.uniform(-2, 3)), 8)) {
            EXPECT_LE(text(tick).size(), 8U) << text(tick); // -49.995 and the like
        }
        for (const double tick : logarithmicTicks(std::pow(10, random.uniform(-9, 9)), 1)) {
            EXPECT_LE(text(tick).size(), 10U) << text(tick);
        }
    }
}

TEST(PlotAxis, TicksAreEquallyFarApart) {
    test::Random random(7);
    SCOPED_TRACE(random.seed());
    for (int i = 0; i < 200; ++i) {
        const double least = random.uniform(-1e6, 1e6);
        const int most = random.integer(1, 12);
        const std::vector<double> ticks = evenTicks(least, least + random.uniform(0.1, 1e5), most);
        const double step = ticks[1] - ticks[0];
        EXPECT_LE(ticks.size(), static_cast<std::size_t>(most) + 1);
        for (std::size_t k = 1; k < ticks.size(); ++k) {
            EXPECT_NEAR(ticks[k] - ticks[k - 1], step, 1e-6 * step);
        }
        const double mantissa = step / std::pow(10, std::floor(std::log10(step) + 1e-6));
        EXPECT_TRUE(std::abs(mantissa - 1) < 1e-4 || std::abs(mantissa - 2) < 1e-4 ||
                    std::abs(mantissa - 5) < 1e-4)
            << step;
    }
}

TEST(PlotAxis, TicksOfOneValueAreStillAnInterval) {
    for (const double value : {1.0, 0.003, 7.0, 12345.0}) {
        const std::vector<double> ticks = logarithmicTicks(value, value);
        ASSERT_GE(ticks.size(), 2U);
        EXPECT_LE(ticks.front(), value * (1 + 1e-9));
        EXPECT_GE(ticks.back(), value);
        EXPECT_LT(ticks.front(), ticks.back());
    }
}

TEST(ErrorColour, IsGreyForWhatIsNoNumber) {
    const std::string grey = errorColour(std::nullopt, 2);
    EXPECT_EQ(errorColour(std::numeric_limits<double>::quiet_NaN(), 2), grey);
    EXPECT_EQ(errorColour(std::numeric_limits<double>::infinity(), 2), grey);
    EXPECT_NE(errorColour(1e300, 2), grey);
}

TEST(ErrorColour, TellsWithinFromBeyondAndUnknown) {
    EXPECT_EQ(errorColour(2, 2), "#ffffbf");
    EXPECT_EQ(errorColour(0, 2), errorColour(0.5, 2)); // the bluest from a quarter on
    EXPECT_EQ(errorColour(8, 2), errorColour(1e9, 2));
    EXPECT_NE(errorColour(0.5, 2), errorColour(8, 2));
    EXPECT_NE(errorColour(std::nullopt, 2), errorColour(2, 2));
}

TEST(ErrorColour, GrowsRedderAndNeverBluerWithTheError) {
    const auto channel = [](const std::string& colour, std::size_t index) {
        return std::stoi(colour.substr(1 + 2 * index, 2), nullptr, 16);
    };
    std::string before = errorColour(0.1, 2);
    for (double error = 0.2; error < 2; error += 0.1) { // from blue to yellow
        const std::string colour = errorColour(error, 2);
        ASSERT_EQ(colour.size(), 7U);
        EXPECT_GE(channel(colour, 0), channel(before, 0)) << error;
        before = colour;
    }
    before = errorColour(2, 2);
    for (double error = 2.2; error < 10; error += 0.2) { // from yellow to red
        const std::string colour = errorColour(error, 2);
        EXPECT_LE(channel(colour, 1), channel(before, 1)) << error;
        EXPECT_LE(channel(colour, 2), channel(before, 2)) << error;
        before = colour;
    }
}

TEST(ErrorColour, DependsOnTheErrorInTolerancesOnly) {
    for (const double share : kErrorSteps) {
        EXPECT_EQ(errorColour(3 * share, 3), errorColour(0.1 * share, 0.1)) << share;
    }
}

TEST(SeriesColours, DifferUntilTheyRepeat) {
    std::set<std::string_view> colours;
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_EQ(seriesColour(i), seriesColour(i + 8));
        colours.insert(seriesColour(i));
    }
    EXPECT_EQ(colours.size(), 8U);
}

TEST(Chart, PutsTheEndsOfItsAxesAtTheEndsOfItsFrame) {
    Svg svg(400, 300, "test");
    Chart chart(svg, {50, 20, 300, 200});
    chart.xAxis({1, 10, 100}, Scale::Logarithmic, "x");
    chart.yAxis({-2, 0, 2}, Scale::Even, "y");
    EXPECT_DOUBLE_EQ(chart.x(1), 50);
    EXPECT_DOUBLE_EQ(chart.x(100), 350);
    EXPECT_NEAR(chart.x(10), 200, 1e-9); // the middle of a logarithmic axis
    EXPECT_DOUBLE_EQ(chart.y(-2), chart.bottom());
    EXPECT_DOUBLE_EQ(chart.bottom(), 220);
    EXPECT_DOUBLE_EQ(chart.y(2), 20);
    EXPECT_DOUBLE_EQ(chart.y(0), 120);
}

TEST(Chart, KeepsValuesInTheirOrderOnEitherScale) {
    test::Random random(8);
    SCOPED_TRACE(random.seed());
    for (const Scale scale : {Scale::Even, Scale::Logarithmic}) {
        Svg svg(400, 300, "test");
        Chart chart(svg, {50, 20, 300, 200});
        chart.xAxis({1, 10, 100}, scale, "x");
        chart.yAxis({1, 10, 100}, scale, "y");
        for (int i = 0; i < 100; ++i) {
            const double small = random.uniform(1, 99);
            const double large = random.uniform(small + 0.1, 100);
            EXPECT_LT(chart.x(small), chart.x(large));
            EXPECT_GT(chart.y(small), chart.y(large)); // upwards
            EXPECT_GE(chart.x(small), 50);
            EXPECT_LE(chart.x(large), 350);
        }
    }
}

TEST(Chart, NumbersEachTickOnceAndDrawsItsGrid) {
    Svg svg(400, 300, "test");
    Chart chart(svg, {50, 20, 300, 200});
    chart.title("What is shown");
    chart.xAxis({0, 25, 50}, Scale::Even, "along");
    chart.yAxis({7, 8}, Scale::Even, "upwards");
    chart.axisLines();
    const std::string drawn = svg.str();
    for (const char* words :
         {">0<", ">25<", ">50<", ">7<", ">8<", ">along<", ">upwards<", ">What is shown<"}) {
        const std::size_t at = drawn.find(words);
        ASSERT_NE(at, std::string::npos) << words;
        EXPECT_EQ(drawn.find(words, at + 1), std::string::npos) << words;
    }
    std::size_t grid = 0;
    for (std::size_t at = 0; (at = drawn.find("class=\"grid\"", at)) != std::string::npos; ++at) {
        ++grid;
    }
    EXPECT_EQ(grid, 5U);
    EXPECT_NE(drawn.find("x=\"200.0\" y=\"238.0\" text-anchor=\"middle\">25<"), std::string::npos);
}

} // namespace spherewalk::report
