// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/capture/operator_signals.h"

#include "ui/capture/capture_desk.h"
#include "ui/look/theme.h"

#include <QApplication>
#include <QPainter>
#include <QTimer>

#include <algorithm>
#include <chrono>

namespace spherewalk::ui {

CapturePlanView::CapturePlanView(const CaptureDesk& desk, QWidget* parent)
    : SurveyPlanView(parent), m_desk(desk) {
    connect(&desk, &CaptureDesk::changed, this, qOverload<>(&QWidget::update));
}

bool CapturePlanView::isPlaced(const store::StationRecord& station) const {
    return m_desk.isPlaced(station);
}

std::vector<StationMark> CapturePlanView::marks(const SurveyState& survey) const {
    std::vector<StationMark> result = SurveyPlanView::marks(survey);
    for (StationMark& mark : result) {
        if (m_desk.isAgain(mark.id)) {
            mark.standing = Standing::Missing;
            mark.note = tr("to be taken again");
        }
    }
    return result;
}

void CapturePlanView::paintFloor(QPainter& painter, const QTransform& widgetFromRoom) {
    SurveyPlanView::paintFloor(painter, widgetFromRoom);
    if (session() == nullptr) {
        return;
    }
    if (!session()->state().plan.placements.empty()) {
        paintCorners(painter, widgetFromRoom);
    }
    if (!m_desk.next()) {
        return;
    }
    paintTapes(painter, widgetFromRoom);
    const Eigen::Vector3d& p = m_desk.next()->station.positionM;
    const QPointF at = mapped(p.head<2>(), widgetFromRoom);
    const double radius = std::clamp(0.02 * std::min(width(), height()) + 12, 14.0, 34.0);
    QPen pen(doubtfulColour(), 5);
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(at, radius, radius);
    for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) {
        painter.drawLine(at + 0.55 * radius * way, at + 1.5 * radius * way);
    }
}

/// Draws the letters of the corners, which tape distances name, where the marking-out sheet has them too.
void CapturePlanView::paintCorners(QPainter& painter, const QTransform& widgetFromRoom) {
    constexpr double kAwayPx = 20;
    constexpr double kRadiusPx = 8;
    const double scale = pixelsPerMetre();
    if (m_labelScale != scale || m_labelled != room().outline) {
        m_labelScale = scale;
        m_labelled = room().outline;
        m_labels = survey::cornerLabels(room(), session()->state().plan, kAwayPx / scale, kRadiusPx / scale);
    }
    painter.save();
    QFont font = painter.font();
    font.setBold(true);
    painter.setFont(font);
    painter.setPen(palette().color(QPalette::WindowText));
    for (std::size_t i = 0; i < m_labels.size(); ++i) {
        const QPointF corner = mapped(m_labelled[i], widgetFromRoom);
        const QPointF label = mapped(m_labels[i], widgetFromRoom);
        if (const double length = QLineF(corner, label).length(); length > kRadiusPx) {
            painter.drawLine(corner, label - kRadiusPx / length * (label - corner));
        }
        const QRectF box(label.x() - 12, label.y() - 9, 24, 18);
        painter.drawText(box, Qt::AlignCenter,
                         QString::fromStdString(survey::cornerName(static_cast<int>(i))));
    }
    painter.restore();
}

/// Draws the rail that is to be laid, and the tapes to its ends.
void CapturePlanView::paintTapes(QPainter& painter, const QTransform& widgetFromRoom) const {
    const survey::RailMark* rail = m_desk.railToLay();
    if (rail == nullptr) {
        return;
    }
    const QColor ink = palette().color(QPalette::WindowText);
    painter.setPen(QPen(ink, 3));
    painter.drawLine(mapped(rail->first.point, widgetFromRoom), mapped(rail->last.point, widgetFromRoom));
    for (const survey::MarkedPoint* point : {&rail->first, &rail->last}) {
        const QPointF at = mapped(point->point, widgetFromRoom);
        for (const survey::TapeDistance& tape : point->tapes) {
            const Eigen::Vector2d from =
                survey::placeOf(tape.from, point->point, room(), session()->state().plan);
            painter.setPen(QPen(ink, 1, point == &rail->first ? Qt::SolidLine : Qt::DashLine));
            painter.drawLine(mapped(from, widgetFromRoom), at);
        }
    }
}

BigText::BigText(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
}

void BigText::setText(const QString& text) {
    if (text != m_text) {
        m_text = text;
        setAccessibleName(text);
        update();
    }
}

void BigText::paintEvent(QPaintEvent* /*event*/) {
    if (m_text.isEmpty()) {
        return;
    }
    constexpr int kTrialPx = 100;
    QFont large = font();
    large.setBold(true);
    large.setPixelSize(kTrialPx);
    const QSize trial = QFontMetrics(large).size(Qt::TextSingleLine, m_text);
    const double fit = std::min(width() / double(trial.width()), height() / double(trial.height()));
    large.setPixelSize(std::max(8, static_cast<int>(kTrialPx * fit)));
    QPainter painter(this);
    painter.setFont(large);
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(rect(), Qt::AlignLeft | Qt::AlignVCenter, m_text);
}

void BellSounds::play(survey::Quality quality) {
    constexpr std::chrono::milliseconds kBetween{250};
    const int times = quality == survey::Quality::Good ? 1 : quality == survey::Quality::Doubtful ? 2 : 3;
    for (int i = 0; i < times; ++i) {
        QTimer::singleShot(i * kBetween, qApp, [] { QApplication::beep(); });
    }
}

void BellSounds::tick() {
    QApplication::beep();
}

} // namespace spherewalk::ui
