// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/align/align_model.h"
#include "ui/review/photo_reviewer.h"
#include "ui/session/survey_presenter.h"
#include "ui/tasks/task_list.h"

#include <functional>
#include <optional>
#include <vector>

namespace spherewalk::ui {

/// What the align page does: runs the alignment, keeps what it found, and applies what it proposes.
class AlignPresenter : public SurveyPresenter {
    Q_OBJECT

  public:
    explicit AlignPresenter(TaskList& tasks, QObject* parent = nullptr);

    void setSession(SurveySession* session) override;

    AlignModel& model() { return m_model; }

    AlignProxy& table() { return m_table; }

    /// Nothing if the survey is not aligned.
    const std::optional<jobs::SolutionFindings>& findings() const { return m_findings; }

    /// "29 photos: 27 good, 2 doubtful. Model tilt. ..."
    QString summary() const;

    bool canRun() const;
    /// Starts the alignment, unless one runs.
    void run(const jobs::AlignOptions& options);

    /// Of the alignment or of moving photos; null if none runs.
    Task* task() const { return m_task && m_task->isRunning() ? m_task.data() : nullptr; }

    /// Moves the photos to the stations that fit them; others of the list are passed over.
    void retag(const std::vector<std::int64_t>& photos);
    /// Moves all that fit other stations.
    void retagAll();
    /// Rejects the photos, so that their stations are taken again.
    void retake(const std::vector<std::int64_t>& photos);

  signals:
    void findingsChanged();
    /// A task began or ended.
    void taskChanged();

  private:
    void read() override;
    void watch(Task* task);

    friend class RetagCommand;
    /// Null if it cannot be begun.
    Task* move(std::vector<jobs::PhotoPlace> places,
               const std::function<void(std::vector<jobs::PhotoPlace>)>& done);

    TaskList& m_tasks;
    QPointer<Task> m_task;
    AlignModel m_model;
    AlignProxy m_table;
    PhotoReviewer m_reviewer;
    std::optional<jobs::SolutionFindings> m_findings;
};

} // namespace spherewalk::ui
