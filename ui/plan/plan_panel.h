// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plan/plan_editor.h"

#include <QWidget>

#include <functional>

class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QTableView;

namespace spherewalk::ui {

/// The numbers beside the drawing: corners, heights, grid, pace, and what they come to.
class PlanPanel : public QWidget {
    Q_OBJECT

  public:
    explicit PlanPanel(PlanEditor& editor, QWidget* parent = nullptr);

  private:
    QWidget* makeResult();
    QWidget* makeGrid();
    QWidget* makeCorners();
    QDoubleSpinBox* makeNumber(const QString& objectName, double least, double most, double step, int digits,
                               const QString& unit);
    /// Edits follow the box; steps with the same key are one step of undo.
    void bind(QDoubleSpinBox* box, int key, const std::function<void(PlanDraft&, double)>& apply);
    void applyHeights();
    void showDraft();
    void showOutcome();

    PlanEditor& m_editor;
    QLabel* m_counts = nullptr;
    QLabel* m_walk = nullptr;
    QLabel* m_floor = nullptr;
    QLabel* m_uncovered = nullptr;
    QLabel* m_problem = nullptr;
    QDoubleSpinBox* m_step = nullptr;
    QDoubleSpinBox* m_rail = nullptr;
    QLabel* m_railStops = nullptr;
    QDoubleSpinBox* m_clearance = nullptr;
    QDoubleSpinBox* m_ceiling = nullptr;
    QDoubleSpinBox* m_photoPace = nullptr;
    QDoubleSpinBox* m_railPace = nullptr;
    QLineEdit* m_heights = nullptr;
    QLabel* m_cornersTitle = nullptr;
    QTableView* m_corners = nullptr;
    QWidget* m_grid = nullptr;
};

} // namespace spherewalk::ui
