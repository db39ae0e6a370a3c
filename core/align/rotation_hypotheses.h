// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <vector>

namespace spherewalk::align {

/// The usable matches of a pair, side by side. Shape: all of the same length.
struct Bearings {
    std::vector<Eigen::Vector3d> inA;
    std::vector<Eigen::Vector3d> inB;
    std::vector<double> sigmaRad;
    std::vector<int> match; ///< index among the pair's matches

    int count() const { return static_cast<int>(inA.size()); }
};

/// A rotation that many matches agree with, as far as parallax lets them.
struct RotationHypothesis {
    Eigen::Matrix3d aFromB = Eigen::Matrix3d::Identity();
    double score = 0; ///< agreeing share of the matches looked at, the nearer the more
};

/// The rotations that most matches agree with within the parallax that a room has, the best first, each at
/// least kDistinctRad from the others. Right to a few degrees: parallax is taken for noise. Empty if there
/// are less than two matches.
std::vector<RotationHypothesis> rotationHypotheses(const Bearings& bearings);

} // namespace spherewalk::align
