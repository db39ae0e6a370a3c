// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/render/dataset_format.h"

#include <Eigen/Core>

#include <string>

namespace mujoco_example {

/// The group of geoms that stand for what the photos show: there for collisions and rays, hidden from the
/// camera.
constexpr int kRoomGroup = 3;
/// The group of what of that lies level, and the ball's shadow falls on.
constexpr int kGroundGroup = 4;

/// What is in the room besides what the photos show. Frames: the room's, which is MuJoCo's world.
struct WorldOptions {
    Eigen::Vector2d startM = Eigen::Vector2d::Zero(); ///< of the robot
    double startYawRad = 0;
    double lensHeightM = 1.2;
    Eigen::Vector3d ballM = Eigen::Vector3d::Zero(); ///< its centre
    double ballRadiusM = 0.25;
    double tableM = 0; ///< The height of a table below the ball, which photos show; 0 for none.
};

/// A world (MJCF) with the dataset's walls and obstacles in kRoomGroup, floor and table in kGroundGroup, a
/// ball, and a robot on two driven wheels with a camera of this size and vertical field of view. The names of
/// its parts: robot, left, right, eyes, ball. Errors: spherewalk::Error for a dataset without an outline.
std::string roomWorld(const spherewalk::render::DatasetInfo& dataset,
                      const spherewalk::CameraIntrinsics& eyes, const WorldOptions& options);

} // namespace mujoco_example
