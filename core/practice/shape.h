// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "texture.h"

#include <Eigen/Core>

#include <cmath>
#include <limits>

namespace spherewalk::practice {

inline constexpr double kNothing = std::numeric_limits<double>::infinity();

/// A solid of the practice room. Frames: the room's corner, metres; boxes turn about z.
struct Shape {
    enum class Kind { Box, Sphere, Cylinder };

    Kind kind = Kind::Box;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    Eigen::Vector3d half = Eigen::Vector3d::Zero(); ///< spheres and cylinders: x is the radius
    double cosYaw = 1;
    double sinYaw = 0;
    double boundRadius = 0;
    float shade = 1;       ///< how strongly it darkens what is near, 0 for not at all
    double shadeScale = 0; ///< how far, see shadeFrom
    bool isObject = false;
    Finish finish;

    Eigen::Vector3d toLocal(const Eigen::Vector3d& v) const {
        return {cosYaw * v.x() + sinYaw * v.y(), cosYaw * v.y() - sinYaw * v.x(), v.z()};
    }

    Eigen::Vector3d toRoom(const Eigen::Vector3d& v) const {
        return {cosYaw * v.x() - sinYaw * v.y(), cosYaw * v.y() + sinYaw * v.x(), v.z()};
    }
};

/// Where a ray that starts outside first meets the shape; kNothing if it does not. direction: unit length.
double distanceTo(const Shape& shape, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction);

/// The surface at a point found by distanceTo.
SurfacePoint surfaceAt(const Shape& shape, const Eigen::Vector3d& point);

/// How much the shape takes from the light at a point near it, [0, 1).
float shadeFrom(const Shape& shape, const Eigen::Vector3d& point);

/// How far shadeFrom reaches.
double shadeReach(const Shape& shape);

/// The same shape with what follows from its extents filled in.
Shape completed(Shape shape);

} // namespace spherewalk::practice
