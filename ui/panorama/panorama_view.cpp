// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panorama/panorama_view.h"

#include "ui/look/theme.h"
#include "ui/look/words.h"
#include "ui/panorama/panorama_presenter.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QTransform>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace spherewalk::ui {

namespace {

constexpr double kLineReachPx = 10;
constexpr double kKeyShare = 1.0 / 12; ///< Share of the field of view that a key turns by.
constexpr double kZoomStep = 1.15;
constexpr double kShareStep = 0.02;
constexpr double kBoxStep = 1.0 / 40; ///< Share of the view that a key moves or sizes the box by.
constexpr int kPlatePx = 34;          ///< The height of a plate of one line, with a gap.
constexpr double kLeastBoxPx = 4;     ///< Smaller boxes are clicks of a hand that shakes.

/// Source: Okabe and Ito, Color Universal Design. Their lines differ, too.
const QColor kFoundColour(86, 180, 233);
const QColor kMarkedColour(240, 228, 66);

} // namespace

PanoramaView::PanoramaView(QWidget* parent) : QWidget(parent), m_presenter(new PanoramaPresenter(this)) {
    setFocusPolicy(Qt::StrongFocus);
    announceAs(*this, QAccessible::Graphic, tr("Photo to look around in"));
    setMinimumSize(240, 160);
    setCursor(Qt::OpenHandCursor);
    setToolTip(tr("Drag or use the arrow keys to look around; wheel, + and - change the field of view; 0 "
                  "looks level"));
    connect(m_presenter, &PanoramaPresenter::changed, this, &PanoramaView::showState);
}

