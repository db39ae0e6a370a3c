// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"

#include "spherewalk/dataset/world_file.h"
#include "spherewalk/render/scene_depth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ignition/math/AxisAlignedBox.hh>
#include <limits>
#include <numbers>
#include <sdf/sdf.hh>
#include <tuple>

namespace spherewalk::dataset {
namespace {

namespace im = ignition::math;
using test::expectError;

/// A room with a corner that points inwards.
WorldRoom roomWithACorner() {
    return {"Anna's <kitchen>", {{0, 0}, {5, 0}, {5, 2}, {2, 2}, {2, 4}, {0, 4}}, 0, 2.5, {1, 1, 1.2}, {}};
}

CameraIntrinsics vga() {
    return {640, 480, 465.5, 466, 318.25, 240.5, LensModel::Pinhole, {}};
}

class WorldFile : public testing::Test {
  protected:
    explicit WorldFile(WorldRoom of = roomWithACorner()) : room(std::move(of)) {
        const sdf::Errors errors = root.LoadSdfString(sdfWorld(room, vga()));
        for (const sdf::Error& error : errors) {
            ADD_FAILURE() << error.Message();
        }
        world = root.WorldByIndex(0);
    }

    const sdf::Link* surfaces() const { return world->ModelByName("room")->LinkByName("surfaces"); }

    const sdf::Link* cameraLink() const { return world->ModelByName("robot")->LinkByName("camera"); }

    /// How far a ray goes to the nearest collision of the room; infinity if it leaves.
    double distance(const Eigen::Vector3d& from, const Eigen::Vector3d& direction) const {
        double nearest = std::numeric_limits<double>::infinity();
        for (std::uint64_t i = 0; i < surfaces()->CollisionCount(); ++i) {
            const sdf::Collision* collision = surfaces()->CollisionByIndex(i);
            const im::Vector3d half = collision->Geom()->BoxShape()->Size() / 2;
            const im::Pose3d boxFromWorld = collision->RawPose().Inverse();
            const im::Vector3d origin = boxFromWorld.CoordPositionAdd({from.x(), from.y(), from.z()});
            const im::Vector3d along =
                boxFromWorld.Rot().RotateVector({direction.x(), direction.y(), direction.z()});
            const auto [isHit, reach] = im::AxisAlignedBox(-half, half).IntersectDist(origin, along, 0, 100);
            nearest = isHit ? std::min(nearest, reach) : nearest;
        }
        return nearest;
    }

    static int labelOf(const sdf::Model* model) {
        for (sdf::ElementPtr plugin = model->Element()->GetElement("plugin"); plugin;
             plugin = plugin->GetNextElement("plugin")) {
            if (plugin->Get<std::string>("name") == "ignition::gazebo::systems::Label") {
                return plugin->Get<int>("label");
            }
        }
        return -1;
    }

