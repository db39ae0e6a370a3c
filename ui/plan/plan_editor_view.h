// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/map/floor_picture.h"
#include "ui/map/plan_canvas.h"
#include "ui/plan/outline_pen.h"
#include "ui/plan/plan_editor.h"
#include "ui/plan/rail_tool.h"

#include <QLineF>

#include <optional>
#include <vector>

namespace spherewalk::ui {

/// The length of a wall as the drawing shows it.
struct LengthLabel {
    QString words;
    QRectF box;             ///< On the widget.
    bool isUpright = false; ///< Whether the words run upwards.
};

/// The drawing of the room: corners to drag, walls to split, a pen, and the rails and stations of the plan.
/// Tab goes from corner to corner, arrows move the selected corner, and Delete removes it. While the pen
/// draws, digits type the length of the next wall, Return sets the corner, Backspace takes back, and Escape
/// ends.
class PlanEditorView : public PlanCanvas {
    Q_OBJECT

  public:
    enum class Tool { Select, Outline, Obstacle, Name, Rails, Scale, Place };

    explicit PlanEditorView(PlanEditor& editor, QWidget* parent = nullptr);

    Tool tool() const { return m_tool; }

    void setTool(Tool tool);

    /// Sets the grid that drawn points snap to. Units: metres.
    void setGrid(double gridM) { m_gridM = gridM; }

    FloorPicture& picture() { return m_picture; }

    /// Returns the lengths of the outline's walls, in the order of the walls; without those of walls that are
    /// shorter than their label.
    std::vector<LengthLabel> lengthLabels() const;

    /// Fits the room and the picture into the view.
    void fitRoom();

  signals:
    void toolChanged(spherewalk::ui::PlanEditorView::Tool tool);
    /// The user has drawn a line over something of known length, for the scale of the picture.
    void scaleDrawn(QLineF inRoom);
    /// The user wants to name the room at this place, or to change the name that is written there.
    void nameWanted(QPointF inRoom, std::optional<std::size_t> name);
    /// The user has moved, turned or scaled the picture.
    void pictureMoved();
    /// Carries a sentence about the keys of the present tool; empty: none.
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
    void paintRail(QPainter& painter, int rail, double radius, const QColor& colour,
                   const QTransform& widgetFromRoom) const;
    void paintUncovered(QPainter& painter, const QTransform& widgetFromRoom) const;
    void paintSelection(QPainter& painter, const QTransform& widgetFromRoom) const;
    /// Where the lengths of walls are written.
    enum class LengthSide { OfRoom, Outside, OnOpenLine };

    LengthLabel labelBeside(const QLineF& wall, const QString& words, double aside) const;
    std::vector<LengthLabel> lengthLabels(const Polygon& polygon, const QTransform& widgetFromRoom,
                                          LengthSide side) const;
    void paintLengths(QPainter& painter, const Polygon& polygon, const QTransform& widgetFromRoom,
                      LengthSide side) const;
    void paintPen(QPainter& painter, const QTransform& widgetFromRoom) const;

    /// Returns the corner, or else the obstacle, or else the polygon of the wall at this point of the widget.
    PlanPart partAt(const QPointF& at) const;
    /// Returns the corner before the wall at this point of the widget.
    PlanPart wallAt(const QPointF& at) const;
    /// Returns the name of a room that is written at this point of the widget.
    std::optional<std::size_t> nameAt(const QPointF& at) const;
    Eigen::Vector2d snappedPoint(const QPointF& at, Qt::KeyboardModifiers modifiers) const;
    void drag(const QPointF& at, Qt::KeyboardModifiers modifiers);
    /// Returns the corner near this point of the widget, or else the point itself.
    QPointF cornerOr(const QPointF& at) const;
    void placePicture(const QLineF& inRoom);
    void pressPen();
    void finishPen(const Polygon& polygon);
    bool penKey(QKeyEvent* event);
    void nextPart(int step);
    void nudge(const Eigen::Vector2d& by);

    PlanEditor& m_editor;
    FloorPicture m_picture;
    OutlinePen m_pen;
    RailTool m_rails;
    Tool m_tool = Tool::Select;
    double m_gridM = 0.05;
    PlanPart m_dragged;
    Eigen::Vector2d m_dragFrom = Eigen::Vector2d::Zero();
    std::optional<QLineF> m_scaleLine; ///< What is dragged with the tools Scale and Place.
    std::optional<QPointF> m_pinned;   ///< The point of the picture that is where it belongs.
};

} // namespace spherewalk::ui
