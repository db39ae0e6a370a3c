// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/preview/laid_object.h"
#include "ui/tasks/task.h"

#include <QObject>
#include <QPointer>

namespace spherewalk::ui {

/// The object in the preview: which one, how large, and where. Threads: the GUI thread.
class ObjectStage : public QObject {
    Q_OBJECT

  public:
    explicit ObjectStage(TaskList& tasks, QObject* parent = nullptr);

    const std::optional<LaidObject>& object() const { return m_object; }

    void setObject(const std::optional<LaidObject>& object);

    /// Lays an object of this shape there, or takes the object away. It keeps the size that it had before. A
    /// mesh is the one that was read last; without one, nothing happens.
    void lay(std::optional<LaidObject::Shape> shape, const Eigen::Vector3d& footM);
    /// Takes the object away, or lays the one that was there last.
    void toggle(const Eigen::Vector3d& footM);

    /// Reads an OBJ file in a task, and lays its mesh there in the size of the file's metres. The task says
    /// why if that fails, and the object stays as it is.
    void readMesh(const QString& file, const Eigen::Vector3d& footM);

    /// Whether a mesh was read.
    bool hasMesh() const { return m_mesh != nullptr; }

    /// Each does nothing without an object. Sizes stay between LaidObject::kSmallestM and kLargestM.
    void setSize(double sizeM);
    void turn(const Radians& angle);
    void moveBy(const Eigen::Vector2d& wayM);
    void standOn(const SurfaceSpot& spot);

  signals:
    void changed();

  private:
    TaskList& m_tasks;
    QPointer<Task> m_reading;
    std::optional<LaidObject> m_object;
    LaidObject m_latest; ///< The one that toggle() lays again.
    std::shared_ptr<const jobs::ObjectMesh> m_mesh;
};

} // namespace spherewalk::ui
