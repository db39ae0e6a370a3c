// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/angle.h"
#include "spherewalk/geometry/polygon.h"
#include "spherewalk/geometry/rigid3.h"

#include <vector>

namespace spherewalk::ui {

/// Where a robot stands. Frames: room.
struct RobotPlace {
    Eigen::Vector2d pInRoom = Eigen::Vector2d::Zero();
    Radians yaw;
};

/// How the robot carries its camera.
struct CameraMount {
    double heightM = 1.2;
    Radians down; ///< below the horizon
};

/// Of the camera's optical frame.
Rigid3 roomFromOptical(const RobotPlace& robot, const CameraMount& mount);

/// What the driver wants, each in [-1, 1].
struct DriveWish {
    double forward = 0;
    double left = 0;
    double turnLeft = 0;

    bool isNone() const { return forward == 0 && left == 0 && turnLeft == 0; }
};

/// Moves a robot as it is driven, and keeps it on the floor: along a wall it slides.
class Drive {
  public:
    static constexpr double kSpeedMps = 0.8;
    static constexpr Degrees kTurnPerSecond{60};

    Drive() = default;

    /// Without an outline it may go anywhere.
    Drive(Polygon outline, std::vector<Polygon> obstacles);

    RobotPlace after(const RobotPlace& robot, const DriveWish& wish, double seconds) const;
    bool isFloor(const Eigen::Vector2d& point) const;

  private:
    Polygon m_outline;
    std::vector<Polygon> m_obstacles;
};

} // namespace spherewalk::ui
