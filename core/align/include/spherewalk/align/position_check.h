// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/align/photo_pair.h"

#include <Eigen/Core>

#include <span>
#include <string>
#include <vector>

namespace spherewalk::align {

/// A position that photos may have been tagged with.
struct PlannedPosition {
    std::string name; ///< The name that sentences for people use: "rail 3, stop 5".
    Eigen::Vector3d positionM = Eigen::Vector3d::Zero(); ///< In the room frame.
    int placement = -1;                                  ///< Index of the rail; -1 for none.
    int stop = 0;                                        ///< Index along the rail.
};

/// One photo whose matches contradict the position that it is tagged with.
struct WrongPosition {
    int photo = 0; ///< Index among the priors.
    int fits = -1; ///< Index of the planned position that fits; -1 if none does.
    Eigen::Vector3d takenM = Eigen::Vector3d::Zero(); ///< Where it was taken, to some centimetres.
    double confidence = 0;                            ///< In [0, 1].
    std::string reason;                               ///< A sentence: "Rail 3 was walked from the other end."
};

/// Finds photos with wrong positions from the directions of the pairs' baselines and from the parallax:
/// swaps, photos or runs of photos off by one stop, rails walked backwards, photos taken elsewhere. One
/// blunder is believed after the other, the one that explains most first, as long as the baselines gain more
/// from it than chance would give. planned: where photos may have been taken. A rail's stops may lie anywhere
/// at one height.
///
/// Not judged are: photos with fewer than four baselines, unless their whole rail is judged; components of
/// the survey against one another; what all photos of a component have in common (all of it turned, moved or
/// scaled); which way a single rail was walked, and other doubts along one line. Where explanations are about
/// as good (two rails, one of them off by one: which?) the confidence says so.
///
/// The result is sorted by photo. Values that are not finite are passed over. Errors: InvalidInput for an
/// estimate of photos that do not exist. Cost: a tenth of a second for 400 photos in order, a second for
/// several wrong rails.
std::vector<WrongPosition> wrongPositions(std::span<const PhotoPrior> photos,
                                          std::span<const PairEstimate> estimates,
                                          std::span<const PlannedPosition> planned);

} // namespace spherewalk::align
