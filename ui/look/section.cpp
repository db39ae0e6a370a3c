// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/section.h"

#include <QFormLayout>
#include <QLabel>
#include <QVBoxLayout>

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

} // namespace spherewalk::ui
