// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/survey_presenter.h"
#include "ui/tasks/task_list.h"

#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/jobs/export_dataset.h"

#include <filesystem>
#include <optional>
#include <string>

namespace spherewalk::ui {

/// What a scene model is to be enough for.
struct ViewTolerance {
    CameraIntrinsics camera; ///< the robot's
    double px = 2;           ///< that 95 of 100 places may be displaced by
};

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
    /// tolerance: with the cheapest scene model that holds it, up to that of the options.
    void setOptions(const jobs::ExportOptions& options, const std::optional<ViewTolerance>& tolerance = {});

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

    const jobs::ExportReport& report() const { return m_done.report; }

    /// Why it has the scene model that it has; empty if that was not left open.
    QString reason() const { return QString::fromStdString(m_done.reason); }

  signals:
    /// What was found, the task, or what was exported.
    void changed();

  private:
    struct Done {
        jobs::ExportReport report;
        std::string reason;
    };

    void read() override;
    static Done exported(const std::filesystem::path& survey, const std::filesystem::path& folder,
                         const jobs::ExportOptions& options, const std::optional<ViewTolerance>& tolerance,
                         ProgressSink& progress, const std::stop_token& stop);
    void show(const QString& folder, const Done& done);

    TaskList& m_tasks;
    QString m_folder;
    jobs::ExportOptions m_options;
    std::optional<ViewTolerance> m_tolerance;
    std::optional<jobs::ExportCheck> m_found;
    QPointer<Task> m_checking;
    int m_request = 0; ///< of the latest check; what earlier ones find is dropped
    QPointer<Task> m_task;
    QString m_exported;
    Done m_done;
};

} // namespace spherewalk::ui
