// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/map/floor_picture.h"

#include <QImageReader>
#include <QSettings>

namespace spherewalk::ui {

bool FloorPicture::load(const QString& file) {
    constexpr int kMostSide = 6000;
    constexpr double kFirstWidthM = 10;
    QImageReader reader(file);
    reader.setAutoTransform(true);
    if (const QSize size = reader.size();
        size.isValid() && std::max(size.width(), size.height()) > kMostSide) {
        reader.setScaledSize(size.scaled(kMostSide, kMostSide, Qt::KeepAspectRatio));
    }
    const QImage image = reader.read();
    if (image.isNull()) {
        return false;
    }
    m_image = image;
    m_file = file;
    m_origin = {};
    m_metresPerPixel = kFirstWidthM / image.width();
    return true;
}

void FloorPicture::place(double metresPerPixel, const QPointF& origin) {
    m_metresPerPixel = metresPerPixel;
    m_origin = origin;
}

void FloorPicture::setLength(const QLineF& drawn, double metres) {
    const double factor = metres / drawn.length();
    m_metresPerPixel *= factor;
    m_origin = drawn.p1() + factor * (m_origin - drawn.p1());
}

QRectF FloorPicture::extent() const {
    return {m_origin, QSizeF(m_image.width() * m_metresPerPixel, m_image.height() * m_metresPerPixel)};
}

void FloorPicture::keep(const QString& surveyId) const {
    QSettings settings;
    settings.beginGroup("floorPictures/" + surveyId);
    if (isEmpty()) {
        settings.remove("");
        return;
    }
    settings.setValue("file", m_file);
    settings.setValue("metresPerPixel", m_metresPerPixel);
    settings.setValue("origin", m_origin);
}

FloorPicture FloorPicture::kept(const QString& surveyId) {
    QSettings settings;
    settings.beginGroup("floorPictures/" + surveyId);
    FloorPicture picture;
    const double metresPerPixel = settings.value("metresPerPixel").toDouble();
    if (metresPerPixel > 0 && picture.load(settings.value("file").toString())) {
        picture.place(metresPerPixel, settings.value("origin").toPointF());
    }
    return picture;
}

} // namespace spherewalk::ui
