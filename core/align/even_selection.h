// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <vector>

namespace spherewalk::align {

/// Something on the sphere that is worth more or less.
struct Spot {
    Eigen::Vector3d bearing = Eigen::Vector3d::UnitX();
    float response = 0;
    double ownRad = 0; ///< no weaker spot is wanted as near as that
};

/// At most `most` of the spots, spread evenly: first the strongest of each part of the sphere (some 10
/// degrees wide), then the second of each, and so on; in each round by strength.
std::vector<int> evenSelection(const std::vector<Spot>& spots, int most);

} // namespace spherewalk::align
