// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "refinement.h"

#include <span>
#include <vector>

namespace spherewalk::align {

/// How far one photo may err, one standard deviation each.
struct PhotoUncertainty {
    double yawRad = 0; ///< against all others: the common turn taken off
    double pitchRad = 0;
    double rollRad = 0;
    double positionM = 0; ///< along each axis
};

struct Uncertainty {
    std::vector<PhotoUncertainty> photos;
    double commonYawRad = 0;
};

/// How far a converged solution may err. A feature of one photo takes part in many pairs with the same error,
/// and pairs outnumber what is known by far: the usual inverse of the normal matrix promises too much. So
/// the residuals themselves, with chance signs that are equal within a track, are sent through the normal
/// equations many times (a wild cluster bootstrap), and the priors' errors with them. What the model does
/// not solve (tilts, positions) errs as its prior says and passes its error on.
/// Source: Cameron, Gelbach, Miller, Bootstrap-Based Improvements for Inference with Clustered Errors, 2008.
Uncertainty uncertainty(const Unknowns& unknowns, std::span<const PhotoPrior> priors,
                        std::span<const UsedPair> pairs, const RefinementOptions& options,
                        const std::stop_token& stop);

} // namespace spherewalk::align
