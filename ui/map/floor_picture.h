// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QLineF>
#include <QPointF>
#include <QRectF>
#include <QString>

namespace spherewalk::ui {

/// A floor plan from elsewhere, under the drawing. Frames: room, metres. It is a help for the eye on this
/// computer and no part of the survey.
class FloorPicture {
  public:
    bool isEmpty() const { return m_image.isNull(); }

    const QImage& image() const { return m_image; }

    const QString& file() const { return m_file; }

    double metresPerPixel() const { return m_metresPerPixel; }

    /// The lower left corner.
    QPointF origin() const { return m_origin; }

    /// At first, the picture is ten metres wide. Returns whether it could be read.
    bool load(const QString& file);

    void clear() { *this = FloorPicture(); }

    void place(double metresPerPixel, const QPointF& origin);
    /// Scales so that the line drawn on it gets this length; its first point stays. Range: both positive.
    void setLength(const QLineF& drawn, double metres);

    /// In the room.
    QRectF extent() const;

    /// Remembers the picture of this survey, and finds it again.
    void keep(const QString& surveyId) const;
    static FloorPicture kept(const QString& surveyId);

  private:
    QImage m_image;
    QString m_file;
    double m_metresPerPixel = 0.01;
    QPointF m_origin;
};

} // namespace spherewalk::ui
