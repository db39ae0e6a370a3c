// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/align_trade.h"

#include "spherewalk/base/median.h"
#include "spherewalk/base/temporary_folder.h"

namespace spherewalk::jobs {

namespace {

double degrees(double radians) {
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
    row.cycleErrorDeg = degrees(report.alignment.cycleErrorRad);
    std::vector<double> sigmas;
    for (const AlignedPhoto& photo : report.photos) {
        if (photo.pose.isSolved) {
            sigmas.push_back(degrees(photo.pose.sigmaYaw.value()));
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
                rows.back().heldOutDeg = degrees(trial.heldOutRad);
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

} // namespace spherewalk::jobs
