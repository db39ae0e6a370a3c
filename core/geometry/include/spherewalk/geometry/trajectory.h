// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/geometry/rigid3.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk {

struct TimedPose {
    double timeS = 0;
    Rigid3 roomFromCamera;
};

/// The pose that "x y z qx qy qz qw" spells (metres; the order of TUM files and ROS). Errors: InvalidInput.
Rigid3 parsePose(std::string_view text);

/// The poses of a TUM file: a line each of "time x y z qx qy qz qw", lines that begin with # left out.
/// Errors: those of readFile; InvalidInput, with the line's number, for a line that is no pose or a file
/// without any.
std::vector<TimedPose> readTum(const std::filesystem::path& file);

/// The lines of a TUM file.
std::string tumText(const std::vector<TimedPose>& poses);

} // namespace spherewalk
