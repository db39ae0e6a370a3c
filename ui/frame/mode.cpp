// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/frame/mode.h"

#include "ui/look/icon.h"
#include "ui/look/words.h"

#include <utility>

namespace spherewalk::ui {

Mode::Mode(const QString& name, QString title, QString hint, QWidget* parent)
    : QWidget(parent), m_title(std::move(title)), m_hint(std::move(hint)) {
    setObjectName(name);
    announceAs(*this, QAccessible::Pane, m_title);
}

QIcon Mode::icon() const {
    return ui::icon(objectName());
}

void Mode::showEvent(QShowEvent* event) {
    emit shownChanged(true);
    QWidget::showEvent(event);
}

void Mode::hideEvent(QHideEvent* event) {
    emit shownChanged(false);
    QWidget::hideEvent(event);
}

} // namespace spherewalk::ui
