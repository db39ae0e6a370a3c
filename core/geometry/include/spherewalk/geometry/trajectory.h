// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/geometry/rigid3.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk {

/// A pose of a camera at a time.
struct TimedPose {
    double timeS = 0;
    Rigid3 roomFromCamera;
};

/// The pose that "x y z qx qy qz qw" spells (metres; the order of TUM files and ROS). Errors: InvalidInput.
Rigid3 parsePose(std::string_view text);

/// The poses of a TUM file. Each line is "time x y z qx qy qz qw"; lines that begin with # are comments.
/// Errors: those of readFile; InvalidInput for a file without poses, or, with the line's number, for a line
/// that is no pose.
std::vector<TimedPose> readTum(const std::filesystem::path& file);

/// The pose on a path at a time: between the two poses about it, as interpolated() says. Before the first and
/// after the last pose, the camera goes on as between the two poses there. Range: at least one pose,
/// ascending times.
Rigid3 poseAt(const std::vector<TimedPose>& path, double timeS);

/// The poses as the lines of a TUM file.
std::string tumText(const std::vector<TimedPose>& poses);

} // namespace spherewalk
