// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/polygon.h"

#include <Eigen/Geometry>

#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::dataset {

/// Labels and visibility of an exported world; resources/docs/guide/gazebo.md says who sees what.
inline constexpr int kRoomLabel = 1;
inline constexpr int kObjectLabel = 10;
inline constexpr unsigned kSeenByCamera = 0x1; ///< The colour camera's visibility_mask.
inline constexpr unsigned kHiddenFromCamera = 0x2;

/// A thing on the floor that robots and lasers cannot pass, upright from the floor to its height.
struct WorldObstacle {
    Polygon outline;
    double heightM = 0;
};

/// A room for a simulator. Frames: the room is the world.
struct WorldRoom {
    std::string name;
    Polygon outline;
    double floorM = 0;
    double ceilingM = 0;
    Eigen::Vector3d cameraAt =
        Eigen::Vector3d::Zero(); ///< First place of the robot's camera, which looks along x.
    std::vector<WorldObstacle> obstacles;
    /// All that stands in the room, as boxes, and as a mesh (Wavefront OBJ, frame: room), which worlds for
    /// Gazebo have. Where either is known, furniture takes the place of the obstacles, which still say where
    /// the robot cannot begin.
    std::vector<Eigen::AlignedBox3d> furniture = {};
    std::string furnitureMesh = {};
    /// The dataset that the robot's camera shows by a plugin of Gazebo, as seen from the world's folder.
    /// Empty: a process beside Gazebo shows it.
    std::string pluginDataset = {};

    bool hasFurniture() const { return !furniture.empty() || !furnitureMesh.empty(); }

    /// Errors: InvalidInput for a defect of an outline, a ceiling that is not above the floor, an obstacle
    /// without height, and a camera that is not inside of the room.
    void validate() const;
};

/// A wall, the floor or the ceiling. Frames: room; its length lies along x, turned by yaw about z.
struct WorldBox {
    std::string name;
    Eigen::Vector3d middle;
    double yaw = 0;
    Eigen::Vector3d sizeM;
};

/// Floor, ceiling and walls, which lie outside of the room and leave no gap. Range: a valid room.
std::vector<WorldBox> boxesOf(const WorldRoom& room);

/// The file beside the world that the world takes its furniture's mesh from.
inline constexpr const char* kFurnitureFile = "furniture.obj";

/// A name of letters, digits, - and _ only.
std::string worldIdentifier(std::string_view name);

/// The world as SDF 1.9 for Gazebo Fortress. Walls, floor, ceiling and obstacles stop things and lasers; the
/// camera does not see them. A robot carries a laser and the cameras that overlays are made from. One object
/// stands before the camera where the camera sees it, high enough where the room is too small for a low one.
/// Errors: those of WorldRoom::validate(); Unsupported for a camera with distortion; InvalidInput for a
/// dataset whose path has letters that XML gives a meaning.
std::string sdfWorld(const WorldRoom& room, const CameraIntrinsics& camera);

/// The world as MJCF for MuJoCo. Floor, ceiling, walls and furniture are boxes, and so are the sides of
/// obstacles where there is no furniture; all are in kRoomGroup. A robot slides along x and y and turns, each
/// by a velocity actuator. It carries the camera, which looks along x, and the site of a laser. Errors: those
/// of WorldRoom::validate(); Unsupported for a camera with distortion.
std::string mjcfWorld(const WorldRoom& room, const CameraIntrinsics& camera);

/// The group of MuJoCo's geoms that is the room.
inline constexpr int kRoomGroup = 3;

/// The room as URDF, without a robot: one link, fixed in the world. Errors: those of WorldRoom::validate().
std::string urdfRoom(const WorldRoom& room);

} // namespace spherewalk::dataset
