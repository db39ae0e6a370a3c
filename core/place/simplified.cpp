// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/place/surface.h"

#include <algorithm>
#include <cmath>
#include <meshoptimizer.h>

namespace spherewalk::place {

namespace {

/// A plane of a room; its normal looks into the room.
struct Plane {
    Eigen::Vector3d normal;
    double offsetM;

    double distanceM(const Eigen::Vector3d& point) const { return normal.dot(point) - offsetM; }
};

/// Floor, ceiling, and a plane for each wall.
std::vector<Plane> planesOf(const render::RoomShape& room) {
    std::vector<Plane> planes = {{Eigen::Vector3d::UnitZ(), room.floorM},
                                 {-Eigen::Vector3d::UnitZ(), -room.ceilingM}};
    const double turn = signedArea(room.outline) < 0 ? -1 : 1;
    for (std::size_t i = 0; i < room.outline.size(); ++i) {
        const Eigen::Vector2d& begin = room.outline[i];
        const Eigen::Vector2d along = room.outline[(i + 1) % room.outline.size()] - begin;
        const Eigen::Vector2d inwards = turn * Eigen::Vector2d(-along.y(), along.x()).normalized();
        planes.push_back({{inwards.x(), inwards.y(), 0}, inwards.dot(begin)});
    }
    return planes;
}

/// Whether a point lies beside a wall itself, and not beside its line elsewhere.
bool isAtWall(const render::RoomShape& room, const Eigen::Vector3d& point, double withinM) {
    return distanceToEdge(room.outline, point.head<2>()) <= withinM;
}

bool isOfTheRoom(const render::RoomShape& room, const Eigen::Vector3d& point, double withinM) {
    return point.z() < room.floorM + withinM || point.z() > room.ceilingM - withinM ||
           isAtWall(room, point, withinM) || !contains(room.outline, point.head<2>());
}

} // namespace

void flatten(Surface& surface, const render::RoomShape& room, double withinM) {
    constexpr double kAlike = 0.8; // the cosine of 37 degrees
    const std::vector<Plane> planes = planesOf(room);
    for (SurfaceVertex& vertex : surface.vertices) {
        const Eigen::Vector3d normal = vertex.normal.cast<double>();
        for (std::size_t i = 0; i < planes.size(); ++i) {
            const double distanceM = planes[i].distanceM(vertex.pInRoom);
            const bool isWall = i >= 2;
            if (std::abs(distanceM) <= withinM && planes[i].normal.dot(normal) > kAlike &&
                (!isWall || isAtWall(room, vertex.pInRoom, withinM))) {
                vertex.pInRoom -= distanceM * planes[i].normal;
            }
        }
    }
}

Surface simplified(const Surface& surface, double errorM) {
    if (surface.triangles.empty()) {
        return surface;
    }
    const Eigen::Vector3d& origin = surface.vertices.front().pInRoom;
    std::vector<Eigen::Vector3f> positions;
    for (const SurfaceVertex& vertex : surface.vertices) {
        positions.emplace_back((vertex.pInRoom - origin).cast<float>());
    }
    std::vector<unsigned> indices;
    for (const auto& triangle : surface.triangles) {
        indices.insert(indices.end(), triangle.begin(), triangle.end());
    }
    const float* first = positions.front().data();
    constexpr std::size_t kStride = sizeof(Eigen::Vector3f);
    const float scaleM = meshopt_simplifyScale(first, positions.size(), kStride);
    std::vector<unsigned> kept(indices.size());
    kept.resize(meshopt_simplify(kept.data(), indices.data(), indices.size(), first, positions.size(),
                                 kStride, 0, static_cast<float>(errorM) / scaleM, 0, nullptr));
    Surface result{surface.vertices, {}};
    for (std::size_t i = 0; i + 2 < kept.size(); i += 3) {
        result.triangles.push_back({kept[i], kept[i + 1], kept[i + 2]});
    }
    result.keepTriangles([](std::size_t) { return true; });
    result.estimateNormals();
    return result;
}

Surface furnitureOf(Surface surface, const render::RoomShape& room, double withinM) {
    std::vector<bool> isRooms;
    for (const SurfaceVertex& vertex : surface.vertices) {
        isRooms.push_back(isOfTheRoom(room, vertex.pInRoom, withinM));
    }
    surface.keepTriangles([&](std::size_t i) {
        const auto& triangle = surface.triangles[i];
        return !std::all_of(triangle.begin(), triangle.end(),
                            [&](std::uint32_t corner) { return isRooms[corner]; });
    });
    return surface;
}

} // namespace spherewalk::place
