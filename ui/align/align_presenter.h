// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/align/align_model.h"
#include "ui/session/photo_reviewer.h"
#include "ui/session/survey_session.h"
#include "ui/tasks/task.h"

#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace spherewalk::ui {

/// The logic of the align page: it runs the alignment, holds the findings, and applies proposals.
class AlignPresenter : public SurveyPresenter {
    Q_OBJECT

  public:
    explicit AlignPresenter(TaskList& tasks, QObject* parent = nullptr);

    void setSession(SurveySession* session) override;

    AlignModel& model() { return m_model; }

    AlignProxy& table() { return m_table; }

    /// Returns the findings of the active solution; nothing if the survey is not aligned.
    const std::optional<jobs::SolutionFindings>& findings() const { return m_findings; }

    /// Returns "29 photos: 27 good, 2 doubtful. Model tilt. ...".
    Told summary() const;

    bool canRun() const;
    /// Starts the alignment, unless one runs.
    void run(const jobs::AlignOptions& options);

    /// Returns the task that aligns or moves photos; null if none runs.
    Task* task() const { return m_task && m_task->isRunning() ? m_task.data() : nullptr; }

    /// Moves these photos to the stations that are proposed for them. Photos without a proposal stay.
    void retag(const std::vector<std::int64_t>& photos);
    /// Moves all photos that have such a proposal.
    void retagAll();
    /// Rejects these photos, so that their stations are photographed again.
    void retake(const std::vector<std::int64_t>& photos);

  signals:
    void findingsChanged();
    /// A task has begun or ended.
    void taskChanged();

  private:
    void read() override;
    void forgetOfMoved();
    void watch(Task* task);

    friend class RetagCommand;
    /// Starts the move of photos; null if it cannot begin.
    Task* move(std::vector<jobs::PhotoPlace> places,
               const std::function<void(std::vector<jobs::PhotoPlace>)>& done);

    TaskList& m_tasks;
    QPointer<Task> m_task;
    AlignModel m_model;
    AlignProxy m_table;
    PhotoReviewer m_reviewer;
    std::optional<jobs::SolutionFindings> m_findings;
    /// Stations at which the alignment saw the photos that have been moved since, by photo.
    std::map<std::int64_t, std::int64_t> m_solvedAt;
};

} // namespace spherewalk::ui
