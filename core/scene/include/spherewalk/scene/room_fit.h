// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/render/scene_depth.h"
#include "spherewalk/scene/depth_sweep.h"
#include "spherewalk/survey/room.h"

#include <Eigen/Core>

#include <cstddef>
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

/// What was drawn of a room, with its floor at height 0.
struct DrawnRoom {
    Polygon outline = {};
    double ceilingM = 0; ///< 0 if nobody said.
};

/// A room that was found in depths.
struct FittedRoom {
    render::RoomShape shape;
    /// The drawn outline is not the room's: most of what the photos show at the height of walls stands more
    /// than half a metre beyond it. The walls were then found without it.
    bool contradictsOutline = false;
    /// Indices of drawn walls that stand where they do not seem to be: towards most of such a wall photos see
    /// more than half a metre farther. It is a window, a mirror or an opening, or wrong. Empty for an outline
    /// that is wrong as a whole.
    std::vector<std::size_t> wallsSeenThrough;

    bool operator==(const FittedRoom&) const = default;
};

/// Walls, floor and ceiling from depths. Floor and ceiling lie at the lowest and the highest level where many
/// points heap up, within half a metre of where they were drawn. Each wall of the drawn outline is moved
/// along its normal, by up to half a metre, to the outermost place where points heap up, since furniture
/// stands before walls. A wall of which less than two fifths of the length are seen stays as it was drawn.
/// Without a drawn outline the walls are those of a rectangle, turned as most upright surfaces are; the floor
/// is sought to 3 m below the photos, and the ceiling to 10 m above them. An outline that the photos
/// contradict counts as not drawn. Frames: the room frame; only points that are `sure` count. Empty if too
/// little is seen of all walls, or of a floor or ceiling that was not drawn.
std::optional<FittedRoom> fittedRoom(std::span<const PosedDepth> depths, const DrawnRoom& room = {});

} // namespace spherewalk::scene
