// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "camera_node.h"

#include "spherewalk/simulator/camera_options.h"

namespace spherewalk::ros {

/// Errors: InvalidInput with a sentence for names that are unknown and numbers out of range.
simulator::CameraOptions cameraOptions(const NodeOptions& options);

} // namespace spherewalk::ros
