// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/survey/walking_distance.h"

#include <Eigen/Core>

#include <vector>

namespace spherewalk::survey {

/// A rail to be walked from either end: its points [begin, end) on one line of the lattice.
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

/// The way from each rail's end to the next one's beginning, in metres.
double carryingDistance(const std::vector<RailEnds>& rails, const std::vector<Leg>& route,
                        const WalkingDistance& walking);

} // namespace spherewalk::survey
