// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plan/corner_model.h"

#include "spherewalk/survey/marking.h"

#include <QLocale>

#include <cmath>

namespace spherewalk::ui {

CornerModel::CornerModel(PlanEditor& editor, QObject* parent)
    : QAbstractTableModel(parent), m_editor(editor) {
    connect(&editor, &PlanEditor::draftChanged, this, &CornerModel::follow);
    connect(&editor, &PlanEditor::selectionChanged, this, &CornerModel::follow);
    follow();
}

void CornerModel::follow() {
    const int obstacles = static_cast<int>(m_editor.draft().room.obstacles.size());
    const int polygon = std::clamp(m_editor.selected().polygon, 0, obstacles);
    const int rows = static_cast<int>(m_editor.polygon(polygon).size());
    if (polygon != m_polygon || rows != m_rows) {
        beginResetModel();
        m_polygon = polygon;
        m_rows = rows;
        endResetModel();
    } else if (rows > 0) {
        emit dataChanged(index(0, 0), index(rows - 1, 1));
    }
}

int CornerModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : m_rows;
}

int CornerModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : 2;
}

QVariant CornerModel::data(const QModelIndex& index, int role) const {
    const Eigen::Vector2d& corner = m_editor.polygon(m_polygon)[static_cast<std::size_t>(index.row())];
    if (role == Qt::DisplayRole) {
        return QLocale().toString(corner[index.column()], 'f', 3);
    }
    if (role == Qt::EditRole) {
        return corner[index.column()];
    }
    return role == Qt::TextAlignmentRole ? QVariant(Qt::AlignRight | Qt::AlignVCenter) : QVariant();
}

QVariant CornerModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (role != Qt::DisplayRole) {
        return {};
    }
    if (orientation == Qt::Horizontal) {
        return section == 0 ? tr("x (m)") : tr("y (m)");
    }
    return m_polygon == PlanPart::kOutline ? QString::fromStdString(survey::cornerName(section))
                                           : QString::number(section + 1);
}

Qt::ItemFlags CornerModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    return m_editor.isLocked() ? flags : flags | Qt::ItemIsEditable;
}

bool CornerModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    bool isNumber = false;
    const double metres = value.toDouble(&isNumber);
    if (role != Qt::EditRole || !isNumber || !std::isfinite(metres) || m_editor.isLocked()) {
        return false;
    }
    Eigen::Vector2d corner = m_editor.polygon(m_polygon)[static_cast<std::size_t>(index.row())];
    corner[index.column()] = metres;
    m_editor.endRun();
    m_editor.moveCorner({m_polygon, index.row()}, corner);
    m_editor.endRun();
    return true;
}

} // namespace spherewalk::ui
