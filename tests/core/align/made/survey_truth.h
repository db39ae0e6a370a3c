// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "made/synthetic_survey.h"

#include "spherewalk/align/solve.h"

#include <vector>

namespace spherewalk::align {

/// How far a solution is from the truth, over its solved photos. Units: radians.
struct SurveyErrors {
    std::vector<double> yaw; ///< the common offset removed
    std::vector<double> pitch;
    std::vector<double> roll;
    double commonYaw = 0;
    double yawRms = 0;
    double yawWorst = 0;
    double tiltRms = 0;
    double tiltApartRms = 0; ///< the lean common to all removed
    double ratioYaw = 0;     ///< root mean square of error / reported sigma
    double ratioTilt = 0;
    double within3 = 0; ///< share of the errors
    int solved = 0;
};

/// Range: at least one solved photo. component: whose photos are looked at.
SurveyErrors errorsOf(const Alignment& alignment, const std::vector<Rigid3>& truth, int component = 0);

/// Estimates the pairs and solves.
Alignment solveSurvey(const SyntheticSurvey& survey, const SolveOptions& options = {});

} // namespace spherewalk::align
