// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/geometry/polygon.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/depth_map.h"

namespace spherewalk::render {

/// A room as upright walls between a level floor and a level ceiling. Frames: the room's.
struct RoomShape {
    Polygon outline;
    double floorM = 0;
    double ceilingM = 0;

    bool operator==(const RoomShape&) const = default;

    /// Errors: InvalidInput for an outline of less than three corners, and heights that are not finite or
    /// not above each other.
    void validate() const;
};

/// 1 / distance from a point along a direction to the first wall, the floor or the ceiling; 0 where there is
/// none. Range: any; from outside of the room, walls are seen from behind.
double inverseDistance(const RoomShape& room, const Eigen::Vector3d& pInRoom,
                       const Eigen::Vector3d& direction);

/// The room's depth as a photo sees it. width: a multiple of 16. Errors: those of RoomShape::validate().
DepthMap roomDepth(const RoomShape& room, const Rigid3& roomFromPhoto, int width);

} // namespace spherewalk::render
