// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plan/rail_panel.h"

#include "ui/plan/plan_draft.h"

#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>

#include <algorithm>

namespace spherewalk::ui {

namespace {

QString degreesText(Radians heading) {
    return QLocale().toString(Degrees(heading).value(), 'f', 0);
}

} // namespace

RailPanel::RailPanel(PlanEditor& editor, QWidget* parent)
    : Section(tr("Rails"), parent), m_editor(editor), m_whose(addWords()), m_selected(addWords()) {
    m_whose->setObjectName("whoseRails");
    m_selected->setObjectName("selectedRail");
    m_split =
        addButton("splitRail", tr("Split"), tr("Make two rails of it, the second from the selected stop on"));
    m_lock =
        addButton("lockRail", tr("Lock"), tr("Keep the rail where it is, also when others are laid anew"));
    m_remove = addButton("removeRail", tr("Remove"), tr("Remove the selected stop or rail (Delete)"));
    m_anew = addButton("layAnew", tr("Lay the others anew"),
                       tr("Keep the locked rails, and lay out the rest of the floor around them"));
    m_lock->setCheckable(true);
    auto* grid = new QGridLayout;
    grid->addWidget(m_split, 0, 0);
    grid->addWidget(m_lock, 0, 1);
    grid->addWidget(m_remove, 0, 2);
    grid->addWidget(m_anew, 1, 0, 1, 3);
    static_cast<QVBoxLayout*>(layout())->addLayout(grid);
    connect(m_split, &QPushButton::clicked, &editor, &PlanEditor::splitSelected);
    connect(m_lock, &QPushButton::clicked, &editor, &PlanEditor::setSelectedLocked);
    connect(m_remove, &QPushButton::clicked, &editor, &PlanEditor::removeSelected);
    connect(m_anew, &QPushButton::clicked, &editor, &PlanEditor::layOthersAnew);
    connect(&editor, &PlanEditor::draftChanged, this, &RailPanel::showState);
    connect(&editor, &PlanEditor::selectionChanged, this, &RailPanel::showState);
    connect(&editor, &PlanEditor::outcomeChanged, this, &RailPanel::showState);
    showState();
}

QPushButton* RailPanel::addButton(const QString& objectName, const QString& text, const QString& hint) {
    auto* button = new QPushButton(text, this);
    button->setObjectName(objectName);
    button->setToolTip(hint);
    return button;
}

void RailPanel::showState() {
    const PlanDraft& draft = m_editor.draft();
    const PlanPart part = m_editor.selected();
    const std::vector<survey::RailPlacement>& rails = m_editor.rails();
    const bool isSelected = part.rail >= 0 && part.rail < static_cast<int>(rails.size());
    const bool isByHand = !draft.rails.empty();
    setVisible(!m_editor.isLocked() && (isSelected || isByHand));
    const auto locked =
        static_cast<int>(std::ranges::count_if(rails, [](const auto& rail) { return rail.isLocked; }));
    m_whose->setText(!isByHand ? tr("The program laid all rails.")
                     : draft.laysRest
                         ? tr("The program laid the rest around %n locked rail(s).", nullptr, locked)
                         : tr("Laid by hand; %n of them locked.", nullptr, locked));
    m_selected->setVisible(isSelected);
    m_anew->setEnabled(isByHand);
    const survey::RailPlacement rail =
        isSelected ? rails[static_cast<std::size_t>(part.rail)] : survey::RailPlacement();
    if (isSelected) {
        m_selected->setText(tr("Rail %1: %n stop(s), %L2 m, heading %3°", nullptr, rail.stops)
                                .arg(part.rail + 1)
                                .arg(railLengthM(rail.stops, rail.stepM), 0, 'f', 2)
                                .arg(degreesText(rail.heading)));
    }
    m_split->setEnabled(isSelected && part.stop > 0 && !rail.isLocked);
    m_remove->setEnabled(isSelected && !rail.isLocked);
    m_lock->setEnabled(isSelected);
    m_lock->setChecked(rail.isLocked);
    m_lock->setText(rail.isLocked ? tr("Unlock") : tr("Lock"));
}

} // namespace spherewalk::ui
