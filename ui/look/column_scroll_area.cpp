// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/column_scroll_area.h"

#include <QEvent>
#include <QScrollBar>

namespace spherewalk::ui {

ColumnScrollArea::ColumnScrollArea(QWidget* column, QWidget* parent) : QScrollArea(parent) {
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setWidget(column);
    column->installEventFilter(this);
}

QSize ColumnScrollArea::minimumSizeHint() const {
    return {widget()->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width(),
            QScrollArea::minimumSizeHint().height()};
}

bool ColumnScrollArea::eventFilter(QObject* watched, QEvent* event) {
    if (watched == widget() && event->type() == QEvent::LayoutRequest) {
        updateGeometry(); // what is in it may have become wider
    }
    return QScrollArea::eventFilter(watched, event);
}

} // namespace spherewalk::ui
