// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/survey/room.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace spherewalk::scene {

/// The radius of the sphere that stands for an empty room seen from these points: 1 / the mean of 1 /
/// distance to the first wall, floor, or ceiling, over directions spread evenly over the sphere, since
/// parallax goes with the inverse distance. Units: metres. Points outside of the room are left out; nothing
/// if none is inside.
std::optional<double> sphereRadius(const survey::Room& room, const std::vector<Eigen::Vector3d>& pInRoom);

} // namespace spherewalk::scene
