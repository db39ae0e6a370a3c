// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pose_graph.h"

namespace spherewalk::align {

/// What is left of an edge's rotation between these two photos: the turn that its ends disagree by.
Eigen::Vector3d disagreement(const GraphEdge& edge, std::span<const Eigen::Quaterniond> rootFromPhoto,
                             std::span<const int> indexOf);

/// Averages the edges' rotations over a connected component, from several spanning trees, robustly: first by
/// the sum of angles, then by a sum that ignores what disagrees by degrees. indexOf: photo to its place in
/// the component. Source: Chatterjee and Govindu, Efficient and Robust Large-Scale Rotation Averaging, 2013.
std::vector<Eigen::Quaterniond> averagedRotations(const Component& component, std::span<const int> indexOf);

} // namespace spherewalk::align
