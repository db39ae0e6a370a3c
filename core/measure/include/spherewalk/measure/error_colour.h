// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>

namespace spherewalk::measure {

/// For an error beside a tolerance: blue well within, light yellow at the tolerance, red well beyond, grey if
/// it is not known. A quarter and four times the tolerance are the ends. As SVG and CSS take it. Told apart
/// with any kind of colour vision.
std::string errorColour(std::optional<double> errorPx, double tolerancePx);

/// Errors, in tolerances, that stand in a legend of these colours.
inline constexpr std::array<double, 5> kErrorSteps{0.25, 0.5, 1, 2, 4};

} // namespace spherewalk::measure
