// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/dataset/world_file.h"

#include <string>

namespace spherewalk::dataset {

/// The world as MJCF for MuJoCo. Floor, ceiling, walls and furniture are boxes, and so are the sides of
/// obstacles where there is no furniture; all are in kRoomGroup. A robot slides along x and y and turns, each
/// by a velocity actuator. It carries the camera, which looks along x, and the site of a laser. Errors: those
/// of WorldRoom::validate(); Unsupported for a camera with distortion.
std::string mjcfWorld(const WorldRoom& room, const CameraIntrinsics& camera);

/// The group of MuJoCo's geoms that is the room.
inline constexpr int kRoomGroup = 3;

/// The room as URDF, without a robot: one link, fixed in the world. Errors: those of WorldRoom::validate().
std::string urdfRoom(const WorldRoom& room);

} // namespace spherewalk::dataset
