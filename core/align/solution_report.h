// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "component_solver.h"

#include "spherewalk/align/solve.h"

#include <vector>

namespace spherewalk::align {

/// How well the matches that the pairs agreed on fit a solution.
struct SolutionQuality {
    struct Photo {
        int judged = 0;
        int contradicted = 0; ///< out of plane or behind
        int pairs = 0;        ///< that hold it
        double residualRad = 0;
    };

    std::vector<Photo> photos;
    double agreeingShare = 0; ///< of all that were judged
    double residualRad = 0;   ///< robust root mean square
};

SolutionQuality quality(const ComponentInput& input, const ComponentState& state);

/// Writes a component's poses and their uncertainty into the alignment.
void report(const ComponentInput& input, Model model, const ComponentState& state,
            const SolutionQuality& quality, bool hasHeading, int component, Alignment& alignment,
            const std::stop_token& stop);

} // namespace spherewalk::align
