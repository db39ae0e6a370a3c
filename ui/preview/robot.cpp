// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/preview/drive.h"

#include "spherewalk/geometry/rotation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace spherewalk::ui {

Rigid3 roomFromOptical(const RobotPlace& robot, const CameraMount& mount) {
    return {rotation({robot.yaw, mount.down, Radians(0)}) * bodyFromOptical(),
            {robot.pInRoom.x(), robot.pInRoom.y(), mount.heightM}};
}

Drive::Drive(Polygon outline, std::vector<Polygon> obstacles)
    : m_outline(std::move(outline)), m_obstacles(std::move(obstacles)) {
}

bool Drive::isFloor(const Eigen::Vector2d& point) const {
    return (m_outline.empty() || contains(m_outline, point)) &&
           std::none_of(m_obstacles.begin(), m_obstacles.end(),
                        [&](const Polygon& obstacle) { return contains(obstacle, point); });
}

RobotPlace Drive::after(const RobotPlace& robot, const DriveWish& wish, double seconds) const {
    RobotPlace next = robot;
    next.yaw = wrapped(robot.yaw + Radians(kTurnPerSecond) * (wish.turnLeft * seconds));
    const double way = kSpeedMps * seconds;
    const Eigen::Vector2d ahead(cos(robot.yaw), sin(robot.yaw));
    const Eigen::Vector2d beside(-ahead.y(), ahead.x());
    const Eigen::Vector2d step = way * (wish.forward * ahead + wish.left * beside);
    for (const Eigen::Vector2d& tried : std::array<Eigen::Vector2d, 3>{step, {step.x(), 0}, {0, step.y()}}) {
        // A robot that was put where no floor is may leave.
        if (isFloor(robot.pInRoom + tried) || !isFloor(robot.pInRoom)) {
            next.pInRoom = robot.pInRoom + tried;
            break;
        }
    }
    return next;
}

} // namespace spherewalk::ui