/// Paints anew, and tells pointers and screen readers what is on.
void PanoramaView::showState() {
    update();
    const RegionTool& tool = m_presenter->regions();
    if (!m_dragFrom) {
        setCursor(tool.isMarking() ? Qt::CrossCursor : Qt::OpenHandCursor);
    }
    const ShownRegion* selected = tool.selected();
    const QString description =
        tool.isMarking()      ? tr("A box is being put around what exports shall show blurred.")
        : selected != nullptr ? (selected->isFound ? tr("Private region %1 of %2, found by the search")
                                                   : tr("Private region %1 of %2, marked by hand"))
                                    .arg(selected - tool.regions().data() + 1)
                                    .arg(tool.regions().size())
                              : QString();
    if (description != accessibleDescription()) {
        setAccessibleDescription(description);
    }
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
        paintRegions(painter);
        paintBox(painter);
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

/// Outlines private regions: dashed where the search has found them, whole where a person has marked them.
void PanoramaView::paintRegions(QPainter& painter) const {
    if (m_presenter->comparison() == Comparison::Blink && m_presenter->isOtherShown()) {
        return;
    }
    for (const auto& [corners, region, isSelected] : m_presenter->regionOutlines(size())) {
        const double width = isSelected ? 4 : 2;
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(QColor(0, 0, 0, 170), width + 2.5, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
        painter.drawPolyline(corners);
        painter.setPen(QPen(region.isFound ? kFoundColour : kMarkedColour, width,
                            region.isFound ? Qt::DashLine : Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
        painter.drawPolyline(corners);
        if (isSelected) {
            painter.setPen(QPen(Qt::black, 1));
            painter.setBrush(Qt::white);
            constexpr double kHandlePx = 4;
            for (const QPointF& corner : corners) {
                painter.drawRect(
                    QRectF(corner - QPointF(kHandlePx, kHandlePx), corner + QPointF(kHandlePx, kHandlePx)));
            }
        }
    }
    if (!m_presenter->regions().isMarking()) {
        const int below = m_presenter->isComparingUnaligned() ? 2 * kPlatePx : kPlatePx;
        paintPlate(painter, rect().adjusted(0, 0, 0, -below), Qt::AlignBottom | Qt::AlignRight,
                   accessibleDescription());
    }
}

/// Draws the box that marks a region, and says how it is moved.
void PanoramaView::paintBox(QPainter& painter) const {
    const RegionTool& tool = m_presenter->regions();
    if (!tool.isMarking()) {
        return;
    }
    const QRectF& share = tool.box();
    const QRectF box(share.left() * width(), share.top() * height(), share.width() * width(),
                     share.height() * height());
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(Qt::black, 3));
    painter.drawRect(box);
    painter.setPen(QPen(Qt::white, 1.5, Qt::DashLine));
    painter.drawRect(box);
    paintPlate(painter, rect().adjusted(0, kPlatePx, 0, 0), Qt::AlignTop | Qt::AlignLeft,
               tr("Drag a box. Or move this one: arrow keys move it, and with Shift they size it. Return "
                  "hides what is in it, Escape leaves."));
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
        paintPlate(painter, rect().adjusted(0, 0, 0, -kPlatePx), Qt::AlignBottom | Qt::AlignHCenter,
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
        m_pressedAt = event->position();
        m_dragFrom = event->position();
        m_isClick = true;
        if (m_presenter->regions().isMarking()) {
            return;
        }
        m_dragsLine = isOnLine(event->position());
        setCursor(m_dragsLine ? Qt::SplitHCursor : Qt::ClosedHandCursor);
    }
}

void PanoramaView::mouseMoveEvent(QMouseEvent* event) {
    if (!m_dragFrom) {
        return;
    }
    m_isClick = m_isClick && (event->position() - m_pressedAt).manhattanLength() < kLeastBoxPx;
    if (m_presenter->regions().isMarking()) {
        const QTransform shares =
            QTransform::fromScale(1.0 / std::max(1, width()), 1.0 / std::max(1, height()));
        return m_presenter->regions().setBox(
            shares.mapRect(QRectF(m_pressedAt, event->position()).normalized()));
    }
    if (m_isClick) {
        return; // a click that shakes does not turn
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
    if (event->button() != Qt::LeftButton || !m_dragFrom) {
        return;
    }
    m_dragFrom.reset();
    RegionTool& tool = m_presenter->regions();
    if (tool.isMarking()) {
        const QRectF drawn = QRectF(m_pressedAt, event->position()).normalized();
        if (drawn.width() >= kLeastBoxPx && drawn.height() >= kLeastBoxPx) {
            return mark();
        }
    } else if (m_isClick && !m_dragsLine) {
        tool.select(m_presenter->regionAt(event->position(), size()));
    }
    showState();
}

/// Hands on what the box marks, and leaves the tool.
void PanoramaView::mark() {
    const auto region = m_presenter->markedRegion(size());
    m_presenter->regions().setMarking(false);
    if (region) {
        emit regionMarked(*region);
    }
}

void PanoramaView::wheelEvent(QWheelEvent* event) {
    m_presenter->zoom(std::pow(kZoomStep, -event->angleDelta().y() / 120.0));
    event->accept();
}

/// Keeps shortcuts of the page from keys that the view itself needs now.
bool PanoramaView::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        const bool isOfTool = key == Qt::Key_Escape || key == Qt::Key_Return || key == Qt::Key_Enter;
        const bool isRemoval = key == Qt::Key_Delete && m_presenter->regions().selected() != nullptr;
        if (isRemoval || (isOfTool && m_presenter->regions().isMarking())) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

/// Tab goes through the private regions before it leaves the view.
bool PanoramaView::focusNextPrevChild(bool isNext) {
    return m_presenter->selectNextRegion(isNext ? 1 : -1) || QWidget::focusNextPrevChild(isNext);
}

/// Returns whether the box takes the key.
bool PanoramaView::pressWhileMarking(const QKeyEvent& event) {
    const auto change = [&](double right, double down) {
        if (event.modifiers().testFlag(Qt::ShiftModifier)) {
            m_presenter->regions().growBox({right * kBoxStep, -down * kBoxStep});
        } else {
            m_presenter->moveBox({right * kBoxStep, down * kBoxStep}, size());
        }
    };
    switch (event.key()) {
    case Qt::Key_Left:
        change(-1, 0);
        return true;
    case Qt::Key_Right:
        change(1, 0);
        return true;
    case Qt::Key_Up:
        change(0, -1);
        return true;
    case Qt::Key_Down:
        change(0, 1);
        return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        mark();
        return true;
    case Qt::Key_Escape:
        m_presenter->regions().setMarking(false);
        return true;
    default:
        return false;
    }
}

void PanoramaView::keyPressEvent(QKeyEvent* event) {
    if (m_presenter->regions().isMarking() && pressWhileMarking(*event)) {
        return;
    }
    if (event->key() == Qt::Key_Delete && m_presenter->regions().selected() != nullptr) {
        emit removalWanted();
        return;
    }
    if (event->key() == Qt::Key_Escape && m_presenter->regions().selected() != nullptr) {
        return m_presenter->regions().select(std::nullopt);
    }
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
