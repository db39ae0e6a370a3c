// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "options/command.h"

#include "spherewalk/camera/capture_options.h"
#include "spherewalk/camera/osc_client.h"

#include <memory>
#include <stop_token>
#include <string>

namespace spherewalk::cli {

/// The options of commands that talk to a camera: its address, and the time scale of a practice camera.
class CameraOptions {
  public:
    void declare(const program::Command& command);

    /// A client of the camera. Where the camera wants a password, the client takes it from the environment,
    /// or asks for it at the terminal. Errors: InvalidInput for a bad address. Stop: ends the wait for an
    /// answer.
    std::unique_ptr<camera::OscClient> client(const std::stop_token& stop) const;
    camera::CaptureOptions captureOptions() const;

    double timeScale() const { return m_timeScale; }

    camera::Endpoint endpoint() const { return camera::parseEndpoint(m_address); }

  private:
    std::string m_address = "192.168.1.1";
    double m_timeScale = 1;
};

} // namespace spherewalk::cli
