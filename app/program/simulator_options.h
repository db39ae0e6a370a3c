// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "program/render_options.h"

#include "spherewalk/simulator/camera_options.h"

#include <string>
#include <vector>

namespace spherewalk::program {

/// How a camera behaves in a simulator, whatever the middleware.
class SimulatorOptions {
  public:
    /// --rate, --pace, --late, --prefetch, --mount, --room-from-world, and the overlay's --objects-by,
    /// --room-labels, --overlay-wait, --overlay-camera.
    void declare(CLI::App& command);

    /// hasOverlay: whether pictures of objects are to come. Errors: InvalidInput with a sentence.
    simulator::CameraOptions options(const render::ViewOptions& view, bool hasOverlay) const;

  private:
    StreamOptions m_stream;
    double m_rateHz = simulator::CameraOptions().rateHz;
    std::string m_pace = "newest";
    std::string m_mount = "0 0 0 0 0 0 1";
    std::string m_roomFromWorld = "0 0 0 0 0 0 1";
    std::string m_objectsBy = "labels";
    std::vector<int> m_roomLabels = {0, 1};
    double m_overlayWaitS = 0.5;
    std::string m_overlayCamera;
};

} // namespace spherewalk::program
