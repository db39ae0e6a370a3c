// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "camera_node.h"

#include "spherewalk/simulator/camera_options.h"

#include <filesystem>
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

/// The file that a URL of camera_info_manager names, or a path: file:///a/b.yaml, package://name/a/b.yaml,
/// a/b.yaml. Of its variables ${NAME} is the name given here, and ${ROS_HOME} that of the environment, or
/// .ros in the home folder. Packages are those of AMENT_PREFIX_PATH, and those that lie in a folder of
/// ROS_PACKAGE_PATH or are one. Errors: InvalidInput for other kinds of URL, NotFound for an unknown package.
std::filesystem::path fileOf(std::string_view url, std::string_view name);

} // namespace spherewalk::ros
