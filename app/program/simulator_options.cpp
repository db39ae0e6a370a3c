// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/simulator_options.h"

#include "spherewalk/geometry/trajectory.h"
#include "spherewalk/render/camera_info.h"

#include <chrono>

namespace spherewalk::program {

void SimulatorOptions::declare(CLI::App& command) {
    command
        .add_option("--rate", m_rateHz,
                    "Frames a second of simulation time, each at the first pose at or after a multiple of "
                    "1/rate; 0: one for each pose")
        ->check(CLI::Range(0.0, 1000.0))
        ->capture_default_str();
    command
        .add_option("--pace", m_pace,
                    "When the simulation is faster than the rendering: newest leaves frames out and counts "
                    "them, every renders all in turn")
        ->check(CLI::IsMember({"newest", "every"}))
        ->capture_default_str();
    m_stream.declare(command);
    command
        .add_option("--mount", m_mount,
                    "Pose of the camera (x forward) on the link whose poses come: \"x y z qx qy qz qw\"")
        ->capture_default_str();
    command
        .add_option("--room-from-world", m_roomFromWorld,
                    "Pose of the simulator's world in the dataset's room: \"x y z qx qy qz qw\"")
        ->capture_default_str();
    command
        .add_option("--objects-by", m_objectsBy,
                    "How the simulator's objects are told from its model of the room: by labels of a "
                    "segmentation camera, by depth, or alone if the depth camera sees nothing else")
        ->check(CLI::IsMember({"labels", "depth", "alone"}))
        ->capture_default_str();
    command
        .add_option("--room-labels", m_roomLabels,
                    "Labels of the simulator's model of the room, and of nothing")
        ->check(CLI::Range(0, 255))
        ->delimiter(',')
        ->capture_default_str();
    command
        .add_option("--overlay-wait", m_overlayWaitS,
                    "Seconds of simulation time that a frame waits for pictures of the objects")
        ->check(CLI::Range(0.0, 10.0))
        ->capture_default_str();
    command.add_option("--overlay-camera", m_overlayCamera,
                       "Camera that takes the pictures of the objects, if it is not the same: a ROS "
                       "camera-info YAML");
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
    options.validate();
    return options;
}

} // namespace spherewalk::program
