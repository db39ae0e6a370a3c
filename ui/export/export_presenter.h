// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/survey_session.h"
#include "ui/tasks/task.h"

#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/jobs/export_dataset.h"

#include <filesystem>
#include <optional>
#include <string>

namespace spherewalk::ui {

/// What the scene model must suffice for.
struct ViewTolerance {
    CameraIntrinsics camera; ///< Camera of the robot.
    double px = 2;           ///< Displacement that 95 of 100 places keep.
};

/// The logic of the export page: it checks what an export would make, exports, and reports the result.
class ExportPresenter : public SurveyPresenter {
    Q_OBJECT

  public:
    explicit ExportPresenter(TaskList& tasks, QObject* parent = nullptr);

    void setSession(SurveySession* session) override;

    /// Returns a folder beside the survey, with its name.
    QString usualFolder() const;

    QString folder() const { return m_folder; }

    void setFolder(const QString& folder);
    /// tolerance: the export chooses the cheapest scene model that holds it, up to the one of the options.
    void setOptions(const jobs::ExportOptions& options, const std::optional<ViewTolerance>& tolerance = {});

    /// Returns folder() if it holds a dataset, or else the folder of the last export; empty without either.
    QString dataset() const;

    /// Checks again what an export would make. changed() follows.
    void check();

    /// Returns the result of the check; nothing before its end.
    const std::optional<jobs::ExportCheck>& found() const { return m_found; }

    /// Returns the number of doubtful and failed photos on which nobody has decided.
    int undecided() const;

    bool isChecking() const { return m_checking && m_checking->isRunning(); }

    bool canExport() const;
    void exportNow();

    /// Returns the export that runs; null without one.
    Task* task() const { return m_task && m_task->isRunning() ? m_task.data() : nullptr; }

    /// Returns the folder of the last completed export; empty without one.
    QString exported() const { return m_exported; }

    const jobs::ExportReport& report() const { return m_done.report; }

    /// Returns how long the last export took, with all that it measured.
    double seconds() const { return m_done.seconds; }

    /// Says why the export chose its scene model; empty if the options fixed it.
    QString reason() const { return QString::fromStdString(m_done.reason); }

  signals:
    /// The result of the check, the task or the result of the export has changed.
    void changed();

  private:
    struct Done {
        jobs::ExportReport report;
        std::string reason;
        double seconds = 0;   ///< All that it took, with measuring.
        std::string surveyId; ///< Of a measured dataset, which has its report beside the photos.
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
    int m_request = 0; ///< Number of the latest check; results of earlier ones are dropped.
    QPointer<Task> m_task;
    QString m_exported;
    Done m_done;
};

} // namespace spherewalk::ui
