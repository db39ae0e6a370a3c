// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/angle.h"
#include "spherewalk/survey/room.h"

#include <Eigen/Core>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace spherewalk::survey {

inline constexpr int kMostStations = 200'000; ///< Largest number of stations in one plan.
inline constexpr int kMostRailStops = 1000;   ///< Largest number of stops of a rail.

/// How stations are to be laid out.
struct PlanOptions {
    double stepM = 0.2; ///< Distance between neighbouring stops, in both directions.
    /// Heights of the lens above the floor. Each stop has one station per height.
    std::vector<double> heightsM = {1.2};
    int railStops = 6;               ///< Number of positions of the cart on the rail.
    double clearanceM = 0.3;         ///< Least distance between a stop and any wall or obstacle.
    double secondsPerPhoto = 12;     ///< Time for one photo, including moving the cart.
    double secondsPerPlacement = 60; ///< Time for carrying the rail and laying it anew.
    bool areHeightsGuessed = false;  ///< Nobody has said them: there is no cart that was set to them.

    /// Errors: InvalidInput with the option and its range; for a step so fine that the room would need more
    /// than kMostStations, the sentence says which step would fit. The room must be valid.
    void validate(const Room& room) const;
};

/// Photos by hand are about so far apart, along their way and beside it.
inline constexpr double kStepByHandM = 0.5;

/// Where the rail lies. The stops are at origin + k * step along the heading.
struct RailPlacement {
    Eigen::Vector2d origin = Eigen::Vector2d::Zero(); ///< Position of stop 0, where the operator begins.
    Radians heading;
    int stops = 0;
    double stepM = 0;
    bool isLocked = false; ///< A person wants it to stay where it is.

    /// Range: 0 <= k < stops, not checked.
    Eigen::Vector2d stop(int k) const;
};

/// One planned position of the camera.
struct Station {
    int placement = -1; ///< Index into Plan::placements; -1 for a station of imported photos.
    int stop = 0;       ///< Number along the rail, counted from 0.
    Eigen::Vector3d positionM = Eigen::Vector3d::Zero();
};

/// Stations in walking order, placement by placement, stop by stop, and at each stop height by height.
struct Plan {
    std::vector<RailPlacement> placements;
    std::vector<Station> stations;
    bool isByHand = false; ///< A person laid the rails; room and options alone do not give them.
};

/// Lays the room out: stops on a lattice along the room's axes, shifted so that most of them fit; rails of up
/// to railStops stops along the axis that needs fewer placements; the order and direction of rails that moves
/// the operator least, as far as a local search finds it. The rooms of a flat that have names come one after
/// the other. A room without space for any stop gives an empty plan. The same input gives the same plan.
/// locked: rails that stay, though some may be walked from their other end; no other stop comes nearer than
/// half a step to theirs. Errors: those of both validate(), and with locked rails those of planOfLaid().
/// Cost: under a second for a room of 100 m2 at 20 cm.
Plan plan(const Room& room, const PlanOptions& options, std::span<const RailPlacement> locked = {});

/// The name that people read: "rail 3, stop 5" (counted from 1), with " at 1.20 m" if the plan's stations
/// have several heights, "unplanned position (1.20, 3.40)" without a placement. Range: index <
/// stations.size().
std::string stationName(const Plan& plan, std::size_t index);

/// The names of all stations, in order.
std::vector<std::string> stationNames(const Plan& plan);

} // namespace spherewalk::survey
