// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/align/photo_pair.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCore>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace spherewalk::align {

/// A pair estimate as an edge of a graph of photos.
struct GraphEdge {
    int pair = 0; ///< Index among the estimates.
    int a = 0;
    int b = 0;
    Eigen::Quaterniond aFromB;
    double weight = 1;
    int triangles = 0;      ///< Number of triangles that it makes with two other edges.
    int closed = 0;         ///< Number of those whose three rotations come back to where they began.
    double residualRad = 0; ///< Turn between its rotation and the averaged rotations.
};

/// Photos that edges connect.
struct Component {
    std::vector<int> photos; ///< Indices of the photos, ascending.
    std::vector<GraphEdge> edges;
    std::vector<Eigen::Quaterniond> componentFromPhoto; ///< One a photo, in a frame of the component's own.
};

struct PoseGraph {
    std::vector<Component> components; ///< Most photos first. Photos without edges are in none.
    std::vector<int> contradicted;     ///< Pairs whose rotation the others contradict, ascending.
    double cycleErrorRad = 0;          ///< Median turn around the triangles; 0 if there are none.
};

/// How the photos are turned to each other: rotations averaged over all pairs, from several spanning trees.
/// Pairs that contradict the others are left out. leastClosed: number of triangles that must confirm a pair
/// before it counts. confirmed: photos that need no other photo to confirm them; nothing, or one a photo.
/// Estimates that are no constraint, or whose rotation is not finite, are passed over. Errors: InvalidInput
/// for an estimate of photos that do not exist.
PoseGraph poseGraph(int photos, std::span<const PairEstimate> estimates, int leastClosed = 0,
                    const std::vector<bool>& confirmed = {});

/// The turn that remains of an edge's rotation between the averaged rotations of its photos. indexOf: the
/// place of each photo in the component.
Eigen::Vector3d disagreement(const GraphEdge& edge, std::span<const Eigen::Quaterniond> componentFromPhoto,
                             std::span<const int> indexOf);

/// Averages the edges' rotations over a connected component, from several spanning trees. The norm is robust:
/// first the sum of angles, then a sum that ignores edges which disagree by degrees.
/// Source: Chatterjee and Govindu, Efficient and Robust Large-Scale Rotation Averaging, 2013.
std::vector<Eigen::Quaterniond> averagedRotations(const Component& component, std::span<const int> indexOf);

/// The solution of matrix * x = right, one column each. Empty if the matrix cannot be factored. Range: the
/// matrix is symmetric and definite; its lower half is read. Eigen's factorisation is compiled here alone,
/// since it takes seconds.
std::optional<Eigen::MatrixXd> solvedSparse(const Eigen::SparseMatrix<double>& matrix,
                                            const Eigen::MatrixXd& right);

/// A way in which a component may lie in the room.
struct RoomOrientation {
    Eigen::Quaterniond roomFromComponent = Eigen::Quaterniond::Identity();
    bool hasHeading = false;   ///< False if no two photos stand far enough apart to tell the heading.
    double agreeingShare = 0;  ///< Share of the baselines, by weight, that point as the positions do.
    double positionErrorM = 0; ///< What the baselines say that positions are off by, across them: a sigma.
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

/// The names of some photos for a sentence: five of them, and how many more there are.
std::string namesOf(std::span<const int> photos, std::span<const PhotoPrior> priors);

} // namespace spherewalk::align