    WorldRoom room;
    sdf::Root root;
    const sdf::World* world = nullptr;
};

TEST_F(WorldFile, ThePluginIsTheRobotsCameraIfOneIsWanted) {
    const auto plugin = [](const sdf::ElementPtr& model) {
        sdf::ElementPtr found = model->GetElement("plugin");
        while (found && found->Get<std::string>("filename") != "spherewalk-gz-system") {
            found = found->GetNextElement("plugin");
        }
        return found;
    };
    EXPECT_EQ(plugin(world->ModelByName("robot")->Element()), nullptr);
    room.pluginDataset = "../my dataset";
    sdf::Root with;
    EXPECT_TRUE(with.LoadSdfString(sdfWorld(room, vga())).empty());
    const sdf::Model* robot = with.WorldByIndex(0)->ModelByName("robot");
    const sdf::ElementPtr camera = plugin(robot->Element());
    ASSERT_NE(camera, nullptr);
    EXPECT_EQ(camera->Get<std::string>("name"), "spherewalk::gazebo::CameraSystem");
    EXPECT_EQ(camera->Get<std::string>("dataset"), "../my dataset");
    EXPECT_NE(robot->LinkByName(camera->Get<std::string>("frame")), nullptr);
    room.pluginDataset = "a&b";
    expectError(ErrorKind::InvalidInput, "another name", [&] { sdfWorld(room, vga()); });
}

TEST_F(WorldFile, RaysMeetWallsFloorAndCeilingWhereTheRoomHasThem) {
    const render::RoomShape shape{room.outline, room.floorM, room.ceilingM};
    for (const Eigen::Vector3d& from : {Eigen::Vector3d(1, 1, 1.2), Eigen::Vector3d(4, 1.9, 0.3)}) {
        for (int azimuth = 0; azimuth < 360; ++azimuth) {
            for (const double rise : {-1.5, -0.3, 0.0, 0.2, 2.0}) {
                const double angle = (azimuth + 0.3) * std::numbers::pi / 180;
                const Eigen::Vector3d direction =
                    Eigen::Vector3d(std::cos(angle), std::sin(angle), rise).normalized();
                ASSERT_NEAR(distance(from, direction), 1 / render::inverseDistance(shape, from, direction),
                            1e-9)
                    << azimuth << " " << rise;
            }
        }
    }
}

TEST_F(WorldFile, WhatStopsThingsIsWhatLasersSee) {
    ASSERT_EQ(surfaces()->CollisionCount(), surfaces()->VisualCount());
    EXPECT_EQ(surfaces()->CollisionCount(), room.outline.size() + 2);
    for (std::uint64_t i = 0; i < surfaces()->CollisionCount(); ++i) {
        const sdf::Collision* collision = surfaces()->CollisionByIndex(i);
        const sdf::Visual* visual = surfaces()->VisualByName(collision->Name());
        ASSERT_NE(visual, nullptr);
        EXPECT_EQ(visual->RawPose(), collision->RawPose());
        EXPECT_EQ(visual->Geom()->BoxShape()->Size(), collision->Geom()->BoxShape()->Size());
    }
    EXPECT_TRUE(world->ModelByName("room")->Static());
}

TEST_F(WorldFile, TheCameraSeesObjectsAndNotTheRoom) {
    const std::uint32_t mask = cameraLink()->SensorByName("overlay_colour")->CameraSensor()->VisibilityMask();
    for (std::uint64_t i = 0; i < surfaces()->VisualCount(); ++i) {
        EXPECT_EQ(surfaces()->VisualByIndex(i)->VisibilityFlags() & mask, 0U);
    }
    const sdf::Link* box = world->ModelByName("parcel")->LinkByName("box");
    EXPECT_NE(box->VisualByIndex(0)->VisibilityFlags() & mask, 0U);
    EXPECT_NE(sdf::Visual().VisibilityFlags() & mask, 0U); // what a user adds without saying anything
    EXPECT_EQ(labelOf(world->ModelByName("room")), kRoomLabel);
    EXPECT_EQ(labelOf(world->ModelByName("parcel")), kObjectLabel);
    EXPECT_EQ(labelOf(world->ModelByName("robot")), kRoomLabel); // whose own parts show the photo
}

TEST_F(WorldFile, ItsCamerasAreTheRobotsAndStandWhereThePhotosWereTaken) {
    for (const char* name : {"overlay_colour", "overlay_depth", "overlay_labels"}) {
        const sdf::Sensor* sensor = cameraLink()->SensorByName(name);
        ASSERT_NE(sensor, nullptr) << name;
        EXPECT_EQ(sensor->UpdateRate(), 30);
        EXPECT_EQ(sensor->RawPose(), im::Pose3d::Zero);
        const sdf::Camera* camera = sensor->CameraSensor();
        EXPECT_EQ(camera->ImageWidth(), 640U);
        EXPECT_EQ(camera->ImageHeight(), 480U);
        EXPECT_EQ(camera->LensIntrinsicsFx(), 465.5);
        EXPECT_EQ(camera->LensIntrinsicsFy(), 466);
        EXPECT_EQ(camera->LensIntrinsicsCx(), 318.75); // from the corner of the first pixel
        EXPECT_EQ(camera->LensIntrinsicsCy(), 241);
        EXPECT_NEAR(std::tan(camera->HorizontalFov().Radian() / 2), 320 / 465.5, 1e-9);
        const std::string topic = sensor->Topic(); // a copy, so that both iterators are of one string
        EXPECT_GE(std::count(topic.begin(), topic.end(), '/'), 1) << topic;
    }
    const im::Vector3d at = world->ModelByName("robot")->RawPose().Pos() + cameraLink()->RawPose().Pos();
    EXPECT_EQ(at, im::Vector3d(1, 1, 1.2));
    const sdf::Sensor* lidar = world->ModelByName("robot")->LinkByName("base")->SensorByName("lidar");
    ASSERT_NE(lidar, nullptr);
    EXPECT_EQ(lidar->LidarSensor()->HorizontalScanSamples(), 360U);
}

TEST_F(WorldFile, ItsNameIsOneThatTopicsCanHave) {
    EXPECT_EQ(world->Name(), "Anna_s__kitchen_");
}

/// The same outline the other way round, on a platform.
class TurnedWorldFile : public WorldFile {
  protected:
    TurnedWorldFile() : WorldFile(turned()) {}

