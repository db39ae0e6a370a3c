// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/preview/robot_layer.h"

#include "ui/look/theme.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::ui {

namespace {

constexpr double kBodyPx = 11;
constexpr double kFanPx = 90;
const QColor kPath(204, 121, 167);

} // namespace

void RobotLayer::paint(QPainter& painter, const QTransform& widgetFromRoom) {
    if (!m_scene) {
        return;
    }
    const QColor robotColour = goodColour();
    if (m_scene->path.size() > 1) {
        QPolygonF line;
        for (const TimedPose& pose : m_scene->path) {
            line << mapped(pose.roomFromCamera.translation.head<2>(), widgetFromRoom);
        }
        painter.setPen(QPen(kPath, 2.5));
        painter.drawPolyline(line);
    }
    if (m_scene->ball) {
        const jobs::Ball& ball = *m_scene->ball;
        const double radius =
            std::max(4.0, ball.radiusM * std::hypot(widgetFromRoom.m11(), widgetFromRoom.m12()));
        painter.setPen(QPen(QColor(ball.colour[0], ball.colour[1], ball.colour[2]), 2));
        painter.setBrush(QColor(ball.colour[0], ball.colour[1], ball.colour[2], 110));
        painter.drawEllipse(mapped(ball.centreM.head<2>(), widgetFromRoom), radius, radius);
    }
    const QPointF at = mapped(m_scene->robot.pInRoom, widgetFromRoom);
    if (m_scene->photo) {
        painter.setPen(QPen(robotColour, 1.5, Qt::DashLine));
        painter.drawLine(at, mapped(*m_scene->photo, widgetFromRoom));
    }
    const double yawDeg = Degrees(m_scene->robot.yaw).value();
    const double fovDeg = std::min(359.0, Degrees(m_scene->fov).value());
    QColor fan = robotColour;
    fan.setAlpha(60);
    painter.setPen(QPen(robotColour, 1));
    painter.setBrush(fan);
    painter.drawPie(QRectF(at.x() - kFanPx, at.y() - kFanPx, 2 * kFanPx, 2 * kFanPx),
                    static_cast<int>(16 * (yawDeg - 0.5 * fovDeg)), static_cast<int>(16 * fovDeg));
    painter.save();
    painter.translate(at);
    painter.rotate(-yawDeg);
    painter.setPen(QPen(Qt::white, 1.5));
    painter.setBrush(robotColour);
    painter.drawPolygon(QPolygonF({{kBodyPx, 0},
                                   {-0.7 * kBodyPx, 0.7 * kBodyPx},
                                   {-0.35 * kBodyPx, 0},
                                   {-0.7 * kBodyPx, -0.7 * kBodyPx}}));
    painter.restore();
}

} // namespace spherewalk::ui
