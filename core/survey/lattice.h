// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "floor.h"

#include "spherewalk/survey/plan.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace spherewalk::survey {

/// A regular lattice over the floor, in its local frame, and which of its points can hold a stop.
struct Lattice {
    Eigen::Vector2d origin = Eigen::Vector2d::Zero(); ///< of point (0, 0)
    double stepM = 0;
    int columns = 0;
    int rows = 0;
    std::vector<std::uint8_t> free; ///< row by row

    Eigen::Vector2d at(int column, int row) const { return origin + stepM * Eigen::Vector2d(column, row); }

    bool isFree(int column, int row) const {
        return free[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                    static_cast<std::size_t>(column)] != 0;
    }

    int freeCount() const;
};

/// The lattice at the shift that lets most points keep the clearance; among equals, the one nearest to the
/// middle of the floor's bounds. Points that obstacles enclose are not free.
Lattice bestLattice(const Floor& floor, const PlanOptions& options);

/// Straight pieces of consecutive free points between which the clearance holds, as point indices (column,
/// row) of their first stop with the number of stops.
struct Rail {
    int column = 0;
    int row = 0;
    int stops = 0;
    bool alongX = true;
};

/// All free points as rails of at most railStops along one axis, a run's points split evenly.
std::vector<Rail> railsAlong(bool alongX, const Lattice& lattice, const Floor& floor,
                             const PlanOptions& options);

} // namespace spherewalk::survey
