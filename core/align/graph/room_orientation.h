// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "graph/pose_graph.h"

#include "spherewalk/align/photo_pair.h"

#include <span>
#include <vector>

namespace spherewalk::align {

/// A way in which a component may lie in the room.
struct RoomOrientation {
    Eigen::Quaterniond roomFromComponent = Eigen::Quaterniond::Identity();
    bool hasHeading = false;  ///< False if no two photos stand far enough apart to tell the heading.
    double agreeingShare = 0; ///< Share of the baselines, by weight, that point as the positions do.
};

/// The ways in which a component may lie in the room, the most likely first; at least one, at most three.
/// What the photos say of their tilt turns it upright; baselines that point as the positions do vote for
/// headings. No single photo decides. Where many positions are wrong, the right heading may be the second.
/// Without any vote the one orientation is upright and has no heading. Shape: photos and estimates are all of
/// them. Values that are not finite are passed over.
std::vector<RoomOrientation> orientations(const Component& component, std::span<const PhotoPrior> photos,
                                          std::span<const PairEstimate> estimates);

/// The photos outside of the largest component that stand, by a good pair with one of its photos, where their
/// tags put them. Walls may hide them from all others that they were compared with, so that no third photo
/// confirms them. One entry a photo; none if the tags do not say how the component lies in the room.
std::vector<bool> confirmedByTags(const PoseGraph& graph, std::span<const PhotoPrior> photos,
                                  std::span<const PairEstimate> estimates);

} // namespace spherewalk::align
