// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/polygon.h"

#include <Eigen/Core>
#include <QString>

#include <optional>
#include <vector>

namespace spherewalk::ui {

/// The things that a drawn point snaps to. Frames: room. Units: metres.
struct Snapping {
    double gridM = 0.05;                  ///< Grid spacing; 0: no grid.
    double reachM = 0.1;                  ///< Corners and neighbours attract within this distance.
    std::vector<Eigen::Vector2d> corners; ///< Points to meet exactly.
    /// Corners before and after the drawn one. A point near their x or y takes it, so that walls meet at
    /// right angles.
    std::vector<Eigen::Vector2d> neighbours;
};

/// Returns the nearest corner within reach. Without one, each coordinate snaps to a neighbour's within reach,
/// or else to the grid.
Eigen::Vector2d snapped(const Eigen::Vector2d& point, const Snapping& snapping);

/// A polygon while it is drawn, corner by corner. A corner lies at the pointer, or at a typed length in the
/// direction of the pointer. Frames: room. Units: metres.
class OutlinePen {
  public:
    bool isDrawing() const { return m_isDrawing; }

    void start();
    void cancel();

    const Polygon& corners() const { return m_corners; }

    /// Returns the place of the next corner.
    const Eigen::Vector2d& tip() const { return m_tip; }

    /// Returns the length as it is typed so far.
    const QString& typed() const { return m_typed; }

    /// Returns the corners and the tip.
    Polygon preview() const;

    /// Moves the pointer to a snapped point. A typed length fixes the distance of the tip from the last
    /// corner.
    void moveTo(const Eigen::Vector2d& point);
    /// Sets a corner at the tip. If the tip is on the first corner, it ends the drawing and returns the
    /// polygon.
    std::optional<Polygon> press();
    /// Takes a digit or a decimal sign. Returns false for any other character.
    bool type(QChar character);
    /// Removes the last typed character, or else the last corner.
    void takeBack();
    /// Ends the drawing and returns the corners. With fewer than three it returns nothing and goes on.
    std::optional<Polygon> close();

    /// Returns the distance from the last corner to the tip; nothing before the first corner.
    std::optional<double> length() const;

  private:
    void updateTip();

    bool m_isDrawing = false;
    Polygon m_corners;
    Eigen::Vector2d m_pointer = Eigen::Vector2d::Zero();
    Eigen::Vector2d m_tip = Eigen::Vector2d::Zero();
    QString m_typed;
};

} // namespace spherewalk::ui
