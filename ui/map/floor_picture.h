// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QLineF>
#include <QPointF>
#include <QRectF>
#include <QString>

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

    /// Reads a picture and makes it ten metres wide. Returns whether the file is a picture.
    bool load(const QString& file);

    void clear() { *this = FloorPicture(); }

    void place(double metresPerPixel, const QPointF& origin);
    /// Scales the picture so that a line on it gets this length. The first point of the line stays. Range:
    /// both lengths positive.
    void setLength(const QLineF& drawn, double metres);

    /// Returns the rectangle that the picture covers.
    QRectF extent() const;

    /// Remembers file, scale and place of the picture for this survey in QSettings.
    void keep(const QString& surveyId) const;
    /// Returns the picture that keep() remembered; empty if there is none.
    static FloorPicture kept(const QString& surveyId);

  private:
    QImage m_image;
    QString m_file;
    double m_metresPerPixel = 0.01;
    QPointF m_origin;
};

} // namespace spherewalk::ui
