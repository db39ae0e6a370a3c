// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panorama/panorama_presenter.h"

#include "ui/panorama/photo_pictures.h"

#include "spherewalk/base/error.h"
#include "spherewalk/geometry/rotation.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

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
    connect(&m_regions, &RegionTool::changed, this, &PanoramaPresenter::changed);
}

void PanoramaPresenter::show(const std::optional<ShownPhoto>& photo) {
    if (photo == m_photo) {
        return;
    }
    const bool isOther = !photo || !m_photo || photo->file != m_photo->file;
    m_photo = photo;
    if (isOther) {
        m_regions.setMarking(false); // the box was of the photo before
    }
    m_regions.setRegions(photo ? photo->regions : std::vector<ShownRegion>());
    if (isOther && photo && !photo->areas.empty()) {
        lookAt({photo->areas.front().azimuth, photo->areas.front().elevation});
        m_look.fov = Degrees(90.0);
    }
    want();
}

void PanoramaPresenter::lookAt(const SphericalDirection& inPhoto) {
    const SphericalDirection at = sphericalDirection(m_photo->roomFromPhoto.rotation * direction(inPhoto));
    m_look.yaw = at.azimuth;
    m_look.up = at.elevation;
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
        files.push_back(shownFile());
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
    const auto decoded = m_photo ? m_decoder.find(shownFile()) : std::nullopt;
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
    const auto view = projection(sizePx);
    if (!view) {
        return result;
    }
    constexpr int kCorners = 48;
    constexpr double kLeastAhead = 0.05; // beside and behind the camera nothing can be drawn
    for (const PhotoArea& area : m_photo->areas) {
        QPolygonF outline;
        for (int i = 0; i <= kCorners; ++i) {
            const double turn = 2 * std::numbers::pi * i / kCorners;
            const SphericalDirection corner{area.azimuth + area.halfWidth * std::cos(turn),
                                            area.elevation + area.halfHeight * std::sin(turn)};
            const Eigen::Vector3d ray = view->cameraFromPhoto * direction(corner);
            if (const auto pixel = view->camera.project(ray); pixel && ray.z() > kLeastAhead) {
                outline << QPointF(pixel->x(), pixel->y());
            }
        }
        if (outline.size() > 2) {
            result.push_back(outline);
        }
    }
    return result;
}

std::optional<PhotoProjection> PanoramaPresenter::projection(const QSize& sizePx) const {
    if (!m_photo || sizePx.isEmpty()) {
        return std::nullopt;
    }
    const Eigen::Quaterniond cameraFromRoom =
        m_look.roomFromCamera(Eigen::Vector3d::Zero()).rotation.conjugate();
    return PhotoProjection{CameraModel(m_look.camera(sizePx.width(), sizePx.height())),
                           cameraFromRoom * m_photo->roomFromPhoto.rotation};
}

PhotoDecoder::File PanoramaPresenter::shownFile() const {
    std::vector<survey::PrivateRegion> blurred;
    if (m_isAsExported) {
        for (const ShownRegion& region : m_photo->regions) {
            blurred.push_back(region.region);
        }
    }
    return {m_photo->file, std::move(blurred)};
}

void PanoramaPresenter::setAsExported(bool isAsExported) {
    m_isAsExported = isAsExported;
    want();
}

std::vector<PanoramaPresenter::RegionOutline> PanoramaPresenter::regionOutlines(const QSize& sizePx) const {
    std::vector<RegionOutline> result;
    const auto view = projection(sizePx);
    if (!view) {
        return result;
    }
    for (const ShownRegion& region : m_regions.regions()) {
        const bool isSelected = &region == m_regions.selected();
        const QPolygonF corners = outlineOf(region.region, *view);
        if (!corners.isEmpty() && (isSelected || !m_isAsExported)) {
            result.push_back({corners, region, isSelected});
        }
    }
    std::stable_partition(result.begin(), result.end(),
                          [](const RegionOutline& outline) { return !outline.isSelected; });
    return result;
}

std::optional<std::int64_t> PanoramaPresenter::regionAt(const QPointF& pixel, const QSize& sizePx) const {
    const auto view = projection(sizePx);
    std::optional<std::int64_t> found;
    double least = std::numeric_limits<double>::max();
    for (const ShownRegion& region : view ? m_regions.regions() : std::vector<ShownRegion>()) {
        const double size = region.region.width.value() * region.region.height.value();
        if (size < least && survey::RegionFrame(region.region).contains(view->direction(pixel))) {
            least = size;
            found = region.id;
        }
    }
    return found;
}

bool PanoramaPresenter::selectNextRegion(int by) {
    if (!m_regions.selectNext(by)) {
        return false;
    }
    const survey::PrivateRegion& region = m_regions.selected()->region;
    lookAt({region.azimuth, region.elevation});
    emit changed();
    return true;
}

std::optional<survey::PrivateRegion> PanoramaPresenter::markedRegion(const QSize& sizePx) const {
    const auto view = projection(sizePx);
    if (!view || !m_regions.isMarking()) {
        return std::nullopt;
    }
    const QRectF& box = m_regions.box();
    return regionAround({box.left() * sizePx.width(), box.top() * sizePx.height(),
                         box.width() * sizePx.width(), box.height() * sizePx.height()},
                        *view);
}

void PanoramaPresenter::moveBox(const QPointF& by, const QSize& sizePx) {
    const QPointF beyond = m_regions.moveBox(by);
    if (!beyond.isNull()) {
        const double highPerWide = static_cast<double>(sizePx.height()) / std::max(1, sizePx.width());
        turn(m_look.fov * -beyond.x(), m_look.fov * (-beyond.y() * highPerWide));
    }
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
    if (const QString sentence = m_decoder.sentence(shownFile()); !sentence.isEmpty()) {
        return sentence;
    }
    if (!m_decoder.find(shownFile())) {
        return tr("Decoding %1...").arg(m_photo->name);
    }
    if (isComparing() && !m_mover.sentence().isEmpty()) {
        return m_mover.sentence();
    }
    return isComparing() && !m_mover.picture() ? tr("Moving %1 to here...").arg(m_other->name) : QString();
}

} // namespace spherewalk::ui
