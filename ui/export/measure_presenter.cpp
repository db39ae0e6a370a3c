// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/measure_presenter.h"

#include "ui/shell/settings.h"

#include "spherewalk/jobs/measure_dataset.h"
#include "spherewalk/jobs/measure_page.h"
#include "spherewalk/jobs/measure_survey.h"

#include <QFileInfo>

namespace spherewalk::ui {

namespace {

namespace fs = std::filesystem;

constexpr double kMeasuringShare = 0.95; ///< of the time; the rest is for the report
constexpr std::size_t kWorstShown = 3;
constexpr const char* kReportFolder = "report";

struct Measured {
    std::string surveyId;
    std::string reason;
    bool isStored = false;
};

/// On the task's thread.
Measured measured(const fs::path& folder, const CameraIntrinsics& camera, double tolerancePx,
                  ProgressSink& progress, const std::stop_token& stop) {
    const render::Renderer renderer(std::make_shared<const render::Dataset>(
        render::Dataset::open(folder, render::Verify::Sizes, noProgress(), stop)));
    jobs::MeasureOptions options;
    options.tolerancePx = tolerancePx;
    options.worst = kWorstShown;
    options.cacheFolder = jobs::measureCacheFolder(folder) / "results";
    ProgressStep measuring(progress, 0, kMeasuringShare);
    const jobs::MeasureReport report =
        jobs::measureDataset(renderer, CameraModel(camera), options, measuring, stop);
    progress.progress(kMeasuringShare, "Writing the report");
    const render::DatasetInfo& info = renderer.dataset().info();
    Measured result{info.surveyId, report.choice.reason, jobs::viewChoice(report).has_value()};
    if (result.isStored) {
        jobs::storeChoice(folder, report);
    }
    jobs::writeReport({&info, &report, nullptr}, folder / kReportFolder);
    return result;
}

} // namespace

MeasurePresenter::MeasurePresenter(TaskList& tasks, QObject* parent) : QObject(parent), m_tasks(tasks) {
}

void MeasurePresenter::setDataset(const QString& folder) {
    if (folder != m_dataset) {
        m_dataset = folder;
        m_words.clear();
        emit changed();
    }
}

void MeasurePresenter::measure(const CameraIntrinsics& camera, double tolerancePx) {
    if (!canMeasure()) {
        return;
    }
    m_words.clear();
    m_task = m_tasks.start(
        tr("Measuring %1").arg(QFileInfo(m_dataset).fileName()), this,
        [folder = fs::path(m_dataset.toStdString()), camera, tolerancePx](ProgressSink& progress,
                                                                          const std::stop_token& stop) {
            return measured(folder, camera, tolerancePx, progress, stop);
        },
        [this, folder = m_dataset](const Measured& found) {
            Settings().setMeasuredReport(QString::fromStdString(found.surveyId),
                                         folder + "/" + kReportFolder + "/report.json");
            if (folder == m_dataset) {
                const QString reason = QString::fromStdString(found.reason);
                m_words =
                    found.isStored
                        ? tr("%1\nStored: views whose choice is left to the dataset are made so.").arg(reason)
                        : reason;
            }
        });
    connect(m_task, &Task::ended, this, [this, task = m_task.data()] { ended(*task); });
    emit changed();
}

void MeasurePresenter::ended(const Task& task) {
    if (task.state() == Task::State::Failed) {
        m_words = task.sentence();
    } else if (task.state() == Task::State::Stopped) {
        m_words = tr("Stopped. What was found is kept: measuring again goes on from there.");
    }
    emit changed();
}

QString MeasurePresenter::page() const {
    const QString file = m_dataset + "/" + kReportFolder + "/report.html";
    return !m_dataset.isEmpty() && QFileInfo::exists(file) ? file : QString();
}

} // namespace spherewalk::ui
