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

/// Finds photos with wrong positions from how the pairs' baselines point and from the parallax: swaps, photos
/// or runs of photos off by one stop, rails walked backwards, photos laid elsewhere. One blunder is believed
/// after the other, the one that explains most first, as long as the baselines gain more from it than chance
/// would give. planned: where photos may have been taken; a rail's stops may lie anywhere, at one height.
///
/// Not judged: photos with fewer than four baselines, unless their whole rail is; parts of a survey that no
/// triangle of pairs connects, against one another; what all photos of a part have in common (all of it
/// turned, moved or scaled); which way a single rail was walked, and other doubts along one line. Where
/// explanations are about as good (two rails, one of them off by one: which?) the confidence says so. Errors:
/// InvalidInput for an estimate of photos that do not exist; what holds no number is passed over. Cost: a
/// tenth of a second for 400 photos in order, a second for several wrong rails.
std::vector<WrongPosition> wrongPositions(std::span<const PhotoPrior> photos,
                                          std::span<const PairEstimate> estimates,
                                          std::span<const PlannedPosition> planned);

} // namespace spherewalk::align
