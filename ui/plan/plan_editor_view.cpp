// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plan/plan_editor_view.h"

#include <QKeyEvent>
#include <QMouseEvent>

#include <algorithm>
#include <cmath>

namespace spherewalk::ui {

using Eigen::Vector2d;

namespace {

constexpr double kReachPx = 10;

Vector2d vectorOf(const QPointF& point) {
    return {point.x(), point.y()};
}

QPointF pointOf(const Vector2d& vector) {
    return {vector.x(), vector.y()};
}

} // namespace

PlanEditorView::PlanEditorView(PlanEditor& editor, QWidget* parent)
    : PlanCanvas(parent), m_editor(editor), m_rails(editor) {
    setAccessibleName(tr("Drawing of the room"));
    setMouseTracking(true);
    connect(&editor, &PlanEditor::draftChanged, this, qOverload<>(&QWidget::update));
    connect(&editor, &PlanEditor::selectionChanged, this, qOverload<>(&QWidget::update));
    connect(&editor, &PlanEditor::outcomeChanged, this, qOverload<>(&QWidget::update));
}

void PlanEditorView::setTool(Tool tool) {
    if (m_pen.isDrawing()) {
        m_pen.cancel();
        m_editor.preview({});
    }
    m_scaleLine.reset();
    m_pinned.reset();
    const bool isForPicture = tool == Tool::Scale || tool == Tool::Place;
    m_tool = m_editor.isLocked() && !isForPicture ? Tool::Select : tool;
    if ((m_editor.selected().rail != PlanPart::kNone) != (m_tool == Tool::Rails)) {
        m_editor.select({});
    }
    if (m_tool == Tool::Outline || m_tool == Tool::Obstacle) {
        m_pen.start();
        emit hint(tr("Click corner after corner, or type a wall's length and press Return. "
                     "Close on the first corner, or with a double click."));
    } else {
        emit hint(m_tool == Tool::Scale   ? tr("Drag along something whose length you know.")
                  : m_tool == Tool::Place ? tr("Drag a corner on the picture to the corner where it belongs.")
                  : m_tool == Tool::Name  ? tr("Click into a room to name it, or on a name to change it.")
                  : m_tool == Tool::Rails ? RailTool::hint()
                                          : QString());
    }
    setCursor(m_tool == Tool::Select ? Qt::ArrowCursor : Qt::CrossCursor);
    update();
    emit toolChanged(m_tool);
}

void PlanEditorView::fitRoom() {
    Polygon shown = m_editor.draft().room.outline;
    for (const survey::Station& photo : m_editor.draft().byHand) {
        shown.emplace_back(photo.positionM.head<2>());
    }
    Bounds2 extent = bounds(shown);
    if (!m_picture.isEmpty()) {
        const QRectF picture = m_picture.extent();
        extent.least = extent.least.cwiseMin(vectorOf(picture.topLeft()));
        extent.greatest = extent.greatest.cwiseMax(vectorOf(picture.bottomRight()));
    }
    setExtent(extent);
    fit();
}

PlanPart PlanEditorView::partAt(const QPointF& at) const {
    const QTransform transform = widgetFromRoom();
    const int count = static_cast<int>(m_editor.draft().room.obstacles.size()) + 1;
    for (int i = count - 1; i >= 0; --i) { // obstacles lie above the outline
        const Polygon& polygon = m_editor.polygon(i);
        for (std::size_t k = 0; k < polygon.size(); ++k) {
            if (QLineF(transform.map(pointOf(polygon[k])), at).length() <= kReachPx) {
                return {i, static_cast<int>(k)};
            }
        }
    }
    for (int i = count - 1; i > 0; --i) {
        if (contains(m_editor.polygon(i), vectorOf(roomFromWidget(at)))) {
            return {i, PlanPart::kNone};
        }
    }
    return {wallAt(at).polygon, PlanPart::kNone};
}

PlanPart PlanEditorView::wallAt(const QPointF& at) const {
    const QTransform transform = widgetFromRoom();
    const int count = static_cast<int>(m_editor.draft().room.obstacles.size()) + 1;
    for (int i = count - 1; i >= 0; --i) {
        const QPolygonF corners = mapped(m_editor.polygon(i), transform);
        for (qsizetype k = 0; k < corners.size(); ++k) {
            if (distanceTo(at, QLineF(corners[k], corners[(k + 1) % corners.size()])) <= kReachPx) {
                return {i, static_cast<int>(k)};
            }
        }
    }
    return {};
}

std::optional<std::size_t> PlanEditorView::nameAt(const QPointF& at) const {
    const QTransform transform = widgetFromRoom();
    const std::vector<survey::RoomName>& names = m_editor.draft().room.names;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const QSize size = fontMetrics().size(Qt::TextSingleLine, QString::fromStdString(names[i].name));
        QRectF box(QPointF(), QSizeF(size) + QSizeF(kReachPx, kReachPx));
        box.moveCenter(mapped(names[i].at, transform));
        if (box.contains(at)) {
            return i;
        }
    }
    return std::nullopt;
}

