// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/dataset/world_file.h"
#include "spherewalk/geometry/angle.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::dataset {

namespace {

constexpr double kSideM = 0.05; ///< Thickness of an obstacle's sides, which lie inside of it.
constexpr double kRobotRadiusM = 0.15;
constexpr double kRobotHeightM = 0.2;
constexpr double kAboveFloorM = 0.01; ///< The robot slides and does not touch the floor.
constexpr double kLaserHeightM = 0.25;

/// The sides of an obstacle, along its edges.
void addSides(const WorldObstacle& obstacle, const std::string& name, double floorM,
              std::vector<WorldBox>& boxes) {
    const Polygon& outline = obstacle.outline;
    const double turn = signedArea(outline) > 0 ? 1 : -1;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Eigen::Vector2d along = outline[(i + 1) % outline.size()] - outline[i];
        const Eigen::Vector2d inwards = turn * Eigen::Vector2d(-along.y(), along.x()).normalized();
        const Eigen::Vector2d middle = outline[i] + along / 2 + kSideM / 2 * inwards;
        boxes.push_back({text(name, "_", i),
                         {middle.x(), middle.y(), floorM + obstacle.heightM / 2},
                         std::atan2(along.y(), along.x()),
                         {along.norm(), kSideM, obstacle.heightM}});
    }
}

/// All of the room.
std::vector<WorldBox> solidsOf(const WorldRoom& room) {
    std::vector<WorldBox> boxes = boxesOf(room);
    for (std::size_t i = 0; i < room.furniture.size(); ++i) {
        boxes.push_back({text("furniture_", i), room.furniture[i].center(), 0, room.furniture[i].sizes()});
    }
    for (std::size_t i = 0; i < room.obstacles.size() && !room.hasFurniture(); ++i) {
        addSides(room.obstacles[i], text("obstacle_", i), room.floorM, boxes);
    }
    return boxes;
}

std::string triple(const Eigen::Vector3d& values) {
    return text(values.x(), " ", values.y(), " ", values.z());
}

std::string mjcfRoom(const WorldRoom& room) {
    std::string geoms;
    for (const WorldBox& box : solidsOf(room)) {
        geoms += text("<geom class=\"room\" name=\"", box.name, "\" type=\"box\" pos=\"", triple(box.middle),
                      "\" euler=\"0 0 ", box.yaw, "\" size=\"", triple(box.sizeM / 2), "\"/>\n");
    }
    return geoms;
}

std::string mjcfRobot(const WorldRoom& room, const CameraIntrinsics& camera) {
    const Eigen::Vector3d& at = room.cameraAt;
    const double fovyDeg = Degrees(Radians(2 * std::atan2(camera.height / 2.0, camera.fy))).value();
    return text("<body name=\"robot\" pos=\"", at.x(), " ", at.y(), " ", room.floorM, "\">\n",
                "<joint name=\"x\" type=\"slide\" axis=\"1 0 0\"/>\n",
                "<joint name=\"y\" type=\"slide\" axis=\"0 1 0\"/>\n",
                "<joint name=\"yaw\" type=\"hinge\" axis=\"0 0 1\"/>\n",
                "<geom name=\"body\" type=\"cylinder\" pos=\"0 0 ", kAboveFloorM + kRobotHeightM / 2,
                "\" size=\"", kRobotRadiusM, " ", kRobotHeightM / 2, "\" mass=\"5\"/>\n",
                "<site name=\"laser\" pos=\"0 0 ", kLaserHeightM, "\"/>\n",
                "<camera name=\"camera\" pos=\"0 0 ", at.z() - room.floorM,
                "\" xyaxes=\"0 -1 0 0 0 1\" fovy=\"", fovyDeg, "\"/>\n</body>\n");
}

/// A collision of URDF and the same as its visual.
std::string urdfSolid(const std::string& name, const std::string& origin, const std::string& geometry) {
    std::string both;
    for (const char* kind : {"visual", "collision"}) {
        both += text("<", kind, " name=\"", name, "\">", origin, "<geometry>", geometry, "</geometry></",
                     kind, ">\n");
    }
    return both;
}

} // namespace

std::string mjcfWorld(const WorldRoom& room, const CameraIntrinsics& camera) {
    room.validate();
    camera.validate();
    if (camera.lens != LensModel::Pinhole) {
        throw Error(ErrorKind::Unsupported,
                    "MuJoCo's cameras do not distort as this lens does; make the world "
                    "for a camera without distortion.");
    }
    std::string actuators;
    for (const char* joint : {"x", "y", "yaw"}) {
        actuators += text("<velocity name=\"", joint, "\" joint=\"", joint, "\" kv=\"50\"/>\n");
    }
    return text("<mujoco model=\"", worldIdentifier(room.name), "\">\n<compiler angle=\"radian\"/>\n",
                "<statistic extent=\"1\"/>\n<visual><map znear=\"0.05\" zfar=\"100\"/></visual>\n",
                "<default><default class=\"room\"><geom group=\"", kRoomGroup,
                "\" rgba=\"0.8 0.8 0.78 1\"/></default></default>\n<worldbody>\n", "<light pos=\"",
                room.cameraAt.x(), " ", room.cameraAt.y(), " ", room.ceilingM - 0.1, "\"/>\n", mjcfRoom(room),
                mjcfRobot(room, camera), "</worldbody>\n<actuator>\n", actuators, "</actuator>\n</mujoco>\n");
}

std::string urdfRoom(const WorldRoom& room) {
    room.validate();
    std::string solids;
    for (const WorldBox& box : solidsOf(room)) {
        solids +=
            urdfSolid(box.name, text("<origin xyz=\"", triple(box.middle), "\" rpy=\"0 0 ", box.yaw, "\"/>"),
                      text("<box size=\"", triple(box.sizeM), "\"/>"));
    }
    // Readers drop a link without mass.
    return text("<?xml version=\"1.0\"?>\n<robot name=\"", worldIdentifier(room.name), "\">\n",
                "<link name=\"world\"/>\n<link name=\"room\">\n",
                "<inertial><mass value=\"1\"/><inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" "
                "izz=\"1\"/></inertial>\n",
                solids, "</link>\n<joint name=\"room_in_world\" type=\"fixed\"><parent link=\"world\"/>",
                "<child link=\"room\"/></joint>\n</robot>\n");
}

} // namespace spherewalk::dataset
