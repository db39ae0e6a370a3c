// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "rotation_hypotheses.h"

#include <Eigen/Geometry>

#include <vector>

namespace spherewalk::align {

/// A rotation and a direction of the baseline that matches were fitted with.
struct EpipolarFit {
    Eigen::Matrix3d aFromB = Eigen::Matrix3d::Identity();
    Eigen::Vector3d baselineInA = Eigen::Vector3d::UnitX();
    bool hasBaseline = true;    ///< false: the matches show a turn alone
    double scale = 1;           ///< of the residuals of what agrees: 1 if the matches' sigmas are right
    std::vector<bool> isInlier; ///< one a bearing
    int inliers = 0;
    int gated = 0;           ///< bearings near enough to the rotation to be judged
    double forwardShare = 0; ///< of the inliers with measurable parallax, those in front
    int measurable = 0;      ///< inliers with measurable parallax
    double parallaxRad = 0;  ///< median over the inliers
    Eigen::Matrix3d rotationCovariance = Eigen::Matrix3d::Zero();
    double baselineSigmaRad = 0;
};

/// The rotation and the baseline near this rotation that most bearings lie in one plane with: several
/// directions of the baseline are tried, the best are refined by robust least squares.
EpipolarFit refineEpipolar(const Bearings& bearings, const Eigen::Matrix3d& start);

} // namespace spherewalk::align
