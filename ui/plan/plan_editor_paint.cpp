// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/theme.h"
#include "ui/plan/plan_editor_view.h"

#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace spherewalk::ui {

using Eigen::Vector2d;

namespace {

constexpr double kHandlePx = 5;

/// Draws a small padlock around this point.
void paintLock(QPainter& painter, const QPointF& at, const QColor& colour) {
    painter.setPen(QPen(colour, 1.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawArc(QRectF(at.x() - 3, at.y() - 6, 6, 8), 0, 180 * 16);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawRect(QRectF(at.x() - 4.5, at.y() - 2, 9, 7));
}

} // namespace

void PlanEditorView::paintFloor(QPainter& painter, const QTransform& widgetFromRoom) {
    paintPicture(painter, widgetFromRoom);
    QColor floor = palette().color(QPalette::Base);
    floor.setAlphaF(m_picture.isEmpty() ? 1.0F : 0.3F);
    paintRoom(painter, m_editor.draft().room, floor, widgetFromRoom,
              m_editor.draft().isRoomKnown ? Qt::SolidLine : Qt::DashLine);
    paintPlan(painter, widgetFromRoom);
    paintNames(painter, m_editor.draft().room, widgetFromRoom);
    paintUncovered(painter, widgetFromRoom);
    paintSelection(painter, widgetFromRoom);
    paintPen(painter, widgetFromRoom);
}

void PlanEditorView::paintPicture(QPainter& painter, const QTransform& widgetFromRoom) const {
    if (m_picture.isEmpty()) {
        return;
    }
    painter.save();
    painter.setOpacity(0.5);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.setTransform(m_picture.roomFromPicture() * widgetFromRoom);
    painter.drawImage(0, 0, m_picture.image());
    painter.restore();
}

void PlanEditorView::paintPlan(QPainter& painter, const QTransform& widgetFromRoom) const {
    const std::vector<survey::RailPlacement>& rails = m_editor.rails();
    QColor colour = palette().color(QPalette::Highlight);
    colour.setAlphaF(m_editor.isSettled() ? 1.0F : 0.5F);
    const double spacingPx = m_editor.draft().options.stepM * pixelsPerMetre();
    const double radius = std::clamp(0.14 * spacingPx, 1.2, 5.0);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    for (const survey::Station& photo : m_editor.draft().byHand) {
        painter.drawEllipse(mapped(photo.positionM.head<2>(), widgetFromRoom), radius, radius);
    }
    for (std::size_t i = 0; i < rails.size(); ++i) {
        paintRail(painter, static_cast<int>(i), radius, colour, widgetFromRoom);
    }
    constexpr double kLeastForNumbersPx = 16;
    if (spacingPx < kLeastForNumbersPx) {
        return;
    }
    painter.setPen(palette().color(QPalette::WindowText));
    for (std::size_t i = 0; i < rails.size(); ++i) {
        const QPointF at = mapped(rails[i].origin, widgetFromRoom);
        painter.drawText(at + QPointF(radius + 4, -radius - 2), QString::number(i + 1));
    }
}

void PlanEditorView::paintRail(QPainter& painter, int index, double radius, const QColor& colour,
                               const QTransform& widgetFromRoom) const {
    const survey::RailPlacement& rail = m_editor.rails()[static_cast<std::size_t>(index)];
    const PlanPart selected = m_editor.selected();
    const bool isSelected = selected.rail == index;
    const QPointF first = mapped(rail.stop(0), widgetFromRoom);
    const QPointF last = mapped(rail.stop(rail.stops - 1), widgetFromRoom);
    painter.setPen(QPen(colour, (isSelected ? 2 : 1) * std::clamp(0.35 * radius, 0.8, 2.0)));
    painter.drawLine(first, last);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    for (int k = 0; k < rail.stops; ++k) {
        painter.drawEllipse(mapped(rail.stop(k), widgetFromRoom), radius, radius);
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colour, 1.5));
    painter.drawEllipse(first, radius + 2.5, radius + 2.5); // where the operator begins
    const double half = radius + kHandlePx;
    const auto drawSquare = [&](const QPointF& at, double side) {
        painter.drawRect(QRectF(at.x() - side, at.y() - side, 2 * side, 2 * side));
    };
    if (rail.isLocked) {
        paintLock(painter, (first + last) / 2 - QPointF(0, radius + 9), colour);
    }
    if (isSelected) {
        painter.setPen(QPen(palette().color(QPalette::WindowText), 1.5));
        drawSquare(first, half);
        drawSquare(last, half);
    }
    if (isSelected && selected.stop != PlanPart::kNone) {
        painter.setBrush(palette().color(QPalette::WindowText));
        drawSquare(mapped(rail.stop(selected.stop), widgetFromRoom), radius + 1);
    }
}

void PlanEditorView::paintUncovered(QPainter& painter, const QTransform& widgetFromRoom) const {
    const double leastM2 = 0.5 * m_editor.draft().options.stepM * m_editor.draft().options.stepM;
    for (const survey::UncoveredArea& area : m_editor.outcome().report.uncovered) {
        if (area.areaM2 < leastM2 || area.reason == survey::UncoveredReason::Clearance) {
            continue; // along every wall lies a strip that the clearance leaves out
        }
        const QPointF at = mapped(area.point, widgetFromRoom);
        const QColor colour = failedColour();
        painter.setPen(QPen(colour, 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawLine(at + QPointF(-5, -5), at + QPointF(5, 5));
        painter.drawLine(at + QPointF(-5, 5), at + QPointF(5, -5));
        painter.drawText(at + QPointF(9, 4), tr("%L1 m² not covered").arg(area.areaM2, 0, 'f', 2));
    }
}

void PlanEditorView::paintSelection(QPainter& painter, const QTransform& widgetFromRoom) const {
    if (m_editor.isLocked() || m_pen.isDrawing()) {
        return;
    }
    const QColor colour = palette().color(QPalette::WindowText);
    const PlanPart selected = m_editor.selected();
    const int count = static_cast<int>(m_editor.draft().room.obstacles.size()) + 1;
    for (int i = 0; i < count; ++i) {
        const Polygon& polygon = m_editor.polygon(i);
        const bool isSelected = selected.polygon == i;
        if (isSelected || (i == PlanPart::kOutline && selected.polygon == PlanPart::kNone)) {
            const bool isOutline = i == PlanPart::kOutline;
            paintLengths(painter, polygon, widgetFromRoom,
                         isOutline ? LengthSide::OfRoom : LengthSide::Outside);
        }
        for (std::size_t k = 0; k < polygon.size(); ++k) {
            const QPointF at = mapped(polygon[k], widgetFromRoom);
            const bool isCorner = isSelected && static_cast<int>(k) == selected.corner;
            painter.setPen(QPen(colour, isSelected ? 2 : 1));
            painter.setBrush(isCorner ? palette().color(QPalette::Highlight)
                                      : palette().color(QPalette::Base));
            const double half = isCorner ? kHandlePx + 1.5 : kHandlePx - (isSelected ? 0 : 1.5);
            painter.drawRect(QRectF(at.x() - half, at.y() - half, 2 * half, 2 * half));
        }
    }
}

/// Returns a label that lies along a wall, or across it. aside: 1 on the right of the wall's direction on the
/// screen, -1 on its left, 0 on the wall.
LengthLabel PlanEditorView::labelBeside(const QLineF& wall, const QString& words, double aside) const {
    constexpr double kGapPx = 4;
    const QPointF along = (wall.p2() - wall.p1()) / wall.length();
    LengthLabel label{words, fontMetrics().boundingRect(words), std::abs(along.y()) > std::abs(along.x())};
    label.box = label.box.adjusted(-4, -1, 4, 1);
    if (label.isUpright) {
        label.box = label.box.transposed();
    }
    const double reachPx =
        0.5 * (std::abs(along.y()) * label.box.width() + std::abs(along.x()) * label.box.height());
    label.box.moveCenter(wall.center() + aside * (reachPx + kGapPx) * QPointF(-along.y(), along.x()));
    return label;
}

/// Returns the labels of a polygon. Those of a room stand outside, where no stops are, unless there is floor
/// too, as behind a thin wall.
std::vector<LengthLabel> PlanEditorView::lengthLabels(const Polygon& polygon,
                                                      const QTransform& widgetFromRoom,
                                                      LengthSide side) const {
    const std::size_t walls = side == LengthSide::OnOpenLine ? polygon.size() - 1 : polygon.size();
    const double outside = signedArea(polygon) > 0 ? 1 : -1; // y points down on the screen
    QPainterPath floor;
    floor.addPolygon(mapped(polygon, widgetFromRoom));
    floor.closeSubpath();
    std::vector<LengthLabel> labels;
    for (std::size_t i = 0; i < walls; ++i) {
        const Vector2d& begin = polygon[i];
        const Vector2d& end = polygon[(i + 1) % polygon.size()];
        const QLineF wall(mapped(begin, widgetFromRoom), mapped(end, widgetFromRoom));
        const QString words = tr("%L1 m").arg((end - begin).norm(), 0, 'f', 2);
        if (wall.length() < fontMetrics().horizontalAdvance(words) + 12) {
            continue;
        }
        LengthLabel label = labelBeside(wall, words, side == LengthSide::OnOpenLine ? 0 : outside);
        const bool isFree = QRectF(rect()).contains(label.box) && !floor.intersects(label.box);
        if (side == LengthSide::OfRoom && !isFree) {
            label = labelBeside(wall, words, -outside);
        }
        labels.push_back(label);
    }
    return labels;
}

std::vector<LengthLabel> PlanEditorView::lengthLabels() const {
    return lengthLabels(m_editor.draft().room.outline, widgetFromRoom(), LengthSide::OfRoom);
}

void PlanEditorView::paintLengths(QPainter& painter, const Polygon& polygon, const QTransform& widgetFromRoom,
                                  LengthSide side) const {
    for (const LengthLabel& label : lengthLabels(polygon, widgetFromRoom, side)) {
        painter.save();
        painter.translate(label.box.center());
        painter.rotate(label.isUpright ? -90 : 0);
        const QSizeF size = label.isUpright ? label.box.size().transposed() : label.box.size();
        const QRectF box(QPointF(-0.5 * size.width(), -0.5 * size.height()), size);
        painter.setPen(Qt::NoPen);
        painter.setBrush(palette().color(QPalette::Window));
        painter.drawRoundedRect(box, 4, 4);
        painter.setPen(palette().color(QPalette::WindowText));
        painter.drawText(box, Qt::AlignCenter, label.words);
        painter.restore();
    }
}

void PlanEditorView::paintPen(QPainter& painter, const QTransform& widgetFromRoom) const {
    const QColor colour = palette().color(QPalette::Highlight);
    if (m_scaleLine) {
        painter.setPen(QPen(colour, 2, Qt::DashLine));
        painter.drawLine(widgetFromRoom.map(*m_scaleLine));
    }
    if (m_pinned) {
        painter.setPen(QPen(colour, 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(widgetFromRoom.map(*m_pinned), kHandlePx + 3, kHandlePx + 3);
    }
    if (!m_pen.isDrawing()) {
        return;
    }
    const Polygon preview = m_pen.preview();
    painter.setPen(QPen(colour, 2, Qt::DashLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(mapped(preview, widgetFromRoom));
    paintLengths(painter, preview, widgetFromRoom, LengthSide::OnOpenLine);
    for (const Vector2d& corner : m_pen.corners()) {
        const QPointF at = mapped(corner, widgetFromRoom);
        painter.setPen(QPen(colour, 2));
        painter.setBrush(palette().color(QPalette::Base));
        painter.drawRect(QRectF(at.x() - kHandlePx, at.y() - kHandlePx, 2 * kHandlePx, 2 * kHandlePx));
    }
    if (!m_pen.typed().isEmpty()) {
        const QPointF at = mapped(m_pen.tip(), widgetFromRoom) + QPointF(14, -10);
        const QString words = tr("%1 m, then Return").arg(m_pen.typed());
        const QRectF box =
            QRectF(painter.fontMetrics().boundingRect(words)).translated(at).adjusted(-5, -3, 5, 3);
        painter.setPen(QPen(colour, 1));
        painter.setBrush(palette().color(QPalette::Base));
        painter.drawRoundedRect(box, 4, 4);
        painter.setPen(palette().color(QPalette::WindowText));
        painter.drawText(box, Qt::AlignCenter, words);
    }
}

} // namespace spherewalk::ui
