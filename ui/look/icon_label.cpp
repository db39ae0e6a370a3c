// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/icon_label.h"

#include "ui/look/icon.h"

#include <QPainter>

namespace spherewalk::ui {

IconLabel::IconLabel(const QString& iconName, int sizePx, QWidget* parent) : QWidget(parent) {
    setFixedSize(sizePx, sizePx);
    setIcon(iconName);
}

void IconLabel::setIcon(const QString& iconName) {
    if (iconName != m_name) {
        m_name = iconName;
        m_icon = ui::icon(iconName);
        update();
    }
}

void IconLabel::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    m_icon.paint(&painter, rect());
}

} // namespace spherewalk::ui
