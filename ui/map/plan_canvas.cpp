// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/map/plan_canvas.h"

#include "ui/look/words.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace spherewalk::ui {

namespace {

constexpr double kMarginPx = 28;
constexpr double kLeastPixelsPerMetre = 0.05;
constexpr double kMostPixelsPerMetre = 5000;

/// Returns the least of 1, 2, 5 times a power of ten that is not below `least`.
double roundedUp(double least) {
    const double power = std::pow(10, std::floor(std::log10(least)));
    for (const double step : {1.0, 2.0, 5.0}) {
        if (step * power >= least) {
            return step * power;
        }
    }
    return 10 * power;
}

} // namespace

QPointF mapped(const Eigen::Vector2d& place, const QTransform& widgetFromRoom) {
    return widgetFromRoom.map(QPointF(place.x(), place.y()));
}

QPolygonF mapped(const Polygon& polygon, const QTransform& widgetFromRoom) {
    QPolygonF result;
    for (const Eigen::Vector2d& vertex : polygon) {
        result << mapped(vertex, widgetFromRoom);
    }
    return result;
}

PlanCanvas::PlanCanvas(QWidget* parent) : QWidget(parent) {
    setMinimumSize(160, 120);
    setFocusPolicy(Qt::StrongFocus);
    announceAs(*this, QAccessible::Graphic, tr("Plan of the room"));
}

void PlanCanvas::setExtent(const Bounds2& extent) {
    m_extent = extent;
    update();
}

void PlanCanvas::fit() {
    m_moved.reset();
    update();
}

QTransform PlanCanvas::fitting() const {
    const Eigen::Vector2d size = (m_extent.greatest - m_extent.least).cwiseMax(0.1);
    const double scale = std::max(kLeastPixelsPerMetre, std::min((width() - 2 * kMarginPx) / size.x(),
                                                                 (height() - 2 * kMarginPx) / size.y()));
    const Eigen::Vector2d centre = 0.5 * (m_extent.least + m_extent.greatest);
    QTransform transform;
    transform.translate(0.5 * width(), 0.5 * height());
    transform.scale(scale, -scale);
    transform.translate(-centre.x(), -centre.y());
    return transform;
}

QTransform PlanCanvas::widgetFromRoom() const {
    return m_moved.value_or(fitting());
}

QPointF PlanCanvas::roomFromWidget(const QPointF& at) const {
    return widgetFromRoom().inverted().map(at);
}

double PlanCanvas::pixelsPerMetre() const {
    return widgetFromRoom().m11();
}

void PlanCanvas::zoom(double factor, const QPointF& around) {
    const QTransform now = widgetFromRoom();
    const double scale = std::clamp(now.m11() * factor, kLeastPixelsPerMetre, kMostPixelsPerMetre);
    const QPointF kept = now.inverted().map(around);
    QTransform next;
    next.translate(around.x(), around.y());
    next.scale(scale, -scale);
    next.translate(-kept.x(), -kept.y());
    m_moved = next;
    update();
}

void PlanCanvas::addLayer(PlanLayer* layer) {
    m_layers << layer;
    update();
}

void PlanCanvas::removeLayer(PlanLayer* layer) {
    m_layers.removeAll(layer);
    update();
}

void PlanCanvas::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QTransform transform = widgetFromRoom();
    if (showsGrid()) {
        paintGrid(painter, transform);
    }
    paintFloor(painter, transform);
    for (PlanLayer* layer : std::as_const(m_layers)) {
        painter.save();
        painter.setPen(palette().color(QPalette::WindowText));
        layer->paint(painter, transform);
        painter.restore();
    }
    if (showsGrid()) {
        paintScale(painter);
    }
}

void PlanCanvas::paintRoom(QPainter& painter, const survey::Room& room, const QColor& floor,
                           const QTransform& widgetFromRoom, Qt::PenStyle walls) const {
    const QColor ink = palette().color(QPalette::WindowText);
    const bool isWhole = walls == Qt::SolidLine;
    painter.setPen(QPen(ink, isWhole ? 3 : 1.5, walls, isWhole ? Qt::SquareCap : Qt::FlatCap, Qt::MiterJoin));
    painter.setBrush(floor);
    painter.drawPolygon(mapped(room.outline, widgetFromRoom));
    painter.setPen(QPen(ink, 1.2));
    painter.setBrush(QBrush(palette().color(QPalette::Mid), Qt::BDiagPattern));
    for (const Polygon& obstacle : room.obstacles) {
        painter.drawPolygon(mapped(obstacle, widgetFromRoom));
    }
}

