// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/render/room_shape.h"
#include "spherewalk/scene/depth_sweep.h"

#include <optional>
#include <span>

namespace spherewalk::scene {

/// The radius of the sphere that stands best for what photos see within 30 degrees of the horizon: 1 / the
/// mean of 1 / distance there, since parallax goes with the inverse distance. Units: metres. Nothing
/// without depths.
std::optional<double> sphereRadius(std::span<const PosedDepth> depths);

/// Walls, floor and ceiling from depths. Floor and ceiling lie where most of what is seen at about a height
/// is, the lowest and the highest of such; each wall of the drawn outline is moved along its normal, by up to
/// half a metre, to where most of what is seen beside it is, the outermost of such, since furniture stands
/// before walls. Without a drawn outline the walls are those of a rectangle, turned as most upright surfaces
/// are. Nothing if too little is seen of the floor, the ceiling, or all walls.
std::optional<render::RoomShape> fittedRoom(std::span<const PosedDepth> depths, const Polygon& drawnOutline);

} // namespace spherewalk::scene
