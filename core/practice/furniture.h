// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shape.h"

#include "spherewalk/geometry/polygon.h"

#include <array>
#include <vector>

namespace spherewalk::practice {

/// The faces of the room itself, in the order in which they are numbered.
enum class Wall { Floor, Ceiling, South, North, West, East };

inline constexpr int kWalls = 6;

/// All that stands in the practice room. Frames: the room's corner, metres.
struct Furniture {
    std::array<Finish, kWalls> walls;
    std::vector<Shape> shapes;
    std::vector<Polygon> obstacles; ///< footprints of what stands on the floor
    Eigen::Vector3d windowCentre;
    Eigen::Vector3d windowHalf;
    Eigen::Vector3d ceilingLamp;
    Eigen::Vector3d floorLamp;
};

/// Against the walls of a room of this size, leaving the middle free.
Furniture furnished(const Eigen::Vector3d& roomSize);

} // namespace spherewalk::practice
