// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/dataset/world_file.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string_view>

namespace spherewalk::dataset {

namespace {

constexpr double kWallM = 0.1; ///< Thickness; walls stand outside of the room.
constexpr double kObjectM = 0.3;
constexpr double kNearestObjectM = 0.6; ///< From the camera.

std::string tag(std::string_view name, const std::string& content) {
    return text("<", name, ">", content, "</", name, ">\n");
}

std::string pose(double x, double y, double z, double yaw = 0) {
    return tag("pose", text(x, " ", y, " ", z, " 0 0 ", yaw));
}

std::string system(std::string_view library, std::string_view type, const std::string& content = "") {
    return text("<plugin filename=\"ignition-gazebo-", library,
                "-system\" name=\"ignition::gazebo::systems::", type, "\">", content, "</plugin>\n");
}

std::string label(int number) {
    return system("label", "Label", tag("label", std::to_string(number)));
}

std::string box(double x, double y, double z) {
    return tag("geometry", tag("box", tag("size", text(x, " ", y, " ", z))));
}

/// An upright prism on the floor of its frame.
std::string prism(const Polygon& outline, double heightM) {
    std::string points;
    for (const Eigen::Vector2d& corner : outline) {
        points += tag("point", text(corner.x(), " ", corner.y()));
    }
    return tag("geometry", tag("polyline", points + tag("height", text(heightM))));
}

std::string material(double red, double green, double blue) {
    const std::string colour = text(red, " ", green, " ", blue, " 1");
    return tag("material", tag("ambient", colour) + tag("diffuse", colour));
}

/// A collision, which stops things and lasers, and its visual, which cameras of this visibility see.
std::string solid(std::string_view name, const std::string& place, const std::string& geometry,
                  unsigned visibility, const std::string& look) {
    return text("<collision name=\"", name, "\">\n", place, geometry, "</collision>\n<visual name=\"", name,
                "\">\n", place, geometry, tag("visibility_flags", std::to_string(visibility)), look,
                "</visual>\n");
}

std::string surface(std::string_view name, const std::string& place, const std::string& geometry) {
    return solid(name, place, geometry, kHiddenFromCamera, material(0.8, 0.8, 0.78));
}

/// The wall outside of an edge of an outline that runs counter-clockwise. At a corner that turns left, the
/// wall is longer by its thickness, so that no gap stays.
WorldBox wall(const WorldRoom& room, const Polygon& outline, std::size_t i) {
    const auto corner = [&](std::size_t k) { return outline[k % outline.size()]; };
    const auto turnsLeft = [&](std::size_t k) {
        const Eigen::Vector2d before = corner(k) - corner(k + outline.size() - 1);
        const Eigen::Vector2d after = corner(k + 1) - corner(k);
        return before.x() * after.y() - before.y() * after.x() > 0;
    };
    const Eigen::Vector2d along = (corner(i + 1) - corner(i)).normalized();
    const Eigen::Vector2d outwards(along.y(), -along.x());
    const Eigen::Vector2d begin = corner(i) - (turnsLeft(i) ? kWallM : 0) * along;
    const Eigen::Vector2d end = corner(i + 1) + (turnsLeft(i + 1) ? kWallM : 0) * along;
    const Eigen::Vector2d middle = (begin + end) / 2 + kWallM / 2 * outwards;
    const double height = room.ceilingM - room.floorM;
    return {text("wall_", i),
            {middle.x(), middle.y(), room.floorM + height / 2},
            std::atan2(along.y(), along.x()),
            {(end - begin).norm(), kWallM, height}};
}

std::string roomModel(const WorldRoom& room) {
    std::string surfaces;
    for (const WorldBox& one : boxesOf(room)) {
        surfaces += surface(one.name, pose(one.middle.x(), one.middle.y(), one.middle.z(), one.yaw),
                            box(one.sizeM.x(), one.sizeM.y(), one.sizeM.z()));
    }
    if (!room.furnitureMesh.empty()) {
        surfaces +=
            surface("furniture", pose(0, 0, 0), tag("geometry", tag("mesh", tag("uri", kFurnitureFile))));
    }
    for (std::size_t i = 0; i < room.obstacles.size() && !room.hasFurniture(); ++i) {
        surfaces += surface(text("obstacle_", i), pose(0, 0, room.floorM),
                            prism(room.obstacles[i].outline, room.obstacles[i].heightM));
    }
    return text("<!-- The room as physics and lasers know it. Cameras with visibility_mask ", kSeenByCamera,
                " do not see it: they show the photos. -->\n<model name=\"room\">\n", tag("static", "true"),
                label(kRoomLabel), "<link name=\"surfaces\">\n", surfaces, "</link>\n</model>\n");
}

/// Gazebo counts the principal point from the corner of the first pixel.
std::string lens(const CameraIntrinsics& camera) {
    return tag("lens",
               tag("intrinsics", text("<fx>", camera.fx, "</fx><fy>", camera.fy, "</fy><cx>", camera.cx + 0.5,
                                      "</cx><cy>", camera.cy + 0.5, "</cy><s>0</s>")));
}

std::string sensor(std::string_view name, std::string_view type, const CameraIntrinsics& camera,
                   std::string_view format, const std::string& topic, const std::string& extra) {
    const double horizontalFov = 2 * std::atan2(camera.width, 2 * camera.fx);
    return text("<sensor name=\"", name, "\" type=\"", type, "\">\n",
                "<always_on>1</always_on><update_rate>30</update_rate>\n", tag("topic", topic),
                "<camera name=\"", name, "\">\n", tag("horizontal_fov", text(horizontalFov)),
                "<image><width>", camera.width, "</width><height>", camera.height, "</height><format>",
                format, "</format></image>\n<clip><near>0.05</near><far>100</far></clip>\n", extra,
                lens(camera), "</camera>\n</sensor>\n");
}

std::string overlaySensors(const CameraIntrinsics& camera) {
    return text("<!-- What the overlay is made from: at the same place, with the same pixels. Depth and\n"
                "     segmentation cameras do not obey a visibility_mask, so the labels tell the room. -->\n",
                sensor("overlay_colour", "camera", camera, "R8G8B8", "robot/overlay_colour/image",
                       tag("visibility_mask", std::to_string(kSeenByCamera))),
                sensor("overlay_depth", "depth_camera", camera, "R_FLOAT32", "robot/overlay_depth/image", ""),
                sensor("overlay_labels", "segmentation", camera, "R8G8B8", "robot/overlay_labels",
                       tag("segmentation_type", "semantic")));
}

std::string lidar() {
    return "<sensor name=\"lidar\" type=\"gpu_lidar\">\n"
           "<pose>0 0 0.25 0 0 0</pose>\n"
           "<always_on>1</always_on><update_rate>10</update_rate><topic>robot/lidar</topic>\n"
           "<lidar><scan><horizontal><samples>360</samples><min_angle>-3.14159</min_angle>"
           "<max_angle>3.14159</max_angle></horizontal></scan>\n"
           "<range><min>0.1</min><max>30</max></range></lidar>\n"
           "</sensor>\n";
}

std::string inertia(double massKg) {
    const std::string moment = text(massKg * 0.02);
    return tag("inertial", tag("mass", text(massKg)) +
                               tag("inertia", tag("ixx", moment) + tag("iyy", moment) + tag("izz", moment)));
}

/// The robot's camera inside of Gazebo, on the topics that the process beside it has in the guide.
std::string cameraPlugin(const std::string& dataset) {
    if (dataset.empty()) {
        return {};
    }
    if (dataset.find_first_of("<>&") != std::string::npos) {
        throw Error(ErrorKind::InvalidInput,
                    text("The world cannot name the dataset ", printable(dataset),
                         ": its path has one of the letters < > &. Give its folder another name."));
    }
    return text("<plugin filename=\"spherewalk-gz-system\" name=\"spherewalk::gazebo::CameraSystem\">\n",
                tag("dataset", dataset), tag("camera", "camera.yaml"), tag("frame", "camera"),
                tag("image", "/robot/front/image"), tag("overlay_colour", "/robot/overlay_colour/image"),
                tag("overlay_depth", "/robot/overlay_depth/image"),
                tag("overlay_labels", "/robot/overlay_labels/labels_map"), "</plugin>\n");
}

std::string robotModel(const WorldRoom& room, const CameraIntrinsics& camera) {
    const Eigen::Vector3d& at = room.cameraAt;
    const std::string body =
        solid("body", pose(0, 0, 0.1),
              tag("geometry", tag("cylinder", tag("radius", text(0.15)) + tag("length", text(0.2)))),
              kHiddenFromCamera, material(0.2, 0.3, 0.5));
    const std::string poses =
        "<publish_link_pose>true</publish_link_pose><publish_model_pose>true</publish_model_pose>"
        "<publish_nested_model_pose>true</publish_nested_model_pose>"
        "<use_pose_vector_msg>true</use_pose_vector_msg><update_frequency>-1</update_frequency>";
    return text(
        "<!-- Drives by /model/robot/cmd_vel; says at each step where it is on /model/robot/pose. -->\n"
        "<model name=\"robot\">\n",
        pose(at.x(), at.y(), room.floorM), label(kRoomLabel), system("velocity-control", "VelocityControl"),
        system("pose-publisher", "PosePublisher", poses), cameraPlugin(room.pluginDataset),
        "<link name=\"base\">\n", inertia(5), body, lidar(), "</link>\n<link name=\"camera\">\n",
        pose(0, 0, at.z() - room.floorM), inertia(0.1), overlaySensors(camera),
        "</link>\n<joint name=\"mast\" type=\"fixed\"><parent>base</parent><child>camera</child></joint>\n"
        "</model>\n");
}

/// Whether the object can stand this far before the camera, and nothing stands between.
bool isFreeAhead(const WorldRoom& room, double distanceM) {
    constexpr double kSightM = 0.05;
    const Eigen::Vector2d from = room.cameraAt.head<2>();
    const Eigen::Vector2d at = from + Eigen::Vector2d(distanceM, 0);
    const auto isClear = [&](const Polygon& edges) {
        return distanceToEdge(edges, at) >= kObjectM && distanceToEdge(edges, from, at) >= kSightM;
    };
    return contains(room.outline, at) && isClear(room.outline) &&
           std::all_of(room.obstacles.begin(), room.obstacles.end(), [&](const WorldObstacle& obstacle) {
               return !contains(obstacle.outline, at) && isClear(obstacle.outline);
           });
}

/// An object before the camera: as near as the camera sees its foot, or as far as there is room.
std::string objectModel(const WorldRoom& room, const CameraIntrinsics& camera) {
    constexpr double kStepM = 0.05;
    const double lensHeightM = room.cameraAt.z() - room.floorM;
    const double fallPerM = std::max((camera.height - 1 - camera.cy) / camera.fy, 0.01);
    double distanceM = lensHeightM / fallPerM + kObjectM;
    while (distanceM > kNearestObjectM && !isFreeAhead(room, distanceM)) {
        distanceM -= kStepM;
    }
    distanceM = std::max(distanceM, kNearestObjectM);
    const double unseenM = std::max(lensHeightM - fallPerM * (distanceM - kObjectM / 2), 0.0);
    const double heightM = std::min(unseenM + kObjectM, room.ceilingM - room.floorM);
    return text("<!-- An object that the camera sees; your own get a label of their own, not ", kRoomLabel,
                ". -->\n<model name=\"parcel\">\n",
                pose(room.cameraAt.x() + distanceM, room.cameraAt.y(), room.floorM + heightM / 2),
                label(kObjectLabel), "<link name=\"box\">\n", inertia(1),
                solid("box", "", box(kObjectM, kObjectM, heightM), kSeenByCamera, material(0.8, 0.5, 0.2)),
                "</link>\n</model>\n");
}

void validateObstacles(const std::vector<WorldObstacle>& obstacles) {
    for (std::size_t i = 0; i < obstacles.size(); ++i) {
        if (const auto why = defect(obstacles[i].outline)) {
            throw Error(ErrorKind::InvalidInput, text("A world cannot be made of this room: of its obstacle ",
                                                      i + 1, ", ", *why, "."));
        }
        if (!std::isfinite(obstacles[i].heightM) || !(obstacles[i].heightM > 0)) {
            throw Error(ErrorKind::InvalidInput,
                        text("A world cannot be made with an obstacle ", obstacles[i].heightM,
                             " m high; obstacles are higher than 0 m."));
        }
    }
}

} // namespace

void WorldRoom::validate() const {
    if (const auto why = defect(outline)) {
        throw Error(ErrorKind::InvalidInput,
                    text("A world cannot be made of this room: of its outline, ", *why, "."));
    }
    if (!std::isfinite(floorM) || !std::isfinite(ceilingM) || !(ceilingM > floorM)) {
        throw Error(ErrorKind::InvalidInput, text("A world cannot be made of a room from ", floorM, " to ",
                                                  ceilingM, " m; its ceiling must be above its floor."));
    }
    if (!cameraAt.allFinite() || !(cameraAt.z() > floorM && cameraAt.z() < ceilingM) ||
        !contains(outline, cameraAt.head<2>())) {
        throw Error(ErrorKind::InvalidInput,
                    text("The robot's camera cannot begin at x ", cameraAt.x(), ", y ", cameraAt.y(), ", z ",
                         cameraAt.z(), ", which is not inside of the room."));
    }
    validateObstacles(obstacles);
}

std::vector<WorldBox> boxesOf(const WorldRoom& room) {
    Polygon outline = room.outline;
    if (signedArea(outline) < 0) {
        std::reverse(outline.begin(), outline.end());
    }
    const Bounds2 around = bounds(outline);
    const Eigen::Vector2d middle = (around.least + around.greatest) / 2;
    const Eigen::Vector2d size = around.greatest - around.least;
    std::vector<WorldBox> boxes;
    for (const auto& [name, z] :
         {std::pair{"floor", room.floorM - kWallM / 2}, {"ceiling", room.ceilingM + kWallM / 2}}) {
        boxes.push_back({name, {middle.x(), middle.y(), z}, 0, {size.x(), size.y(), kWallM}});
    }
    for (std::size_t i = 0; i < outline.size(); ++i) {
        boxes.push_back(wall(room, outline, i));
    }
    return boxes;
}

std::string worldIdentifier(std::string_view name) {
    std::string result;
    for (const char c : name) {
        const bool isKept = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_';
        result += isKept ? c : '_';
    }
    return result.empty() ? "room" : result;
}

std::string sdfWorld(const WorldRoom& room, const CameraIntrinsics& camera) {
    room.validate();
    camera.validate();
    if (camera.lens != LensModel::Pinhole) {
        throw Error(ErrorKind::Unsupported,
                    "Gazebo's cameras do not distort as this lens does; make the world for a camera without "
                    "distortion, and give it to spherewalk-gz as --overlay-camera.");
    }
    const Eigen::Vector3d& at = room.cameraAt;
    return text("<?xml version=\"1.0\"?>\n<sdf version=\"1.9\">\n<world name=\"", worldIdentifier(room.name),
                "\">\n",
                "<physics name=\"steps\" type=\"ignored\"><max_step_size>0.001</max_step_size>"
                "<real_time_factor>1</real_time_factor></physics>\n",
                system("physics", "Physics"), system("user-commands", "UserCommands"),
                system("scene-broadcaster", "SceneBroadcaster"),
                system("sensors", "Sensors", tag("render_engine", "ogre2")),
                "<light name=\"lamp\" type=\"point\">\n", pose(at.x(), at.y(), room.ceilingM - 0.1),
                "<diffuse>0.9 0.9 0.9 1</diffuse><specular>0.1 0.1 0.1 1</specular>\n"
                "<attenuation><range>50</range><constant>0.6</constant><linear>0.02</linear>"
                "<quadratic>0</quadratic></attenuation>\n</light>\n",
                roomModel(room), robotModel(room, camera), objectModel(room, camera), "</world>\n</sdf>\n");
}

} // namespace spherewalk::dataset
