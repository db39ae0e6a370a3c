// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/align/pair_estimate.h"

#include <Eigen/Geometry>

#include <span>
#include <vector>

namespace spherewalk::align {

/// How all photos are turned to each other, from the pairs' rotations alone. Good to a fraction of a degree,
/// which is enough to see where baselines point.
struct RoughRotations {
    /// One a photo; each part has a frame of its own.
    std::vector<Eigen::Quaterniond> partFromPhoto;
    std::vector<int> part; ///< one a photo; -1: no pair that others confirm holds it
    int parts = 0;
    /// One an estimate: the turn between the pair and the average; infinity where it took no part.
    std::vector<double> residualRad;
};

/// A pair counts only if at least one triangle of pairs confirms it: a wrong rotation hardly ever closes a
/// triangle. Photos that confirmed pairs connect are a part. Estimates that are no constraint or hold numbers
/// that are not finite are passed over. Errors: InvalidInput for an estimate of photos that do not exist.
RoughRotations roughRotations(int photos, std::span<const PairEstimate> estimates);

} // namespace spherewalk::align
