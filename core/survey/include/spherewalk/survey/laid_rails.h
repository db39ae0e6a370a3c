// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/survey/plan.h"

#include <Eigen/Core>

#include <cstddef>
#include <span>
#include <vector>

namespace spherewalk::survey {

/// The plan of rails that a person has laid, in this order. Errors: InvalidInput with the number of the rail
/// that lies off the floor, meets a wall or an obstacle, or has a stop where another rail has one; those of
/// both validate().
Plan planOfLaid(const Room& room, const PlanOptions& options, std::span<const RailPlacement> rails);

/// Returns the rail moved by this vector. Frames: room. Units: metres.
RailPlacement moved(RailPlacement rail, const Eigen::Vector2d& by);
/// Returns the rail turned around its middle, counter-clockwise.
RailPlacement turned(RailPlacement rail, Radians by);
/// Returns the rail with this many stops from its first one. Range: stops > 0.
RailPlacement withStops(RailPlacement rail, int stops);

enum class RailEnd { First, Last };

/// Returns the rail with one end pulled towards this place: the other end stays, the rail turns, and has the
/// stops that fit. A place within half a step of the other end leaves one stop.
RailPlacement pulled(const RailPlacement& rail, RailEnd end, const Eigen::Vector2d& to);

/// Returns a rail whose first stop is here and whose last is near there.
RailPlacement laid(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double stepM);

/// Returns two rails, of which the second begins at this stop. Range: 0 < stop < rail.stops.
std::vector<RailPlacement> split(const RailPlacement& rail, int stop);
/// Returns what is left of the rail without this stop: none, one, or two rails. Range: 0 <= stop <
/// rail.stops.
std::vector<RailPlacement> withoutStop(const RailPlacement& rail, int stop);

} // namespace spherewalk::survey
