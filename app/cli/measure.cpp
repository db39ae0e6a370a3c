// SPDX-License-Identifier: GPL-3.0-or-later
#include "command.h"
#include "dataset_options.h"

#include "spherewalk/jobs/measure_dataset.h"

#include <memory>

namespace spherewalk::cli {

namespace {

struct Options {
    DatasetOptions dataset;
    std::string pictures;
    std::string report;
    jobs::MeasureOptions measure;
};

Result measure(const Options& options, Context& context) {
    jobs::MeasureOptions wanted = options.measure;
    const render::ViewOptions view = options.dataset.viewOptions();
    wanted.sampling = view.sampling;
    wanted.threads = view.threads;
    if (!options.pictures.empty()) {
        wanted.pictures = jobs::readRobotPictures(options.pictures);
    }
    const render::Renderer renderer = options.dataset.renderer(context);
    const jobs::MeasureReport report =
        measureDataset(renderer, options.dataset.cameraModel(), wanted, context.progress, context.stop);
    if (!options.report.empty()) {
        writeMeasurePage(report, options.report);
    }
    return {toJson(report), measureText(report)};
}

} // namespace

void addMeasure(Commands& commands) {
    const auto options = std::make_shared<Options>();
    CLI::App& command =
        commands.add("measure", "Measure how right each scene model's views are, and choose the cheapest",
                     [options](Context& context) { return measure(*options, context); });
    options->dataset.declare(command);
    command.add_option(
        "--pictures", options->pictures,
        "CSV of the robot camera's own pictures with their poses; without it, photos are left out "
        "and compared");
    command.add_option("--tolerance", options->measure.tolerancePx, "Pixels of the robot's camera")
        ->check(CLI::Range(0.01, 1000.0))
        ->capture_default_str();
    command.add_option("--photos", options->measure.mostPhotos, "Photos that are left out, at most")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    command.add_option("--directions", options->measure.directions, "Directions about the horizon, of each")
        ->check(CLI::Range(1, 360))
        ->capture_default_str();
    command.add_option("--report", options->report, "Folder to write a page into (HTML and JSON)");
}

} // namespace spherewalk::cli
