// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace spherewalk::ui {

/// What a point being drawn snaps to. Units: metres, room frame.
struct Snapping {
    double gridM = 0.05;                  ///< 0: no grid
    double reachM = 0.1;                  ///< how near is near
    std::vector<Eigen::Vector2d> corners; ///< that there are
    /// The corner before (and after) the one that is drawn: their x and y are kept where near, so that walls
    /// meet at right angles.
    std::vector<Eigen::Vector2d> neighbours;
};

/// The point, moved: onto a corner within reach; else each coordinate to a neighbour's within reach, else to
/// the grid.
Eigen::Vector2d snapped(const Eigen::Vector2d& point, const Snapping& snapping);

} // namespace spherewalk::ui
