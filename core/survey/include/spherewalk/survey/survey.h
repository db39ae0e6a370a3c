// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/angle.h"
#include "spherewalk/geometry/polygon.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace spherewalk::survey {

/// The room's shape. Frames: room. Units: metres.
struct Room {
    Polygon outline;                ///< the walls on the floor; may be concave
    std::vector<Polygon> obstacles; ///< what stands on the floor and the rail cannot pass
    double ceilingM = 0;

    /// Errors: InvalidInput, naming the polygon and its defect, an obstacle that is not inside the outline's
    /// bounds, or a ceiling that is not positive.
    void validate() const;
};

/// How stations are to be laid out.
struct PlanOptions {
    double stepM = 0.2;
    std::vector<double> heightsM = {
        1.2};                        ///< of the lens above the floor; one station per height at each stop
    int railStops = 6;               ///< positions of the cart on the rail
    double clearanceM = 0.3;         ///< between a stop and any wall or obstacle
    double secondsPerPhoto = 12;     ///< pace: one photo with moving the cart
    double secondsPerPlacement = 60; ///< pace: laying the rail anew

    /// Errors: InvalidInput with the option and its range.
    void validate(const Room& room) const;
};

/// Where the rail lies. The stops are at origin + k * step along the heading.
struct RailPlacement {
    Eigen::Vector2d origin = Eigen::Vector2d::Zero(); ///< of stop 0
    Radians heading;
    int stops = 0;
    double stepM = 0;

    Eigen::Vector2d stop(int k) const;
};

/// One planned position of the camera.
struct Station {
    int placement = -1; ///< index into Plan::placements; -1 for a station that came with imported photos
    int stop = 0;       ///< along the rail, from 0
    Eigen::Vector3d positionM = Eigen::Vector3d::Zero();

    /// What people call it: "rail 3, stop 5" (counted from 1), with "at 1.2 m" if the plan has several
    /// heights.
};

/// A floor area that no station covers, and why.
struct UncoveredArea {
    double areaM2 = 0;
    Eigen::Vector2d centre = Eigen::Vector2d::Zero(); ///< a point of the area
    std::string reason; ///< as a sentence's end: "closer than the clearance to a wall or obstacle"
};

/// Stations in walking order, placement by placement.
struct Plan {
    std::vector<RailPlacement> placements;
    std::vector<Station> stations;
};

/// What a plan costs and what it leaves out.
struct PlanReport {
    int placements = 0;
    int stations = 0;
    double metresWalked = 0;
    double minutes = 0;
    double floorM2 = 0; ///< inside the outline and outside the obstacles
    double uncoveredM2 =
        0; ///< farther than half a grid cell's diagonal from every station, as the robot sees it
    std::vector<UncoveredArea> uncovered;
};

} // namespace spherewalk::survey
