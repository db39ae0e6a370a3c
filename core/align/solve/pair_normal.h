// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/lens_pair.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <span>
#include <vector>

namespace spherewalk::align {

/// The pose of a photo while it is solved. Frames: the room's axes; the origin lies near the photos, so that
/// doubles keep their digits.
struct PhotoState {
    Eigen::Quaterniond roomFromPhoto = Eigen::Quaterniond::Identity();
    Eigen::Vector3d positionM = Eigen::Vector3d::Zero();
    LensPair lenses = {};
};

/// LensPair::side(), but between the two where a picture is faded from one lens to the other.
double softSide(const Eigen::Vector3d& inPhoto);

/// A match that the solution uses.
struct UsedMatch {
    Eigen::Vector3d inA;
    Eigen::Vector3d inB;
    double sigmaRad = 0;
    int match = 0; ///< Index among the pair's matches.
    int track = 0; ///< Number of the thing that its features show, over all photos.
    /// By how much the solution follows it alone, [0, 1): what it misses by is so much too small.
    double leverage = 0;
};

/// A pair with the matches that the solution uses.
struct UsedPair {
    int pair = 0; ///< Index among the given pairs.
    int a = 0;    ///< Place of the photo within the component.
    int b = 0;
    bool isTurn = false;     ///< The photos stand too close for a direction; the turn alone counts.
    double toleranceRad = 0; ///< Of a turn: the parallax that may hide in it.
    std::vector<UsedMatch> matches;
};

/// The normal equations of a pair's matches: sums of products of the robust residuals and their derivatives.
/// Least squares needs no more of some hundred matches.
/// Order: 3 of a turn of a, 3 of a turn of b (both about the room's axes), 3 of the baseline b - a (metres),
/// 1 of the residual itself.
using PairNormal = Eigen::Matrix<double, 10, 10>;

/// One match's residual and its derivatives, in standard deviations. A turn has two rows, else one.
struct MatchRow {
    double residual = 0;
    Eigen::Matrix<double, 9, 1> by = Eigen::Matrix<double, 9, 1>::Zero();
};

/// Computes the rows of one match and returns their number: none where a bearing points along the baseline.
int matchRows(const UsedPair& pair, const UsedMatch& match, const PhotoState& a, const PhotoState& b,
              MatchRow rows[2]);

/// Calls visit(match, row) for every row of the pair's matches.
template <class Visit>
void forEachRow(const UsedPair& pair, std::span<const PhotoState> states, Visit&& visit) {
    MatchRow rows[2];
    for (const UsedMatch& match : pair.matches) {
        const int count = matchRows(pair, match, states[static_cast<std::size_t>(pair.a)],
                                    states[static_cast<std::size_t>(pair.b)], rows);
        for (int i = 0; i < count; ++i) {
            visit(match, rows[i]);
        }
    }
}

/// A residual under Geman and McClure's norm: r / sqrt(1 + (r / width)^2), whose square is bounded.
struct Bounded {
    double value = 0;
    double slope = 0; ///< Derivative of the value by the residual.
};

Bounded bounded(double residual, double width);

/// The normal equations of all matches. scale: factor by which the matches' sigmas are too small. width: of
/// the norm, in scaled standard deviations.
PairNormal pairNormal(const UsedPair& pair, const PhotoState& a, const PhotoState& b, double scale,
                      double width);

/// The last entry of pairNormal() alone: the sum of squares.
double pairCost(const UsedPair& pair, const PhotoState& a, const PhotoState& b, double scale, double width);

} // namespace spherewalk::align