    static WorldRoom turned() {
        WorldRoom room = roomWithACorner();
        std::reverse(room.outline.begin(), room.outline.end());
        room.floorM = 0.5;
        return room;
    }
};

TEST_F(TurnedWorldFile, HasItsWallsOutsideToo) {
    const render::RoomShape shape{room.outline, room.floorM, room.ceilingM};
    for (int azimuth = 0; azimuth < 360; ++azimuth) {
        const double angle = (azimuth + 0.3) * std::numbers::pi / 180;
        const Eigen::Vector3d direction(std::cos(angle), std::sin(angle), 0);
        ASSERT_NEAR(distance(room.cameraAt, direction),
                    1 / render::inverseDistance(shape, room.cameraAt, direction), 1e-9);
    }
}

/// The room with a table, and a cupboard around a corner.
class FurnishedWorldFile : public WorldFile {
  protected:
    FurnishedWorldFile() : WorldFile(furnished()) {}

    static WorldRoom furnished() {
        WorldRoom room = roomWithACorner();
        room.floorM = 0.1;
        room.obstacles = {{{{3, 0.5}, {4, 0.5}, {4, 1.5}, {3, 1.5}}, 0.75},
                          {{{0.2, 3}, {1, 3}, {1, 3.3}, {0.5, 3.3}, {0.5, 3.9}, {0.2, 3.9}}, 1.9}};
        return room;
    }
};

TEST_F(FurnishedWorldFile, HasItsObstaclesForRobotsLasersAndLabelsButNotForTheCamera) {
    for (std::size_t i = 0; i < room.obstacles.size(); ++i) {
        const std::string name = "obstacle_" + std::to_string(i);
        const sdf::Collision* collision = surfaces()->CollisionByName(name);
        const sdf::Visual* visual = surfaces()->VisualByName(name);
        ASSERT_TRUE(collision != nullptr && visual != nullptr) << name;
        EXPECT_EQ(visual->VisibilityFlags(), kHiddenFromCamera);
        EXPECT_EQ(visual->RawPose(), collision->RawPose());
        EXPECT_EQ(collision->RawPose(), im::Pose3d(0, 0, 0.1, 0, 0, 0));
        for (const sdf::ElementPtr& element : {collision->Element(), visual->Element()}) {
            // sdformat has a class for it as of 12.5.
            const sdf::ElementPtr prism = element->GetElement("geometry")->GetElement("polyline");
            EXPECT_EQ(prism->Get<double>("height"), room.obstacles[i].heightM);
            sdf::ElementPtr point = prism->GetElement("point");
            for (const Eigen::Vector2d& corner : room.obstacles[i].outline) {
                ASSERT_NE(point, nullptr);
                EXPECT_EQ(point->Get<im::Vector2d>(), im::Vector2d(corner.x(), corner.y()));
                point = point->GetNextElement("point");
            }
            EXPECT_EQ(point, nullptr);
        }
    }
}

/// The same with a mesh of what stands there.
class MeshedWorldFile : public WorldFile {
  protected:
    MeshedWorldFile() : WorldFile(meshed()) {}

