// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "unknowns.h"

#include "spherewalk/base/progress.h"

#include <span>
#include <stop_token>
#include <vector>

namespace spherewalk::align {

struct RefinementOptions {
    Model model = Model::Position; ///< not Auto
    double scale = 1;              ///< by which the matches' sigmas are too small
    double width = 4;              ///< of the bounded norm, in scaled standard deviations
    double placementSigmaM = 0.01;
    double placementSigmaRad = 0.0175;
    int iterations = 25;
    double tolerance = 1e-7; ///< of the cost, relative
    int threads = 0;
};

/// Moves the unknowns to the least squares of the matches and the priors. pairs: a and b counted within the
/// component. Returns the cost. Errors: Internal if Ceres gives up. Stop: Error{Stopped}.
double refine(Unknowns& unknowns, std::span<const PhotoPrior> priors, std::span<const UsedPair> pairs,
              const RefinementOptions& options, ProgressSink& progress, const std::stop_token& stop);

} // namespace spherewalk::align
