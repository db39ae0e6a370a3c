// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge.h"
#include "middleware.h"
#include "program/program.h"
#include "program/simulator_options.h"
#include "program/stop_on_signal.h"

#include "spherewalk/base/text.h"

#include <CLI/CLI.hpp>

namespace spherewalk::gazebo {

namespace {

using program::printLine;

struct Options {
    program::RenderOptions render;
    program::SimulatorOptions simulator;
    BridgeOptions bridge;
    bool isJson = false;
};

void declareTopics(CLI::App& app, Options& options) {
    Topics& topics = options.bridge.topics;
    app.add_option("--poses", topics.poses,
                   "Topic of poses: of a model's pose publisher (/model/NAME/pose), or of the scene "
                   "(/world/NAME/dynamic_pose/info); can be repeated")
        ->required();
    app.add_option("--frame", options.bridge.frame,
                   "Frame of these poses in which the camera sits, with its scopes: robot::base::camera")
        ->required();
    app.add_option("--image", topics.image,
                   "Topic of two levels or more for the pictures; camera_info and report go beside it")
        ->required();
    app.add_option("--frame-id", options.bridge.frameId,
                   "Name of the optical frame (z forward) in the pictures' headers; default: that of --frame "
                   "and _optical");
    app.add_option("--overlay-colour", topics.overlayColour,
                   "Topic of a camera at the same place that sees the simulator's objects alone");
    app.add_option("--overlay-depth", topics.overlayDepth, "Topic of a depth camera at the same place");
    app.add_option("--overlay-labels", topics.overlayLabels,
                   "Topic of the label map of a segmentation camera at the same place");
}

/// Whether pictures of objects are to come. Errors: InvalidInput if some of the topics are missing.
bool hasOverlay(const Topics& topics) {
    const bool isColour = !topics.overlayColour.empty();
    if (isColour != !topics.overlayDepth.empty() || (!isColour && !topics.overlayLabels.empty())) {
        throw Error(ErrorKind::InvalidInput, "Objects of the simulator need both their colours and their "
                                             "depths: give --overlay-colour and --overlay-depth.");
    }
    return isColour;
}

simulator::CameraOptions cameraOptions(const Options& options) {
    const Topics& topics = options.bridge.topics;
    simulator::CameraOptions camera =
        options.simulator.options(options.render.viewOptions(), hasOverlay(topics));
    if (camera.overlay && camera.overlay->by == simulator::ObjectsBy::Labels &&
        topics.overlayLabels.empty()) {
        throw Error(ErrorKind::InvalidInput,
                    "Objects are told by labels: give --overlay-labels, or --objects-by depth.");
    }
    return camera;
}

int run(Options& options, const std::stop_token& stop) {
    BridgeOptions& wanted = options.bridge;
    wanted.frameId = wanted.frameId.empty() ? wanted.frame + "_optical" : wanted.frameId;
    wanted.topics.validate();
    const simulator::CameraOptions camera = cameraOptions(options);
    const CameraModel model = options.render.cameraModel();
    const render::Renderer renderer = options.render.renderer(options.render.folder(), noProgress(), stop);
    Bridge bridge(renderer, model, camera, wanted,
                  [](const std::string& sentence) { printLine(stderr, sentence); });
    printLine(stderr, text("Waits for poses of ", wanted.frame, "; pictures go to ", wanted.topics.image,
                           ". Ctrl-C ends it."));
    bridge.run(stop);
    printLine(stdout, options.isJson ? toJson(bridge.counters(), bridge.latencies()).dump()
                                     : summary(bridge.counters(), bridge.latencies()));
    return program::kDone;
}

int runProgram(int argc, char** argv) {
    CLI::App app("A camera beside Gazebo that sees a room that was scanned.", "spherewalk-gz");
    app.set_version_flag("--version", "spherewalk-gz " SPHEREWALK_VERSION);
    Options options;
    options.render.declare(app);
    declareTopics(app, options);
    options.simulator.declare(app);
    app.add_flag("--json", options.isJson, "Print the summary at the end as one JSON object");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? program::kDone : program::kUsage;
    }
    const program::StopOnSignal signals;
    return program::guarded([&] { return run(options, signals.token()); });
}

} // namespace

} // namespace spherewalk::gazebo

int main(int argc, char** argv) {
    spherewalk::gazebo::endProgram(spherewalk::gazebo::runProgram(argc, argv));
}
