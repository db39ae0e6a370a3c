// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "floor.h"

#include "spherewalk/survey/plan.h"
#include "spherewalk/survey/walking_distance.h"

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <vector>

namespace spherewalk::survey {

inline constexpr double kLeastClearanceM = 0.01; ///< A stop on a wall would see nothing.

/// A regular grid of points over the floor, and which of the points can hold a stop. Frames: the floor's own.
struct StopGrid {
    Eigen::Vector2d origin = Eigen::Vector2d::Zero(); ///< Position of point (0, 0).
    double stepM = 0;
    int columns = 0;
    int rows = 0;
    std::vector<std::uint8_t> free; ///< 1 for each point that can hold a stop, row by row.

    Eigen::Vector2d at(int column, int row) const { return origin + stepM * Eigen::Vector2d(column, row); }

    bool isFree(int column, int row) const {
        return free[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                    static_cast<std::size_t>(column)] != 0;
    }

    int freeCount() const;
    /// Takes the points away that are nearer than half a step to a stop of these rails. anchor: of the floor.
    void leaveOut(std::span<const RailPlacement> rails, const Eigen::Vector2d& anchor);
};

/// The grid at the shift that lets most points keep the clearance; among equals, the one nearest to the
/// middle of the floor's bounds. Points that obstacles enclose are not free.
StopGrid bestStopGrid(const Floor& floor, const PlanOptions& options);

/// Straight pieces of consecutive free points between which the clearance holds, as point indices (column,
/// row) of their first stop with the number of stops.
struct Rail {
    int column = 0;
    int row = 0;
    int stops = 0;
    bool alongX = true;
};

/// All free points as rails of at most railStops along one axis, a run's points split evenly.
std::vector<Rail> railsAlong(bool alongX, const StopGrid& grid, const Floor& floor,
                             const PlanOptions& options);

/// A rail to be walked from either end: its points [begin, end) on one line of the grid.
struct RailEnds {
    Eigen::Vector2d first;
    Eigen::Vector2d last;
    int line = 0;
    int begin = 0;
    int end = 0;
};

/// One rail of a route, walked from first to last or backwards.
struct Leg {
    int rail = 0;
    bool backwards = false;
};

/// Order and directions of all rails that keep the way between them short: the best of a sweep and
/// nearest-neighbour starts, improved by turning and moving pieces. Range: rails sorted by line, then begin;
/// points in the room frame. The same input gives the same route.
std::vector<Leg> shortRoute(const std::vector<RailEnds>& rails, const WalkingDistance& walking);

/// The rail to be walked from its other end.
RailPlacement reversed(const RailPlacement& rail);

/// The plan of these rails, with a station for each stop and height.
Plan withStations(std::vector<RailPlacement> rails, const PlanOptions& options);

/// Errors: InvalidInput, with a step that fits, if so many stops make more than kMostStations.
void refuseTooMany(int stops, const PlanOptions& options);

/// The way from each rail's end to the next one's beginning, in metres.
double carryingDistance(const std::vector<RailEnds>& rails, const std::vector<Leg>& route,
                        const WalkingDistance& walking);

} // namespace spherewalk::survey
