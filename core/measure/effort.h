// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <climits>

#include <vector>

namespace spherewalk::measure {

/// How often things are measured.
struct Effort {
    int viewRounds = 100;
    int decodeRounds = 15;
    int coldViews = 40;
    int directions = 40;  ///< of fidelity
    int pixelStep = 1;    ///< of fidelity: every so many pixels along each axis
    int latticeEvery = 1; ///< of each search's views
    std::vector<double> speedsMS{1, 2, 5, 10, 15, 20};
    int walkViews = 90;
    int photosAllRound = INT_MAX; ///< at most

    static Effort quick() { return {10, 3, 8, 4, 4, 11, {1, 5, 10}, 20, 12}; }
};

} // namespace spherewalk::measure
