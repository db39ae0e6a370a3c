// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/look/side_panel.h"
#include "ui/plan/plan_editor.h"

class QPushButton;

namespace spherewalk::ui {

/// What is said of the rails and of the selected one, and what can be done with it. It hides while the
/// program lays all rails and none is selected.
class RailPanel : public Section {
    Q_OBJECT

  public:
    explicit RailPanel(PlanEditor& editor, QWidget* parent = nullptr);

  private:
    QPushButton* addButton(const QString& objectName, const QString& text, const QString& hint);
    void showState();

    PlanEditor& m_editor;
    QLabel* m_whose;
    QLabel* m_selected;
    QPushButton* m_split;
    QPushButton* m_lock;
    QPushButton* m_remove;
    QPushButton* m_anew;
};

} // namespace spherewalk::ui
