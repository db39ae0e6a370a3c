// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <bitset>
#include <cstdint>
#include <limits>
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
    Tag,
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
    std::bitset<64> cells = {}; ///< White cells of a tag, 8 x 8, from its upper left corner.
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
    bool castsShadow = false; ///< As PracticeObject has it.
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

/// Distance from a point, inside or outside, to the shape's surface.
double surfaceDistance(const Shape& shape, const Eigen::Vector3d& point);

/// The surface at a point found by distanceTo.
SurfacePoint surfaceAt(const Shape& shape, const Eigen::Vector3d& point);

/// The share of the light that the shape takes from a point near it, [0, 1).
float shadeFrom(const Shape& shape, const Eigen::Vector3d& point);

/// Distance beyond which shadeFrom() is 0.
double shadeReach(const Shape& shape);

/// The same shape with the members that follow from its extents.
Shape completed(Shape shape);

} // namespace spherewalk::practice
