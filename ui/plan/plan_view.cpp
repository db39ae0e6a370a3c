// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plan/plan_view.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <utility>

namespace spherewalk::ui {

namespace {

constexpr double kMarginPx = 24;

QPolygonF polygonOf(const Polygon& polygon, const QTransform& widgetFromRoom) {
    QPolygonF result;
    for (const Eigen::Vector2d& vertex : polygon) {
        result << widgetFromRoom.map(QPointF(vertex.x(), vertex.y()));
    }
    return result;
}

} // namespace

PlanView::PlanView(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Plan of the room"));
    setMinimumSize(320, 240);
}

void PlanView::setRoom(const survey::Room& room) {
    m_room = room;
    update();
}

void PlanView::setStations(std::vector<StationMark> stations) {
    m_stations = std::move(stations);
    update();
}

QSize PlanView::sizeHint() const {
    return {800, 600};
}

QTransform PlanView::widgetFromRoom() const {
    if (m_room.outline.empty()) {
        return {};
    }
    const Bounds2 room = bounds(m_room.outline);
    const Eigen::Vector2d size = room.greatest - room.least;
    const double scale =
        std::min((width() - 2 * kMarginPx) / size.x(), (height() - 2 * kMarginPx) / size.y());
    const Eigen::Vector2d centre = 0.5 * (room.least + room.greatest);
    QTransform transform;
    transform.translate(0.5 * width(), 0.5 * height());
    transform.scale(scale, -scale);
    transform.translate(-centre.x(), -centre.y());
    return transform;
}

double PlanView::stationRadiusPx(const QTransform& widgetFromRoom) const {
    constexpr double kRadiusM = 0.06;
    return std::clamp(kRadiusM * widgetFromRoom.m11(), 2.0, 12.0);
}

void PlanView::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_room.outline.empty()) {
        painter.drawText(rect(), Qt::AlignCenter, tr("No survey is open"));
        return;
    }
    const QTransform transform = widgetFromRoom();
    painter.setPen(QPen(palette().color(QPalette::WindowText), 3));
    painter.setBrush(palette().base());
    painter.drawPolygon(polygonOf(m_room.outline, transform));
    painter.setPen(QPen(palette().color(QPalette::WindowText), 1));
    painter.setBrush(QBrush(palette().color(QPalette::Mid), Qt::BDiagPattern));
    for (const Polygon& obstacle : m_room.obstacles) {
        painter.drawPolygon(polygonOf(obstacle, transform));
    }
    const double radius = stationRadiusPx(transform);
    const QColor colour = palette().color(QPalette::Highlight);
    for (const StationMark& station : m_stations) {
        painter.setPen(QPen(colour, 2));
        painter.setBrush(station.hasPhoto ? QBrush(colour) : QBrush(Qt::NoBrush));
        painter.drawEllipse(transform.map(QPointF(station.positionM.x(), station.positionM.y())), radius,
                            radius);
    }
}

bool PlanView::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) {
        return QWidget::event(event);
    }
    const auto* help = static_cast<QHelpEvent*>(event);
    const QTransform transform = widgetFromRoom();
    const double reach = 2 * stationRadiusPx(transform);
    const auto found = std::find_if(m_stations.begin(), m_stations.end(), [&](const StationMark& station) {
        const QPointF at = transform.map(QPointF(station.positionM.x(), station.positionM.y()));
        return QLineF(at, help->pos()).length() <= reach;
    });
    if (found == m_stations.end()) {
        QToolTip::hideText();
    } else {
        QToolTip::showText(help->globalPos(), found->name, this);
    }
    return true;
}

} // namespace spherewalk::ui
