// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/polygon.h"
#include "spherewalk/practice/practice_room.h"

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace spherewalk::practice {

/// Linear light.
using Rgb = Eigen::Array3f;

/// A colour given as pictures store it, 0xRRGGBB.
Rgb linear(std::uint32_t stored);

enum class Texture {
    Plain,
    Planks,
    Rug,
    Wallpaper,
    Plaster,
    Wood,
    Fabric,
    Ribs,
    Curtain,
    Door,
    Outside,
    Art,
    Page,
    Book,
    Leaves,
    Globe,
    Stripes,
    Mosaic,
};

/// A disc, bar or ring on a painting. Units: metres from its lower left corner.
struct Blot {
    enum class Form { Disc, Bar, Ring };

    Form form = Form::Disc;
    float u = 0;
    float v = 0;
    float radius = 0;
    Rgb colour = Rgb::Zero();
};

/// The forms of one painting. seed: another one gives another painting.
std::vector<Blot> blots(std::uint32_t seed, float width, float height);

/// What a surface is made of.
struct Finish {
    Texture texture = Texture::Plain;
    Rgb first = Rgb::Constant(0.5F);
    Rgb second = Rgb::Constant(0.2F);
    std::uint32_t seed = 0;
    float mirror = 0; ///< Share of the light that is mirrored at normal incidence.
    float glow = 0;   ///< Own light, as a multiple of the albedo.
    std::vector<Blot> blots = {};
};

/// A place on a surface, in the surface's own coordinates. Units: metres.
struct SurfacePoint {
    float u = 0;      ///< To the right as seen from outside, from the lower left corner.
    float v = 0;      ///< Up.
    float width = 1;  ///< Width of the face.
    float height = 1; ///< Height of the face.
    int face = 0;     ///< Number of the solid's face.
    bool isRound = false;
    Eigen::Vector3f local = Eigen::Vector3f::Zero(); ///< In the frame of the solid.
    Eigen::Vector3f normal = Eigen::Vector3f::UnitZ();
};

/// The share of light that the surface sends back, averaged over a footprint of this many metres.
Rgb albedo(const Finish& finish, const SurfacePoint& surface, float footprint);

inline constexpr double kNothing = std::numeric_limits<double>::infinity();

/// A solid of the practice room; boxes turn about z. Frames: origin at the room's corner. Units: metres.
struct Shape {
    enum class Kind { Box, Sphere, Cylinder };

    Kind kind = Kind::Box;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    Eigen::Vector3d half = Eigen::Vector3d::Zero(); ///< Of spheres and cylinders, x is the radius.
    double cosYaw = 1;
    double sinYaw = 0;
    double boundRadius = 0;
    float shade = 1;       ///< How strongly it darkens what is near, [0, 1].
    double shadeScale = 0; ///< Reach of the shade, see shadeFrom().
    bool isObject = false;
    Finish finish;

    Eigen::Vector3d toLocal(const Eigen::Vector3d& v) const {
        return {cosYaw * v.x() + sinYaw * v.y(), cosYaw * v.y() - sinYaw * v.x(), v.z()};
    }

    Eigen::Vector3d toRoom(const Eigen::Vector3d& v) const {
        return {cosYaw * v.x() - sinYaw * v.y(), cosYaw * v.y() + sinYaw * v.x(), v.z()};
    }
};

/// Distance along a ray that starts outside to the shape; kNothing if the ray misses it. direction: unit
/// length.
double distanceTo(const Shape& shape, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction);

/// The surface at a point found by distanceTo.
SurfacePoint surfaceAt(const Shape& shape, const Eigen::Vector3d& point);

/// The share of the light that the shape takes from a point near it, [0, 1).
float shadeFrom(const Shape& shape, const Eigen::Vector3d& point);

/// Distance beyond which shadeFrom() is 0.
double shadeReach(const Shape& shape);

/// The same shape with the members that follow from its extents.
Shape completed(Shape shape);

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

/// Furniture along the walls of a room of this size; the middle stays free.
Furniture furnished(RoomStyle style, const Eigen::Vector3d& roomSize);

/// What a ray meets first. id: number of the surface, which differs across edges; -1 for nothing.
struct Hit {
    double distance = kNothing;
    int id = -1;
};

/// A shape that a ray may meet. nearest: a lower bound of its distance.
struct Candidate {
    double nearest = 0;
    std::uint16_t shape = 0;
};

/// The practice room with its corner at the origin. Threads: any.
class Scene {
  public:
    Scene(RoomStyle style, const Eigen::Vector3d& size, const std::vector<PracticeObject>& objects,
          const Eigen::Vector3d& origin);

    /// Finds the shapes that a cone from the eye may meet, nearest first. halfAngle: radians; from pi on, all
    /// shapes.
    void candidates(const Eigen::Vector3d& eye, const Eigen::Vector3d& axis, double halfAngle,
                    Content content, std::vector<Candidate>& found) const;

    Hit hit(const Eigen::Vector3d& eye, const Eigen::Vector3d& direction,
            std::span<const Candidate> candidates, bool withWalls) const;

    /// The colour at the hit as pictures store it, [0, 255]. footprint: angle of the sample, radians.
    Rgb colour(const Hit& hit, const Eigen::Vector3d& eye, const Eigen::Vector3d& direction,
               float footprint) const;

    const Furniture& furniture() const { return m_furniture; }

  private:
    /// The light on a wall at the nodes of a grid, computed once.
    struct LightMap {
        int columns = 0;
        int rows = 0;
        float perMetre = 0;
        std::vector<Rgb> values;
    };

    Rgb radiance(const Hit& hit, const Eigen::Vector3d& eye, const Eigen::Vector3d& direction,
                 float footprint, bool mayMirror) const;
    /// The light from behind, with what panes before it reflect.
    Rgb throughPanes(const Rgb& behind, double distance, const Eigen::Vector3d& eye,
                     const Eigen::Vector3d& direction, float footprint) const;
    Rgb wallLight(int wall, float u, float v) const;
    Rgb lightAt(const Eigen::Vector3d& point, const Eigen::Vector3f& normal) const;
    Rgb sunAt(const Eigen::Vector3d& point) const;
    float openness(const Eigen::Vector3d& point, std::span<const std::uint16_t> near) const;
    float cornerOpenness(const Eigen::Vector3d& point, int wall) const;
    SurfacePoint wallSurface(int wall, const Eigen::Vector3d& point) const;
    Eigen::Vector3d wallPoint(int wall, float u, float v) const;
    LightMap bakedWall(int wall) const;

    Eigen::Vector3d m_size;
    Furniture m_furniture;
    std::vector<std::uint16_t> m_all;                   ///< Furniture without objects.
    std::vector<Candidate> m_allUnsorted;               ///< The same, for rays from anywhere.
    std::vector<std::vector<std::uint16_t>> m_shadedBy; ///< By shape.
    std::array<LightMap, kWalls> m_lightMaps;
};

} // namespace spherewalk::practice
