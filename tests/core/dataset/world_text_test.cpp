// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"

#include "spherewalk/dataset/world_file.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/render/scene_depth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>
#include <vector>

namespace spherewalk::dataset {

using Eigen::Vector2d;
using test::expectError;

namespace {

WorldRoom angularRoom() {
    return {"Anna's <kitchen> & hall",
            {{0, 0}, {5, 0}, {5, 2}, {2, 2}, {2, 4}, {0, 4}},
            -0.5,
            2.5,
            {1, 1, 1.2},
            {}};
}

const CameraIntrinsics kWorldCamera{640, 480, 465.5, 466, 318.25, 240.5, LensModel::Pinhole, {}};

/// The first defect of a text as XML: "" if every element is closed in its turn.
std::string xmlDefect(const std::string& xml) {
    std::vector<std::string> open;
    for (std::size_t at = 0; (at = xml.find('<', at)) != std::string::npos;) {
        if (xml.compare(at, 4, "<!--") == 0) {
            at = xml.find("-->", at);
            if (at == std::string::npos) {
                return "a comment is open";
            }
            continue;
        }
        const std::size_t end = xml.find('>', at);
        const std::string tag = xml.substr(at + 1, end - at - 1);
        at = end;
        if (tag.starts_with('?')) {
            continue;
        }
        if (std::count(tag.begin(), tag.end(), '"') % 2 != 0 || tag.find('<') != std::string::npos) {
            return "an attribute is open: " + tag;
        }
        if (tag.starts_with('/')) {
            if (open.empty() || open.back() != tag.substr(1)) {
                return "closed out of turn: " + tag;
            }
            open.pop_back();
        } else if (!tag.ends_with('/')) {
            open.push_back(tag.substr(0, tag.find(' ')));
        }
    }
    return open.empty() ? "" : "left open: " + open.back();
}

/// The numbers of the first element of this name after a place in the text.
std::vector<double> numbersOf(const std::string& xml, const std::string& element, std::size_t after) {
    const std::size_t begin = xml.find("<" + element + ">", after) + element.size() + 2;
    std::istringstream words(xml.substr(begin, xml.find('<', begin) - begin));
    std::vector<double> numbers;
    for (double number = 0; words >> number;) {
        numbers.push_back(number);
    }
    return numbers;
}

/// The parcel of a world, as the world's text says.
struct Parcel {
    explicit Parcel(const std::string& world) {
        const std::size_t at = world.find("<model name=\"parcel\">");
        const std::vector<double> pose = numbersOf(world, "pose", at);
        const std::vector<double> size = numbersOf(world, "size", at);
        middle = {pose[0], pose[1], pose[2]};
        half = Eigen::Vector3d(size[0], size[1], size[2]) / 2;
    }

    /// How far a ray goes to the parcel; infinity if the ray passes.
    double distance(const Eigen::Vector3d& from, const Eigen::Vector3d& along) const {
        double enter = 0;
        double leave = HUGE_VAL;
        for (int i = 0; i < 3; ++i) {
            const double a = (middle[i] - half[i] - from[i]) / along[i];
            const double b = (middle[i] + half[i] - from[i]) / along[i];
            enter = std::max(enter, std::min(a, b));
            leave = std::min(leave, std::max(a, b));
        }
        return enter < leave ? enter : HUGE_VAL;
    }

