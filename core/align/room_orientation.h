// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pose_graph.h"

#include "spherewalk/align/photo_pair.h"

#include <span>

namespace spherewalk::align {

/// How a component stands in the room.
struct RoomOrientation {
    Eigen::Quaterniond roomFromRoot = Eigen::Quaterniond::Identity();
    bool hasHeading = false;  ///< false: no two photos stand apart enough to say
    double agreeingShare = 0; ///< of the baselines, by weight, those within kAgreeingRad of the positions
};

/// Turns a component upright by what its photos say of their tilt, and to the heading in which most baselines
/// point as the positions do. No single photo decides. rank: 0 for the best heading, 1 for the runner-up ...
RoomOrientation roomOrientation(const Component& component, std::span<const PhotoPrior> photos,
                                std::span<const PairEstimate> estimates, int rank = 0);

} // namespace spherewalk::align
