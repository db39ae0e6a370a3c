// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panorama/panorama_view.h"

#include "ui/look/theme.h"
#include "ui/panorama/panorama_presenter.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>

#include <cmath>

namespace spherewalk::ui {

namespace {

constexpr double kLineReachPx = 10;
constexpr double kKeyShare = 1.0 / 12; ///< Share of the field of view that a key turns by.
constexpr double kZoomStep = 1.15;
constexpr double kShareStep = 0.02;

} // namespace

PanoramaView::PanoramaView(QWidget* parent) : QWidget(parent), m_presenter(new PanoramaPresenter(this)) {
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(240, 160);
    setCursor(Qt::OpenHandCursor);
    setAccessibleName(tr("Photo to look around in"));
    setToolTip(tr("Drag or use the arrow keys to look around; wheel, + and - change the field of view; 0 "
                  "looks level"));
    connect(m_presenter, &PanoramaPresenter::changed, this, qOverload<>(&QWidget::update));
}

void PanoramaView::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QImage picture = m_presenter->picture(size() * devicePixelRatioF());
    picture.setDevicePixelRatio(devicePixelRatioF());
    painter.drawImage(0, 0, picture);
    const QRect aboveLine = rect().adjusted(0, 0, 0, -height() / 3); // the handle is in the middle
    paintPlate(painter, aboveLine, Qt::AlignCenter, m_presenter->remark());
    if (m_presenter->photo()) {
        paintAreas(painter);
        paintLine(painter);
        paintNames(painter);
        paintLook(painter);
    }
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

/// Outlines what the checks found, in the photo that they found it in.
void PanoramaView::paintAreas(QPainter& painter) const {
    if (m_presenter->comparison() == Comparison::Blink && m_presenter->isOtherShown()) {
        return;
    }
    painter.setBrush(Qt::NoBrush);
    for (const QPolygonF& outline : m_presenter->outlines(size())) {
        painter.setPen(QPen(QColor(0, 0, 0, 160), 5));
        painter.drawPolyline(outline);
        painter.setPen(QPen(doubtfulColour(), 2.5));
        painter.drawPolyline(outline);
    }
}

void PanoramaView::paintLine(QPainter& painter) const {
    if (m_presenter->comparison() != Comparison::Slider || !m_presenter->other()) {
        return;
    }
    const double x = m_presenter->share() * width();
    painter.setPen(QPen(QColor(0, 0, 0, 120), 4));
    painter.drawLine(QPointF(x, 0), QPointF(x, height()));
    painter.setPen(QPen(Qt::white, 2));
    painter.drawLine(QPointF(x, 0), QPointF(x, height()));
    const QPointF middle(x, 0.5 * height());
    painter.setBrush(Qt::white);
    painter.setPen(QPen(QColor(0, 0, 0, 120), 1));
    painter.drawEllipse(middle, 13, 13);
    QPainterPath arrows;
    for (const int side : {-1, 1}) {
        arrows.moveTo(middle + QPointF(side * 3, -5));
        arrows.lineTo(middle + QPointF(side * 8, 0));
        arrows.lineTo(middle + QPointF(side * 3, 5));
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(Qt::black, 2));
    painter.drawPath(arrows);
}

void PanoramaView::paintNames(QPainter& painter) const {
    const auto& other = m_presenter->other();
    const QString first = m_presenter->photo()->name;
    const QString moved = m_presenter->movedWords();
    const QString second = !other || moved.isEmpty() ? QString() : tr("B: %1\n%2").arg(other->name, moved);
    switch (other ? m_presenter->comparison() : Comparison::Off) {
    case Comparison::Off:
        paintPlate(painter, rect(), Qt::AlignTop | Qt::AlignLeft, first);
        return;
    case Comparison::Blink:
        paintPlate(painter, rect(), Qt::AlignTop | Qt::AlignLeft,
                   m_presenter->isOtherShown() && !second.isEmpty() ? second : tr("A: %1").arg(first));
        return;
    case Comparison::Slider: {
        const double line = m_presenter->share() * width();
        paintPlate(painter, QRectF(0, 0, line, height()), Qt::AlignTop | Qt::AlignLeft,
                   tr("A: %1").arg(first));
        paintPlate(painter, QRectF(line, 0, width() - line, height()), Qt::AlignTop | Qt::AlignRight, second);
    }
    }
}

void PanoramaView::paintLook(QPainter& painter) const {
    if (m_presenter->isComparingUnaligned()) {
        constexpr int kLookPx = 34; // the height of the plate below
        paintPlate(painter, rect().adjusted(0, 0, 0, -kLookPx), Qt::AlignBottom | Qt::AlignHCenter,
                   tr("Not aligned yet: the second photo is turned by what both show, roughly."));
    }
    const Look& look = m_presenter->look();
    paintPlate(painter, rect(), Qt::AlignBottom | Qt::AlignRight,
               tr("heading %1°, %2° up, %3° wide")
                   .arg(Degrees(look.yaw).value(), 0, 'f', 0)
                   .arg(Degrees(look.up).value(), 0, 'f', 0)
                   .arg(Degrees(look.fov).value(), 0, 'f', 0));
}

bool PanoramaView::isOnLine(const QPointF& at) const {
    return m_presenter->comparison() == Comparison::Slider && m_presenter->other() &&
           std::abs(at.x() - m_presenter->share() * width()) < kLineReachPx;
}

void PanoramaView::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) {
        m_dragFrom = event->position();
        m_dragsLine = isOnLine(event->position());
        setCursor(m_dragsLine ? Qt::SplitHCursor : Qt::ClosedHandCursor);
    }
}

void PanoramaView::mouseMoveEvent(QMouseEvent* event) {
    if (!m_dragFrom) {
        return;
    }
    if (m_dragsLine) {
        m_presenter->setShare(event->position().x() / std::max(1, width()));
        return;
    }
    // The picture stays under the pointer, about.
    const QPointF moved = event->position() - *m_dragFrom;
    m_dragFrom = event->position();
    const Radians perPixel = m_presenter->look().fov * (1.0 / std::max(1, width()));
    m_presenter->turn(perPixel * moved.x(), perPixel * moved.y());
}

void PanoramaView::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) {
        m_dragFrom.reset();
        setCursor(Qt::OpenHandCursor);
    }
}

void PanoramaView::wheelEvent(QWheelEvent* event) {
    m_presenter->zoom(std::pow(kZoomStep, -event->angleDelta().y() / 120.0));
    event->accept();
}

void PanoramaView::keyPressEvent(QKeyEvent* event) {
    const Radians step = m_presenter->look().fov * kKeyShare;
    switch (event->key()) {
    case Qt::Key_Left:
        return m_presenter->turn(step, Radians(0));
    case Qt::Key_Right:
        return m_presenter->turn(-step, Radians(0));
    case Qt::Key_Up:
        return m_presenter->turn(Radians(0), step);
    case Qt::Key_Down:
        return m_presenter->turn(Radians(0), -step);
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        return m_presenter->zoom(1 / kZoomStep);
    case Qt::Key_Minus:
        return m_presenter->zoom(kZoomStep);
    case Qt::Key_0:
        return m_presenter->lookLevel();
    case Qt::Key_BracketLeft:
        return m_presenter->setShare(m_presenter->share() - kShareStep);
    case Qt::Key_BracketRight:
        return m_presenter->setShare(m_presenter->share() + kShareStep);
    default:
        QWidget::keyPressEvent(event);
    }
}

} // namespace spherewalk::ui
