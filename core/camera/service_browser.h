// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/camera/discovery.h"

#include <chrono>
#include <stop_token>
#include <string>
#include <vector>

namespace spherewalk::camera {

struct BrowseReport {
    std::vector<CameraPlace> places;
    std::string problem; ///< why it could not listen, as a sentence; empty if it could
};

/// Listens so long for cameras that announce themselves as _osc._tcp, over IPv4. Stop: within 200 ms; what
/// came until then is returned.
BrowseReport browseForCameras(std::chrono::milliseconds time, const std::stop_token& stop);

} // namespace spherewalk::camera
