// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/export_presenter.h"

#include "ui/export/measure_panel.h"
#include "ui/frame/settings.h"
#include "ui/look/words.h"

#include "spherewalk/base/clock.h"
#include "spherewalk/jobs/measure_page.h"
#include "spherewalk/jobs/measured_dataset.h"
#include "spherewalk/render/dataset.h"

#include <QDir>
#include <QFileInfo>

namespace spherewalk::ui {

ExportPresenter::ExportPresenter(TaskList& tasks, QObject* parent) : SurveyPresenter(parent), m_tasks(tasks) {
}

void ExportPresenter::setSession(SurveySession* session) {
    SurveyPresenter::setSession(session);
    m_exported.clear();
    setFolder(usualFolder());
}

QString ExportPresenter::usualFolder() const {
    if (session() == nullptr) {
        return {};
    }
    const QFileInfo survey(QString::fromStdString(session()->path().string()));
    return survey.dir().filePath(survey.completeBaseName() + QStringLiteral(".dataset"));
}

void ExportPresenter::setFolder(const QString& folder) {
    if (folder.trimmed() != m_folder) {
        m_folder = folder.trimmed();
        read();
    }
}

void ExportPresenter::setOptions(const jobs::ExportOptions& options,
                                 const std::optional<ViewTolerance>& tolerance) {
    m_options = options;
    m_tolerance = tolerance;
    read();
}

QString ExportPresenter::dataset() const {
    const bool isThere = !m_folder.isEmpty() && QFileInfo::exists(m_folder + "/dataset.json");
    return isThere ? m_folder : m_exported;
}

/// Drops the result of a check that is outdated.
void ExportPresenter::read() {
    m_found.reset();
    ++m_request;
    if (m_checking) {
        m_checking->stop();
        m_checking.clear();
    }
    emit changed();
}

void ExportPresenter::check() {
    if (session() == nullptr || m_folder.isEmpty() || isChecking() || task() != nullptr) {
        return;
    }
    m_checking = m_tasks.start(
        tr("Looking before the export"), this,
        [survey = session()->path(), folder = std::filesystem::path(m_folder.toStdString()),
         options = m_options](ProgressSink& progress, const std::stop_token& stop) {
            const auto store = store::SurveyStore::open(survey, store::Access::Read);
            return jobs::checkExport(store, folder, options, progress, stop);
        },
        [this, request = ++m_request](jobs::ExportCheck found) {
            if (request == m_request) {
                m_found = std::move(found);
            }
        });
    connect(m_checking, &Task::ended, this, &ExportPresenter::changed);
    emit changed();
}

int ExportPresenter::undecided() const {
    return session() == nullptr
               ? 0
               : session()->state().count(Standing::Doubtful) + session()->state().count(Standing::Failed);
}

bool ExportPresenter::canExport() const {
    return session() != nullptr && m_found && m_found->isPossible() && task() == nullptr;
}

void ExportPresenter::exportNow() {
    if (!canExport()) {
        return;
    }
    m_exported.clear();
    m_task = m_tasks.start(
        tr("Exporting %1").arg(session()->name()), this,
        [survey = session()->path(), folder = std::filesystem::path(m_folder.toStdString()),
         options = m_options, tolerance = m_tolerance](ProgressSink& progress, const std::stop_token& stop) {
            return exported(survey, folder, options, tolerance, progress, stop);
        },
        [this, folder = m_folder](const Done& done) { show(folder, done); });
    connect(m_task, &Task::ended, this, [this, task = m_task.data()] {
        if (task->state() == Task::State::Stopped) {
            emit message(tr("Stopped; nothing of the dataset is left."));
        }
        emit changed();
    });
    emit changed();
}

/// Runs on the thread of the task.
ExportPresenter::Done ExportPresenter::exported(const std::filesystem::path& survey,
                                                const std::filesystem::path& folder,
                                                const jobs::ExportOptions& options,
                                                const std::optional<ViewTolerance>& tolerance,
                                                ProgressSink& progress, const std::stop_token& stop) {
    const Clock::TimePoint begun = systemClock().now();
    const auto seconds = [begun] {
        return std::chrono::duration<double>(systemClock().now() - begun).count();
    };
    const auto store = store::SurveyStore::open(survey, store::Access::Read);
    if (!tolerance) {
        const jobs::ExportReport report = jobs::exportDataset(store, folder, options, progress, stop);
        return {report, {}, seconds(), {}};
    }
    jobs::MeasureOptions measure;
    measure.tolerancePx = tolerance->px;
    const jobs::ChosenExport chosen =
        jobs::exportChosen(store, folder, CameraModel(tolerance->camera), measure, options, progress, stop);
    const render::Dataset dataset = render::Dataset::open(folder, render::Verify::Sizes, noProgress(), stop);
    jobs::writeReport({&dataset.info(), &chosen.measured, nullptr}, folder / kReportFolder);
    return {chosen.exported, chosen.measured.choice.reason, seconds(), dataset.info().surveyId};
}

void ExportPresenter::show(const QString& folder, const Done& done) {
    m_exported = folder;
    m_done = done;
    m_found.reset();
    if (!done.surveyId.empty()) {
        Settings().setMeasuredReport(QString::fromStdString(done.surveyId),
                                     folder + "/" + kReportFolder + "/report.json");
    }
    const dataset::WriteReport& written = done.report.written;
    emit message(tr("Exported %n photo(s) to %1: %2.", nullptr, static_cast<int>(written.photos))
                     .arg(folder, bytesText(written.totalBytes)));
}

} // namespace spherewalk::ui
