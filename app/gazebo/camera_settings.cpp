// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera_settings.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/trajectory.h"
#include "spherewalk/render/camera_info.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>

namespace spherewalk::gazebo {

namespace {

/// Elements that name files and folders.
constexpr std::array<std::string_view, 5> kPaths{"dataset", "camera", "rig", "overlay_camera", "sensor"};

/// Whether pictures of objects are to come. Errors: InvalidInput if some of the topics are missing.
bool hasOverlay(const Topics& topics) {
    const bool isColour = !topics.overlayColour.empty();
    if (isColour != !topics.overlayDepth.empty() || (!isColour && !topics.overlayLabels.empty())) {
        throw Error(ErrorKind::InvalidInput, "Objects of the simulator need both their colours and their "
                                             "depths: give --overlay-colour and --overlay-depth.");
    }
    return isColour;
}

std::string trimmed(const std::string& text) {
    constexpr const char* kBlank = " \t\r\n";
    const std::size_t first = text.find_first_not_of(kBlank);
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(kBlank) + 1 - first);
}

} // namespace

CameraSettings::CameraSettings(simulator::Pace pace) : m_pace(name(pace)) {
}

void CameraSettings::declare(const program::Command& command) {
    m_render.declare(command, "Folder of the dataset", true);
    declareTopics(command);
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
    declareOverlay(command);
    command.option("--sensor", m_sensor,
                   "Sensor that is not perfect: a YAML with noise, exposure, shutter and other effects");
    command.flag("--depth", m_wantsDepth,
                 "Publish depth images, too, with the objects: beside the pictures, as depth_image");
}

void CameraSettings::declareTopics(const program::Command& command) {
    command
        .option("--image", m_topics.image,
                "Topic of two levels or more for the pictures; camera_info, report, and with objects labels "
                "and boxes go beside it. With --rig, each camera's name comes before the last level, there "
                "and in the overlay's topics")
        .required();
    command.option("--frame-id", m_frameId,
                   "Name of the optical frame (z forward) in the pictures' headers; default: that of --frame "
                   "and _optical");
    command.option("--overlay-colour", m_topics.overlayColour,
                   "Topic of a camera at the same place that sees the simulator's objects alone");
    command.option("--overlay-depth", m_topics.overlayDepth, "Topic of a depth camera at the same place");
    command.option("--overlay-labels", m_topics.overlayLabels,
                   "Topic of the label map of a segmentation camera at the same place");
}

void CameraSettings::declareOverlay(const program::Command& command) {
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
}

simulator::CameraOptions CameraSettings::options() const {
    simulator::CameraOptions options;
    options.view = m_render.viewOptions();
    options.stream = m_stream.options();
    options.mounting = {parsePose(m_roomFromWorld), parsePose(m_mount)};
    options.rateHz = m_rateHz;
    options.pace = simulator::pace(m_pace);
    options.wantsDepth = m_wantsDepth;
    if (hasOverlay(m_topics)) {
        simulator::OverlayOptions& overlay = options.overlay.emplace();
        overlay.by = simulator::objectsBy(m_objectsBy);
        overlay.roomLabels.assign(m_roomLabels.begin(), m_roomLabels.end());
        overlay.wait =
            std::chrono::duration_cast<simulator::Stamp>(std::chrono::duration<double>(m_overlayWaitS));
        if (!m_overlayCamera.empty()) {
            overlay.camera = render::readCameraInfo(m_overlayCamera);
        }
        options.wantsLabels = true;
    }
    if (!m_sensor.empty()) {
        options.sensor = render::readSensor(m_sensor);
    }
    options.validate();
    return options;
}

CameraSetup CameraSettings::setup(const std::string& frame) const {
    m_topics.validate();
    CameraSetup setup{m_topics, {}, options()};
    if (setup.options.overlay && setup.options.overlay->by == simulator::ObjectsBy::Labels &&
        m_topics.overlayLabels.empty()) {
        throw Error(ErrorKind::InvalidInput,
                    "Objects are told by labels: give --overlay-labels, or --objects-by depth.");
    }
    setup.cameras = m_render.rig();
    if (setup.cameras.empty()) {
        const std::string frameId = m_frameId.empty() ? frame + "_optical" : m_frameId;
        setup.cameras = {{"", frameId, m_render.cameraModel().intrinsics(), Rigid3()}};
    } else { // its file says which axes it has
        render::placesOnRig(setup.cameras, m_render.rigFile());
        setup.options.mounting.axes = simulator::CameraAxes::Optical;
    }
    return setup;
}

std::vector<std::string> wordsOf(const Elements& elements, const std::filesystem::path& folder) {
    std::vector<std::string> words;
    for (const auto& [name, content] : elements) {
        std::string value = trimmed(content);
        if (!value.empty() && std::find(kPaths.begin(), kPaths.end(), name) != kPaths.end()) {
            value = (folder / value).lexically_normal();
        }
        std::string option = "--" + name;
        std::replace(option.begin(), option.end(), '_', '-');
        words.push_back(name == "dataset" ? value : value.empty() ? option : text(option, "=", value));
    }
    return words;
}

std::string aboutElements(std::string_view sentence) {
    std::string result;
    for (std::size_t i = 0; i < sentence.size(); ++i) {
        const auto isOf = [&](std::size_t k) {
            return k < sentence.size() &&
                   (std::isalnum(static_cast<unsigned char>(sentence[k])) != 0 || sentence[k] == '-');
        };
        if (sentence.substr(i, 2) != "--" || !isOf(i + 2)) {
            result += sentence[i];
            continue;
        }
        std::string name;
        for (i += 2; isOf(i); ++i) {
            name += sentence[i] == '-' ? '_' : sentence[i];
        }
        --i;
        result += text("<", name, ">");
    }
    return result;
}

} // namespace spherewalk::gazebo
