// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plan/floor_picture.h"
#include "ui/plan/outline_pen.h"
#include "ui/plan/plan_canvas.h"
#include "ui/plan/plan_editor.h"

#include <QLineF>

#include <optional>

namespace spherewalk::ui {

/// The room being drawn: corners to drag, walls to split, a pen, and the rails and stations that come of it.
/// Keys: Tab from corner to corner, arrows move the selected one, Delete removes it; while drawing, digits
/// type the next wall's length, Return sets the corner, Backspace takes back, Escape ends.
class PlanEditorView : public PlanCanvas {
    Q_OBJECT

  public:
    enum class Tool { Select, Outline, Obstacle, Scale };

    explicit PlanEditorView(PlanEditor& editor, QWidget* parent = nullptr);

    Tool tool() const { return m_tool; }

    void setTool(Tool tool);

    void setGrid(double gridM) { m_gridM = gridM; }

    FloorPicture& picture() { return m_picture; }

    /// Brings the room, or the picture where it is larger, into sight.
    void fitRoom();

  signals:
    void toolChanged(spherewalk::ui::PlanEditorView::Tool tool);
    /// A line over something whose length is known, for the picture's scale.
    void scaleDrawn(QLineF inRoom);
    /// What the keys do now, for people.
    void hint(const QString& sentence);

  protected:
    void paintFloor(QPainter& painter, const QTransform& widgetFromRoom) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

  private:
    void paintPicture(QPainter& painter, const QTransform& widgetFromRoom) const;
    void paintPlan(QPainter& painter, const QTransform& widgetFromRoom) const;
    void paintUncovered(QPainter& painter, const QTransform& widgetFromRoom) const;
    void paintSelection(QPainter& painter, const QTransform& widgetFromRoom) const;
    void paintLengths(QPainter& painter, const Polygon& polygon, const QTransform& widgetFromRoom,
                      bool isClosed) const;
    void paintPen(QPainter& painter, const QTransform& widgetFromRoom) const;

    /// The corner, else the wall, else the obstacle under this point of the widget.
    PlanPart partAt(const QPointF& at) const;
    /// The wall under this point: the corner before it.
    PlanPart wallAt(const QPointF& at) const;
    Eigen::Vector2d snappedPoint(const QPointF& at, Qt::KeyboardModifiers modifiers) const;
    void drag(const QPointF& at, Qt::KeyboardModifiers modifiers);
    void pressPen();
    void finishPen(const Polygon& polygon);
    bool penKey(QKeyEvent* event);
    void nextPart(int step);
    void nudge(const Eigen::Vector2d& by);

    PlanEditor& m_editor;
    FloorPicture m_picture;
    OutlinePen m_pen;
    Tool m_tool = Tool::Select;
    double m_gridM = 0.05;
    PlanPart m_dragged;
    Eigen::Vector2d m_dragFrom = Eigen::Vector2d::Zero();
    std::optional<QLineF> m_scaleLine;
};

} // namespace spherewalk::ui
