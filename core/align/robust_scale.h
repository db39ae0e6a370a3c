// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace spherewalk::align {

/// The standard deviation of those of the residuals (in supposed standard deviations, any sign) that agree,
/// a minority of wrong ones ignored. Range of the result: [0.3, largest]; 1 for too few to tell.
double agreeingScale(std::vector<double> residuals, double largest);

} // namespace spherewalk::align
