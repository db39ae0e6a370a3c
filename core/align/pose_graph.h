// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/align/pair_estimate.h"

#include <Eigen/Geometry>

#include <span>
#include <vector>

namespace spherewalk::align {

/// Pair estimates as the edges of a graph of photos.
struct GraphEdge {
    int pair = 0; ///< index among the estimates
    int a = 0;
    int b = 0;
    Eigen::Quaterniond aFromB;
    double weight = 1;
    int triangles = 0; ///< with two other edges
    int closed = 0;    ///< of those, the ones that come back to where they began
};

/// Photos that edges connect.
struct Component {
    std::vector<int> photos; ///< ascending
    std::vector<GraphEdge> edges;
    std::vector<Eigen::Quaterniond> rootFromPhoto; ///< one a photo, in a frame of the component's own
};

struct PoseGraph {
    std::vector<Component> components; ///< the one with most photos first; photos without edges in none
    std::vector<int> contradicted;     ///< pairs whose rotation the others contradict
    double cycleErrorRad = 0;          ///< median around the triangles; 0 if there are none
};

/// Where the estimated rotations put the photos to each other: averaged over all pairs, from several starts
/// (spanning trees), pairs that contradict the others left out. leastClosed: triangles that must confirm a
/// pair before it counts. Estimates whose rotation is none are passed over.
PoseGraph poseGraph(int photos, std::span<const PairEstimate> estimates, int leastClosed = 0);

} // namespace spherewalk::align
