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

/// The names of some photos for a sentence: five of them, and how many more there are.
std::string namesOf(std::span<const int> photos, std::span<const PhotoPrior> priors);

} // namespace spherewalk::align