    Eigen::Vector3d middle;
    Eigen::Vector3d half;
};

bool isHidden(const WorldRoom& room, const Eigen::Vector3d& along, double distance) {
    const render::RoomShape shape{room.outline, room.floorM, room.ceilingM};
    if (1 / render::inverseDistance(shape, room.cameraAt, along) < distance - 1e-9) {
        return true;
    }
    for (double t = 0; t < distance; t += 0.02) {
        const Eigen::Vector3d at = room.cameraAt + t * along;
        if (std::any_of(room.obstacles.begin(), room.obstacles.end(), [&](const WorldObstacle& obstacle) {
                return at.z() < room.floorM + obstacle.heightM && contains(obstacle.outline, at.head<2>());
            })) {
            return true;
        }
    }
    return false;
}

/// The share of the first picture's pixels that a segmentation camera would give the parcel's label.
double shareOfParcel(const WorldRoom& room, const CameraIntrinsics& camera) {
    constexpr int kStep = 8;
    const Parcel parcel(sdfWorld(room, camera));
    const CameraModel model(camera);
    int shown = 0;
    int all = 0;
    for (int y = 0; y < camera.height; y += kStep) {
        for (int x = 0; x < camera.width; x += kStep) {
            const Eigen::Vector3d along = bodyFromOptical() * *model.ray(Vector2d(x, y));
            const double distance = parcel.distance(room.cameraAt, along);
            shown += distance < HUGE_VAL && !isHidden(room, along, distance) ? 1 : 0;
            ++all;
        }
    }
    return static_cast<double>(shown) / all;
}

Polygon rectangle(double x, double y, double width, double depth) {
    return {{x, y}, {x + width, y}, {x + width, y + depth}, {x, y + depth}};
}

/// Between 0.5 and 2.2 m high, with furniture that leaves the camera a metre.
WorldRoom randomRoom(std::mt19937& random) {
    const auto between = [&](double least, double most) {
        return std::uniform_real_distribution<double>(least, most)(random);
    };
    WorldRoom room{"random", rectangle(0, 0, between(2, 9), between(2, 9)), between(-1, 1), 0, {}, {}};
    const Vector2d size = room.outline[2];
    room.ceilingM = room.floorM + between(2.2, 3);
    room.cameraAt = {between(0.3, size.x() - 1), between(0.4, size.y() - 0.4),
                     room.floorM + between(0.3, 1.8)};
    for (int i = 0; i < 4; ++i) {
        const Polygon obstacle =
            rectangle(between(0, size.x()), between(0, size.y()), between(0.3, 1.5), between(0.3, 1.5));
        const Vector2d from = room.cameraAt.head<2>();
        if (!contains(obstacle, from) && distanceToEdge(obstacle, from) > 1) {
            room.obstacles.push_back({obstacle, between(0.4, 2)});
        }
    }
    return room;
}

} // namespace

TEST(WorldText, TheParcelIsInTheFirstPicture) {
    EXPECT_GT(shareOfParcel(angularRoom(), kWorldCamera), 0.005);
    for (unsigned seed = 0; seed < 200; ++seed) {
        std::mt19937 random(seed);
        const WorldRoom room = randomRoom(random);
        const double fov = std::uniform_real_distribution<double>(0.8, 1.6)(random);
        EXPECT_GT(shareOfParcel(room, CameraIntrinsics::pinhole(640, 480, fov)), 0.003) << "seed " << seed;
    }
}

TEST(WorldText, ObstaclesAreTheRoomsAndStandOnItsFloor) {
    WorldRoom room = angularRoom();
    room.obstacles = {{rectangle(3, 0.2, 1, 0.5), 0.75}, {{{0.2, 3}, {1, 3}, {0.2, 3.8}}, 1.9}};
    const std::string world = sdfWorld(room, kWorldCamera);
    EXPECT_EQ(xmlDefect(world), "");
    for (const char* kind : {"<collision name=\"obstacle_1\">", "<visual name=\"obstacle_1\">"}) {
        const std::size_t at = world.find(kind);
        ASSERT_NE(at, std::string::npos) << kind;
        EXPECT_EQ(numbersOf(world, "pose", at), (std::vector<double>{0, 0, -0.5, 0, 0, 0}));
        EXPECT_EQ(numbersOf(world, "point", at), (std::vector<double>{0.2, 3}));
        EXPECT_EQ(numbersOf(world, "height", at), std::vector<double>{1.9});
    }
    EXPECT_EQ(numbersOf(world, "visibility_flags", world.find("<visual name=\"obstacle_0\">")),
              std::vector<double>{kHiddenFromCamera});
    room.obstacles[1].heightM = 0;
    expectError(ErrorKind::InvalidInput, "higher than 0", [&] { room.validate(); });
    room.obstacles[1] = {{{0, 0}, {1, 1}, {1, 0}, {0, 1}}, 1};
    expectError(ErrorKind::InvalidInput, "obstacle 2", [&] { room.validate(); });
}

TEST(WorldText, IsWellFormedWhateverTheRoomIsCalled) {
    for (const char* name : {"Anna's <kitchen> & hall", "", "\"", "Küche"}) {
        WorldRoom room = angularRoom();
        room.name = name;
        const std::string world = sdfWorld(room, kWorldCamera);
        EXPECT_EQ(xmlDefect(world), "") << name;
        EXPECT_EQ(world.find('&'), std::string::npos);
    }
    EXPECT_NE(xmlDefect("<a><b></a></b>"), ""); // the check itself can fail
}

TEST(WorldText, WallsCloseTheOutlineWhicheverWayItRuns) {
    WorldRoom room = angularRoom();
    WorldRoom backwards = room;
    std::reverse(backwards.outline.begin(), backwards.outline.end());
    for (const WorldRoom& one : {room, backwards}) {
        const std::string world = sdfWorld(one, kWorldCamera);
        for (std::size_t i = 0; i < one.outline.size(); ++i) {
            const std::size_t at = world.find("<collision name=\"wall_" + std::to_string(i) + "\">");
            ASSERT_NE(at, std::string::npos);
            const std::vector<double> pose = numbersOf(world, "pose", at);
            const std::vector<double> size = numbersOf(world, "size", at);
            EXPECT_NEAR(pose[2], 1, 1e-6); // from the floor to the ceiling
            EXPECT_NEAR(size[2], 3, 1e-6);
            // The inner face holds both ends of one edge of the outline.
            const Vector2d along(std::cos(pose[5]), std::sin(pose[5]));
            const Vector2d inwards(-along.y(), along.x());
            const Vector2d face = Vector2d(pose[0], pose[1]) + size[1] / 2 * inwards;
            int ends = 0;
            for (const Vector2d& corner : one.outline) {
                const Vector2d from = corner - face;
                ends += std::abs(from.dot(inwards)) < 1e-4 && std::abs(from.dot(along)) < size[0] / 2 + 1e-4;
            }
            EXPECT_GE(ends, 2) << i;
        }
        EXPECT_EQ(world.find("wall_6"), std::string::npos);
    }
}

TEST(WorldText, CamerasHaveTheIntrinsicsCountedFromThePixelsCorner) {
    const std::string world = sdfWorld(angularRoom(), kWorldCamera);
    for (const char* sensor : {"overlay_colour", "overlay_depth", "overlay_labels"}) {
        const std::size_t at = world.find(std::string("<sensor name=\"") + sensor);
        ASSERT_NE(at, std::string::npos) << sensor;
        EXPECT_EQ(numbersOf(world, "width", at), std::vector<double>{640});
        EXPECT_EQ(numbersOf(world, "fx", at), std::vector<double>{465.5});
        EXPECT_EQ(numbersOf(world, "cx", at), std::vector<double>{318.75});
        EXPECT_EQ(numbersOf(world, "cy", at), std::vector<double>{241});
    }
}

TEST(WorldText, TheRoomIsHiddenFromTheCameraAndTheObjectIsNot) {
    const std::string world = sdfWorld(angularRoom(), kWorldCamera);
    const auto flags = [&](const char* visual) {
        return numbersOf(world, "visibility_flags", world.find(std::string("<visual name=\"") + visual));
    };
    for (const char* surface : {"floor", "ceiling", "wall_0", "body"}) {
        EXPECT_EQ(flags(surface), std::vector<double>{kHiddenFromCamera}) << surface;
    }
    EXPECT_EQ(flags("box"), std::vector<double>{kSeenByCamera});
}

TEST(WorldModels, HaveTheRoomsBoxesAndItsFurnitureOrObstacles) {
    WorldRoom room = angularRoom();
    room.obstacles = {{rectangle(3, 0.2, 1, 0.5), 0.75}};
    for (const std::string& model : {mjcfWorld(room, kWorldCamera), urdfRoom(room)}) {
        EXPECT_EQ(xmlDefect(model), "");
        EXPECT_NE(model.find("\"wall_5\""), std::string::npos);
        EXPECT_EQ(model.find("\"wall_6\""), std::string::npos);
        EXPECT_NE(model.find("\"obstacle_0_3\""), std::string::npos) << "the side of an obstacle";
    }
    room.furniture.resize(2, {Eigen::Vector3d(1, 2, 0), Eigen::Vector3d(2, 4, 1)});
    for (const std::string& model : {mjcfWorld(room, kWorldCamera), urdfRoom(room)}) {
        EXPECT_EQ(xmlDefect(model), "");
        EXPECT_EQ(model.find("obstacle"), std::string::npos) << "furniture takes their place";
        EXPECT_NE(model.find("\"furniture_1\""), std::string::npos);
        EXPECT_NE(model.find("\"1.5 3 0.5\""), std::string::npos) << "its middle";
    }
    CameraIntrinsics bent = kWorldCamera;
    bent.lens = LensModel::Equidistant;
    bent.distortion = {0, 0, 0, 0};
    expectError(ErrorKind::Unsupported, "MuJoCo", [&] { mjcfWorld(room, bent); });
    room.ceilingM = room.floorM;
    expectError(ErrorKind::InvalidInput, "above its floor", [&] { mjcfWorld(room, kWorldCamera); });
    expectError(ErrorKind::InvalidInput, "above its floor", [&] { urdfRoom(room); });
}

TEST(WorldText, RefusesRoomsThatCannotBe) {
    WorldRoom crossed = angularRoom();
    std::swap(crossed.outline[1], crossed.outline[2]);
    expectError(ErrorKind::InvalidInput, "outline", [&] { crossed.validate(); });
    WorldRoom flat = angularRoom();
    flat.ceilingM = flat.floorM;
    expectError(ErrorKind::InvalidInput, "above its floor", [&] { flat.validate(); });
    for (const Eigen::Vector3d& at :
         {Eigen::Vector3d(4, 3, 1), Eigen::Vector3d(1, 1, 3), Eigen::Vector3d(1, 1, HUGE_VAL)}) {
        WorldRoom room = angularRoom();
        room.cameraAt = at;
        expectError(ErrorKind::InvalidInput, "not inside", [&] { room.validate(); });
    }
}

TEST(WorldText, RefusesALensThatGazeboDoesNotHave) {
    CameraIntrinsics camera = kWorldCamera;
    camera.lens = LensModel::PlumbBob;
    camera.distortion = {-0.05, 0.01, 0, 0, 0};
    expectError(ErrorKind::Unsupported, "distort", [&] { sdfWorld(angularRoom(), camera); });
}

} // namespace spherewalk::dataset
