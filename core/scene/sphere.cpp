// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/scene/sphere.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace spherewalk::scene {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

/// Directions spread evenly over the sphere. Source: the spherical Fibonacci lattice (Gonzalez 2010).
std::vector<Vector3d> evenDirections(int count) {
    const double turn = 2 * std::numbers::pi / (std::numbers::phi * std::numbers::phi);
    std::vector<Vector3d> result;
    for (int i = 0; i < count; ++i) {
        const double z = 1 - (2 * i + 1.0) / count;
        const double r = std::sqrt(1 - z * z);
        result.emplace_back(r * std::cos(turn * i), r * std::sin(turn * i), z);
    }
    return result;
}

/// 1 / distance along the ray to the first wall; 0 if it meets none.
double inverseWallDistance(const Polygon& outline, const Vector3d& from, const Vector3d& ray) {
    double greatest = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vector2d a = outline[i] - from.head<2>();
        const Vector2d wall = outline[(i + 1) % outline.size()] - outline[i];
        const double across = ray.x() * wall.y() - ray.y() * wall.x();
        const double along = (a.x() * ray.y() - a.y() * ray.x()) / across; // where on the wall, 0 to 1
        const double t = (a.x() * wall.y() - a.y() * wall.x()) / across;
        if (across != 0 && along >= 0 && along <= 1 && t > 0) {
            greatest = std::max(greatest, 1 / t);
        }
    }
    return greatest;
}

double inverseDistance(const survey::Room& room, const Vector3d& from, const Vector3d& ray) {
    const double flat = ray.z() < 0 ? -ray.z() / from.z() : ray.z() / (room.ceilingM - from.z());
    return std::max(flat, inverseWallDistance(room.outline, from, ray));
}

} // namespace

std::optional<double> sphereRadius(const survey::Room& room, const std::vector<Vector3d>& pInRoom) {
    constexpr int kDirections = 500;
    const std::vector<Vector3d> directions = evenDirections(kDirections);
    double sum = 0;
    std::size_t count = 0;
    for (const Vector3d& point : pInRoom) {
        const bool inside = point.z() > 0 && point.z() < room.ceilingM &&
                            contains(room.outline, point.head<2>()) &&
                            distanceToEdge(room.outline, point.head<2>()) > 0;
        if (!inside) {
            continue;
        }
        for (const Vector3d& ray : directions) {
            sum += inverseDistance(room, point, ray);
        }
        count += directions.size();
    }
    if (count == 0) {
        return std::nullopt;
    }
    return static_cast<double>(count) / sum;
}

} // namespace spherewalk::scene
