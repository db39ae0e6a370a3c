// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/render/scene_depth.h"
#include "spherewalk/scene/depth_sweep.h"
#include "spherewalk/survey/room.h"

#include <Eigen/Core>

#include <optional>
#include <span>
#include <vector>

namespace spherewalk::scene {

/// The radius of the sphere that stands best for an empty room seen from these points. It is 1 / the mean of
/// 1 / distance to the first wall, floor or ceiling over all directions, since parallax is proportional to
/// the inverse distance. Units: metres. Points outside of the room are left out. Empty if none is inside.
std::optional<double> sphereRadius(const survey::Room& room, const std::vector<Eigen::Vector3d>& pInRoom);

/// The radius of the sphere that stands best for what these photos show within 30 degrees of the horizon: 1 /
/// the mean of 1 / distance there. Units: metres. Empty without depths.
std::optional<double> sphereRadius(std::span<const PosedDepth> depths);

/// Walls, floor and ceiling from depths. Floor and ceiling lie at the lowest and the highest level where many
/// points heap up. Each wall of the drawn outline is moved along its normal, by up to half a metre, to the
/// outermost place where points heap up, since furniture stands before walls. Without a drawn outline the
/// walls are those of a rectangle, turned as most upright surfaces are. Frames: the room frame; only points
/// that are `sure` count. Empty if too little is seen of the floor, the ceiling, or all walls.
std::optional<render::RoomShape> fittedRoom(std::span<const PosedDepth> depths, const Polygon& drawnOutline);

} // namespace spherewalk::scene
