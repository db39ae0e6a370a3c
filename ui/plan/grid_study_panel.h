// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/look/section.h"

class QCheckBox;
class QComboBox;
class QPushButton;
class QTableView;

namespace spherewalk::ui {

class CameraBox;
class GridStudyModel;
class GridStudyPresenter;
class TaskBar;
class ToleranceBox;

/// "How dense?": asks for camera and tolerance, and shows what a study of the grid found.
class GridStudyPanel : public Section {
    Q_OBJECT

  public:
    explicit GridStudyPanel(GridStudyPresenter& presenter, QWidget* parent = nullptr);

  signals:
    /// The user wants to plan with this step. Units: metres.
    void stepChosen(double stepM);

  private:
    void makeQuestion();
    void makeAnswer();
    void study();
    void showState();
    void showFound();

    GridStudyPresenter& m_presenter;
    GridStudyModel* m_model;
    QLabel* m_obstacle = nullptr;
    CameraBox* m_camera = nullptr;
    ToleranceBox* m_tolerance = nullptr;
    QCheckBox* m_depth = nullptr;
    QPushButton* m_study = nullptr;
    TaskBar* m_progress = nullptr;
    QLabel* m_words = nullptr;
    QTableView* m_table = nullptr;
    QComboBox* m_answer = nullptr;
    QPushButton* m_use = nullptr;
};

} // namespace spherewalk::ui
