// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/side_panel.h"

#include "ui/look/theme.h"
#include "ui/look/words.h"

#include <QEvent>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>

namespace spherewalk::ui {

Section::Section(const QString& title, QWidget* parent) : QFrame(parent), m_title(new QLabel(title, this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 8);
    layout->setSpacing(4);
    QFont font = m_title->font();
    font.setBold(true);
    m_title->setFont(font);
    layout->addWidget(m_title);
}

QLabel* Section::addWords() {
    auto* label = new QLabel(this);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    layout()->addWidget(label);
    return label;
}

QFormLayout* Section::addForm() {
    auto* form = new QFormLayout;
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->setVerticalSpacing(4);
    static_cast<QVBoxLayout*>(layout())->addLayout(form);
    return form;
}

void Section::addRow(QFormLayout* form, const QString& label, QWidget* field, const QString& hint) {
    form->addRow(label, field);
    field->setToolTip(hint);
    field->setAccessibleName(QString(label).remove('&'));
    field->setAccessibleDescription(hint);
}

ColumnScrollArea::ColumnScrollArea(QWidget* column, QWidget* parent) : QScrollArea(parent) {
    setWidgetResizable(true);
    announceAs(*this, QAccessible::Pane, tr("Column that scrolls"));
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setWidget(column);
    column->installEventFilter(this);
}

QSize ColumnScrollArea::minimumSizeHint() const {
    const int narrowest = std::max(widget()->minimumSizeHint().width(), widget()->minimumWidth());
    return {narrowest + verticalScrollBar()->sizeHint().width(), QScrollArea::minimumSizeHint().height()};
}

bool ColumnScrollArea::eventFilter(QObject* watched, QEvent* event) {
    if (watched == widget() && event->type() == QEvent::LayoutRequest) {
        updateGeometry(); // what is in it may have become wider
    }
    return QScrollArea::eventFilter(watched, event);
}

void makePrimary(QPushButton* button) {
    button->setStyleSheet("QPushButton { background: palette(highlight); color: palette(highlighted-text);"
                          " border: 2px solid palette(highlight); border-radius: 6px; padding: 5px 14px;"
                          " font-weight: bold; }"
                          "QPushButton:focus { border-color: palette(window-text); }"
                          "QPushButton:pressed { border-color: palette(base); }"
                          "QPushButton:disabled { background: palette(button); color: palette(mid);"
                          " border-color: palette(mid); }");
}

void makeWarning(QLabel* label) {
    label->setStyleSheet(QString("background: %1; color: black; border-radius: 4px; padding: 4px 8px;"
                                 " font-weight: bold;")
                             .arg(doubtfulColour().name()));
}

} // namespace spherewalk::ui
