// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "camera_node.h"

#include "spherewalk/simulator/camera_options.h"

#include <string_view>

namespace spherewalk::ros {

/// How depth images are encoded. Source: REP 118.
enum class DepthEncoding {
    None,        ///< There are none.
    Metres,      ///< 32FC1
    Millimetres, ///< 16UC1
};

/// The encoding that "none", "32FC1" or "16UC1" names. Errors: InvalidInput, with all the names.
DepthEncoding depthEncoding(std::string_view name);

/// The options of the simulated camera behind a node. Errors: InvalidInput for unknown words and numbers out
/// of range.
simulator::CameraOptions cameraOptions(const NodeOptions& options);

} // namespace spherewalk::ros
