// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/survey/room.h"

#include <QPainter>
#include <QTransform>
#include <QWidget>

#include <memory>
#include <optional>

namespace spherewalk::ui {

/// Something drawn over a plan. Frames: the painter is in the widget's coordinates, its pen in the colour of
/// text; widgetFromRoom takes metres of the room to them.
class PlanLayer {
  public:
    virtual ~PlanLayer() = default;

    virtual void paint(QPainter& painter, const QTransform& widgetFromRoom) = 0;
};

/// A piece of floor seen from above, y up, that can be moved (middle button, or dragging with Ctrl), zoomed
/// (wheel, + and -) and brought back to fit (0). It draws a grid of metres and a scale; what else is on it,
/// its layers and subclasses draw.
class PlanCanvas : public QWidget {
    Q_OBJECT

  public:
    explicit PlanCanvas(QWidget* parent = nullptr);

    /// What fit() brings into sight; fits at once unless the user has moved or zoomed. Units: metres.
    void setExtent(const Bounds2& extent);
    void fit();
    void zoom(double factor, const QPointF& around);

    QTransform widgetFromRoom() const;
    QPointF roomFromWidget(const QPointF& at) const;
    double pixelsPerMetre() const;

    /// Drawn over everything else, in the order of adding. Owner: the caller keeps it alive.
    void addLayer(PlanLayer* layer);
    void removeLayer(PlanLayer* layer);

    QSize sizeHint() const override { return {800, 600}; }

  signals:
    /// The left button over the floor, in metres, room frame.
    void pressedAt(QPointF pInRoom, Qt::KeyboardModifiers modifiers);
    void draggedTo(QPointF pInRoom, Qt::KeyboardModifiers modifiers);
    void releasedAt(QPointF pInRoom, Qt::KeyboardModifiers modifiers);

  protected:
    /// What is on the floor. The grid is there already.
    virtual void paintFloor(QPainter& painter, const QTransform& widgetFromRoom) = 0;

    virtual bool showsGrid() const { return true; }

    /// The walls, the floor in this colour, and the obstacles.
    void paintRoom(QPainter& painter, const survey::Room& room, const QColor& floor,
                   const QTransform& widgetFromRoom) const;

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
    std::optional<QTransform> m_moved; ///< in place of the fitting transform, once the user has moved it
    std::optional<QPointF> m_panFrom;
    QList<PlanLayer*> m_layers;
};

/// A place, or a polygon's vertices, in widget coordinates.
QPointF mapped(const Eigen::Vector2d& place, const QTransform& widgetFromRoom);
QPolygonF mapped(const Polygon& polygon, const QTransform& widgetFromRoom);

} // namespace spherewalk::ui
