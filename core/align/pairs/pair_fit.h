// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/align/photo_pair.h"

#include <Eigen/Geometry>

#include <vector>

namespace spherewalk::align {

/// The usable matches of a pair, side by side, and which of them are asked. Shape: all vectors have the same
/// length.
struct Bearings {
    std::vector<Eigen::Vector3d> inA;
    std::vector<Eigen::Vector3d> inB;
    std::vector<double> sigmaRad;
    std::vector<int> match; ///< Index among the pair's matches.
    Radians reach = PairOptions().reach;
    double leastSine = PairOptions().leastSine;

    int count() const { return static_cast<int>(inA.size()); }
};

/// A rotation that many matches agree with, as far as parallax lets them.
struct RotationHypothesis {
    Eigen::Matrix3d aFromB = Eigen::Matrix3d::Identity();
    double score = 0; ///< Share of the matches looked at that agree, the nearer the more.
};

/// The rotations that most matches agree with, within the parallax that a room has; the best comes first.
/// They differ by at least 12 degrees and are right to a few degrees, since parallax is taken for noise.
/// Empty for fewer than two matches.
std::vector<RotationHypothesis> rotationHypotheses(const Bearings& bearings);

/// The rotations about the vertical with which most matches lie in planes with one baseline, and in front;
/// the best comes first. Parallax may be of any size here, and one right match in six is enough; but both
/// photos must be level to about 2 degrees after these turns. They differ by at least 9 degrees. Empty for
/// fewer than six matches. Source: three matches with a common vertical, Fraundorfer, Tanskanen, Pollefeys
/// 2010.
std::vector<RotationHypothesis> levelHypotheses(const Bearings& bearings, const Eigen::Quaterniond& levelA,
                                                const Eigen::Quaterniond& levelB);

/// A rotation and a direction of the baseline, fitted to matches.
struct EpipolarFit {
    Eigen::Matrix3d aFromB = Eigen::Matrix3d::Identity();
    Eigen::Vector3d baselineInA = Eigen::Vector3d::UnitX();
    bool hasBaseline = true;    ///< False where the matches show a turn alone.
    double scale = 1;           ///< Of the residuals that agree: 1 if the matches' sigmas are right.
    std::vector<bool> isInlier; ///< One entry a bearing.
    int inliers = 0;
    int gated = 0;           ///< Number of bearings near enough to the rotation to be judged.
    double forwardShare = 0; ///< Share of the inliers with measurable parallax that lie in front.
    int measurable = 0;      ///< Number of inliers with measurable parallax.
    double parallaxRad = 0;  ///< Median over the inliers.
    Eigen::Matrix3d rotationCovariance = Eigen::Matrix3d::Zero(); ///< Of a small turn in a's frame, rad^2.
    double baselineSigmaRad = 0;
};

/// The rotation near this start, and the baseline, that put most bearings into one plane with the baseline.
/// Several directions of the baseline are tried; robust least squares refines the best. The fit has no
/// baseline where a turn alone explains as much: with two photos of one place any baseline fits.
EpipolarFit refineEpipolar(const Bearings& bearings, const Eigen::Matrix3d& start);

} // namespace spherewalk::align
