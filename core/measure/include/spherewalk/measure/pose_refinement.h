// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/measure/pose_fit.h"
#include "spherewalk/render/renderer.h"

#include <stop_token>

namespace spherewalk::measure {

struct PoseRefinementOptions {
    render::ViewOptions view; ///< how the picture is rendered that the robot's is compared with
    int rounds = 3;           ///< of rendering and matching, at most
    PoseFitOptions fit;
};

/// Where a robot's picture was taken, from an approximate pose some 10 cm and 5 degrees off: the dataset's
/// view from there is matched with the picture, the matches are put into the room by the view's depth, and
/// the pose is fitted to them; and again from the new pose, where view and picture are more alike. A picture
/// whose pose cannot be refined keeps the approximate one, and PoseFit::why says why. Errors: InvalidInput
/// for a picture that has not the camera's size; those of rendering. Stop: Error{Stopped}. Cost: 0.6 s for
/// 640 x 480.
PoseFit refinedPose(const render::Renderer& renderer, const CameraModel& camera, const RgbImage& picture,
                    const Rigid3& approximate, const PoseRefinementOptions& options = {},
                    const std::stop_token& stop = {});

/// The place in the room that a view shows at this pixel, by its depth; nothing where it has none or jumps.
std::optional<Eigen::Vector3d> placeShown(const DepthImage& depth, const CameraModel& camera,
                                          const Rigid3& roomFromCamera, const Eigen::Vector2d& pixel);

} // namespace spherewalk::measure
