// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/demo.h"

#include "command.h"

#include "spherewalk/base/text.h"

#include <memory>

namespace spherewalk::cli {

namespace {

struct Options {
    std::string out;
    jobs::DemoOptions demo;
};

Result demo(const Options& options, Context& context) {
    const jobs::DemoReport report = jobs::demo(options.out, options.demo, context.progress, context.stop);
    const auto seconds = [](double s) { return humanDuration(std::chrono::duration<double>(s)); };
    return {
        jobs::toJson(report),
        text(
            "A practice room was planned, photographed over HTTP, aligned, exported, and walked through.\n\n",
            "In ", options.out, ":\n", "  practice-room.spherewalk  the survey: ", report.capture.stations,
            " stations on ", report.placements, " rail placements, ", report.capture.taken, " photos in ",
            seconds(report.capture.seconds), "\n", "  dataset                   for simulators: ",
            humanBytes(report.exported.written.totalBytes), "\n", "  walk                      ",
            report.walk.frames, " views of a robot's camera, index.csv, contact-sheet.png; ",
            fixed(report.walk.medianRenderMs, 1), " ms a view\n",
            "  comparison.png            views beside exact pictures: ", fixed(report.atPhotosDb, 1),
            " dB at photos, ", fixed(report.betweenDb, 1), " dB between them (medians)\n",
            "  robot.yaml, path.tum      the robot's camera and its path\n",
            "  truth.jsonl               where the practice camera really was\n\n",
            "The photos' rotations were solved from the pictures: ", report.alignmentError.photos, " of ",
            report.capture.stations, " photos, off by ", fixed(report.alignmentError.yawRmsDeg, 3),
            " deg in yaw and ", fixed(report.alignmentError.tiltRmsDeg, 3), " in tilt (root mean square).\n",
            "Look around:  spherewalk-cli view ", options.out, "/dataset --camera ", options.out,
            "/robot.yaml --frame body --pose \"2.5 2 1.2 0 0 0 1\" --out view.png")};
}

} // namespace

void addDemo(Commands& commands) {
    const auto options = std::make_shared<Options>();
    CLI::App& command = commands.add("demo", "Scan, export, and walk through a practice room",
                                     [options](Context& context) { return demo(*options, context); });
    command.add_option("out", options->out, "Folder to make")->required();
    command.add_option("--width", options->demo.photoWidth, "Of the photos, pixels")
        ->check(CLI::Range(1024, 16384))
        ->capture_default_str();
    command.add_option("--step", options->demo.stepM, "Of the grid, metres")->capture_default_str();
    command.add_option("--frames", options->demo.frames, "Of the walk")
        ->check(CLI::Range(6, 100000))
        ->capture_default_str();
    command.add_option("--seed", options->demo.seed, "Of the camera's errors")->capture_default_str();
}

} // namespace spherewalk::cli
