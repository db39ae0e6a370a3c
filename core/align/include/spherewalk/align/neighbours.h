// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <span>
#include <utility>
#include <vector>

namespace spherewalk::align {

struct NeighbourOptions {
    int directions = 8;     ///< each photo is paired with the nearest in each of so many, [1, 64]
    int farDirections = 0;  ///< and in so many with one at two to three times that distance, [0, 64]
    int mostAtOnePlace = 4; ///< with so many photos of its own place, [1, 1000]
    /// No farther than this, but to connect parts. Photos much farther apart than the room is wide have
    /// little in common.
    double mostDistanceM = 2.5;

    /// Errors: InvalidInput, naming the option and its range.
    void validate() const;
};

/// Which photos to compare, each pair once and a < b, sorted. Photos within a centimetre of each other across
/// the floor are of one place. Parts without a connection get the shortest ones that connect them. Heights
/// are not asked. Errors: InvalidInput for positions that are not finite. Cost: the square of their number;
/// half a second for 5000.
std::vector<std::pair<int, int>> neighbours(std::span<const Eigen::Vector3d> positionsM,
                                            const NeighbourOptions& options = {});

} // namespace spherewalk::align
