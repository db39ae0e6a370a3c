// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "command.h"

#include "spherewalk/camera/capture_options.h"
#include "spherewalk/camera/osc_client.h"

#include <memory>
#include <stop_token>
#include <string>

namespace spherewalk::cli {

/// How to reach a camera, for the commands that talk to one.
class CameraOptions {
  public:
    void declare(CLI::App& command);

    /// Errors: InvalidInput.
    /// A camera that wants a password gets it from the environment, or asks for it at the terminal until the
    /// stop.
    std::unique_ptr<camera::OscClient> client(const std::stop_token& stop) const;
    camera::CaptureOptions captureOptions() const;

    double timeScale() const { return m_timeScale; }

    camera::Endpoint endpoint() const { return camera::parseEndpoint(m_address); }

  private:
    std::string m_address = "192.168.1.1";
    double m_timeScale = 1;
};

} // namespace spherewalk::cli
