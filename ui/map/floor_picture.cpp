// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/map/floor_picture.h"

#include "ui/map/robot_map_file.h"

#include "spherewalk/base/error.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QImageReader>
#include <QProcess>
#include <QSettings>
#include <QStandardPaths>

#include <cmath>

namespace spherewalk::ui {

namespace {

/// The words of this file, for translators.
struct PictureWords {
    Q_DECLARE_TR_FUNCTIONS(spherewalk::ui::FloorPicture)
};

[[noreturn]] void refuse(ErrorKind kind, const QString& sentence) {
    throw Error(kind, sentence.toStdString());
}

/// The first page of a PDF, as the program pdftoppm draws it.
QImage pdfPage(const QString& file) {
    constexpr int kMostMs = 20'000;
    const QString program = QStandardPaths::findExecutable("pdftoppm");
    if (program.isEmpty()) {
        refuse(ErrorKind::Unsupported,
               PictureWords::tr("A PDF needs the program pdftoppm (poppler-utils); install it, or export the "
                                "page as PNG or SVG."));
    }
    QProcess drawing;
    drawing.start(program, {"-png", "-r", "150", "-f", "1", "-singlefile", file, "-"});
    const bool isDone = drawing.waitForFinished(kMostMs) && drawing.exitCode() == 0;
    const QImage page = isDone ? QImage::fromData(drawing.readAllStandardOutput()) : QImage();
    if (page.isNull()) {
        refuse(ErrorKind::Corrupt, PictureWords::tr("%1 is no PDF that can be drawn.").arg(file));
    }
    return page;
}

QImage pictureIn(const QString& file) {
    constexpr int kMostSide = 6000;
    QImageReader reader(file);
    reader.setAutoTransform(true);
    if (const QSize size = reader.size();
        size.isValid() && std::max(size.width(), size.height()) > kMostSide) {
        reader.setScaledSize(size.scaled(kMostSide, kMostSide, Qt::KeepAspectRatio));
    }
    const QImage image = reader.read();
    if (image.isNull()) {
        refuse(ErrorKind::Corrupt, PictureWords::tr("%1 is no picture that can be read.").arg(file));
    }
    return image;
}

} // namespace

void FloorPicture::load(const QString& file) {
    constexpr double kFirstWidthM = 10;
    const QString kind = QFileInfo(file).suffix().toLower();
    if (kind == "yaml" || kind == "yml") {
        return loadMap(file);
    }
    m_image = kind == "pdf" ? pdfPage(file) : pictureIn(file);
    m_file = file;
    place(kFirstWidthM / m_image.width(), {});
}

/// Takes a map as map_server does: its lower left pixel lies at the origin.
void FloorPicture::loadMap(const QString& file) {
    const RobotMapFile map = readRobotMap(file);
    const QImage pixels = pictureIn(map.image).convertToFormat(QImage::Format_Grayscale8);
    m_image = mapPicture(map, pixels);
    m_file = file;
    place(map.metresPerPixel, map.origin, map.yaw);
}

void FloorPicture::place(double metresPerPixel, const QPointF& origin, Radians yaw) {
    m_metresPerPixel = metresPerPixel;
    m_origin = origin;
    m_yaw = yaw;
}

void FloorPicture::setLength(const QLineF& drawn, double metres) {
    const double factor = metres / drawn.length();
    m_metresPerPixel *= factor;
    m_origin = drawn.p1() + factor * (m_origin - drawn.p1());
}

void FloorPicture::move(const QPointF& from, const QPointF& to) {
    m_origin += to - from;
}

void FloorPicture::pull(const QPointF& around, const QPointF& from, const QPointF& to) {
    const QLineF before(around, from);
    const QLineF after(around, to);
    if (!(before.length() > 0 && after.length() > 0)) {
        return;
    }
    setLength(before, after.length());
    // Y points up in the room, and down where Qt counts angles.
    const double turn = std::atan2(after.dy(), after.dx()) - std::atan2(before.dy(), before.dx());
    const QPointF arm = m_origin - around;
    m_origin = around + QPointF(std::cos(turn) * arm.x() - std::sin(turn) * arm.y(),
                                std::sin(turn) * arm.x() + std::cos(turn) * arm.y());
    m_yaw = wrapped(m_yaw + Radians(turn));
}

QTransform FloorPicture::roomFromPicture() const {
    QTransform transform;
    transform.translate(m_origin.x(), m_origin.y());
    transform.rotateRadians(m_yaw.value());
    transform.scale(m_metresPerPixel, -m_metresPerPixel);
    transform.translate(0, -m_image.height());
    return transform;
}

QRectF FloorPicture::extent() const {
    return roomFromPicture().mapRect(QRectF(m_image.rect()));
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
    settings.setValue("yaw", m_yaw.value());
}

FloorPicture FloorPicture::kept(const QString& surveyId) {
    QSettings settings;
    settings.beginGroup("floorPictures/" + surveyId);
    const double metresPerPixel = settings.value("metresPerPixel").toDouble();
    if (!(metresPerPixel > 0)) {
        return {};
    }
    try {
        FloorPicture picture;
        picture.load(settings.value("file").toString());
        picture.place(metresPerPixel, settings.value("origin").toPointF(),
                      Radians(settings.value("yaw").toDouble()));
        return picture;
    } catch (const Error&) { // the file has gone, and the drawing is complete without the picture
        return {};
    }
}

} // namespace spherewalk::ui
