// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/jobs/grid_study.h"

#include <QAbstractTableModel>
#include <QString>

namespace spherewalk::ui {

/// The steps that were studied: what a plan with each takes, and the error of each scene model.
class GridStudyModel : public QAbstractTableModel {
    Q_OBJECT

  public:
    enum Column { StepColumn, PhotosColumn, TimeColumn, FirstSceneColumn };

    using QAbstractTableModel::QAbstractTableModel;

    void setStudy(const jobs::GridStudy& study);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

  private:
    struct Line {
        double stepM = 0;
        std::optional<jobs::GridCost> cost;
        std::vector<std::optional<double>> errorsPx; ///< of m_scenes
    };

    QString text(const Line& line, int column) const;
    /// Of a scene model's column.
    std::optional<double> errorPx(const Line& line, int column) const;

    std::vector<render::SceneKind> m_scenes;
    std::vector<Line> m_lines;
    double m_tolerancePx = 0;
};

/// "Depth: 53 cm, 38 photos, about 12 min". Range: an answer with a step.
QString answerWords(const jobs::GridAnswer& answer);

} // namespace spherewalk::ui
