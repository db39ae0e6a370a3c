// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/angle.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/rigid3.h"

#include <Eigen/Core>

#include <cstddef>
#include <span>
#include <string>

namespace spherewalk::measure {

/// A thing whose place is known, and where a picture has it.
struct SeenPoint {
    Eigen::Vector3d pInRoom;
    Eigen::Vector2d pixel;
};

struct PoseFitOptions {
    double largestMoveM = 0.5;         ///< from the approximate pose
    Radians largestTurn = Degrees(20); ///< likewise
    std::size_t fewest = 12;           ///< points that must agree
    double leastShare = 0.2;           ///< of all points, that must agree
    double largestSigmaM = 0.05;       ///< of the position, or the pose is not determined
    Radians largestSigma = Degrees(1); ///< of the rotation
};

/// Where a picture was taken.
struct PoseFit {
    bool isFitted = false;
    std::string why;       ///< a sentence, if not fitted
    Rigid3 roomFromCamera; ///< the approximate pose, if not fitted
    std::size_t points = 0;
    std::size_t inliers = 0; ///< that agree on the pose
    double residualPx = 0;   ///< root mean square of the inliers' reprojection errors along an axis
    /// Standard deviations along the worst direction and about the worst axis; points close together count as
    /// a few only, since what is wrong with them is alike.
    double sigmaPositionM = 0;
    Radians sigmaRotation;
};

/// The pose that most points agree on: RANSAC over poses from three points each, then least squares of the
/// reprojection errors with a robust loss. Wrong points are left out; points that are too few, contradict
/// each other, or lie so that they do not tell where the camera is, give no pose but a sentence. The same
/// input gives the same result. roomFromCamera: of the optical frame. Errors: InvalidInput for a pose that is
/// not finite. Source: Gao 2003 (P3P); Fischler and Bolles 1981.
PoseFit fittedPose(std::span<const SeenPoint> points, const CameraModel& camera, const Rigid3& approximate,
                   const PoseFitOptions& options = {});

} // namespace spherewalk::measure