Vector2d PlanEditorView::snappedPoint(const QPointF& at, Qt::KeyboardModifiers modifiers) const {
    const Vector2d point = vectorOf(roomFromWidget(at));
    if (modifiers.testFlag(Qt::AltModifier)) {
        return point;
    }
    Snapping snapping;
    snapping.gridM = m_gridM;
    snapping.reachM = kReachPx / pixelsPerMetre();
    if (m_pen.isDrawing()) {
        const Polygon& corners = m_pen.corners();
        if (!corners.empty()) {
            snapping.corners = {corners.front()};
            snapping.neighbours = {corners.front(), corners.back()};
        }
    } else if (m_dragged.corner != PlanPart::kNone) {
        const Polygon& polygon = m_editor.polygon(m_dragged.polygon);
        const auto k = static_cast<std::size_t>(m_dragged.corner);
        const std::size_t n = polygon.size();
        snapping.neighbours = {polygon[(k + n - 1) % n], polygon[(k + 1) % n]};
    }
    return snapped(point, snapping);
}

void PlanEditorView::mousePressEvent(QMouseEvent* event) {
    PlanCanvas::mousePressEvent(event);
    if (event->button() != Qt::LeftButton || event->modifiers() == Qt::ControlModifier) {
        return;
    }
    const QPointF at = event->position();
    if (m_tool == Tool::Scale || m_tool == Tool::Place) {
        m_scaleLine = QLineF(roomFromWidget(at), roomFromWidget(at));
    } else if (m_tool == Tool::Name) {
        return; // it acts on the release, as a question follows
    } else if (m_tool == Tool::Rails) {
        m_rails.press(at, snappedPoint(at, event->modifiers()), widgetFromRoom());
    } else if (m_pen.isDrawing()) {
        m_pen.moveTo(snappedPoint(at, event->modifiers()));
        pressPen();
    } else {
        m_dragged = partAt(at);
        m_editor.select(m_dragged);
        m_editor.endRun();
        m_dragFrom = snappedPoint(at, event->modifiers());
        if (m_dragged.polygon == PlanPart::kOutline && m_dragged.corner == PlanPart::kNone) {
            m_dragged = {}; // the room itself stays where it is
        }
    }
}

void PlanEditorView::mouseMoveEvent(QMouseEvent* event) {
    PlanCanvas::mouseMoveEvent(event);
    const QPointF at = event->position();
    if (m_scaleLine) {
        m_scaleLine->setP2(m_tool == Tool::Place ? cornerOr(at) : roomFromWidget(at));
        update();
    } else if (m_pen.isDrawing()) {
        m_pen.moveTo(snappedPoint(at, event->modifiers()));
        // While the line back to the first corner crosses a wall, the room is still to be drawn.
        if (m_tool == Tool::Outline && !defect(m_pen.preview())) {
            m_editor.preview(m_pen.preview());
        }
        update();
    } else if (m_tool == Tool::Rails && event->buttons().testFlag(Qt::LeftButton)) {
        m_rails.drag(snappedPoint(at, event->modifiers()), event->modifiers().testFlag(Qt::ShiftModifier));
    } else if (event->buttons().testFlag(Qt::LeftButton) && m_dragged.polygon != PlanPart::kNone) {
        drag(at, event->modifiers());
    } else if (m_tool == Tool::Select && event->buttons() == Qt::NoButton && !m_editor.isLocked()) {
        const PlanPart part = partAt(at);
        setCursor(part.corner != PlanPart::kNone ? Qt::SizeAllCursor
                  : part.polygon > 0             ? Qt::OpenHandCursor
                                                 : Qt::ArrowCursor);
    }
}

void PlanEditorView::drag(const QPointF& at, Qt::KeyboardModifiers modifiers) {
    const Vector2d to = snappedPoint(at, modifiers);
    if ((to - m_dragFrom).norm() == 0) {
        return;
    }
    if (m_dragged.corner != PlanPart::kNone) {
        m_editor.moveCorner(m_dragged, to);
    } else {
        m_editor.movePolygon(m_dragged.polygon, to - m_dragFrom);
    }
    m_dragFrom = to;
}

void PlanEditorView::mouseReleaseEvent(QMouseEvent* event) {
    PlanCanvas::mouseReleaseEvent(event);
    if (event->button() != Qt::LeftButton) {
        return;
    }
    if (m_tool == Tool::Name && event->modifiers() != Qt::ControlModifier) {
        emit nameWanted(roomFromWidget(event->position()), nameAt(event->position()));
    }
    if (m_scaleLine && m_scaleLine->length() > 0) {
        m_tool == Tool::Place ? placePicture(*m_scaleLine) : emit scaleDrawn(*m_scaleLine);
    }
    m_dragged = {};
    m_rails.release();
    m_editor.endRun();
}

