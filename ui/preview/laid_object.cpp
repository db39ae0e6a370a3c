// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/preview/laid_object.h"

#include <QFileInfo>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

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

using Shape = LaidObject::Shape;

ObjectStage::ObjectStage(TaskList& tasks, QObject* parent) : QObject(parent), m_tasks(tasks) {
    constexpr Degrees kUsual{30}; // more than one side of a box is seen
    m_latest.yaw = kUsual;
}

void ObjectStage::setObject(const std::optional<LaidObject>& object) {
    m_object = object;
    m_latest = object.value_or(m_latest);
    emit changed();
}

void ObjectStage::lay(std::optional<Shape> shape, const Eigen::Vector3d& footM) {
    if (!shape) {
        return setObject(std::nullopt);
    }
    if (*shape == Shape::Mesh && m_mesh == nullptr) {
        return emit changed(); // who showed the wish shows what there is
    }
    LaidObject object = m_object.value_or(m_latest);
    object.shape = *shape;
    object.mesh = *shape == Shape::Mesh ? m_mesh : nullptr;
    if (!m_object) {
        object.footM = footM;
    }
    setObject(object);
}

void ObjectStage::toggle(const Eigen::Vector3d& footM) {
    lay(m_object ? std::nullopt : std::optional(m_latest.shape), footM);
}

void ObjectStage::readMesh(const QString& file, const Eigen::Vector3d& footM) {
    if (m_reading) {
        m_reading->stop(); // the latest wish counts
    }
    m_reading = m_tasks.start(
        tr("Reading %1").arg(QFileInfo(file).fileName()), this,
        [path = std::filesystem::path(file.toStdString())](ProgressSink& /*progress*/,
                                                           const std::stop_token& /*stop*/) {
            return std::make_shared<const jobs::ObjectMesh>(jobs::readObj(path));
        },
        [this, footM](std::shared_ptr<const jobs::ObjectMesh> mesh) {
            m_mesh = std::move(mesh);
            LaidObject object = m_object.value_or(m_latest);
            object.footM = m_object ? m_object->footM : footM;
            object.shape = Shape::Mesh;
            object.mesh = m_mesh;
            object.sizeM = std::clamp(m_mesh->longestSide(), LaidObject::kSmallestM, LaidObject::kLargestM);
            setObject(object);
        });
    connect(m_reading, &Task::ended, this, &ObjectStage::changed);
}

void ObjectStage::setSize(double sizeM) {
    if (m_object) {
        LaidObject object = *m_object;
        object.sizeM = std::clamp(sizeM, LaidObject::kSmallestM, LaidObject::kLargestM);
        setObject(object);
    }
}

void ObjectStage::turn(const Radians& angle) {
    if (m_object) {
        LaidObject object = *m_object;
        object.yaw = wrapped(object.yaw + angle);
        setObject(object);
    }
}

void ObjectStage::moveBy(const Eigen::Vector2d& wayM) {
    if (m_object) {
        LaidObject object = *m_object;
        object.footM.head<2>() += wayM;
        setObject(object);
    }
}

void ObjectStage::standOn(const SurfaceSpot& spot) {
    if (m_object) {
        LaidObject object = *m_object;
        ui::standOn(spot, object);
        setObject(object);
    }
}

} // namespace spherewalk::ui
