// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/survey/room.h"

#include <QPainter>
#include <QTransform>
#include <QWidget>

#include <memory>
#include <optional>

namespace spherewalk::ui {

/// Something that is drawn over a plan. Frames: the painter has the coordinates of the widget, and
/// widgetFromRoom maps metres of the room to them. The pen has the colour of text.
class PlanLayer {
  public:
    virtual ~PlanLayer() = default;

    virtual void paint(QPainter& painter, const QTransform& widgetFromRoom) = 0;
};

/// The floor from above, with y up, a grid of metres and a scale. Subclasses and layers draw the rest.
/// Dragging with the middle button or Ctrl moves it, the wheel or + and - zoom, and 0 fits the extent again.
class PlanCanvas : public QWidget {
    Q_OBJECT

  public:
    explicit PlanCanvas(QWidget* parent = nullptr);

    /// Sets the area that fit() shows, and fits at once unless the user has moved or zoomed. Units: metres.
    void setExtent(const Bounds2& extent);
    void fit();
    void zoom(double factor, const QPointF& around);

    QTransform widgetFromRoom() const;
    QPointF roomFromWidget(const QPointF& at) const;
    double pixelsPerMetre() const;

    /// Adds a layer that is drawn above the floor and earlier layers. Owner: the caller, until removeLayer().
    void addLayer(PlanLayer* layer);
    void removeLayer(PlanLayer* layer);

    QSize sizeHint() const override { return {800, 600}; }

  signals:
    /// Tell what the left button does. Frames: room. Units: metres.
    void pressedAt(QPointF pInRoom, Qt::KeyboardModifiers modifiers);
    void draggedTo(QPointF pInRoom, Qt::KeyboardModifiers modifiers);
    void releasedAt(QPointF pInRoom, Qt::KeyboardModifiers modifiers);

  protected:
    /// Draws what is on the floor, above the grid.
    virtual void paintFloor(QPainter& painter, const QTransform& widgetFromRoom) = 0;

    virtual bool showsGrid() const { return true; }

    /// Draws the floor in this colour, the walls and the obstacles.
    void paintRoom(QPainter& painter, const survey::Room& room, const QColor& floor,
                   const QTransform& widgetFromRoom, Qt::PenStyle walls = Qt::SolidLine) const;
    /// Draws the names of the rooms, each on a plate.
    void paintNames(QPainter& painter, const survey::Room& room, const QTransform& widgetFromRoom) const;

    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    QTransform fitting() const;
    void paintGrid(QPainter& painter, const QTransform& widgetFromRoom) const;
    void paintScale(QPainter& painter) const;

    Bounds2 m_extent{{0, 0}, {5, 4}};
    std::optional<QTransform> m_moved; ///< Replaces the fitting transform once the user has moved or zoomed.
    std::optional<QPointF> m_panFrom;
    QList<PlanLayer*> m_layers;
};

/// Map a place or the vertices of a polygon to coordinates of the widget.
QPointF mapped(const Eigen::Vector2d& place, const QTransform& widgetFromRoom);
QPolygonF mapped(const Polygon& polygon, const QTransform& widgetFromRoom);

/// Returns the distance from the point to the line, which ends at its two points.
double distanceTo(const QPointF& point, const QLineF& line);

} // namespace spherewalk::ui
