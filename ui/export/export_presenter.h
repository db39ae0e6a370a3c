// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/survey_presenter.h"
#include "ui/tasks/task_list.h"

#include "spherewalk/jobs/export_dataset.h"

#include <optional>

namespace spherewalk::ui {

/// What the export page does: looks before, exports, and says what came of it.
class ExportPresenter : public SurveyPresenter {
    Q_OBJECT

  public:
    explicit ExportPresenter(TaskList& tasks, QObject* parent = nullptr);

    void setSession(SurveySession* session) override;

    /// Beside the survey, by its name.
    QString usualFolder() const;

    QString folder() const { return m_folder; }

    void setFolder(const QString& folder);
    void setOptions(const jobs::ExportOptions& options);

    /// The folder, if there is a dataset in it, else the one that was exported last from here; empty without
    /// either.
    QString dataset() const;

    /// Looks again at what an export would make.
    void check();

    /// Nothing while it is not known.
    const std::optional<jobs::ExportCheck>& found() const { return m_found; }

    bool isChecking() const { return m_checking && m_checking->isRunning(); }

    bool canExport() const;
    void exportNow();

    /// Of the export; null if none runs.
    Task* task() const { return m_task && m_task->isRunning() ? m_task.data() : nullptr; }

    /// Of the last export from here that was completed; empty without one.
    QString exported() const { return m_exported; }

    const jobs::ExportReport& report() const { return m_report; }

  signals:
    /// What was found, the task, or what was exported.
    void changed();

  private:
    void read() override;
    void done(const QString& folder, const jobs::ExportReport& report);

    TaskList& m_tasks;
    QString m_folder;
    jobs::ExportOptions m_options;
    std::optional<jobs::ExportCheck> m_found;
    QPointer<Task> m_checking;
    int m_request = 0; ///< of the latest check; what earlier ones find is dropped
    QPointer<Task> m_task;
    QString m_exported;
    jobs::ExportReport m_report;
};

} // namespace spherewalk::ui
