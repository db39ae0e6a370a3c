// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/preview/laid_object.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::ui {

namespace {

std::shared_ptr<const jobs::ObjectMesh> cube() {
    static const auto kCube = std::make_shared<const jobs::ObjectMesh>(jobs::ObjectMesh::cube());
    return kCube;
}

std::optional<Eigen::Vector3d> pointAt(const DepthImage& depth, const CameraModel& camera, int x, int y) {
    if (x < 0 || y < 0 || x >= depth.width() || y >= depth.height()) {
        return std::nullopt;
    }
    const auto ray = camera.ray(Eigen::Vector2d(x, y));
    const double z = *depth.at(x, y);
    if (!ray || ray->z() <= 0 || !std::isfinite(z) || z <= 0) {
        return std::nullopt;
    }
    return z / ray->z() * *ray;
}

/// The direction along the surface from one side of the pixel to the other, or nothing at an edge.
std::optional<Eigen::Vector3d> alongSurface(const DepthImage& depth, const CameraModel& camera,
                                            const Eigen::Vector2i& pixel, const Eigen::Vector2i& step) {
    constexpr double kEdge = 0.15; // share by which the distances along one surface differ at most
    const auto before = pointAt(depth, camera, pixel.x() - step.x(), pixel.y() - step.y());
    const auto after = pointAt(depth, camera, pixel.x() + step.x(), pixel.y() + step.y());
    if (!before || !after || std::abs(before->z() - after->z()) > kEdge * std::min(before->z(), after->z())) {
        return std::nullopt;
    }
    return *after - *before;
}

/// Makes floors level and walls upright: depths are not exact.
Eigen::Vector3d straightened(const Eigen::Vector3d& normal) {
    constexpr double kLevel = 0.8;
    constexpr double kUpright = 0.4;
    if (std::abs(normal.z()) > kLevel) {
        return {0, 0, std::copysign(1.0, normal.z())};
    }
    return std::abs(normal.z()) < kUpright ? Eigen::Vector3d(normal.x(), normal.y(), 0).normalized() : normal;
}

} // namespace

Eigen::Vector3d LaidObject::sidesM() const {
    return shape == Shape::Mesh ? Eigen::Vector3d(sizeM * mesh->sides().cast<double>())
                                : Eigen::Vector3d::Constant(sizeM);
}

jobs::Ball LaidObject::ball() const {
    return {footM + Eigen::Vector3d(0, 0, 0.5 * sizeM), 0.5 * sizeM};
}

jobs::PlacedMesh LaidObject::placed() const {
    return {shape == Shape::Mesh ? mesh : cube(), footM, sizeM, yaw};
}

render::Overlay LaidObject::overlay(const CameraModel& camera, const Rigid3& roomFromCamera) const {
    return shape == Shape::Ball ? jobs::ballOverlay(ball(), camera, roomFromCamera)
                                : jobs::meshOverlay(placed(), camera, roomFromCamera);
}

std::optional<SurfaceSpot> spotAt(const DepthImage& depth, const CameraModel& camera,
                                  const Rigid3& roomFromCamera, const Eigen::Vector2i& pixel) {
    const auto point = pointAt(depth, camera, pixel.x(), pixel.y());
    if (!point) {
        return std::nullopt;
    }
    const int step = std::max(2, depth.width() / 100);
    const auto right = alongSurface(depth, camera, pixel, {step, 0});
    const auto down = alongSurface(depth, camera, pixel, {0, step});
    SurfaceSpot spot{roomFromCamera * *point, Eigen::Vector3d::UnitZ()};
    if (right && down && right->cross(*down).squaredNorm() > 0) {
        Eigen::Vector3d normal = right->cross(*down).normalized();
        normal = normal.dot(*point) > 0 ? Eigen::Vector3d(-normal) : normal; // towards the camera
        spot.normal = straightened(roomFromCamera.rotation * normal);
    }
    return spot;
}

void standOn(const SurfaceSpot& spot, LaidObject& object) {
    const Eigen::Vector3d& normal = spot.normal;
    if (normal.z() == 0) {
        object.yaw = Radians(std::atan2(normal.y(), normal.x()));
    }
    const Eigen::Vector3d sides = object.sidesM();
    double reach = 0.5 * object.sizeM; // from the middle to the surface
    if (object.shape != LaidObject::Shape::Ball) {
        const Eigen::Vector3d ahead(cos(object.yaw), sin(object.yaw), 0);
        const Eigen::Vector3d left(-ahead.y(), ahead.x(), 0);
        reach = 0.5 * (sides.x() * std::abs(ahead.dot(normal)) + sides.y() * std::abs(left.dot(normal)) +
                       sides.z() * std::abs(normal.z()));
    }
    object.footM = spot.pInRoom + reach * normal - Eigen::Vector3d(0, 0, 0.5 * sides.z());
}

} // namespace spherewalk::ui
