// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/place/surface.h"
#include "spherewalk/render/scene_depth.h"

namespace spherewalk::place {

/// Moves vertices that lie within this distance of a wall, the floor or the ceiling, and face as it does,
/// onto it. Planes are then planes.
void flatten(Surface& surface, const render::RoomShape& room, double withinM);

/// The surface with as few triangles as an error of this distance allows. The vertices are some of the
/// surface's, with their colours and evidence; normals are those of the new triangles. Cost: about a second
/// for a million triangles. Source: Garland and Heckbert 1997, by meshoptimizer.
Surface simplified(const Surface& surface, double errorM);

/// What stands in a room: the surface without what lies within this distance of its walls, its floor and its
/// ceiling, or beyond.
Surface furnitureOf(Surface surface, const render::RoomShape& room, double withinM);

} // namespace spherewalk::place
