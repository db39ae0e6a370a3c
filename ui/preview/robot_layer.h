// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plan/plan_canvas.h"
#include "ui/preview/drive.h"

#include "spherewalk/geometry/trajectory.h"
#include "spherewalk/jobs/ball_overlay.h"

#include <QColor>

#include <optional>
#include <vector>

namespace spherewalk::ui {

/// Draws the robot on the plan: where it stands, what its camera sees, which photo that comes from, the path
/// that is recorded, and the ball.
class RobotLayer : public PlanLayer {
  public:
    struct Scene {
        RobotPlace robot;
        Radians fov;
        std::optional<Eigen::Vector2d> photo; ///< that the view comes from
        std::optional<jobs::Ball> ball;
        std::vector<TimedPose> path;
    };

    /// Nothing: there is no robot.
    void setScene(std::optional<Scene> scene) { m_scene = std::move(scene); }

    void paint(QPainter& painter, const QTransform& widgetFromRoom) override;

  private:
    std::optional<Scene> m_scene;
};

} // namespace spherewalk::ui
