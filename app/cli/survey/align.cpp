// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/command.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/align_trade.h"
#include "spherewalk/store/survey_store.h"
#include "spherewalk/survey/room.h"

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <optional>

namespace spherewalk::cli {

namespace {

struct AlignArguments {
    std::string survey;
    std::string effort;
    std::string model = "auto";
    std::string mask;
    std::string truth;
    std::string plot;
    bool isTrade = false;
    bool keepsActive = false;
    bool ignoresPositions = false;
    std::string positions = "given";
    double lensHeightM = 0;
    std::string distance;
    std::string outline;
    double tagSizeM = 0;
    std::string tagsOf;
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

bool isFree(const AlignArguments& options) {
    if (options.positions != "given" && options.positions != "free") {
        throw Error(ErrorKind::InvalidInput, text("There are no positions '", printable(options.positions),
                                                  "' to align with: give --positions given or free."));
    }
    return options.positions == "free";
}

/// "A,B,METRES".
std::optional<jobs::MeasuredDistance> distanceIn(const AlignArguments& options) {
    if (options.distance.empty()) {
        return std::nullopt;
    }
    const std::size_t last = options.distance.rfind(',');
    const std::size_t first = options.distance.find(',');
    jobs::MeasuredDistance distance;
    const char* begin = options.distance.c_str() + last + 1;
    char* end = nullptr;
    distance.metres = last == std::string::npos ? 0 : std::strtod(begin, &end);
    if (first == last || *end != '\0' || !(distance.metres > 0.01 && distance.metres < 1000)) {
        throw Error(ErrorKind::InvalidInput,
                    text("The distance '", printable(options.distance),
                         "' is none: give --distance PHOTO,PHOTO,METRES, from 0.01 to 1000 m."));
    }
    distance.a = options.distance.substr(0, first);
    distance.b = options.distance.substr(first + 1, last - first - 1);
    return distance;
}

/// The outline as `new --outline` reads it.
void writeOutline(const std::string& file, const jobs::AlignReport& report, Result& result) {
    if (!report.places || report.places->outline.empty()) {
        throw Error(ErrorKind::InvalidInput,
                    "There is no outline to write: the photos' places were not solved from the pictures.");
    }
    survey::Room room;
    room.outline = report.places->outline;
    room.ceilingM = report.places->ceilingM;
    writeFile(file, bytesOf(survey::outlineJson(room).dump(2) + "\n"));
    result.text +=
        text("\nWrote ", file, ": a rectangle around what the photos show, and the ceiling's height.");
}

/// Where tags hang by the active solution of another survey.
std::vector<align::RoomTag> knownTags(const AlignArguments& options) {
    if (options.tagsOf.empty()) {
        return {};
    }
    const std::vector<align::RoomTag> tags =
        jobs::aprilTagsOf(store::SurveyStore::open(options.tagsOf, store::Access::Read));
    if (tags.empty()) {
        throw Error(ErrorKind::InvalidInput,
                    text("The active solution of ", options.tagsOf,
                         " knows no AprilTags: align that survey with --tag-size first."));
    }
    return tags;
}

Result align(const AlignArguments& options, Context& context) {
    auto store = store::SurveyStore::open(options.survey, store::Access::Write);
    jobs::AlignOptions alignOptions;
    if (!options.effort.empty()) {
        alignOptions.effort = align::effortNamed(options.effort);
    }
    alignOptions.model = align::modelNamed(options.model);
    alignOptions.mask = options.mask;
    alignOptions.checksPositions = !options.ignoresPositions;
    alignOptions.isFree = isFree(options);
    alignOptions.lensHeightM = options.lensHeightM;
    alignOptions.distance = distanceIn(options);
    alignOptions.tagSizeM = options.tagSizeM;
    alignOptions.knownTags = knownTags(options);
    if (!alignOptions.knownTags.empty() && !alignOptions.isFree) {
        throw Error(
            ErrorKind::InvalidInput,
            "--tags-of moves the photos into the other survey's frame: give --positions free with it.");
    }
    alignOptions.isActivated = !options.keepsActive;
    alignOptions.positionSigmaM = options.positionSigmaM;
    alignOptions.threads = options.threads;
    const jobs::TruePoses truth =
        options.truth.empty() ? jobs::TruePoses() : jobs::readTruePoses(store, options.truth);
    const jobs::AlignReport report = jobs::alignSurvey(store, alignOptions, context.progress, context.stop);
    const bool isAnyKnown = std::ranges::any_of(report.photos, &jobs::AlignedPhoto::isHandedOn);
    Result result{jobs::toJson(report), jobs::alignText(report), isAnyKnown};
    if (!options.outline.empty()) {
        writeOutline(options.outline, report, result);
    }
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
    command.option("--effort", options->effort,
                   "How much work goes into the pictures: draft, normal, fine or exact; without it normal, "
                   "and fine where the pictures place the photos (--positions free, rough tags)");
    command
        .option("--model", options->model,
                "What is solved: yaw, tilt, placement, position, or auto (what the photos support)")
        .showDefault();
    command
        .option("--positions", options->positions,
                "Where the photos were taken: given (as tagged), or free (solved from the pictures alone)")
        .showDefault();
    command
        .option(
            "--lens-height", options->lensHeightM,
            "With --positions free: usual height of the lens above the floor, metres; without it that of the "
            "plan, or that of imported positions; by hand the survey keeps it")
        .range(0.06, 20.0);
    command.option("--distance", options->distance,
                   "With --positions free: PHOTO,PHOTO,METRES between two lenses, for the scale; without it "
                   "the lens's height over the floor gives the scale");
    command.option("--outline", options->outline,
                   "With --positions free: JSON file for the outline that the photos show, as new reads it");
    const program::Option tags =
        command
            .option("--tag-size", options->tagSizeM,
                    "Side of the black square of the AprilTags (36h11) that hang in the room, metres as "
                    "measured; without it, photos are not searched for tags")
            .range(0.01, 10.0);
    command
        .option(
            "--tags-of", options->tagsOf,
            "With --positions free: folder of the survey that saw the same tags, whose frame is taken over")
        .needs(tags);
    command.option("--mask", options->mask,
                   "Picture, twice as wide as high, black where photos are not to be looked at");
    command
        .option("--position-sigma", options->positionSigmaM,
                "How far photos stand from where they are tagged, metres, one standard deviation; from 0.01 "
                "on the pictures say how photos stand to each other")
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
