// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace spherewalk::measure {

/// Values that people like to read, with at least one at or beyond each end of the range.

/// 1, 2 or 5 times a power of ten apart, at most `most` steps. Range: least < greatest.
std::vector<double> evenTicks(double least, double greatest, int most);

/// 1, 2 and 5 times powers of ten, for a logarithmic axis. Range: 0 < least <= greatest.
std::vector<double> logarithmicTicks(double least, double greatest);

} // namespace spherewalk::measure
