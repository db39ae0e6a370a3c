// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/align/photo_pair.h"

#include <Eigen/Geometry>

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace spherewalk::align {

enum class PairVerdict {
    Constraint,  ///< the matches agree on one rotation
    TooFew,      ///< too few matches, or too few that agree
    TooNarrow,   ///< those that agree lie together in one direction, and leave the rotation open
    NoAgreement, ///< no rotation explains a sufficient share
};

/// As reports spell it: "constraint", "too_few".
std::string_view name(PairVerdict verdict);

/// How two photos are turned to each other, from their matches alone: positions and tilts are not asked.
struct PairEstimate {
    int a = 0;
    int b = 0;
    PairVerdict verdict = PairVerdict::TooFew;
    int inliers = 0;
    double inlierShare = 0;     ///< of the matches
    double spread = 0;          ///< least eigenvalue of the mean of (I - b b^T) over inliers, [0, 2/3]
    std::vector<bool> isInlier; ///< one a match
    Eigen::Quaterniond aFromB = Eigen::Quaterniond::Identity();   ///< meaningful for Constraint alone
    Eigen::Matrix3d rotationCovariance = Eigen::Matrix3d::Zero(); ///< rad^2, of a small turn in a's frame
    /// The direction from a to b in a's frame, signed by what lies in front; nothing where the parallax is
    /// too small to tell.
    std::optional<Eigen::Vector3d> baselineInA;
    double baselineSigmaRad = 0; ///< of that direction
    double parallaxRad = 0;      ///< median angle by which inliers moved, the rotation taken off
    double forwardShare = 0; ///< of the inliers with measurable parallax, those on the side of baselineInA
};

struct PairOptions {
    int leastInliers = 15;
    double leastShare = 0.15; ///< a mirror image reaches 0.14 by chance
    int threads = 0;          ///< 0: all that the machine has
};

/// Threads: any. Cost: about a millisecond for some hundred matches. The same input gives the same result.
PairEstimate estimatePair(const PhotoPair& pair, const PairOptions& options = {});

/// The same for each of many pairs, in their order, on PairOptions::threads threads.
std::vector<PairEstimate> estimatePairs(std::span<const PhotoPair> pairs, const PairOptions& options = {});

} // namespace spherewalk::align
