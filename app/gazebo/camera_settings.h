// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "program/render_options.h"
#include "published_camera.h"

#include <string>
#include <vector>

namespace spherewalk::gazebo {

/// What a user says of a camera in Gazebo, wherever its poses come from.
class CameraSettings {
  public:
    /// Declares the dataset, --camera and --rig and how views are made, the topics but those of poses,
    /// --frame-id, --rate, --pace, --mount, --room-from-world, the overlay's options, --sensor and --depth.
    void declare(const program::Command& command);

    /// All but the dataset. frame: whose poses will come, with its scopes; without --frame-id, it names the
    /// optical frame. Errors: InvalidInput for what does not fit together; those of render::readCameraInfo()
    /// and render::readRig().
    CameraSetup setup(const std::string& frame) const;

    const program::RenderOptions& render() const { return m_render; }

  private:
    void declareTopics(const program::Command& command);
    void declareOverlay(const program::Command& command);
    simulator::CameraOptions options() const;

    program::RenderOptions m_render;
    program::StreamOptions m_stream;
    Topics m_topics;
    std::string m_frameId;
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

} // namespace spherewalk::gazebo
