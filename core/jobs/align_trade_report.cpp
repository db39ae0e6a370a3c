// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/align_trade.h"
#include "spherewalk/measure/chart.h"
#include "spherewalk/measure/plot_axis.h"
#include "spherewalk/measure/svg.h"
#include "spherewalk/measure/text_table.h"

#include <algorithm>

namespace spherewalk::jobs {

using measure::Chart;
using measure::Scale;
using measure::Svg;
using measure::SvgBox;

namespace {

constexpr int kWidth = 760;
constexpr int kHeight = 500;
constexpr SvgBox kFrame{80, 80, 480, 340};
constexpr double kLeastShownDeg = 1e-4;
/// One pixel of a VGA camera of 90 degrees is 0.14 deg; the default is the cheapest effort within this.
constexpr double kToleranceDeg = 0.1;

/// What the plot shows: the true error where it is known, else what the solution states.
double errorDeg(const AlignTradeRow& row) {
    return std::max(kLeastShownDeg, row.error ? row.error->yawRmsDeg : row.sigmaYawDeg);
}

std::string digits(double degrees) {
    return fixed(degrees, 4);
}

bool isNewEffort(const AlignTrade& trade, std::size_t row) {
    return row == 0 || trade.rows[row].effort != trade.rows[row - 1].effort;
}

std::size_t effortIndex(const AlignTrade& trade, std::size_t row) {
    std::size_t index = 0;
    for (std::size_t i = 1; i <= row; ++i) {
        index += isNewEffort(trade, i) ? 1 : 0;
    }
    return index;
}

} // namespace

Json toJson(const AlignTrade& trade) {
    Json rows = Json::array();
    for (const AlignTradeRow& row : trade.rows) {
        rows.push_back({{"effort", name(row.effort)},
                        {"detector", row.detector},
                        {"width", row.width},
                        {"features", row.most},
                        {"model", name(row.model)},
                        {"seconds", row.seconds()},
                        {"feature_seconds", row.featureSeconds},
                        {"match_seconds", row.matchSeconds},
                        {"solve_seconds", row.solveSeconds},
                        {"solved", row.solved},
                        {"error", row.error ? toJson(*row.error) : Json()},
                        {"held_out_deg", row.heldOutDeg ? Json(*row.heldOutDeg) : Json()},
                        {"cycle_error_deg", row.cycleErrorDeg},
                        {"sigma_yaw_deg", row.sigmaYawDeg}});
    }
    return {{"photos", trade.photos}, {"rows", rows}};
}

std::string tradeTable(const AlignTrade& trade) {
    measure::TextTable table(2);
    std::vector<std::string> heads{"effort", "model", "s", "photos", "held out", "cycle", "stated yaw"};
    if (trade.hasTruth) {
        heads.insert(heads.end(), {"yaw RMS", "worst", "tilt RMS", "lean", "error / stated"});
    }
    table.add(heads);
    for (std::size_t i = 0; i < trade.rows.size(); ++i) {
        const AlignTradeRow& row = trade.rows[i];
        std::vector<std::string> cells{
            isNewEffort(trade, i) ? text(name(row.effort), ": ", row.detector, " ", row.width, ", ", row.most)
                                  : "",
            std::string(name(row.model)),
            fixed(row.seconds(), 1),
            text(row.solved),
            row.heldOutDeg ? digits(*row.heldOutDeg) : "-",
            digits(row.cycleErrorDeg),
            digits(row.sigmaYawDeg)};
        if (row.error) {
            cells.insert(cells.end(), {digits(row.error->yawRmsDeg), digits(row.error->yawWorstDeg),
                                       digits(row.error->ownTiltRmsDeg), digits(row.error->commonLeanDeg),
                                       fixed(row.error->yawOverSigma, 2)});
        }
        table.add(cells);
    }
    return text("Alignment of ", trade.photos,
                " photos: effort (detector, working pixels per turn, features a "
                "photo) and model; angles in degrees, common yaw and lean taken off\n",
                table.text());
}

std::string tradePlot(const AlignTrade& trade, const std::string& title) {
    Svg svg(kWidth, kHeight, "Error of the alignment against time");
    svg.text({24, 30}, title, Svg::Text::Title);
    svg.text({24, 50},
             trade.hasTruth ? "Error of the yaw, root mean square over all photos, the common yaw taken off"
                            : "Standard deviation of the yaw, as the solution states it, median",
             Svg::Text::Small);
    double least = kToleranceDeg;
    double most = kToleranceDeg;
    double fastest = 1e9;
    double slowest = 0;
    for (const AlignTradeRow& row : trade.rows) {
        least = std::min(least, errorDeg(row));
        most = std::max(most, errorDeg(row));
        fastest = std::min(fastest, std::max(row.seconds(), 0.1));
        slowest = std::max(slowest, row.seconds());
    }
    Chart chart(svg, kFrame);
    chart.xAxis(measure::logarithmicTicks(0.8 * fastest, 1.2 * std::max(fastest, slowest)),
                Scale::Logarithmic, "seconds for the survey");
    chart.yAxis(measure::logarithmicTicks(0.8 * least, 1.2 * most), Scale::Logarithmic, "degrees");
    chart.axisLines();
    const double tolerance = chart.y(kToleranceDeg);
    svg.line({kFrame.x, tolerance}, {kFrame.x + kFrame.width, tolerance}, Svg::Line::Dashed);
    double legend = kFrame.y + 10;
    for (std::size_t i = 0; i < trade.rows.size(); ++i) {
        const AlignTradeRow& row = trade.rows[i];
        const auto colour = measure::seriesColour(effortIndex(trade, i));
        const measure::SvgPoint at{chart.x(std::max(row.seconds(), 0.1)), chart.y(errorDeg(row))};
        svg.circle(at, 5, colour);
        svg.text({at.x + 8, at.y + 4}, name(row.model), Svg::Text::Small);
        if (isNewEffort(trade, i)) {
            svg.rectangle({kFrame.x + kFrame.width + 24, legend - 10, 12, 12}, colour);
            svg.text({kFrame.x + kFrame.width + 42, legend}, name(row.effort), Svg::Text::Small);
            legend += 22;
        }
    }
    svg.text({kFrame.x, kHeight - 14}, text("Dashed: the tolerance of ", kToleranceDeg, " degrees"),
             Svg::Text::Small);
    return svg.str();
}

} // namespace spherewalk::jobs
