// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plan/plan_editor.h"

#include <QAbstractTableModel>

namespace spherewalk::ui {

/// The corners of the selected polygon as a table of x and y that can be typed into; of the outline if none
/// is selected.
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

} // namespace spherewalk::ui
