// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/camera_model.h"

#include <array>
#include <string>
#include <vector>

namespace spherewalk::simulator {

/// A camera as sensor_msgs/CameraInfo and gz.msgs.CameraInfo carry it. Shape: k and r are 3 x 3, p is 3 x 4,
/// row after row.
struct Calibration {
    int width = 0;
    int height = 0;
    std::string distortionModel; ///< "plumb_bob", "rational_polynomial" or "equidistant"
    std::vector<double> d;       ///< as many as the model has; five zeros for a pinhole
    std::array<double, 9> k{};
    std::array<double, 9> r{};  ///< identity: one camera
    std::array<double, 12> p{}; ///< k and no baseline
};

Calibration calibration(const CameraIntrinsics& camera);

} // namespace spherewalk::simulator
