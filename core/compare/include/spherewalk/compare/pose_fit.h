// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/angle.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/renderer.h"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <span>
#include <stop_token>
#include <string>

namespace spherewalk::compare {

/// A point of known place, and the pixel at which a picture shows it.
struct SeenPoint {
    Eigen::Vector3d pInRoom;
    Eigen::Vector2d pixel;
};

struct PoseFitOptions {
    double largestMoveM = 0.5;         ///< Largest distance from the approximate pose.
    Radians largestTurn = Degrees(20); ///< Largest angle to the approximate pose.
    std::size_t fewest = 12;           ///< Fewest points that must agree on a pose.
    double leastShare = 0.2;           ///< Least share of all points that must agree.
    double largestSigmaM = 0.05;       ///< Beyond this, the points do not determine the position.
    Radians largestSigma = Degrees(1); ///< Beyond this, the points do not determine the rotation.
};

/// The pose at which a picture was taken.
struct PoseFit {
    bool isFitted = false;
    std::string why;         ///< If nothing was fitted, a sentence that says why.
    Rigid3 roomFromCamera;   ///< If nothing was fitted, the approximate pose. Frames: optical.
    std::size_t points = 0;  ///< Number of points that were given.
    std::size_t inliers = 0; ///< Number of points that agree on the pose.
    double residualPx = 0;   ///< Root mean square of the inliers' reprojection errors along an axis.
    /// Standard deviation of the position along the worst direction. Points close together count as a few
    /// only, because their errors are alike.
    double sigmaPositionM = 0;
    Radians sigmaRotation; ///< Standard deviation of the rotation about the worst axis, likewise.
};

/// The pose that most points agree on: RANSAC over poses from three points each, then least squares of the
/// reprojection errors with a robust loss. Wrong points are left out. Without a pose, PoseFit::why tells the
/// reason: too few points, contradictions, or a layout that does not determine the pose. The same input gives
/// the same result. Frames: approximate is the optical frame in the room. Errors: InvalidInput for a pose
/// that is not finite. Source: Gao 2003 (P3P); Fischler and Bolles 1981.
PoseFit fittedPose(std::span<const SeenPoint> points, const CameraModel& camera, const Rigid3& approximate,
                   const PoseFitOptions& options = {});

struct PoseRefinementOptions {
    render::ViewOptions view; ///< The options of the views that are compared with the picture.
    int rounds = 3;           ///< Most rounds of rendering and matching.
    PoseFitOptions fit;
};

/// The pose of a robot's picture, from an approximate pose some 10 cm and 5 degrees off. Each round matches
/// the picture with the dataset's view, places the matches in the room by the view's depth, and fits the pose
/// to them. If this fails, PoseFit::why says why. Errors: InvalidInput if the picture has another size than
/// the camera; those of rendering. Stop: between rounds. Cost: 0.6 s for 640 x 480.
PoseFit refinedPose(const render::Renderer& renderer, const CameraModel& camera, const RgbImage& picture,
                    const Rigid3& approximate, const PoseRefinementOptions& options = {},
                    const std::stop_token& stop = {});

/// The place in the room that a view shows at this pixel, by its depth. Nothing where the view has no depth,
/// or where the depth jumps.
std::optional<Eigen::Vector3d> placeShown(const DepthImage& depth, const CameraModel& camera,
                                          const Rigid3& roomFromCamera, const Eigen::Vector2d& pixel);

} // namespace spherewalk::compare
