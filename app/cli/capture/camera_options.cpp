// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/camera_options.h"

#include "options/terminal.h"

#include "spherewalk/base/clock.h"

#include <cstdlib>
#include <optional>

namespace spherewalk::cli {

namespace {

/// Neither the command line, which every user of the computer can see, nor a file of the survey.
std::optional<camera::Credentials> credentials(const std::stop_token& stop) {
    const char* const user = std::getenv("SPHEREWALK_CAMERA_USER");
    const char* const password = std::getenv("SPHEREWALK_CAMERA_PASSWORD");
    if (user != nullptr && password != nullptr) {
        return camera::Credentials{user, password};
    }
    const auto name =
        askAtTerminal("User name of the camera (THETA and its serial number): ", Echo::On, stop);
    const auto secret = name ? askAtTerminal("Password: ", Echo::Off, stop) : std::nullopt;
    return secret ? std::optional(camera::Credentials{*name, *secret}) : std::nullopt;
}

} // namespace

void CameraOptions::declare(const program::Command& command) {
    command
        .option(
            "--camera", m_address,
            "Address of the camera, with :PORT if it is not 80. One in client mode wants the user name and "
            "the password that stand in SPHEREWALK_CAMERA_USER and SPHEREWALK_CAMERA_PASSWORD, or asks for "
            "them")
        .showDefault();
    command
        .option("--time-scale", m_timeScale,
                "Of a practice camera that is started with the same: 0.1 makes the camera's time ten "
                "times as fast")
        .range(0.001, 1.0)
        .showDefault();
}

std::unique_ptr<camera::OscClient> CameraOptions::client(const std::stop_token& stop) const {
    camera::OscOptions options = camera::OscOptions{}.scaled(m_timeScale);
    options.http.credentials = camera::rememberingCredentials([stop] { return credentials(stop); });
    return std::make_unique<camera::OscClient>(endpoint(), options, systemClock());
}

camera::CaptureOptions CameraOptions::captureOptions() const {
    return camera::CaptureOptions{}.scaled(m_timeScale);
}

} // namespace spherewalk::cli
