// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/command.h"

#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/align_trade.h"
#include "spherewalk/store/survey_store.h"

#include <algorithm>
#include <memory>

namespace spherewalk::cli {

namespace {

struct AlignArguments {
    std::string survey;
    std::string effort{align::name(jobs::AlignOptions().effort)};
    std::string model = "auto";
    std::string mask;
    std::string truth;
    std::string plot;
    bool isTrade = false;
    bool keepsActive = false;
    bool ignoresPositions = false;
    double positionSigmaM = jobs::AlignOptions().positionSigmaM;
    int threads = 0;
};

Result measureTrade(const AlignArguments& options, Context& context) {
    checkPlot(options.plot);
    auto store = store::SurveyStore::open(options.survey, store::Access::Read);
    jobs::AlignTradeOptions tradeOptions;
    tradeOptions.mask = options.mask;
    tradeOptions.threads = options.threads;
    if (!options.truth.empty()) {
        tradeOptions.truth = jobs::readTruePoses(store, options.truth);
    }
    const jobs::AlignTrade trade = jobs::alignTrade(store, tradeOptions, context.progress, context.stop);
    Result result{jobs::toJson(trade), jobs::tradeTable(trade)};
    if (!options.plot.empty()) {
        writePlot(options.plot, jobs::tradePlot(trade, text("Alignment of ", store.info().name)), result);
    }
    return result;
}

std::string errorText(const jobs::AlignmentError& error) {
    return text("\nAgainst the truth of ", error.photos, " photos: yaw ", fixed(error.yawRmsDeg, 4),
                " deg RMS, ", fixed(error.yawWorstDeg, 4), " worst (the common ",
                fixed(error.commonYawDeg, 3), " deg taken off); tilt ", fixed(error.tiltRmsDeg, 4), " RMS, ",
                fixed(error.tiltWorstDeg, 4), " worst (", fixed(error.ownTiltRmsDeg, 4),
                " RMS with the common lean of ", fixed(error.commonLeanDeg, 4), " deg taken off); position ",
                fixed(1000 * error.positionRmsM, 2), " mm RMS; error over sigma ",
                fixed(error.yawOverSigma, 2), " (yaw), ", fixed(error.tiltOverSigma, 2), " (tilt), ",
                fixed(100 * error.within3Sigma, 1), " % within three sigma.");
}

Result align(const AlignArguments& options, Context& context) {
    auto store = store::SurveyStore::open(options.survey, store::Access::Write);
    jobs::AlignOptions alignOptions;
    alignOptions.effort = align::effortNamed(options.effort);
    alignOptions.model = align::modelNamed(options.model);
    alignOptions.mask = options.mask;
    alignOptions.checksPositions = !options.ignoresPositions;
    alignOptions.isActivated = !options.keepsActive;
    alignOptions.positionSigmaM = options.positionSigmaM;
    alignOptions.threads = options.threads;
    const jobs::TruePoses truth =
        options.truth.empty() ? jobs::TruePoses() : jobs::readTruePoses(store, options.truth);
    const jobs::AlignReport report = jobs::alignSurvey(store, alignOptions, context.progress, context.stop);
    const bool isAnySolved = std::ranges::any_of(
        report.photos, [](const jobs::AlignedPhoto& photo) { return photo.pose.isSolved; });
    Result result{jobs::toJson(report), jobs::alignText(report), isAnySolved};
    if (!truth.empty()) {
        const jobs::AlignmentError error = jobs::alignmentError(report, truth);
        result.json["error"] = jobs::toJson(error);
        result.text += errorText(error);
    }
    return result;
}

} // namespace

void addAlign(Commands& commands) {
    const auto options = std::make_shared<AlignArguments>();
    const program::Command command =
        commands.add("align", "Solve how each photo is turned, from what neighbours see in common",
                     [options](Context& context) {
                         return options->isTrade ? measureTrade(*options, context) : align(*options, context);
                     });
    command.option("survey", options->survey, "Folder of the survey").required();
    command
        .option("--effort", options->effort,
                "How much work goes into the pictures: draft, normal, fine or exact")
        .showDefault();
    command
        .option("--model", options->model,
                "What is solved: yaw, tilt, placement, position, or auto (what the photos support)")
        .showDefault();
    command.option("--mask", options->mask,
                   "Picture, twice as wide as high, black where photos are not to be looked at");
    command
        .option("--position-sigma", options->positionSigmaM,
                "How far photos stand from where they are tagged, metres, one standard deviation")
        .range(0.0001, 1.0)
        .showDefault();
    command.option("--threads", options->threads, "Threads at most; 0: all that the machine has")
        .range(0, 1024)
        .showDefault();
    command.flag("--keep-active", options->keepsActive,
                 "Record the solution without putting it in place of the active one");
    command.flag("--no-position-check", options->ignoresPositions, "Take all position tags as they are");
    command.option("--truth", options->truth,
                   "True poses to compare with: a practice camera's truth (.jsonl), or a positions file "
                   "with rotations (.csv)");
    command.flag("--trade", options->isTrade,
                 "Measure every effort and model, and print what each costs and gains; records nothing");
    command.option("--plot", options->plot, "With --trade: SVG file to draw the figures into");
}

} // namespace spherewalk::cli
