// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera_options.h"

#include "spherewalk/base/clock.h"

namespace spherewalk::cli {

void CameraOptions::declare(CLI::App& command) {
    command.add_option("--camera", m_address, "Address of the camera, with :PORT if it is not 80")
        ->capture_default_str();
    command
        .add_option("--time-scale", m_timeScale,
                    "Of a practice camera that is started with the same: 0.1 makes the camera's time ten "
                    "times as fast")
        ->check(CLI::Range(0.001, 1.0))
        ->capture_default_str();
}

std::unique_ptr<camera::OscClient> CameraOptions::client() const {
    return std::make_unique<camera::OscClient>(endpoint(), camera::OscOptions{}.scaled(m_timeScale),
                                               systemClock());
}

camera::CaptureOptions CameraOptions::captureOptions() const {
    return camera::CaptureOptions{}.scaled(m_timeScale);
}

} // namespace spherewalk::cli
