// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/survey_presenter.h"
#include "ui/tasks/task_list.h"

#include "spherewalk/jobs/grid_study.h"

#include <optional>

namespace spherewalk::ui {

/// What is to be found out about the grid.
struct GridQuestion {
    CameraIntrinsics camera;
    double tolerancePx = 2;
    bool withDepth = true;
};

/// Finds from the open survey's photos how dense the grid must be. What was found stays when the survey is
/// closed, so that the next one can be planned by it.
class GridStudyPresenter : public SurveyPresenter {
    Q_OBJECT

  public:
    explicit GridStudyPresenter(TaskList& tasks, QObject* parent = nullptr);

    void setSession(SurveySession* session) override;

    /// Why the photos cannot be studied, in a sentence; empty if they can.
    QString obstacle() const;

    void study(const GridQuestion& question);

    /// Null if none runs.
    Task* task() const { return m_task && m_task->isRunning() ? m_task.data() : nullptr; }

    /// Of the latest study that was completed.
    const std::optional<jobs::GridStudy>& found() const { return m_found; }

    /// The answer, or why there is none; empty before the first study.
    QString words() const;

    /// The block that it takes, 3 x 3.
    static constexpr int kLeastPhotos = 9;

  signals:
    void changed();
    /// Something else than before.
    void foundChanged();

  private:
    void read() override { emit changed(); }

    void ended(const Task& task);

    TaskList& m_tasks;
    QPointer<Task> m_task;
    std::optional<jobs::GridStudy> m_found;
    QString m_foundIn; ///< the survey's name
    QString m_problem; ///< of the latest study, if it was not completed
};

} // namespace spherewalk::ui
