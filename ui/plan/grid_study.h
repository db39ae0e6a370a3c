// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/look/side_panel.h"
#include "ui/session/survey_session.h"
#include "ui/tasks/task.h"

#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/jobs/grid_study.h"

#include <QAbstractTableModel>
#include <QString>

#include <optional>

class QCheckBox;
class QComboBox;
class QPushButton;
class QTableView;

namespace spherewalk::ui {

class CameraBox;
class TaskBar;
class ToleranceBox;

/// The steps of a grid study as a table: photos and time of a plan, and the error of each scene model.
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
        std::vector<std::optional<double>> errorsPx; ///< One for each of m_scenes.
    };

    QString text(const Line& line, int column) const;
    /// Returns the error in the column of a scene model; nothing in other columns.
    std::optional<double> errorPx(const Line& line, int column) const;

    std::vector<render::SceneKind> m_scenes;
    std::vector<Line> m_lines;
    double m_tolerancePx = 0;
};

/// Returns "Depth: 53 cm, 38 photos, about 12 min". Range: an answer with a step.
QString answerWords(const jobs::GridAnswer& answer);

/// The question of a grid study: which step suffices for this camera and tolerance?
struct GridQuestion {
    CameraIntrinsics camera;
    double tolerancePx = 2;
    bool withDepth = true;
};

/// Studies with the photos of the open survey how dense a grid must be. The result stays when the survey is
/// closed, so that the next survey can be planned with it.
class GridStudyPresenter : public SurveyPresenter {
    Q_OBJECT

  public:
    explicit GridStudyPresenter(TaskList& tasks, QObject* parent = nullptr);

    void setSession(SurveySession* session) override;

    /// Says why the photos cannot be studied; empty if they can.
    QString obstacle() const;

    /// Starts a study, unless one runs or there is an obstacle.
    void study(const GridQuestion& question);

    /// Returns the study that runs; null without one.
    Task* task() const { return m_task && m_task->isRunning() ? m_task.data() : nullptr; }

    /// Returns the result of the latest completed study.
    const std::optional<jobs::GridStudy>& found() const { return m_found; }

    /// Says the answer, or why there is none; empty before the first study.
    QString words() const;

    /// Photos of the smallest block that can be studied, 3 x 3.
    static constexpr int kLeastPhotos = 9;

  signals:
    void changed();
    /// found() has changed.
    void foundChanged();

  private:
    void read() override { emit changed(); }

    void ended(const Task& task);

    TaskList& m_tasks;
    QPointer<Task> m_task;
    std::optional<jobs::GridStudy> m_found;
    QString m_foundIn; ///< Name of the survey that was studied.
    QString m_problem; ///< Says why the latest study failed.
};

/// A side panel that asks for camera and tolerance, and shows the result of a grid study.
class GridStudyPanel : public Section {
    Q_OBJECT

  public:
    explicit GridStudyPanel(GridStudyPresenter& presenter, QWidget* parent = nullptr);

  signals:
    /// The user wants a plan with this step. Units: metres.
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
