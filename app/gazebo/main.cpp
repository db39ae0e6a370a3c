// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge.h"
#include "program/program.h"
#include "program/render_options.h"

#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/trajectory.h"
#include "spherewalk/render/camera_info.h"
#include "spherewalk/simulator/camera_options.h"

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace spherewalk::gazebo {

namespace {

using program::printLine;

/// The options of a camera in a simulator.
class SimulatorOptions {
  public:
    /// Declares --rate, --pace, --late, --prefetch, --mount, --room-from-world, and the overlay's
    /// --objects-by, --room-labels, --overlay-wait, --overlay-camera.
    void declare(const program::Command& command);

    /// hasOverlay: pictures of objects will come. Errors: InvalidInput with a sentence.
    simulator::CameraOptions options(const render::ViewOptions& view, bool hasOverlay) const;

  private:
    program::StreamOptions m_stream;
    double m_rateHz = simulator::CameraOptions().rateHz;
    std::string m_pace = "newest";
    std::string m_mount = "0 0 0 0 0 0 1";
    std::string m_roomFromWorld = "0 0 0 0 0 0 1";
    std::string m_objectsBy = "labels";
    std::vector<int> m_roomLabels = {1};
    double m_overlayWaitS = 0.5;
    std::string m_overlayCamera;
    std::string m_sensor;
    bool m_wantsDepth = false;
};

void SimulatorOptions::declare(const program::Command& command) {
    command
        .option("--rate", m_rateHz,
                "Frames a second of simulation time, each at the first pose at or after a multiple of "
                "1/rate; 0: one for each pose")
        .range(0.0, 1000.0)
        .showDefault();
    command
        .option("--pace", m_pace,
                "When the simulation is faster than the rendering: newest leaves frames out and counts "
                "them, every renders all in turn")
        .among({"newest", "every"})
        .showDefault();
    m_stream.declare(command);
    command
        .option(
            "--mount", m_mount,
            "Pose of the camera (x forward) or of the rig's frame on the link whose poses come: \"x y z qx "
            "qy qz qw\"")
        .showDefault();
    command
        .option("--room-from-world", m_roomFromWorld,
                "Pose of the simulator's world in the dataset's room: \"x y z qx qy qz qw\"")
        .showDefault();
    command
        .option("--objects-by", m_objectsBy,
                "How the simulator's objects are told from its model of the room: by labels of a "
                "segmentation camera, by depth, or alone if the depth camera sees nothing else")
        .among({"labels", "depth", "alone"})
        .showDefault();
    command
        .option("--room-labels", m_roomLabels,
                "Labels of the simulator's model of the room; with 0 among them, what has no label is not "
                "shown")
        .range(0, 255)
        .separatedBy(',')
        .showDefault();
    command
        .option("--overlay-wait", m_overlayWaitS,
                "Seconds of simulation time that a frame waits for pictures of the objects")
        .range(0.0, 10.0)
        .showDefault();
    command.option("--overlay-camera", m_overlayCamera,
                   "Camera that takes the pictures of the objects, if it is not the same: a ROS "
                   "camera-info YAML");
    command.option("--sensor", m_sensor,
                   "Sensor that is not perfect: a YAML with noise, exposure, shutter and other effects");
    command.flag("--depth", m_wantsDepth,
                 "Publish depth images, too, with the objects: beside the pictures, as depth_image");
}

simulator::CameraOptions SimulatorOptions::options(const render::ViewOptions& view, bool hasOverlay) const {
    simulator::CameraOptions options;
    options.view = view;
    options.stream = m_stream.options();
    options.mounting = {parsePose(m_roomFromWorld), parsePose(m_mount)};
    options.rateHz = m_rateHz;
    options.pace = simulator::pace(m_pace);
    if (hasOverlay) {
        simulator::OverlayOptions& overlay = options.overlay.emplace();
        overlay.by = simulator::objectsBy(m_objectsBy);
        overlay.roomLabels.assign(m_roomLabels.begin(), m_roomLabels.end());
        overlay.wait =
            std::chrono::duration_cast<simulator::Stamp>(std::chrono::duration<double>(m_overlayWaitS));
        if (!m_overlayCamera.empty()) {
            overlay.camera = render::readCameraInfo(m_overlayCamera);
        }
    }
    options.wantsDepth = m_wantsDepth;
    options.wantsLabels = hasOverlay;
    if (!m_sensor.empty()) {
        options.sensor = render::readSensor(m_sensor);
    }
    options.validate();
    return options;
}

struct Options {
    program::RenderOptions render;
    SimulatorOptions simulator;
    BridgeOptions bridge;
    bool isJson = false;
};

void declareTopics(const program::Command& app, Options& options) {
    Topics& topics = options.bridge.topics;
    app.option("--poses", topics.poses,
               "Topic of poses: of a model's pose publisher (/model/NAME/pose), or of the scene "
               "(/world/NAME/dynamic_pose/info); can be repeated")
        .required();
    app.option("--frame", options.bridge.frame,
               "Frame of these poses in which the camera sits, with its scopes: robot::base::camera")
        .required();
    app.option("--image", topics.image,
               "Topic of two levels or more for the pictures; camera_info, report, and with objects labels "
               "and boxes go beside it. With --rig, each camera's name comes before the last level, there "
               "and in the overlay's topics")
        .required();
    app.option("--frame-id", options.bridge.frameId,
               "Name of the optical frame (z forward) in the pictures' headers; default: that of --frame "
               "and _optical");
    app.option("--overlay-colour", topics.overlayColour,
               "Topic of a camera at the same place that sees the simulator's objects alone");
    app.option("--overlay-depth", topics.overlayDepth, "Topic of a depth camera at the same place");
    app.option("--overlay-labels", topics.overlayLabels,
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

/// The camera, or those of the rig, whose file says which axes they have.
std::vector<render::RigCamera> camerasOf(const Options& options, simulator::CameraOptions& camera) {
    std::vector<render::RigCamera> rig = options.render.rig();
    if (rig.empty()) {
        return {{"", options.bridge.frameId, options.render.cameraModel().intrinsics(), Rigid3()}};
    }
    render::placesOnRig(rig, options.render.rigFile());
    camera.mounting.axes = simulator::CameraAxes::Optical;
    return rig;
}

int run(Options& options, const std::stop_token& stop) {
    BridgeOptions& wanted = options.bridge;
    wanted.frameId = wanted.frameId.empty() ? wanted.frame + "_optical" : wanted.frameId;
    wanted.topics.validate();
    simulator::CameraOptions camera = cameraOptions(options);
    const std::vector<render::RigCamera> cameras = camerasOf(options, camera);
    const render::Renderer renderer = options.render.renderer(noProgress(), stop);
    Bridge bridge(renderer, cameras, camera, wanted,
                  [](const std::string& sentence) { printLine(stderr, sentence); });
    printLine(stderr, text("Waits for poses of ", wanted.frame, "; pictures go to ", wanted.topics.image,
                           ". Ctrl-C ends it."));
    bridge.run(stop);
    printLine(stdout, options.isJson ? toJson(bridge.counters(), bridge.latencies()).dump()
                                     : summary(bridge.counters(), bridge.latencies()));
    return program::kDone;
}

int runProgram(int argc, char** argv) {
    program::CommandLine line("A camera beside Gazebo that sees a room that was scanned.", "spherewalk-gz",
                              "spherewalk-gz " SPHEREWALK_VERSION);
    const program::Command command = line.program();
    Options options;
    options.render.declare(command, "Folder of the dataset", true);
    declareTopics(command, options);
    options.simulator.declare(command);
    command.flag("--json", options.isJson, "Print the summary at the end as one JSON object");
    if (const std::optional<int> status = line.parse(argc, argv)) {
        return *status;
    }
    const program::StopOnSignal signals;
    return program::guarded([&] { return run(options, signals.token()); });
}

} // namespace

} // namespace spherewalk::gazebo

int main(int argc, char** argv) {
    spherewalk::gazebo::endProgram(spherewalk::gazebo::runProgram(argc, argv));
}
