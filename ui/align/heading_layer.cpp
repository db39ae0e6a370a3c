// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/align/heading_layer.h"

#include "spherewalk/geometry/rotation.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::ui {

namespace {

constexpr double kShortestPx = 12;
constexpr double kLongestPx = 34;
constexpr double kLengthM = 0.16;
constexpr double kWidestFanDeg = 120;

} // namespace

void HeadingLayer::paint(QPainter& painter, const QTransform& widgetFromRoom) {
    const QColor ink = painter.pen().color();
    const double scale = std::hypot(widgetFromRoom.m11(), widgetFromRoom.m12());
    const double length = std::clamp(kLengthM * scale, kShortestPx, kLongestPx);
    for (const jobs::PhotoFinding& photo : m_photos) {
        if (!photo.roomFromPhoto) {
            continue;
        }
        const QPointF at = mapped(photo.roomFromPhoto->translation.head<2>(), widgetFromRoom);
        const double yawDeg = Degrees(yawPitchRoll(photo.roomFromPhoto->rotation).yaw).value();
        if (photo.sigmaYaw) {
            const double halfDeg =
                std::min(0.5 * kWidestFanDeg, 3 * kMagnified * Degrees(*photo.sigmaYaw).value());
            QColor fan = ink;
            fan.setAlphaF(0.25F);
            painter.setPen(Qt::NoPen);
            painter.setBrush(fan);
            // Qt counts sixteenths of a degree, counter-clockwise as the room does.
            painter.drawPie(QRectF(at.x() - length, at.y() - length, 2 * length, 2 * length),
                            static_cast<int>(16 * (yawDeg - halfDeg)), static_cast<int>(32 * halfDeg));
        }
        QLineF line(at, at + QPointF(length, 0));
        line.setAngle(yawDeg);
        painter.setPen(QPen(ink, 1.6));
        painter.drawLine(line);
    }
}

} // namespace spherewalk::ui
