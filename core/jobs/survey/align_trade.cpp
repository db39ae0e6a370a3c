// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/align_trade.h"

#include "spherewalk/base/folder.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/statistics.h"
#include "spherewalk/base/text.h"
#include "spherewalk/report/chart.h"
#include "spherewalk/report/document.h"
#include "spherewalk/report/svg.h"
#include "spherewalk/store/survey_store.h"

#include <algorithm>

namespace spherewalk::jobs {

using report::Chart;
using report::Scale;
using report::Svg;
using report::SvgBox;

namespace {

double degreesOf(double radians) {
    return Degrees(Radians(radians)).value();
}

AlignTradeRow rowOf(const AlignReport& report, const AlignTradeOptions& options) {
    AlignTradeRow row;
    const align::FeatureOptions features = align::optionsFor(report.effort).features;
    row.effort = report.effort;
    row.detector = align::name(features.detector);
    row.width = features.width;
    row.most = features.most;
    row.model = report.alignment.model;
    row.featureSeconds = report.featureSeconds;
    row.matchSeconds = report.matchSeconds;
    row.solveSeconds = report.solveSeconds;
    row.cycleErrorDeg = degreesOf(report.alignment.cycleErrorRad);
    std::vector<double> sigmas;
    for (const AlignedPhoto& photo : report.photos) {
        if (photo.pose.isSolved) {
            sigmas.push_back(degreesOf(photo.pose.sigmaYaw.value()));
        }
    }
    row.solved = static_cast<int>(sigmas.size());
    row.sigmaYawDeg = sigmas.empty() ? 0 : median(sigmas);
    if (!options.truth.empty()) {
        row.error = alignmentError(report, options.truth);
    }
    return row;
}

/// One effort: its features are found once, and every model solved from them.
std::vector<AlignTradeRow> rowsOf(store::SurveyStore& store, align::Effort effort,
                                  const AlignTradeOptions& options, ProgressSink& progress,
                                  const std::stop_token& stop) {
    const TemporaryFolder cache("spherewalk-align");
    AlignOptions align;
    align.effort = effort;
    align.mask = options.mask;
    align.cacheFolder = cache.path();
    align.isRecorded = false;
    align.threads = options.threads;
    const double share = 0.3 / static_cast<double>(options.models.size());
    ProgressStep first(progress, 0, 0.7);
    const AlignReport chosen = alignSurvey(store, align, first, stop);
    std::vector<AlignTradeRow> rows;
    for (const align::Model model : options.models) {
        const double begin = 0.7 + share * static_cast<double>(rows.size());
        ProgressStep step(progress, begin, begin + share);
        align.model = model;
        rows.push_back(rowOf(alignSurvey(store, align, step, stop), options));
        rows.back().featureSeconds = chosen.featureSeconds;
        for (const align::ModelTrial& trial : chosen.alignment.trials) {
            if (trial.model == model) {
                rows.back().heldOutDeg = degreesOf(trial.heldOutRad);
            }
        }
    }
    return rows;
}

} // namespace

AlignTrade alignTrade(store::SurveyStore& store, const AlignTradeOptions& options, ProgressSink& progress,
                      const std::stop_token& stop) {
    AlignTrade trade;
    trade.photos = store.chosenPhotos().size();
    trade.hasTruth = !options.truth.empty();
    // Each effort takes about three times as long as the one before.
    double total = 0;
    double weight = 1;
    for (std::size_t i = 0; i < options.efforts.size(); ++i, weight *= 3) {
        total += weight;
    }
    double begin = 0;
    weight = 1 / total;
    for (const align::Effort effort : options.efforts) {
        ProgressStep step(progress, begin, begin + weight);
        for (AlignTradeRow& row : rowsOf(store, effort, options, step, stop)) {
            trade.rows.push_back(std::move(row));
        }
        begin += weight;
        weight *= 3;
    }
    return trade;
}

namespace {

constexpr int kTradeWidth = 760;
constexpr int kTradeHeight = 500;
constexpr SvgBox kTradeFrame{80, 80, 480, 340};
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
    report::Table table{{"effort", "model", "s", "photos", "held out", "cycle", "stated yaw"}, {}, 2};
    if (trade.hasTruth) {
        table.titles.insert(table.titles.end(), {"yaw RMS", "worst", "tilt RMS", "lean", "error / stated"});
    }
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
        table.rows.push_back(cells);
    }
    return text("Alignment of ", trade.photos,
                " photos: effort (detector, working pixels per turn, features a "
                "photo) and model; angles in degrees, common yaw and lean taken off\n",
                table.text());
}

std::string tradePlot(const AlignTrade& trade, const std::string& title) {
    Svg svg(kTradeWidth, kTradeHeight, "Error of the alignment against time");
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
    Chart chart(svg, kTradeFrame);
    chart.xAxis(report::logarithmicTicks(0.8 * fastest, 1.2 * std::max(fastest, slowest)), Scale::Logarithmic,
                "seconds for the survey");
    chart.yAxis(report::logarithmicTicks(0.8 * least, 1.2 * most), Scale::Logarithmic, "degrees");
    chart.axisLines();
    const double tolerance = chart.y(kToleranceDeg);
    svg.line({kTradeFrame.x, tolerance}, {kTradeFrame.x + kTradeFrame.width, tolerance}, Svg::Line::Dashed);
    double legend = kTradeFrame.y + 10;
    for (std::size_t i = 0; i < trade.rows.size(); ++i) {
        const AlignTradeRow& row = trade.rows[i];
        const auto colour = report::seriesColour(effortIndex(trade, i));
        const report::SvgPoint at{chart.x(std::max(row.seconds(), 0.1)), chart.y(errorDeg(row))};
        svg.circle(at, 5, colour);
        svg.text({at.x + 8, at.y + 4}, name(row.model), Svg::Text::Small);
        if (isNewEffort(trade, i)) {
            svg.rectangle({kTradeFrame.x + kTradeFrame.width + 24, legend - 10, 12, 12}, colour);
            svg.text({kTradeFrame.x + kTradeFrame.width + 42, legend}, name(row.effort), Svg::Text::Small);
            legend += 22;
        }
    }
    svg.text({kTradeFrame.x, kTradeHeight - 14}, text("Dashed: the tolerance of ", kToleranceDeg, " degrees"),
             Svg::Text::Small);
    return svg.str();
}

} // namespace spherewalk::jobs