void PlanCanvas::paintNames(QPainter& painter, const survey::Room& room,
                            const QTransform& widgetFromRoom) const {
    QColor plate = palette().color(QPalette::Base);
    plate.setAlphaF(0.65F); // what lies below shines through
    for (const survey::RoomName& name : room.names) {
        const QString words = QString::fromStdString(name.name);
        QRectF box = painter.fontMetrics().boundingRect(words).adjusted(-6, -2, 6, 2);
        box.moveCenter(mapped(name.at, widgetFromRoom));
        painter.setPen(Qt::NoPen);
        painter.setBrush(plate);
        painter.drawRoundedRect(box, 4, 4);
        painter.setPen(palette().color(QPalette::WindowText));
        painter.drawText(box, Qt::AlignCenter, words);
    }
}

void PlanCanvas::paintGrid(QPainter& painter, const QTransform& widgetFromRoom) const {
    constexpr double kLeastSpacingPx = 40;
    const double spacing = roundedUp(kLeastSpacingPx / widgetFromRoom.m11());
    const QRectF seen = widgetFromRoom.inverted().mapRect(QRectF(rect()));
    QColor colour = palette().color(QPalette::WindowText);
    colour.setAlphaF(0.08F);
    painter.setPen(QPen(colour, 1));
    for (double x = std::ceil(seen.left() / spacing) * spacing; x <= seen.right(); x += spacing) {
        const double at = widgetFromRoom.map(QPointF(x, 0)).x();
        painter.drawLine(QPointF(at, 0), QPointF(at, height()));
    }
    for (double y = std::ceil(seen.top() / spacing) * spacing; y <= seen.bottom(); y += spacing) {
        const double at = widgetFromRoom.map(QPointF(0, y)).y();
        painter.drawLine(QPointF(0, at), QPointF(width(), at));
    }
}

void PlanCanvas::paintScale(QPainter& painter) const {
    constexpr double kLeastLengthPx = 60;
    const double metres = roundedUp(kLeastLengthPx / pixelsPerMetre());
    const double length = metres * pixelsPerMetre();
    const QPointF begin(12, height() - 10.0);
    painter.setPen(QPen(palette().color(QPalette::WindowText), 1.5));
    painter.drawLine(begin, begin + QPointF(length, 0));
    painter.drawLine(begin - QPointF(0, 4), begin + QPointF(0, 0));
    painter.drawLine(begin + QPointF(length, -4), begin + QPointF(length, 0));
    const QString words = metres < 1 ? tr("%1 cm").arg(100 * metres) : tr("%1 m").arg(metres);
    painter.drawText(begin + QPointF(length + 6, 3), words);
}

void PlanCanvas::mousePressEvent(QMouseEvent* event) {
    const bool pans = event->button() == Qt::MiddleButton ||
                      (event->button() == Qt::LeftButton && event->modifiers() == Qt::ControlModifier);
    if (pans) {
        m_panFrom = event->position();
        setCursor(Qt::ClosedHandCursor);
    } else if (event->button() == Qt::LeftButton) {
        emit pressedAt(roomFromWidget(event->position()), event->modifiers());
    }
}

void PlanCanvas::mouseMoveEvent(QMouseEvent* event) {
    if (m_panFrom) {
        const QPointF by = event->position() - *m_panFrom;
        m_moved = widgetFromRoom() * QTransform::fromTranslate(by.x(), by.y());
        m_panFrom = event->position();
        update();
    } else if (event->buttons().testFlag(Qt::LeftButton)) {
        emit draggedTo(roomFromWidget(event->position()), event->modifiers());
    }
}

void PlanCanvas::mouseReleaseEvent(QMouseEvent* event) {
    if (m_panFrom) {
        m_panFrom.reset();
        unsetCursor();
    } else if (event->button() == Qt::LeftButton) {
        emit releasedAt(roomFromWidget(event->position()), event->modifiers());
    }
}

void PlanCanvas::wheelEvent(QWheelEvent* event) {
    constexpr double kFactorANotch = 1.2;
    constexpr double kNotch = 120;
    zoom(std::pow(kFactorANotch, event->angleDelta().y() / kNotch), event->position());
    event->accept();
}

void PlanCanvas::keyPressEvent(QKeyEvent* event) {
    constexpr double kStep = 1.25;
    const QPointF centre = QRectF(rect()).center();
    switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        return zoom(kStep, centre);
    case Qt::Key_Minus:
        return zoom(1 / kStep, centre);
    case Qt::Key_0:
        return fit();
    default:
        return QWidget::keyPressEvent(event);
    }
}

double distanceTo(const QPointF& point, const QLineF& line) {
    if (line.length() == 0) {
        return QLineF(point, line.p1()).length();
    }
    const QPointF along = line.p2() - line.p1();
    const double t = QPointF::dotProduct(point - line.p1(), along) / QPointF::dotProduct(along, along);
    return QLineF(point, line.pointAt(std::clamp(t, 0.0, 1.0))).length();
}

} // namespace spherewalk::ui
