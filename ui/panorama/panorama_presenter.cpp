// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panorama/panorama_presenter.h"

#include "ui/panorama/photo_pictures.h"

#include "spherewalk/base/error.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/geometry/rotation.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spherewalk::ui {

namespace {

constexpr std::chrono::milliseconds kBlinkInterval{600};
constexpr std::chrono::milliseconds kSettleTime{160};
constexpr qint64 kMostPixels = 8'000'000;

} // namespace

void Look::turn(Radians left, Radians higher) {
    constexpr double kPole = std::numbers::pi / 2;
    yaw = wrapped(yaw + left);
    up = Radians(std::clamp((up + higher).value(), -kPole, kPole));
}

void Look::zoom(double factor) {
    fov = Radians(std::clamp(fov.value() * factor, Radians(kNarrowest).value(), Radians(kWidest).value()));
}

Rigid3 Look::roomFromCamera(const Eigen::Vector3d& at) const {
    return {rotation({yaw, -up, Radians(0)}) * bodyFromOptical(), at};
}

CameraIntrinsics Look::camera(int width, int height) const {
    return CameraIntrinsics::pinhole(width, height, fov.value());
}

PanoramaPresenter::PanoramaPresenter(QObject* parent) : QObject(parent) {
    m_blinking.setInterval(kBlinkInterval);
    connect(&m_blinking, &QTimer::timeout, this, &PanoramaPresenter::blink);
    m_settling.setInterval(kSettleTime);
    m_settling.setSingleShot(true);
    connect(&m_settling, &QTimer::timeout, this, &PanoramaPresenter::changed);
    connect(&m_decoder, &PhotoDecoder::decoded, this, &PanoramaPresenter::changed);
    connect(&m_mover, &PhotoMover::moved, this, &PanoramaPresenter::changed);
}

void PanoramaPresenter::show(const std::optional<ShownPhoto>& photo) {
    if (photo == m_photo) {
        return;
    }
    const bool isOther = !photo || !m_photo || photo->file != m_photo->file;
    m_photo = photo;
    if (isOther && photo && !photo->areas.empty()) {
        lookAt(photo->areas.front());
    }
    want();
}

void PanoramaPresenter::lookAt(const PhotoArea& area) {
    const Eigen::Vector3d inRoom =
        m_photo->roomFromPhoto.rotation * direction(SphericalDirection{area.azimuth, area.elevation});
    const SphericalDirection at = sphericalDirection(inRoom);
    m_look.yaw = at.azimuth;
    m_look.up = at.elevation;
    m_look.fov = Degrees(90.0);
}

void PanoramaPresenter::setOther(const std::optional<ShownPhoto>& photo) {
    if (photo != m_other) {
        m_other = photo;
        want();
    }
}

void PanoramaPresenter::setSurroundings(const Surroundings& surroundings) {
    m_surroundings = surroundings;
    want();
}

void PanoramaPresenter::want() {
    std::vector<PhotoDecoder::File> files;
    if (m_photo) {
        files.push_back(m_photo->file);
    }
    m_decoder.want(files);
    if (isComparing()) {
        m_mover.want(*m_photo, *m_other, m_surroundings);
    }
    emit changed();
}

void PanoramaPresenter::setComparison(Comparison comparison) {
    if (comparison == m_comparison) {
        return;
    }
    m_comparison = comparison;
    m_isOtherShown = false;
    if (comparison == Comparison::Blink) {
        m_blinking.start();
    } else {
        m_blinking.stop();
    }
    emit comparisonChanged();
    want();
}

void PanoramaPresenter::setShare(double share) {
    m_share = std::clamp(share, 0.0, 1.0);
    emit changed();
}

void PanoramaPresenter::blink() {
    m_isOtherShown = !m_isOtherShown;
    emit changed();
}

void PanoramaPresenter::setLook(const Look& look) {
    m_look = look;
    emit changed();
}

void PanoramaPresenter::turn(Radians left, Radians higher) {
    m_look.turn(left, higher);
    move();
}

void PanoramaPresenter::zoom(double factor) {
    m_look.zoom(factor);
    move();
}

void PanoramaPresenter::lookLevel() {
    m_look.up = Radians(0);
    m_look.fov = Degrees(90);
    move();
}

void PanoramaPresenter::move() {
    m_settling.start();
    emit changed();
}

