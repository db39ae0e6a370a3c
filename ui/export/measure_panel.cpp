// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/measure_panel.h"

#include "ui/fields/camera_box.h"
#include "ui/fields/scene_fields.h"
#include "ui/frame/settings.h"
#include "ui/look/told_label.h"
#include "ui/tasks/task_panel.h"

#include "spherewalk/jobs/measure_dataset.h"
#include "spherewalk/jobs/measure_page.h"
#include "spherewalk/jobs/measured_dataset.h"
#include "spherewalk/render/renderer.h"

#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace spherewalk::ui {

namespace {

namespace fs = std::filesystem;

constexpr double kMeasuringShare = 0.95; ///< Share of the progress; the report takes the rest.
constexpr std::size_t kWorstShown = 3;

struct Measured {
    std::string surveyId;
    std::string reason;
    bool isStored = false;
};

/// Runs on the thread of the task.
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
        m_told = {};
        m_isStored = false;
        emit changed();
    }
}

void MeasurePresenter::measure(const CameraIntrinsics& camera, double tolerancePx) {
    if (!canMeasure()) {
        return;
    }
    m_told = {};
    m_isStored = false;
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
                m_told = coreTold(found.reason);
                m_isStored = found.isStored;
            }
        });
    connect(m_task, &Task::ended, this, [this, task = m_task.data()] { ended(*task); });
    emit changed();
}

void MeasurePresenter::ended(const Task& task) {
    if (task.state() == Task::State::Failed) {
        m_told = task.told();
    } else if (task.state() == Task::State::Stopped) {
        m_told = tr("Stopped. What was found is kept: measuring again goes on from there.");
    }
    emit changed();
}

QString MeasurePresenter::page() const {
    const QString file = m_dataset + "/" + kReportFolder + "/report.html";
    return !m_dataset.isEmpty() && QFileInfo::exists(file) ? file : QString();
}

MeasurePanel::MeasurePanel(MeasurePresenter& presenter, QWidget* parent)
    : QGroupBox(tr("How right its views are"), parent), m_presenter(presenter) {
    auto* layout = new QVBoxLayout(this);
    makeQuestion();
    m_words = new ToldLabel(this);
    m_words->setObjectName("measureWords");
    m_open = new QPushButton(tr("Open &report"), this);
    m_open->setObjectName("openReport");
    m_open->setToolTip(tr("The page with error maps and trade-offs; the same as PDF lies beside it"));
    connect(m_open, &QPushButton::clicked, this, [this] { emit openRequested(m_presenter.page()); });
    auto* row = new QHBoxLayout;
    row->addWidget(m_words, 1);
    row->addWidget(m_open, 0, Qt::AlignTop);
    layout->addLayout(row);
    connect(&presenter, &MeasurePresenter::changed, this, &MeasurePanel::showAll);
    showAll();
}

void MeasurePanel::makeQuestion() {
    m_camera = new CameraBox(this);
    m_camera->setObjectName("measureCamera");
    connect(m_camera, &CameraBox::message, this, &MeasurePanel::message);
    m_tolerance = new ToleranceBox("measureTolerance", this);
    m_measure = new QPushButton(tr("&Measure"), this);
    m_measure->setObjectName("measureNow");
    m_measure->setToolTip(tr("Leave photos out, render what they would show from the rest, and compare"));
    connect(m_measure, &QPushButton::clicked, this,
            [this] { m_presenter.measure(m_camera->camera(), m_tolerance->value()); });
    m_progress = new TaskBar("stopMeasuring", tr("Stop; what was found is kept for the next run"), this);
    auto* asked = new QHBoxLayout;
    asked->addWidget(new QLabel(tr("Robot's camera"), this));
    asked->addWidget(m_camera, 1);
    asked->addWidget(new QLabel(tr("Tolerance"), this));
    asked->addWidget(m_tolerance);
    auto* row = new QHBoxLayout;
    row->addWidget(m_measure);
    row->addWidget(m_progress, 1);
    row->addStretch(0);
    static_cast<QVBoxLayout*>(layout())->addLayout(asked);
    static_cast<QVBoxLayout*>(layout())->addLayout(row);
}

void MeasurePanel::showAll() {
    Task* task = m_presenter.task();
    const bool isNone = m_presenter.dataset().isEmpty();
    for (QWidget* widget : std::initializer_list<QWidget*>{m_camera, m_tolerance, m_measure}) {
        widget->setEnabled(m_presenter.canMeasure());
    }
    m_progress->setTask(task);
    QList<Told> lines{isNone ? Told(tr("Export a dataset first, or name the folder of one that is there."),
                                    Cure::ExportFolder)
                             : m_presenter.told()};
    if (m_presenter.isStored()) {
        lines << Told(tr("Stored: views whose choice is left to the dataset are made so."));
    }
    m_words->tell(lines);
    m_words->setVisible(!m_words->text().isEmpty());
    m_open->setVisible(task == nullptr && !m_presenter.page().isEmpty());
}

} // namespace spherewalk::ui
