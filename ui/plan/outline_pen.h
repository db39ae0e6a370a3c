// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plan/snapping.h"

#include "spherewalk/geometry/polygon.h"

#include <QString>

#include <optional>

namespace spherewalk::ui {

/// A polygon while it is drawn: corner by corner with the pointer, or by typing how long the next wall is in
/// the direction of the pointer. Units: metres, room frame.
class OutlinePen {
  public:
    bool isDrawing() const { return m_isDrawing; }

    void start();
    void cancel();

    const Polygon& corners() const { return m_corners; }

    /// Where the next corner would be.
    const Eigen::Vector2d& tip() const { return m_tip; }

    /// What has been typed so far.
    const QString& typed() const { return m_typed; }

    /// The corners with the tip, as they would be if the pen were closed now.
    Polygon preview() const;

    /// The pointer is at the point, snapped. A typed length fixes how far the tip is from the last corner.
    void moveTo(const Eigen::Vector2d& point);
    /// Sets a corner at the tip. On the first corner, closes: the finished polygon.
    std::optional<Polygon> press();
    /// Takes a digit or a decimal sign. Returns false for any other character.
    bool type(QChar character);
    /// Takes back the last typed character, else the last corner.
    void takeBack();
    /// Ends the drawing with the corners so far; nothing, and still drawing, with fewer than three.
    std::optional<Polygon> close();

    /// Metres from the last corner to the tip; nothing before the first corner.
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