QImage PanoramaPresenter::picture(const QSize& sizePx) {
    if (sizePx.isEmpty() || qint64{sizePx.width()} * sizePx.height() > kMostPixels) {
        return {};
    }
    const bool hasOther = isComparing() && m_mover.picture();
    if (hasOther && m_comparison == Comparison::Blink && m_isOtherShown) {
        return renderOther(sizePx);
    }
    QImage first = renderFirst(sizePx);
    if (hasOther && m_comparison == Comparison::Slider) {
        const int line = static_cast<int>(m_share * sizePx.width());
        const QRect right(line, 0, sizePx.width() - line, sizePx.height());
        QPainter(&first).drawImage(right.topLeft(), renderOther(sizePx), right);
    }
    return first;
}

QImage PanoramaPresenter::renderFirst(const QSize& sizePx) {
    const auto decoded = m_photo ? m_decoder.find(m_photo->file) : std::nullopt;
    return render(decoded ? &decoded->panorama : nullptr, sizePx);
}

QImage PanoramaPresenter::renderOther(const QSize& sizePx) {
    return render(&m_mover.picture()->panorama, sizePx);
}

/// Renders a panorama that has the pose of the first photo; null: nothing is there yet.
QImage PanoramaPresenter::render(const render::Panorama* panorama, const QSize& sizePx) {
    if (panorama == nullptr) {
        QImage nothing(sizePx, QImage::Format_RGB32);
        nothing.fill(Qt::black);
        return nothing;
    }
    const Eigen::Vector3d& from = m_photo->roomFromPhoto.translation;
    const render::Sampling sampling =
        m_settling.isActive() ? render::Sampling::Bilinear : render::Sampling::Footprint;
    m_renderer.render(*panorama, {m_photo->roomFromPhoto, std::nullopt},
                      CameraModel(m_look.camera(sizePx.width(), sizePx.height())),
                      m_look.roomFromCamera(from), sampling, m_pixels);
    return qtImage(m_pixels);
}

std::vector<QPolygonF> PanoramaPresenter::outlines(const QSize& sizePx) const {
    std::vector<QPolygonF> result;
    if (!m_photo || sizePx.isEmpty()) {
        return result;
    }
    constexpr int kCorners = 48;
    constexpr double kLeastAhead = 0.05; // beside and behind the camera nothing can be drawn
    const CameraModel camera(m_look.camera(sizePx.width(), sizePx.height()));
    const Eigen::Quaterniond cameraFromPhoto =
        m_look.roomFromCamera(Eigen::Vector3d::Zero()).rotation.conjugate() * m_photo->roomFromPhoto.rotation;
    for (const PhotoArea& area : m_photo->areas) {
        QPolygonF outline;
        for (int i = 0; i <= kCorners; ++i) {
            const double turn = 2 * std::numbers::pi * i / kCorners;
            const SphericalDirection corner{area.azimuth + area.halfWidth * std::cos(turn),
                                            area.elevation + area.halfHeight * std::sin(turn)};
            const Eigen::Vector3d ray = cameraFromPhoto * direction(corner);
            if (const auto pixel = camera.project(ray); pixel && ray.z() > kLeastAhead) {
                outline << QPointF(pixel->x(), pixel->y());
            }
        }
        if (outline.size() > 2) {
            result.push_back(outline);
        }
    }
    return result;
}

bool PanoramaPresenter::isComparingUnaligned() const {
    return isComparing() && !(m_photo->isAligned && m_other->isAligned);
}

QString PanoramaPresenter::movedWords() const {
    if (!isComparing() || !m_mover.picture()) {
        return {};
    }
    switch (m_mover.picture()->by) {
    case MovedBy::Depth:
        return tr("as seen from here, by measured depth");
    case MovedBy::Room:
        return tr("as seen from here, by the drawn walls");
    case MovedBy::Sphere:
        return tr("as seen from here, roughly");
    case MovedBy::Turn:
        return tr("turned as the first");
    }
    return {};
}

QString PanoramaPresenter::remark() const {
    if (!m_photo) {
        return tr("No photo is chosen.");
    }
    if (!m_decoder.sentence(m_photo->file).isEmpty()) {
        return m_decoder.sentence(m_photo->file);
    }
    if (!m_decoder.find(m_photo->file)) {
        return tr("Decoding %1...").arg(m_photo->name);
    }
    if (isComparing() && !m_mover.sentence().isEmpty()) {
        return m_mover.sentence();
    }
    return isComparing() && !m_mover.picture() ? tr("Moving %1 to here...").arg(m_other->name) : QString();
}

} // namespace spherewalk::ui
