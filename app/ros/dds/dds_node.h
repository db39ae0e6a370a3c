// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dds_messages.h"
#include "dds_port.h"

#include <stop_token>
#include <string>

namespace spherewalk::ros {

struct DdsOptions {
    NodeOptions node;
    std::string nameSpace = "/"; ///< that the camera's topics are in
    std::uint32_t domain = 0;
    bool usesSimTime = false; ///< time is what /clock says
};

/// Carries ROS 2's messages to a CameraNode and back.
class DdsNode {
  public:
    /// Errors: those of CameraNode and DdsPort.
    explicit DdsNode(const DdsOptions& options);

    /// Until a stop is asked for; what it asks is looked at a hundred times a second. Errors: those of
    /// DdsPort.
    void run(const std::stop_token& stop);

  private:
    using Clock = std::chrono::steady_clock;

    std::string topic(const std::string& name) const;
    void readPoses();
    void readOverlay(OverlayTopic topic);
    void readCamera();
    void publish(const PublishedFrame& frame);
    void publishDiagnostics();
    Stamp now() const;

    DdsOptions m_options;
    DdsPort m_port;
    dds_entity_t m_images;
    dds_entity_t m_infos;
    dds_entity_t m_diagnostics;
    Stamp m_clock{};   ///< what /clock said last
    CameraNode m_node; ///< after what its thread writes to
};

} // namespace spherewalk::ros
