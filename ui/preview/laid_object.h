// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tasks/task.h"

#include "spherewalk/geometry/angle.h"
#include "spherewalk/jobs/object_overlay.h"

#include <QObject>
#include <QPointer>

#include <memory>
#include <optional>

namespace spherewalk::ui {

/// An object that stands in the room of the preview, as a simulator would render it into the views.
struct LaidObject {
    enum class Shape { Ball, Box, Mesh };

    Shape shape = Shape::Ball;
    double sizeM = 0.4; ///< Its longest side.
    Eigen::Vector3d footM =
        Eigen::Vector3d::Zero(); ///< The middle of the lower face of its bounds. Frames: room.
    Radians yaw;
    std::shared_ptr<const jobs::ObjectMesh> mesh = {}; ///< Of Shape::Mesh: not null.

    static constexpr double kSmallestM = 0.01;
    static constexpr double kLargestM = 10;

    /// The sides of its bounds before it is turned.
    Eigen::Vector3d sidesM() const;
    /// The object as jobs::walk() takes it. Range: Shape::Ball.
    jobs::Ball ball() const;
    /// The same. Range: Shape::Box and Shape::Mesh.
    jobs::PlacedMesh placed() const;
    /// Colour and depth from this pose. Errors: those of jobs::meshOverlay().
    render::Overlay overlay(const CameraModel& camera, const Rigid3& roomFromCamera) const;
};

/// A place of a surface in the room.
struct SurfaceSpot {
    Eigen::Vector3d pInRoom;
    Eigen::Vector3d normal; ///< A unit vector into the room.
};

/// The spot that a pixel of a depth image shows, or nothing where no depth is known. Where its neighbours say
/// too little of the surface, that is taken to be level.
std::optional<SurfaceSpot> spotAt(const DepthImage& depth, const CameraModel& camera,
                                  const Rigid3& roomFromCamera, const Eigen::Vector2i& pixel);

/// Puts the object onto the spot: it stands on floors and tables, and touches walls and ceilings. At a wall
/// it turns its side to the wall.
void standOn(const SurfaceSpot& spot, LaidObject& object);

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
