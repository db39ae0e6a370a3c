// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/measure_plots.h"

#include "spherewalk/base/text.h"
#include "spherewalk/report/chart.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace spherewalk::jobs {

using report::Chart;
using report::Scale;
using report::Svg;
using report::SvgBox;
using report::SvgPoint;

namespace {

constexpr int kPlotWidth = 760;
constexpr int kPlotHeight = 440;
constexpr SvgBox kPlotFrame{80, 80, 480, 290};
constexpr double kLeastPx = 0.05; ///< what is shown is not less
constexpr double kLeastMs = 0.05;

/// A value's least and greatest, with some space about them.
struct Extent {
    double least = 1e9;
    double greatest = 0;

    void add(double value) {
        least = std::min(least, value);
        greatest = std::max(greatest, value);
    }

    std::vector<double> ticks() const { return report::logarithmicTicks(0.85 * least, 1.15 * greatest); }
};

struct Point {
    double x;
    double y;
    std::string words; ///< beside the point
};

using Lines = std::map<render::SceneKind, std::vector<Point>>;

/// Words beside a point, where there is room; the tables have all figures.
void label(Svg& svg, const SvgPoint& point, const std::string& words, std::vector<SvgBox>& taken) {
    constexpr double kAbovePx = 8;
    constexpr double kBelowPx = 18;
    const double width = Svg::extent(point, words, Svg::Text::Small).width;
    for (const SvgPoint& at :
         {SvgPoint{point.x + 6, point.y - kAbovePx}, SvgPoint{point.x + 6, point.y + kBelowPx},
          SvgPoint{point.x - width - 2, point.y - kAbovePx},
          SvgPoint{point.x - width - 2, point.y + kBelowPx}, SvgPoint{point.x + 6, point.y - 2.5 * kAbovePx},
          SvgPoint{point.x + 6, point.y + 1.8 * kBelowPx}}) {
        const SvgBox box = Svg::extent(at, words, Svg::Text::Small);
        if (!words.empty() && box.x > kPlotFrame.x &&
            std::none_of(taken.begin(), taken.end(), [&](const SvgBox& t) { return t.overlaps(box); })) {
            svg.text(at, words, Svg::Text::Small);
            taken.push_back(box);
            return;
        }
    }
}

/// A line for each scene model on logarithmic axes, with the tolerance and a legend.
std::string linesPlot(const std::string& title, const std::string& below, const std::string& xCaption,
                      const Lines& lines, double tolerancePx) {
    Svg svg(kPlotWidth, kPlotHeight, title);
    svg.text({24, 30}, title, Svg::Text::Title);
    svg.text({24, 52}, below, Svg::Text::Small);
    Extent x;
    Extent y;
    y.add(tolerancePx);
    for (const auto& [scene, points] : lines) {
        for (const Point& point : points) {
            x.add(point.x);
            y.add(point.y);
        }
    }
    Chart chart(svg, kPlotFrame);
    chart.xAxis(x.ticks(), Scale::Logarithmic, xCaption);
    chart.yAxis(y.ticks(), Scale::Logarithmic, "95th percentile, px");
    chart.axisLines();
    const double right = kPlotFrame.x + kPlotFrame.width;
    svg.line({kPlotFrame.x, chart.y(tolerancePx)}, {right, chart.y(tolerancePx)}, Svg::Line::Dashed);
    svg.text({right + 8, chart.y(tolerancePx) + 4}, text("tolerance ", tolerancePx, " px"), Svg::Text::Small);
    double legend = kPlotFrame.y + 4;
    std::vector<SvgBox> taken;
    for (const auto& [scene, points] : lines) {
        const auto colour = report::seriesColour(static_cast<std::size_t>(scene));
        std::vector<SvgPoint> at;
        for (const Point& point : points) {
            at.push_back({chart.x(point.x), chart.y(point.y)});
        }
        svg.path(at, Svg::Line::Mark, colour);
        for (std::size_t i = 0; i < at.size(); ++i) {
            svg.circle(at[i], 4.5, colour);
            label(svg, at[i], points[i].words, taken);
        }
        svg.rectangle({right + 110, legend - 10, 12, 12}, colour);
        svg.text({right + 128, legend}, name(scene), Svg::Text::Small);
        legend += 22;
    }
    return svg.str();
}

} // namespace

std::string tradePlot(const MeasureReport& report) {
    Lines lines;
    for (const Rung& rung : report.rungs) {
        if (rung.errorPx && std::isfinite(*rung.errorPx)) {
            lines[rung.scene].push_back({std::max(kLeastMs, rung.renderMs), std::max(kLeastPx, *rung.errorPx),
                                         std::string(name(rung.sampling))});
        }
    }
    for (auto& [scene, points] : lines) {
        std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.x < b.x; });
    }
    return linesPlot("What time buys", "A line a scene model, a point a sampling", "milliseconds a view",
                     lines, report.choice.tolerancePx);
}

std::string gridPlot(const GridStudy& study) {
    Lines lines;
    for (const GridRow& row : study.rows) {
        if (row.p95Px && std::isfinite(*row.p95Px)) {
            lines[row.scene].push_back({100 * row.stepM, std::max(kLeastPx, *row.p95Px), ""});
        }
    }
    return linesPlot("What photos buy",
                     "Where a robot may stand farthest from the photos; a line a scene model",
                     "step of the grid, cm", lines, study.tolerancePx);
}

std::string predictionPlot(const MeasureReport& report) {
    Svg svg(kPlotWidth, kPlotHeight, "Foretold and found");
    svg.text({24, 30}, "Foretold and found", Svg::Text::Title);
    svg.text({24, 52},
             "Median error of each of the robot's pictures against what leaving photos out foretold",
             Svg::Text::Small);
    Extent both;
    for (const Prediction& prediction : report.predictions) {
        for (std::size_t i = 0; i < prediction.foundPx.size(); ++i) {
            both.add(std::max(kLeastPx, prediction.foundPx[i]));
            both.add(std::max(kLeastPx, prediction.foretoldPx[i]));
        }
    }
    if (both.greatest <= 0) {
        return svg.str();
    }
    Chart chart(svg, kPlotFrame);
    chart.xAxis(both.ticks(), Scale::Logarithmic, "foretold, px");
    chart.yAxis(both.ticks(), Scale::Logarithmic, "found, px");
    chart.axisLines();
    const double right = kPlotFrame.x + kPlotFrame.width;
    svg.line({kPlotFrame.x, chart.bottom()}, {right, kPlotFrame.y}, Svg::Line::Dashed);
    double legend = kPlotFrame.y + 4;
    for (const Prediction& prediction : report.predictions) {
        const auto colour = report::seriesColour(static_cast<std::size_t>(prediction.scene));
        for (std::size_t i = 0; i < prediction.foundPx.size(); ++i) {
            svg.circle({chart.x(std::max(kLeastPx, prediction.foretoldPx[i])),
                        chart.y(std::max(kLeastPx, prediction.foundPx[i]))},
                       4, colour);
        }
        svg.rectangle({right + 24, legend - 10, 12, 12}, colour);
        svg.text({right + 42, legend},
                 text(name(prediction.scene), ", rank correlation ",
                      prediction.rankCorrelation ? fixed(*prediction.rankCorrelation, 2) : "-"),
                 Svg::Text::Small);
        legend += 22;
    }
    return svg.str();
}

} // namespace spherewalk::jobs
