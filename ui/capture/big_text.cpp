// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/capture/big_text.h"

#include <QPainter>

#include <algorithm>

namespace spherewalk::ui {

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

} // namespace spherewalk::ui
