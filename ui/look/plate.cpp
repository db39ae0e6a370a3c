// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/plate.h"

#include <QPainter>

namespace spherewalk::ui {

QRectF paintPlate(QPainter& painter, const QRectF& within, Qt::Alignment alignment, const QString& text) {
    constexpr double kNarrowestPx = 40;
    const QRectF inside = within.adjusted(16, 10, -16, -10);
    if (text.isEmpty() || inside.width() < kNarrowestPx) {
        return {};
    }
    const int flags = static_cast<int>(alignment) | Qt::TextWordWrap;
    painter.setPen(Qt::white); // before measuring: without a pen, text has no size
    const QRectF box = painter.boundingRect(inside, flags, text);
    const QRectF plate = box.adjusted(-8, -4, 8, 4);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 170));
    painter.drawRoundedRect(plate, 5, 5);
    painter.setPen(Qt::white);
    painter.drawText(box, flags, text);
    return plate;
}

} // namespace spherewalk::ui
