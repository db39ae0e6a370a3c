// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/survey/plan.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace spherewalk::survey {

/// A distance that a person lays with a tape from a corner of the outline.
struct TapeDistance {
    int corner = 0; ///< Index of a corner of the outline.
    double metres = 0;
};

/// A point of the floor and the tapes that find it.
struct MarkedPoint {
    Eigen::Vector2d point = Eigen::Vector2d::Zero();
    /// Two tapes from corners with a free line to the point; empty where no two corners fix the point.
    std::vector<TapeDistance> tapes;
    /// A third corner in sight, to see whether the point is right; nothing where only two are seen.
    std::optional<TapeDistance> check;
    /// Standard deviation of the point. Each tape is read to 2 mm and 0.5 mm more per metre.
    std::optional<double> sigmaM;
};

/// Where the operator lays one rail.
struct RailMark {
    int placement = 0; ///< Index into Plan::placements.
    MarkedPoint first; ///< Stop 0 of the rail.
    MarkedPoint last;  ///< The last stop of the rail; equal to `first` for a single stop.
};

/// The tape distances of every rail placement, in walking order. The pair of corners that
/// fixes the point best is taken. Pairs whose tapes also meet at a second point in the room come last.
/// Errors: those of Room::validate().
std::vector<RailMark> railMarks(const Room& room, const Plan& plan);

/// The letters by which people call a corner of the outline: "A", "B" ... "Z", "AA". Range: index >= 0.
std::string cornerName(int index);

/// The place of the letter of each corner: on the free floor before its corner, and nearer to it than to any
/// other. At a thin wall the letters of its two sides thus cannot be confused. Letters keep clear of walls,
/// obstacles, rails and each other where there is room. Frames: room. Units: metres.
/// awayM: the wanted distance from the corner. radiusM: half the size of a letter.
/// Errors: those of Room::validate().
std::vector<Eigen::Vector2d> cornerLabels(const Room& room, const Plan& plan, double awayM, double radiusM);

} // namespace spherewalk::survey
