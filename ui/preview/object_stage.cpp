// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/preview/object_stage.h"

#include <QFileInfo>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace spherewalk::ui {

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
