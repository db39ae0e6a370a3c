// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "camera_node.h"

#include "spherewalk/simulator/camera_options.h"

namespace spherewalk::ros {

/// The options of the simulated camera behind a node. Errors: InvalidInput for unknown words and numbers out
/// of range.
simulator::CameraOptions cameraOptions(const NodeOptions& options);

} // namespace spherewalk::ros
