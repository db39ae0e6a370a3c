// SPDX-License-Identifier: GPL-3.0-or-later
#include "command.h"
#include "measured_dataset.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/measure_dataset.h"
#include "spherewalk/jobs/measure_page.h"

#include <algorithm>
#include <memory>
#include <optional>

namespace spherewalk::cli {

namespace {

constexpr std::size_t kWorstShown = 3;

struct Options {
    MeasuredDataset dataset;
    std::string pictures;
    std::string report;
    std::string places{jobs::name(jobs::Places::Features)};
    std::string shard = "1/1";
    bool isStored = false;
    jobs::MeasureOptions measure;
};

jobs::MeasureOptions measureOptions(const Options& options, Context& context) {
    jobs::MeasureOptions wanted = options.measure;
    const render::ViewOptions view = options.dataset.options().viewOptions();
    wanted.scene = view.scene;
    wanted.sampling = view.sampling;
    wanted.threads = view.threads;
    wanted.places = jobs::places(options.places);
    wanted.worst = options.report.empty() ? 0 : kWorstShown;
    wanted.cacheFolder = options.dataset.resultFolder(context);
    if (!options.pictures.empty()) {
        wanted.pictures = options.dataset.options().robotPictures(options.pictures);
    }
    wanted.validate();
    return wanted;
}

/// What a survey is to be exported with, so that this scene model can be compared; nothing: all of them.
render::SceneKind richest(const std::optional<render::SceneKind>& scene) {
    return std::max(scene.value_or(render::SceneKind::Depth), render::SceneKind::Sphere);
}

Result measure(const Options& options, Context& context) {
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

} // namespace

void addMeasure(Commands& commands) {
    const auto options = std::make_shared<Options>();
    CLI::App& command = commands.add(
        "measure", "Measure how right views are, and choose the cheapest scene model and sampling",
        [options](Context& context) { return measure(*options, context); });
    options->dataset.declare(command);
    command.add_option(
        "--pictures", options->pictures,
        "CSV of the robot camera's own pictures with their poses, compared besides photos that are left out");
    declareTolerance(command, options->measure.tolerancePx);
    command
        .add_option(
            "--places", options->places,
            "What those places are: features that are found again, or pixels, all whose depth is known")
        ->check(CLI::IsMember({"features", "pixels"}))
        ->capture_default_str();
    command
        .add_option("--views", options->measure.mostViews,
                    "Views of photos that are left out, at most; spread over photos and directions")
        ->check(CLI::Range(1, 1'000'000))
        ->capture_default_str();
    command.add_option("--directions", options->measure.directions, "Directions about the horizon")
        ->check(CLI::Range(1, 360))
        ->capture_default_str();
    command
        .add_option("--sampling-views", options->measure.samplingViews,
                    "Views that the samplings are compared on, of those")
        ->check(CLI::Range(0, 1'000'000))
        ->capture_default_str();
    command
        .add_option(
            "--shard", options->shard,
            "Compare only the i-th of n parts of the views, \"i/n\"; the same command without it puts "
            "all parts together")
        ->capture_default_str();
    command.add_flag("--store", options->isStored,
                     "Write the choice into the dataset: what --scene auto and --sampling auto stand for");
    command.add_option("--report", options->report, "Folder to write a page into (HTML, PDF and JSON)");
}

} // namespace spherewalk::cli