void PlanEditorView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || m_editor.isLocked()) {
        return;
    }
    if (m_pen.isDrawing()) {
        m_pen.press();
        if (const auto polygon = m_pen.close()) {
            finishPen(*polygon);
        }
    } else if (m_tool == Tool::Select) {
        const PlanPart wall = wallAt(event->position());
        if (wall.polygon != PlanPart::kNone && partAt(event->position()).corner == PlanPart::kNone) {
            m_editor.insertCorner(wall, snappedPoint(event->position(), event->modifiers()));
        }
    }
}

QPointF PlanEditorView::cornerOr(const QPointF& at) const {
    const PlanPart part = partAt(at);
    return part.corner == PlanPart::kNone
               ? roomFromWidget(at)
               : pointOf(m_editor.polygon(part.polygon)[static_cast<std::size_t>(part.corner)]);
}

/// The first drag moves the picture. The second one turns and scales it around the place of the first.
void PlanEditorView::placePicture(const QLineF& inRoom) {
    m_scaleLine.reset();
    if (!m_pinned) {
        m_picture.move(inRoom.p1(), inRoom.p2());
        m_pinned = inRoom.p2();
        emit hint(tr("Drag a second corner to its place: the picture turns and scales around the first."));
    } else {
        m_picture.pull(*m_pinned, inRoom.p1(), inRoom.p2());
        setTool(Tool::Select);
    }
    emit pictureMoved();
    update();
}

void PlanEditorView::pressPen() {
    if (const auto polygon = m_pen.press()) {
        finishPen(*polygon);
    }
    update();
}

void PlanEditorView::finishPen(const Polygon& polygon) {
    if (m_tool == Tool::Outline) {
        m_editor.setOutline(polygon);
    } else {
        m_editor.addObstacle(polygon);
    }
    setTool(Tool::Select);
}

bool PlanEditorView::event(QEvent* event) {
    if (event->type() == QEvent::KeyPress && !m_editor.isLocked()) {
        const auto* key = static_cast<QKeyEvent*>(event);
        const bool isTab = key->key() == Qt::Key_Tab || key->key() == Qt::Key_Backtab;
        const PlanPart selected = m_editor.selected();
        if (isTab &&
            std::max(selected.corner, selected.rail) != PlanPart::kNone) { // leave with Escape, then Tab
            nextPart(key->key() == Qt::Key_Tab ? 1 : -1);
            return true;
        }
    }
    return PlanCanvas::event(event);
}

bool PlanEditorView::penKey(QKeyEvent* event) {
    switch (event->key()) {
    case Qt::Key_Escape:
        setTool(Tool::Select);
        return true;
    case Qt::Key_Backspace:
        m_pen.takeBack();
        break;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (m_pen.typed().isEmpty() && m_pen.corners().size() >= 3) {
            finishPen(*m_pen.close());
        } else {
            pressPen();
        }
        break;
    default:
        if (event->text().isEmpty() || !m_pen.type(event->text().at(0))) {
            return false;
        }
    }
    update();
    return true;
}

void PlanEditorView::keyPressEvent(QKeyEvent* event) {
    if (m_pen.isDrawing() ? penKey(event) : false) {
        return;
    }
    const bool isCoarse = event->modifiers().testFlag(Qt::ShiftModifier);
    const double step = std::max(m_gridM, 0.01) * (isCoarse ? 10 : 1);
    if (m_tool == Tool::Rails && m_rails.key(*event, step)) {
        return;
    }
    switch (event->key()) {
    case Qt::Key_Left:
        return nudge({-step, 0});
    case Qt::Key_Right:
        return nudge({step, 0});
    case Qt::Key_Up:
        return nudge({0, step});
    case Qt::Key_Down:
        return nudge({0, -step});
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
        return m_editor.removeSelected();
    case Qt::Key_Return:
    case Qt::Key_Enter:
        return nextPart(1);
    case Qt::Key_Escape:
        m_editor.select({});
        return setTool(Tool::Select);
    default:
        return PlanCanvas::keyPressEvent(event);
    }
}

void PlanEditorView::nextPart(int step) {
    if (m_tool == Tool::Rails) {
        return m_rails.next(step);
    }
    std::vector<PlanPart> corners;
    const int count = static_cast<int>(m_editor.draft().room.obstacles.size()) + 1;
    for (int i = 0; i < count; ++i) {
        for (int k = 0; k < static_cast<int>(m_editor.polygon(i).size()); ++k) {
            corners.push_back({i, k});
        }
    }
    const auto found = std::find(corners.begin(), corners.end(), m_editor.selected());
    const auto size = static_cast<std::ptrdiff_t>(corners.size());
    const std::ptrdiff_t next = found == corners.end() ? 0 : (found - corners.begin() + step + size) % size;
    m_editor.select(corners[static_cast<std::size_t>(next)]);
}

void PlanEditorView::nudge(const Vector2d& by) {
    const PlanPart part = m_editor.selected();
    if (part.corner != PlanPart::kNone) {
        m_editor.moveCorner(part, m_editor.polygon(part.polygon)[static_cast<std::size_t>(part.corner)] + by);
    } else if (part.polygon > 0) {
        m_editor.movePolygon(part.polygon, by);
    }
}

} // namespace spherewalk::ui
