// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/preview/drive_view.h"

#include "ui/look/plate.h"
#include "ui/preview/preview_presenter.h"
#include "ui/preview/rung_words.h"

#include <QFileInfo>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <cmath>

namespace spherewalk::ui {

namespace {

Radians fieldOf(const CameraIntrinsics& camera) {
    return Radians(2 * std::atan2(0.5 * camera.width, camera.fx));
}

} // namespace

DriveView::DriveView(PreviewPresenter& presenter, QWidget* parent) : QWidget(parent), m_presenter(presenter) {
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(320, 240);
    setAccessibleName(tr("What the robot's camera sees"));
    setToolTip(tr("W A S D or the arrow keys drive, Q and E go sideways; drag to turn"));
    connect(&presenter, &PreviewPresenter::viewsChanged, this, qOverload<>(&QWidget::update));
}

QString DriveView::reportText(const render::ViewReport& report) {
    const QString photo = QFileInfo(QString::fromStdString(report.file)).fileName();
    QString text = tr("%1, %2 cm away, trust %3, %4 ms")
                       .arg(photo)
                       .arg(100 * report.offsetM, 0, 'f', 1)
                       .arg(report.trust, 0, 'f', 2)
                       .arg(report.renderMs + report.decodeMs, 0, 'f', 1);
    text += QStringLiteral("\n") +
            tr("scene model %1, sampling %2").arg(sceneWord(report.scene), samplingWord(report.sampling));
    if (report.origin == render::ViewOrigin::Thumbnail) {
        text += tr(", coarse until it is decoded");
    } else if (report.origin == render::ViewOrigin::PreviousPhoto) {
        text += tr(", from the photo before until it is decoded");
    }
    return text;
}

void DriveView::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), QColor(24, 24, 24));
    const std::vector<MadeView>& views = m_presenter.views();
    if (views.empty()) {
        painter.setPen(QColor(200, 200, 200));
        painter.drawText(rect().adjusted(20, 20, -20, -20), Qt::AlignCenter | Qt::TextWordWrap,
                         m_presenter.dataset() != nullptr
                             ? tr("Rendering...")
                             : tr("Make a preview of the open survey, or open a dataset."));
    }
    for (std::size_t i = 0; i < views.size(); ++i) {
        paintView(painter, boxOf(i), views[i]);
    }
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

/// Beside or above each other, as makes the pictures larger.
QRect DriveView::boxOf(std::size_t view) const {
    const auto count = static_cast<int>(m_presenter.views().size());
    const auto index = static_cast<int>(view);
    const QSize picture = m_presenter.views().front().picture.size();
    const QSize beside(width() / count, height());
    const QSize above(width(), height() / count);
    const bool isBeside = picture.scaled(beside, Qt::KeepAspectRatio).width() >=
                          picture.scaled(above, Qt::KeepAspectRatio).width();
    const QRect box = isBeside ? QRect(QPoint(index * beside.width(), 0), beside)
                               : QRect(QPoint(0, index * above.height()), above);
    return box.adjusted(1, 1, -1, -1);
}

void DriveView::paintView(QPainter& painter, const QRect& box, const MadeView& view) const {
    QRect target(QPoint(), view.picture.size().scaled(box.size(), Qt::KeepAspectRatio));
    target.moveCenter(box.center());
    painter.drawImage(target, view.picture);
    const QRectF plate =
        paintPlate(painter, target, Qt::AlignLeft | Qt::AlignBottom, reportText(view.report));
    // How far the view can be believed, as a bar besides the number.
    const QRectF bar(plate.left(), plate.top() - 9, 120, 5);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 170));
    painter.drawRect(bar);
    painter.setBrush(QColor(86, 180, 233));
    painter.drawRect(QRectF(bar.topLeft(), QSizeF(bar.width() * view.report.trust, bar.height())));
}

bool DriveView::isDriving(int key) {
    static const QSet<int> kKeys{Qt::Key_W, Qt::Key_A,    Qt::Key_S,     Qt::Key_D,  Qt::Key_Q,
                                 Qt::Key_E, Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down};
    return kKeys.contains(key);
}

DriveWish DriveView::wish() const {
    const auto held = [&](int a, int b) { return m_held.contains(a) || m_held.contains(b) ? 1 : 0; };
    DriveWish wish;
    wish.forward = held(Qt::Key_W, Qt::Key_Up) - held(Qt::Key_S, Qt::Key_Down);
    wish.turnLeft = held(Qt::Key_A, Qt::Key_Left) - held(Qt::Key_D, Qt::Key_Right);
    wish.left = held(Qt::Key_Q, Qt::Key_Q) - held(Qt::Key_E, Qt::Key_E);
    return wish;
}

void DriveView::keyPressEvent(QKeyEvent* event) {
    if (!isDriving(event->key()) || event->modifiers().testFlag(Qt::ControlModifier)) {
        return QWidget::keyPressEvent(event);
    }
    if (!event->isAutoRepeat()) {
        m_held.insert(event->key());
        m_presenter.drive(wish());
    }
}

void DriveView::keyReleaseEvent(QKeyEvent* event) {
    if (!isDriving(event->key())) {
        return QWidget::keyReleaseEvent(event);
    }
    if (!event->isAutoRepeat()) {
        m_held.remove(event->key());
        m_presenter.drive(wish());
    }
}

void DriveView::focusOutEvent(QFocusEvent* event) {
    m_held.clear(); // their releases go elsewhere
    m_presenter.drive({});
    QWidget::focusOutEvent(event);
    update();
}

void DriveView::mousePressEvent(QMouseEvent* event) {
    m_dragFrom = event->position();
}

void DriveView::mouseMoveEvent(QMouseEvent* event) {
    if (!event->buttons().testFlag(Qt::LeftButton)) {
        return;
    }
    const QPointF moved = event->position() - m_dragFrom;
    m_dragFrom = event->position();
    RobotPlace robot = m_presenter.robot();
    const double share = moved.x() / std::max(1, width());
    robot.yaw = wrapped(robot.yaw + fieldOf(m_presenter.camera()) * share);
    m_presenter.setRobot(robot);
}

} // namespace spherewalk::ui
