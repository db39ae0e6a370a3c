// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "room/shape.h"

#include "spherewalk/geometry/polygon.h"
#include "spherewalk/practice/practice_room.h"

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

namespace spherewalk::practice {

/// The faces of the room itself, in the order of their ids.
enum class Wall { Floor, Ceiling, South, North, West, East };

inline constexpr int kWalls = 6;

/// The furniture of the practice room. Frames: origin at the room's corner. Units: metres.
struct Furniture {
    std::array<Finish, kWalls> walls;
    std::vector<Shape> shapes;
    std::vector<Shape> panes;       ///< Thin boxes of glass, which nobody meets but light.
    std::vector<Polygon> obstacles; ///< Outlines of the furniture that stands on the floor.
    Eigen::Vector3d windowCentre;
    Eigen::Vector3d windowHalf;
    Eigen::Vector3d ceilingLamp;
    Eigen::Vector3d floorLamp;
};

/// A finish of two colours, which are given as pictures store them, 0xRRGGBB.
Finish finish(Texture texture, std::uint32_t first, std::uint32_t second, std::uint32_t seed);

/// A finish of one colour.
Finish plain(std::uint32_t colour);

/// A piece of furniture: a frame on the floor in which its parts are placed.
class Piece {
  public:
    Piece(Furniture& room, double x, double y, double yawDeg)
        : m_room(room), m_x(x), m_y(y), m_yaw(yawDeg * (std::numbers::pi / 180)) {}

    Shape& box(const Eigen::Vector3d& centre, const Eigen::Vector3d& size, const Finish& made) {
        Shape shape;
        shape.kind = Shape::Kind::Box;
        shape.half = size / 2;
        return placed(shape, centre, made);
    }

    Shape& sphere(const Eigen::Vector3d& centre, double radius, const Finish& made) {
        Shape shape;
        shape.kind = Shape::Kind::Sphere;
        shape.half = {radius, radius, radius};
        return placed(shape, centre, made);
    }

    Shape& cylinder(const Eigen::Vector3d& bottom, double radius, double height, const Finish& made) {
        Shape shape;
        shape.kind = Shape::Kind::Cylinder;
        shape.half = {radius, radius, height / 2};
        return placed(shape, bottom + Eigen::Vector3d(0, 0, height / 2), made);
    }

    /// What the piece covers on the floor: a rectangle of this size around its frame's origin.
    void footprint(double width, double depth) {
        Polygon polygon;
        for (const auto& [sx, sy] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
            polygon.push_back(toRoom({sx * width / 2, sy * depth / 2, 0}).head<2>());
        }
        m_room.obstacles.push_back(polygon);
    }

  private:
    Eigen::Vector3d toRoom(const Eigen::Vector3d& p) const {
        return {m_x + std::cos(m_yaw) * p.x() - std::sin(m_yaw) * p.y(),
                m_y + std::sin(m_yaw) * p.x() + std::cos(m_yaw) * p.y(), p.z()};
    }

    Shape& placed(Shape shape, const Eigen::Vector3d& centre, const Finish& made) {
        shape.centre = toRoom(centre);
        shape.cosYaw = std::cos(m_yaw);
        shape.sinYaw = std::sin(m_yaw);
        shape.finish = made;
        m_room.shapes.push_back(completed(shape));
        return m_room.shapes.back();
    }

    Furniture& m_room;
    double m_x;
    double m_y;
    double m_yaw;
};

/// What stands or hangs in rooms. Units: metres; x and y are those of the room's corner, yaw is in degrees.
void addTable(Furniture& room, double x, double y);
void addChair(Furniture& room, double x, double y, double yawDeg);
void addShelf(Furniture& room, double x, double y);
void addCabinet(Furniture& room, double x, double y);
void addArmchair(Furniture& room, double x, double y);
void addPlant(Furniture& room, double x, double y);
void addFloorLamp(Furniture& room, double x, double y);
void addCeilingLamp(Furniture& room, double x, double y, double ceiling, float glow = 2.4F);
void addWindow(Furniture& room, double y, float glow = 1.0F);
void addDoor(Furniture& room, double x);
void addPicture(Piece& wall, double along, double z, double width, double height, Texture texture,
                std::uint32_t seed);
void addPictures(Furniture& room, const Eigen::Vector3d& size);
void addRug(Furniture& room, double x, double y);
void addPane(Furniture& room, const Eigen::Vector3d& centre, const Eigen::Vector3d& size);
void addInnerWall(Furniture& room, const Eigen::Vector2d& from, const Eigen::Vector2d& to, double height,
                  std::uint32_t seed);
void addOverhang(Furniture& room, double x, double y);

/// The sheet that a tag is printed on. origin: the room's corner. Errors: InvalidInput for an unknown number.
Shape sheetOf(const PracticeTag& tag, const Eigen::Vector3d& origin);

/// Furniture along the walls of a room of this size; the middle stays free.
Furniture furnished(RoomStyle style, const Eigen::Vector3d& roomSize);

} // namespace spherewalk::practice
