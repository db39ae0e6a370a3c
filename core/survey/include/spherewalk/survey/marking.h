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
    int corner = 0; ///< index into the outline
    double metres = 0;
};

/// A point of the floor and the tapes that find it.
struct MarkedPoint {
    Eigen::Vector2d point = Eigen::Vector2d::Zero();
    /// Two, from corners with a free line to the point; fewer where there are none that fix it.
    std::vector<TapeDistance> tapes;
    /// How well two tapes fix the point, if each is read to 2 mm and 0.5 mm more a metre.
    std::optional<double> sigmaM;
};

/// Where the operator lays one rail.
struct RailMark {
    int placement = 0; ///< index into Plan::placements
    MarkedPoint first; ///< stop 0
    MarkedPoint last;  ///< the last stop; the same as first for a single stop
};

/// The tape distances of every rail placement, in walking order. Of the pairs of corners, the one is taken
/// that fixes the point best, and by preference one whose other meeting point lies outside of the outline.
/// Errors: those of Room::validate().
std::vector<RailMark> railMarks(const Room& room, const Plan& plan);

/// What people call a corner of the outline: "A", "B" ... "Z", "AA". Range: index >= 0.
std::string cornerName(int index);

} // namespace spherewalk::survey
