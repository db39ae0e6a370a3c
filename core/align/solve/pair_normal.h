// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "used_pair.h"

#include <Eigen/Core>

#include <cstddef>
#include <span>

namespace spherewalk::align {

/// What a pair's matches ask of two photos, summed up: the products of the robust residuals and their
/// derivatives. All that least squares needs of some hundred matches fits into it.
/// Order: 3 of a turn of a, 3 of a turn of b (both about the room's axes), 3 of the baseline b - a (metres),
/// 1 of the residual itself.
using PairNormal = Eigen::Matrix<double, 10, 10>;

/// One match's residual and its derivatives, in standard deviations. A turn has two rows, else one.
struct MatchRow {
    double residual = 0;
    Eigen::Matrix<double, 9, 1> by = Eigen::Matrix<double, 9, 1>::Zero();
};

/// The rows of one match; returns how many there are: none where a bearing points along the baseline.
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
    double slope = 0; ///< by the residual
};

Bounded bounded(double residual, double width);

/// scale: by which the matches' sigmas are too small. width: in scaled standard deviations.
PairNormal pairNormal(const UsedPair& pair, const PhotoState& a, const PhotoState& b, double scale,
                      double width);

/// The sum of squares alone: the last entry of pairNormal().
double pairCost(const UsedPair& pair, const PhotoState& a, const PhotoState& b, double scale, double width);

} // namespace spherewalk::align
