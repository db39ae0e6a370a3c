// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/rigid3.h"

#include <filesystem>
#include <vector>

namespace spherewalk::jobs {

/// A picture of the robot's camera, to compare views with.
struct RobotPicture {
    std::filesystem::path file;
    std::filesystem::path depthFile; ///< PNG of 16 bits, millimetres along the axis; empty: not known
    Rigid3 roomFromCamera;           ///< of the optical frame
};

/// Reads a positions file (readPositions()) in which each line has a rotation, and optionally a depth; files
/// are relative to it. Errors: as readPositions().
std::vector<RobotPicture> readRobotPictures(const std::filesystem::path& csv);

/// Errors: those of reading it; InvalidInput if it has not the camera's size.
RgbImage readRobotPicture(const RobotPicture& picture, const CameraModel& camera);

} // namespace spherewalk::jobs
