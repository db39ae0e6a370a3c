// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/walk.h"

#include "command.h"
#include "dataset_options.h"

#include "spherewalk/base/text.h"
#include "spherewalk/geometry/trajectory.h"

#include <memory>

namespace spherewalk::cli {

namespace {

struct Options {
    DatasetOptions dataset;
    std::string path;
    std::string out;
    program::StreamOptions stream;
    std::string ball;
    std::vector<std::string> formats;
    std::string bagPictures = "raw";
    std::string shard = "1/1";
};

Result walk(const Options& options, Context& context) {
    std::vector<TimedPose> path = readTum(options.path);
    for (TimedPose& pose : path) {
        pose.roomFromCamera = options.dataset.opticalPose(pose.roomFromCamera);
    }
    const CameraModel camera = options.dataset.cameraModel();
    const render::Renderer renderer = options.dataset.renderer(context);
    jobs::WalkOptions walkOptions{options.dataset.viewOptions(), options.stream.options()};
    if (!options.ball.empty()) {
        walkOptions.ball = jobs::parseBall(options.ball);
    }
    walkOptions.shard = jobs::Shard::parse(options.shard);
    for (const std::string& format : options.formats) {
        if (format == "rosbag" || format == "mcap") {
            walkOptions.bags.push_back(dataset::bagFormat(format));
        } else {
            walkOptions.formats.push_back(dataset::poseFormat(format));
        }
    }
    walkOptions.bagPictures = jobs::bagPictures(options.bagPictures);
    const jobs::WalkReport report =
        jobs::walk(renderer, camera, path, walkOptions, options.out, context.progress, context.stop);
    const std::string known =
        report.reused > 0 ? text(", ", report.reused, " of them were there before") : "";
    return {jobs::toJson(report),
            report.isComplete
                ? text("Wrote ", report.frames, " frames", known, ", index.csv, and contact-sheet.png to ",
                       options.out, " (median ", fixed(report.medianRenderMs, 1), " ms to render, ",
                       report.photosUsed, " photos used, ", report.stream.late,
                       " frames not decoded in time).")
                : text("Wrote ", report.frames, " frames", known, " to ", options.out,
                       ". Other parts are still to come; the last one to end writes index.csv.")};
}

} // namespace

void addWalk(Commands& commands) {
    const auto options = std::make_shared<Options>();
    CLI::App& command = commands.add("walk", "Render a view at each pose of a path",
                                     [options](Context& context) { return walk(*options, context); });
    options->dataset.declare(command);
    command.add_option("--path", options->path, "TUM file: lines of \"time x y z qx qy qz qw\"")->required();
    command.add_option("--out", options->out, "Folder to write frames, index.csv, and contact-sheet.png to")
        ->required();
    options->stream.declare(command);
    command
        .add_option("--format", options->formats,
                    "Write the poses as another program reads them, besides: tum, kitti, euroc, colmap, or "
                    "nerfstudio; or frames and poses as ROS messages: rosbag or mcap; can be repeated")
        ->check(CLI::IsMember({"tum", "kitti", "euroc", "colmap", "nerfstudio", "rosbag", "mcap"}));
    command
        .add_option("--bag-pictures", options->bagPictures,
                    "Frames in a bag: raw (sensor_msgs/Image) or png (CompressedImage, smaller)")
        ->check(CLI::IsMember({"raw", "png"}))
        ->capture_default_str();
    command
        .add_option(
            "--shard", options->shard,
            "Render only the i-th of n parts of the frames, \"i/n\"; several processes may do so at once")
        ->capture_default_str();
    command.add_option(
        "--ball", options->ball,
        "A ball to lay into each frame, \"x y z radius\", metres, as an object of a simulator");
}

} // namespace spherewalk::cli
