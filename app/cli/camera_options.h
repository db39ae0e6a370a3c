// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "command.h"

#include "spherewalk/camera/capture_options.h"
#include "spherewalk/camera/osc_client.h"

#include <memory>
#include <string>

namespace spherewalk::cli {

/// How to reach a camera, for the commands that talk to one.
class CameraOptions {
  public:
    void declare(CLI::App& command);

    /// Errors: InvalidInput.
    std::unique_ptr<camera::OscClient> client() const;
    camera::CaptureOptions captureOptions() const;

    double timeScale() const { return m_timeScale; }

    camera::Endpoint endpoint() const { return camera::parseEndpoint(m_address); }

  private:
    std::string m_address = "192.168.1.1";
    double m_timeScale = 1;
};

} // namespace spherewalk::cli
