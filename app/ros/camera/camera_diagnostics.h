// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "camera_node.h"

#include "spherewalk/simulator/simulated_camera.h"

namespace spherewalk::ros {

/// What is told of frames now and then. Threads: one at a time.
class CameraDiagnostics {
  public:
    /// A frame that was published just now.
    void add(const simulator::Frame& frame);

    /// Of what happened since the call before.
    Diagnostics since(const simulator::CameraCounters& counters, const NodeOptions& options);

  private:
    double m_leastTrust = 1;
    double m_worstLatencyMs = 0;
    std::string m_photo;
    double m_offsetM = 0;
    simulator::CameraCounters m_last;
};

} // namespace spherewalk::ros
