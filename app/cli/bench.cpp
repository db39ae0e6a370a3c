// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/measure/bench.h"

#include "command.h"
#include "plot_option.h"

#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"

#include <memory>

namespace spherewalk::cli {

namespace {

struct Options {
    std::string dataset;
    std::string plot;
    measure::BenchOptions bench;
};

Result bench(const Options& options, Context& context) {
    if (!options.plot.empty()) {
        checkPlot(options.plot);
    }
    // Hashes are checked where photos are used, which is a part of what is measured.
    const auto dataset = std::make_shared<const render::Dataset>(
        render::Dataset::open(options.dataset, render::Verify::Sizes));
    const measure::BenchReport report =
        measure::bench(dataset, options.bench, context.progress, context.stop);
    Json json = toJson(report);
    std::string table = benchTable(report);
    if (!options.plot.empty()) {
        writeFile(options.plot, bytesOf(benchPlot(report)));
        json["plot"] = options.plot;
        table += text("\nWrote ", options.plot, ".");
    }
    return {json, table};
}

} // namespace

void addBench(Commands& commands) {
    const auto options = std::make_shared<Options>();
    CLI::App& command =
        commands.add("bench", "Measure speed, error and memory of the render library on a dataset",
                     [options](Context& context) { return bench(*options, context); });
    command.add_option("dataset", options->dataset, "Folder of the dataset")->required();
    command.add_flag("--peers", options->bench.peers,
                     "Measure OpenCV and libjpeg-turbo too, on the same work");
    command.add_flag("--quick", options->bench.quick, "Rough figures in half a minute");
    command.add_flag(
        "--grid{404}", options->bench.gridPhotos,
        "Walk past copies of the first photo, 20 cm apart (--grid=N for another number than 404)");
    command
        .add_option("--fields", options->bench.fieldsDeg,
                    "Horizontal fields of view to measure the samplings' errors at, degrees")
        ->delimiter(',')
        ->capture_default_str();
    command.add_option("--plot", options->plot, "SVG file to draw the figures into");
}

} // namespace spherewalk::cli
