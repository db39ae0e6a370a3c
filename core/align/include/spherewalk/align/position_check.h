// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/align/pair_estimate.h"
#include "spherewalk/align/photo_pair.h"

#include <span>
#include <string>
#include <vector>

namespace spherewalk::align {

/// A position that photos may have been tagged with.
struct PlannedPosition {
    std::string name; ///< "rail 3, stop 5"
    Eigen::Vector3d positionM = Eigen::Vector3d::Zero();
    int placement = -1;
    int stop = 0;
};

/// One photo whose matches contradict the position that it is tagged with.
struct WrongPosition {
    int photo = 0;         ///< index among the priors
    int fits = -1;         ///< index among the planned positions of the one that fits; -1: none does
    double confidence = 0; ///< in [0, 1]
    std::string reason;    ///< a sentence: "Rail 3 was walked from the other end."
};

struct PositionCheckOptions {
    int threads = 0;
};

/// Finds photos with wrong positions from how the pairs' baselines point and from the parallax: swaps, photos
/// off by one stop, rails walked backwards. Photos that few pairs hold are not judged.
std::vector<WrongPosition> wrongPositions(std::span<const PhotoPrior> photos,
                                          std::span<const PairEstimate> estimates,
                                          std::span<const PlannedPosition> planned,
                                          const PositionCheckOptions& options = {});

} // namespace spherewalk::align
