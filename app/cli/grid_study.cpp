// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/grid_study.h"

#include "command.h"
#include "measured_dataset.h"

#include "spherewalk/base/text.h"
#include "spherewalk/jobs/measure_page.h"

#include <memory>
#include <tuple>

namespace spherewalk::cli {

namespace {

struct Options {
    MeasuredDataset dataset;
    std::string report;
    bool isWithoutDepth = false;
    jobs::GridStudyOptions study;
};

Result study(const Options& options, Context& context) {
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

void addGridStudy(Commands& commands) {
    const auto options = std::make_shared<Options>();
    CLI::App& command = commands.add(
        "grid-study", "From a dense block of photos, find how coarse a grid may be, and what it costs",
        [options](Context& context) { return study(*options, context); });
    options->dataset.declare(command);
    declareTolerance(command, options->study.tolerancePx);
    command.add_option("--largest", options->study.largest, "The coarsest grid keeps every so many-th photo")
        ->check(CLI::Range(2, 20))
        ->capture_default_str();
    command
        .add_option("--offsets", options->study.mostOffsets, "Grids of each step, shifted against each other")
        ->check(CLI::Range(1, 400))
        ->capture_default_str();
    command.add_option("--views", options->study.mostViews, "Views of each step, at most")
        ->check(CLI::Range(1, 1'000'000))
        ->capture_default_str();
    command.add_option("--directions", options->study.directions, "Directions about the horizon")
        ->check(CLI::Range(1, 360))
        ->capture_default_str();
    command.add_option("--report", options->report, "Folder to write a page into (HTML, PDF and JSON)");
    command.add_flag("--no-depth", options->isWithoutDepth,
                     "Leave the depth scene model out: a minute instead of some");
}

} // namespace spherewalk::cli
