// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

namespace spherewalk::measure {

/// How far two lists rise and fall together, whatever their units: 1 if both put everything in the same
/// order, -1 in the opposite one; equal values share a rank. Nothing for lists of fewer than three values,
/// and where one is the same throughout. Range: lists of the same length, finite. Source: Spearman 1904.
std::optional<double> rankCorrelation(std::span<const double> a, std::span<const double> b);

} // namespace spherewalk::measure
