// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/polygon.h"

#include <Eigen/Core>

#include <string>

namespace spherewalk::dataset {

/// Labels and visibility of an exported world; resources/docs/guide/gazebo.md says who sees what.
inline constexpr int kRoomLabel = 1;
inline constexpr int kObjectLabel = 10;
inline constexpr unsigned kSeenByCamera = 0x1; ///< the colour camera's visibility_mask
inline constexpr unsigned kHiddenFromCamera = 0x2;

/// A room for a simulator. Frames: the room is the world.
struct WorldRoom {
    std::string name;
    Polygon outline;
    double floorM = 0;
    double ceilingM = 0;
    Eigen::Vector3d cameraAt = Eigen::Vector3d::Zero(); ///< where the robot's camera begins, looking along x

    /// Errors: InvalidInput with a sentence for an outline that is none, a ceiling that is not above the
    /// floor, and a camera that is not between them or not inside of the outline.
    void validate() const;
};

/// The world as SDF 1.9, for Gazebo Fortress: the room's walls, floor and ceiling, which stop things and
/// which lasers see, but not the camera; a robot with the cameras that an overlay is made from, and a laser;
/// an object that the camera sees. camera: without distortion. Errors: those of WorldRoom::validate();
/// Unsupported for a camera with distortion, which Gazebo's cameras do not have as lenses do.
std::string sdfWorld(const WorldRoom& room, const CameraIntrinsics& camera);

} // namespace spherewalk::dataset