    static WorldRoom meshed() {
        WorldRoom room = roomWithACorner();
        room.obstacles = {{{{3, 0.5}, {4, 0.5}, {4, 1.5}, {3, 1.5}}, 0.75}};
        room.furnitureMesh = "v 0 0 0\n";
        return room;
    }
};

TEST_F(MeshedWorldFile, HasTheMeshInPlaceOfItsObstacles) {
    const sdf::Collision* collision = surfaces()->CollisionByName("furniture");
    const sdf::Visual* visual = surfaces()->VisualByName("furniture");
    ASSERT_TRUE(collision != nullptr && visual != nullptr);
    EXPECT_EQ(visual->VisibilityFlags(), kHiddenFromCamera);
    for (const sdf::Geometry* geometry : {collision->Geom(), visual->Geom()}) {
        ASSERT_NE(geometry->MeshShape(), nullptr);
        EXPECT_EQ(geometry->MeshShape()->Uri(), "furniture.obj");
    }
    EXPECT_EQ(collision->RawPose(), im::Pose3d::Zero) << "the mesh is in the room's frame";
    EXPECT_EQ(surfaces()->CollisionByName("obstacle_0"), nullptr);
    EXPECT_EQ(surfaces()->CollisionCount(), room.outline.size() + 3);
}

TEST(UrdfRoom, IsReadWithTheSameWallsAndItsFurniture) {
    WorldRoom room = roomWithACorner();
    room.furniture.emplace_back(Eigen::Vector3d(3, 0.5, 0), Eigen::Vector3d(4, 1.5, 0.7));
    sdf::Root root;
    for (const sdf::Error& error : root.LoadSdfString(urdfRoom(room))) {
        ADD_FAILURE() << error.Message();
    }
    ASSERT_NE(root.Model(), nullptr);
    const sdf::Link* link = root.Model()->LinkByName("room");
    ASSERT_NE(link, nullptr);
    EXPECT_EQ(link->CollisionCount(), room.outline.size() + 3);
    for (const WorldBox& box : boxesOf(room)) {
        bool isFound = false;
        for (std::uint64_t i = 0; i < link->CollisionCount(); ++i) {
            const sdf::Collision* collision = link->CollisionByIndex(i);
            const im::Vector3d at(box.middle.x(), box.middle.y(), box.middle.z());
            isFound = isFound || (collision->Geom()->BoxShape() != nullptr &&
                                  collision->RawPose().Pos().Equal(at, 1e-6) &&
                                  std::abs(collision->RawPose().Rot().Yaw() - box.yaw) < 1e-6);
        }
        EXPECT_TRUE(isFound) << box.name;
    }
}

TEST(WorldFileErrors, RefusesRoomsAndCamerasThatCannotBe) {
    WorldRoom room = roomWithACorner();
    CameraIntrinsics camera = vga();
    camera.lens = LensModel::Equidistant;
    camera.distortion = {0, 0, 0, 0};
    expectError(ErrorKind::Unsupported, "--overlay-camera", [&] { sdfWorld(room, camera); });
    room.cameraAt = {4, 3, 1};
    expectError(ErrorKind::InvalidInput, "not inside", [&] { sdfWorld(room, vga()); });
    room.ceilingM = 0;
    expectError(ErrorKind::InvalidInput, "ceiling", [&] { sdfWorld(room, vga()); });
    room.outline.clear();
    expectError(ErrorKind::InvalidInput, "outline", [&] { sdfWorld(room, vga()); });
}

} // namespace
} // namespace spherewalk::dataset
