// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/dataset/bag.h"
#include "spherewalk/geometry/trajectory.h"

#include <filesystem>
#include <string_view>
#include <vector>

namespace spherewalk::jobs {

enum class BagPictures {
    Raw, ///< /camera/image_raw, sensor_msgs/Image
    Png, ///< /camera/image_raw/compressed, sensor_msgs/CompressedImage: the frames' own files
};

/// Errors: InvalidInput, listing the names.
BagPictures bagPictures(std::string_view name);

/// Errors: InvalidInput, naming the pose, for times that ROS does not have.
void requireRosTimes(const std::vector<TimedPose>& path);

/// Writes a walk's frames as messages: the picture and /camera/camera_info in the frame camera_optical; the
/// truth as /camera/pose (geometry_msgs/PoseStamped) and as /tf, of camera_optical in the frame map, which is
/// the room. All four of a pose have its time. Shape: a file (PNG) a pose. Errors: those of reading and
/// writing, and of requireRosTimes().
void writeWalkBag(dataset::BagFormat format, BagPictures pictures, const CameraIntrinsics& camera,
                  const std::vector<TimedPose>& path, const std::vector<std::filesystem::path>& frames,
                  const std::filesystem::path& file);

} // namespace spherewalk::jobs
