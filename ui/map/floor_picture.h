// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/angle.h"

#include <QImage>
#include <QLineF>
#include <QPointF>
#include <QRectF>
#include <QString>
#include <QTransform>

namespace spherewalk::ui {

/// A picture of a floor plan that lies under the drawing of a room. It helps on this computer and is no part
/// of the survey. Frames: room. Units: metres.
class FloorPicture {
  public:
    bool isEmpty() const { return m_image.isNull(); }

    const QImage& image() const { return m_image; }

    const QString& file() const { return m_file; }

    double metresPerPixel() const { return m_metresPerPixel; }

    /// Returns the place of the lower left corner.
    QPointF origin() const { return m_origin; }

    /// Returns how the picture is turned around its lower left corner, counter-clockwise.
    Radians yaw() const { return m_yaw; }

    /// Reads a picture, the first page of a PDF, or a robot's map (the YAML file that map_server writes). A
    /// map lies where it says, and any other picture becomes ten metres wide. Errors: NotFound, Io, Corrupt,
    /// Unsupported; the picture then stays as it was.
    void load(const QString& file);

    void clear() { *this = FloorPicture(); }

    void place(double metresPerPixel, const QPointF& origin, Radians yaw = {});
    /// Scales the picture so that a line on it gets this length. The first point of the line stays. Range:
    /// both lengths positive.
    void setLength(const QLineF& drawn, double metres);
    /// Moves the picture so that what lies at `from` comes to `to`.
    void move(const QPointF& from, const QPointF& to);
    /// Turns and scales the picture around a point that stays, so that what lies at `from` comes to `to`.
    void pull(const QPointF& around, const QPointF& from, const QPointF& to);

    /// Returns the transform from pixels of the picture, y down, to the room.
    QTransform roomFromPicture() const;

    /// Returns the smallest rectangle around the picture.
    QRectF extent() const;

    /// Remembers file, scale and place of the picture for this survey in QSettings.
    void keep(const QString& surveyId) const;
    /// Returns the picture that keep() remembered; empty if there is none.
    static FloorPicture kept(const QString& surveyId);

  private:
    void loadMap(const QString& file);

    QImage m_image;
    QString m_file;
    double m_metresPerPixel = 0.01;
    QPointF m_origin;
    Radians m_yaw;
};

} // namespace spherewalk::ui
