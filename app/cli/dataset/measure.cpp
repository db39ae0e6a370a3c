// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/command.h"
#include "options/measured_dataset.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/grid_study.h"
#include "spherewalk/jobs/measure_dataset.h"
#include "spherewalk/jobs/measure_page.h"
#include "spherewalk/jobs/measured_dataset.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <tuple>

namespace spherewalk::cli {

namespace {

constexpr std::size_t kWorstShown = 3;

struct MeasureArguments {
    MeasuredDataset dataset;
    std::string pictures;
    std::string report;
    std::string places{jobs::name(jobs::Places::Features)};
    std::string shard = "1/1";
    bool isStored = false;
    jobs::MeasureOptions measure;
};

jobs::MeasureOptions measureOptions(const MeasureArguments& options, Context& context) {
    jobs::MeasureOptions wanted = options.measure;
    const render::ViewOptions view = options.dataset.options().viewOptions();
    wanted.scene = view.scene;
    wanted.sampling = view.sampling;
    wanted.threads = view.threads;
    wanted.places = jobs::places(options.places);
    wanted.worst = options.report.empty() ? 0 : kWorstShown;
    wanted.cacheFolder = options.dataset.resultFolder(context);
    if (!options.pictures.empty()) {
        wanted.pictures = robotPictures(options.dataset.options(), options.pictures);
    }
    wanted.validate();
    return wanted;
}

/// What a survey is to be exported with, so that this scene model can be compared; nothing: all of them.
render::SceneKind richest(const std::optional<render::SceneKind>& scene) {
    return std::clamp(scene.value_or(render::SceneKind::Depth), render::SceneKind::Sphere,
                      render::SceneKind::Depth);
}

Result measureViews(const MeasureArguments& options, Context& context) {
    if (options.isStored && options.dataset.isSurvey()) {
        throw Error(ErrorKind::InvalidInput, "A choice is stored in a dataset, and this is a survey: export "
                                             "it, and measure the dataset with --store.");
    }
    const jobs::MeasureOptions wanted = measureOptions(options, context);
    const CameraModel camera = options.dataset.options().cameraModel();
    const render::Renderer renderer = options.dataset.renderer(richest(wanted.scene), context);
    const jobs::Shard shard = jobs::Shard::parse(options.shard);
    if (!shard.isWhole()) {
        const jobs::MeasuredPart part =
            measurePart(renderer, camera, wanted, shard, context.progress, context.stop);
        return {{{"views", part.views}, {"reused_views", part.reused}, {"of_views", part.ofViews}},
                text("Compared ", part.views, " of ", part.ofViews, " views, ", part.reused,
                     " known from before. Once all parts are there, measure without --shard.")};
    }
    const jobs::MeasureReport report =
        measureDataset(renderer, camera, wanted, context.progress, context.stop);
    Result result{toJson(report), measureText(report)};
    if (!options.report.empty()) {
        jobs::writeReport({&renderer.dataset().info(), &report, nullptr}, options.report);
        result.text += text("\nWrote ", options.report, "/report.html and report.pdf.");
    }
    if (options.isStored) {
        storeChoice(renderer.dataset().folder(), report);
        result.text += text("\nStored the choice in ", renderer.dataset().folder().string(), ".");
    }
    return result;
}

struct GridStudyArguments {
    MeasuredDataset dataset;
    std::string report;
    bool isWithoutDepth = false;
    jobs::GridStudyOptions study;
};

Result studyGrid(const GridStudyArguments& options, Context& context) {
    jobs::GridStudyOptions wanted = options.study;
    const render::ViewOptions view = options.dataset.options().viewOptions();
    wanted.sampling = view.sampling;
    wanted.threads = view.threads;
    wanted.withDepth = !options.isWithoutDepth;
    wanted.cacheFolder = options.dataset.resultFolder(context);
    wanted.validate();
    const CameraModel camera = options.dataset.options().cameraModel();
    // The study finds depths of its own, from the photos that it keeps.
    const render::Renderer renderer = options.dataset.renderer(render::SceneKind::Sphere, context);
    std::tie(wanted.room, wanted.plan) = options.dataset.plan(renderer.dataset().info());
    const jobs::GridStudy found = gridStudy(renderer, camera, wanted, context.progress, context.stop);
    Result result{toJson(found), gridStudyText(found)};
    if (!options.report.empty()) {
        jobs::writeReport({&renderer.dataset().info(), nullptr, &found}, options.report);
        result.text += text("\nWrote ", options.report, "/report.html and report.pdf.");
    }
    return result;
}

} // namespace

void addMeasure(Commands& commands) {
    const auto options = std::make_shared<MeasureArguments>();
    const program::Command command = commands.add(
        "measure", "Measure how right views are, and choose the cheapest scene model and sampling",
        [options](Context& context) { return measureViews(*options, context); });
    options->dataset.declare(command);
    command.option(
        "--pictures", options->pictures,
        "CSV of the robot camera's own pictures with their poses, compared besides photos that are left out");
    declareTolerance(command, options->measure.tolerancePx);
    command
        .option("--places", options->places,
                "What those places are: features that are found again, or pixels, all whose depth is known")
        .among({"features", "pixels"})
        .showDefault();
    command
        .option("--views", options->measure.mostViews,
                "Views of photos that are left out, at most; spread over photos and directions")
        .range(1, 1'000'000)
        .showDefault();
    command.option("--directions", options->measure.directions, "Directions about the horizon")
        .range(1, 360)
        .showDefault();
    command
        .option("--sampling-views", options->measure.samplingViews,
                "Views that the samplings are compared on, of those")
        .range(0, 1'000'000)
        .showDefault();
    command
        .option("--shard", options->shard,
                "Compare only the i-th of n parts of the views, \"i/n\"; the same command without it puts "
                "all parts together")
        .showDefault();
    command.flag("--store", options->isStored,
                 "Write the choice into the dataset: what --scene auto and --sampling auto stand for");
    command.option("--report", options->report, "Folder to write a page into (HTML, PDF and JSON)");
}

void addGridStudy(Commands& commands) {
    const auto options = std::make_shared<GridStudyArguments>();
    const program::Command command = commands.add(
        "grid-study", "From a dense block of photos, find how coarse a grid may be, and what it costs",
        [options](Context& context) { return studyGrid(*options, context); });
    options->dataset.declare(command);
    declareTolerance(command, options->study.tolerancePx);
    command.option("--largest", options->study.largest, "The coarsest grid keeps every so many-th photo")
        .range(2, 20)
        .showDefault();
    command.option("--offsets", options->study.mostOffsets, "Grids of each step, shifted against each other")
        .range(1, 400)
        .showDefault();
    command.option("--views", options->study.mostViews, "Views of each step, at most")
        .range(1, 1'000'000)
        .showDefault();
    command.option("--directions", options->study.directions, "Directions about the horizon")
        .range(1, 360)
        .showDefault();
    command.option("--report", options->report, "Folder to write a page into (HTML, PDF and JSON)");
    command.flag("--no-depth", options->isWithoutDepth,
                 "Leave the depth scene model out: a minute instead of some");
}

} // namespace spherewalk::cli
