// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/bench/bench.h"

#include "options/command.h"

#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"

#include <memory>

namespace spherewalk::cli {

namespace {

struct BenchArguments {
    std::string dataset;
    std::string plot;
    bench::BenchOptions bench;
};

Result runBench(const BenchArguments& options, Context& context) {
    checkPlot(options.plot);
    // Hashes are checked where photos are used, which is a part of what is measured.
    const auto dataset = std::make_shared<const render::Dataset>(
        render::Dataset::open(options.dataset, render::Verify::Sizes));
    const bench::BenchReport report = bench::bench(dataset, options.bench, context.progress, context.stop);
    Result result{toJson(report), benchTable(report)};
    if (!options.plot.empty()) {
        writePlot(options.plot, benchPlot(report), result);
    }
    return result;
}

} // namespace

void addBench(Commands& commands) {
    const auto options = std::make_shared<BenchArguments>();
    const program::Command command =
        commands.add("bench", "Measure speed, error and memory of the render library on a dataset",
                     [options](Context& context) { return runBench(*options, context); });
    command.option("dataset", options->dataset, "Folder of the dataset").required();
    command.flag("--peers", options->bench.peers, "Measure OpenCV and libjpeg-turbo too, on the same work");
    command.flag("--quick", options->bench.quick, "Rough figures in half a minute");
    command.flag("--grid{404}", options->bench.gridPhotos,
                 "Walk past copies of the first photo, 20 cm apart (--grid=N for another number than 404)");
    command
        .option("--fields", options->bench.fieldsDeg,
                "Horizontal fields of view to measure the samplings' errors at, degrees")
        .separatedBy(',')
        .showDefault();
    command.option("--plot", options->plot, "SVG file to draw the figures into");
}

} // namespace spherewalk::cli
