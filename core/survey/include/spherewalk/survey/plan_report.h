// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/survey/plan.h"

#include <Eigen/Core>

#include <numbers>
#include <string>
#include <vector>

namespace spherewalk::survey {

/// Why no station covers a floor area.
enum class UncoveredReason {
    Clearance, ///< The area is closer to a wall or obstacle than the clearance.
    Enclosed,  ///< Obstacles cut the area off from the rest of the floor.
    /// A stop would fit, but no stop of the grid is near enough with a free line of sight.
    BetweenStops,
};

/// A connected floor area that no station covers.
struct UncoveredArea {
    double areaM2 = 0;
    Eigen::Vector2d point = Eigen::Vector2d::Zero(); ///< The point of the area that is nearest its centroid.
    UncoveredReason reason = UncoveredReason::Clearance;
};

/// What a plan costs and what it leaves out. A floor point is covered if a station stands within half the
/// diagonal of a grid cell, and nothing lies between. Areas are counted on a raster of at most two million
/// cells, a tenth of the step wide where that suffices.
struct PlanReport {
    int placements = 0;
    int stations = 0;
    /// Way along the rails, and from each rail to the next around walls and obstacles.
    double metresWalked = 0;
    double minutes = 0; ///< Duration at the pace that the options state.
    double floorM2 = 0; ///< Area inside the outline and outside the obstacles.
    double uncoveredM2 = 0;
    std::vector<UncoveredArea> uncovered; ///< The areas, largest first; their sum is uncoveredM2.
};

/// How near a station of such a grid must be to cover a point: half the diagonal of a cell.
inline double coveringReachM(double stepM) {
    return stepM * std::numbers::sqrt2 / 2;
}

/// Errors: those of both validate(). The plan may also hold stations that came with imported photos.
PlanReport report(const Room& room, const PlanOptions& options, const Plan& plan);

/// The reason as the end of a sentence: "it is closer than 0.30 m to a wall or an obstacle".
std::string reasonText(UncoveredReason reason, const PlanOptions& options);

} // namespace spherewalk::survey
