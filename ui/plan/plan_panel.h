// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plan/plan_editor.h"

#include <QAbstractTableModel>
#include <QWidget>

#include <functional>

class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QTableView;

namespace spherewalk::ui {

/// The corners of the selected polygon as an editable table of x and y, in metres of the room. Without a
/// selection it has the corners of the outline.
class CornerModel : public QAbstractTableModel {
    Q_OBJECT

  public:
    explicit CornerModel(PlanEditor& editor, QObject* parent = nullptr);

    int polygon() const { return m_polygon; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

  private:
    void follow();

    PlanEditor& m_editor;
    int m_polygon = PlanPart::kOutline;
    int m_rows = 0;
};

/// The panel beside the drawing: it edits corners, heights, grid and pace, and shows the figures of the plan.
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
    /// Applies each edit of the box to the draft. Successive edits of one key are one step of undo.
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
