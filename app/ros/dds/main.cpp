// SPDX-License-Identifier: GPL-3.0-or-later
// A robot's camera for ROS 2 by its wire protocol alone; resources/docs/guide/ros.md says how it is used.
#include "dds_node.h"
#include "program/program.h"
#include "program/stop_on_signal.h"

#include <CLI/CLI.hpp>

namespace {

void declare(CLI::App& app, spherewalk::ros::DdsOptions& options) {
    spherewalk::ros::NodeOptions& node = options.node;
    app.add_option("dataset", node.dataset, "Folder of the dataset")->required();
    app.add_option("--camera", node.cameraInfoUrl, "Camera: a ROS camera-info YAML")->required();
    app.add_option("--namespace", options.nameSpace, "That the camera's topics are in")
        ->capture_default_str();
    app.add_option("--domain", options.domain, "DDS domain")
        ->envname("ROS_DOMAIN_ID")
        ->check(CLI::Range(0, 232))
        ->capture_default_str();
    app.add_flag("--sim-time", options.usesSimTime, "Time is what /clock says");
    app.add_option("--room-frame", node.roomFrame, "Frame of the dataset's room")->capture_default_str();
    app.add_option("--camera-frame", node.cameraFrame, "Optical frame of the camera")->capture_default_str();
    app.add_option("--rate", node.rate, "Frames a second of simulation time; 0: one for each pose")
        ->capture_default_str();
    app.add_option("--scene", node.scene, "none, sphere, room, depth, or auto")->capture_default_str();
    app.add_option("--sampling", node.sampling, "nearest, bilinear, reduced, footprint, bicubic, or auto")
        ->capture_default_str();
    app.add_option("--late", node.late,
                   "What a frame is made from when its photo is not decoded yet: wait, coarse, or previous")
        ->capture_default_str();
    app.add_option("--pace", node.pace,
                   "Frames whose turn has passed: newest leaves them out, every renders all")
        ->capture_default_str();
    app.add_option(
           "--overlay", node.overlay,
           "How a simulator's objects are told from its room: labels, depth or alone; none: no objects")
        ->capture_default_str();
    app.add_option("--room-label", node.roomLabels, "With labels: those of the room, which show the photo")
        ->capture_default_str();
    app.add_option("--overlay-wait", node.overlayWait, "Seconds that a frame waits for its overlay")
        ->capture_default_str();
    app.add_option("--threads", node.threads, "Threads to render with; 0: all")->capture_default_str();
    app.add_option("--cache-mb", node.cacheMb, "Of decoded photos")->capture_default_str();
}

int run(const spherewalk::ros::DdsOptions& options) {
    const spherewalk::program::StopOnSignal stop;
    spherewalk::ros::DdsNode node(options);
    spherewalk::program::printLine(stderr, "Ready; frames are rendered while somebody listens.");
    node.run(stop.token());
    return spherewalk::program::kDone;
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app("A robot's camera for ROS 2, by its wire protocol: no ROS is needed to run it.");
    spherewalk::ros::DdsOptions options;
    declare(app, options);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? spherewalk::program::kDone : spherewalk::program::kUsage;
    }
    return spherewalk::program::guarded([&] { return run(options); });
}
