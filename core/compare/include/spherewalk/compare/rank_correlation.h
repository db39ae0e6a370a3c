// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

namespace spherewalk::compare {

/// Spearman's rank correlation of two lists: 1 if both put everything in the same order, -1 in the opposite
/// order. Equal values share a rank. Nothing for fewer than three values, for lists of different lengths, and
/// for a list of one value throughout. Range: finite values. Source: Spearman 1904.
std::optional<double> rankCorrelation(std::span<const double> a, std::span<const double> b);

} // namespace spherewalk::compare
