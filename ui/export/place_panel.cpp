// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/place_panel.h"

#include "ui/look/core_words.h"
#include "ui/look/told_label.h"
#include "ui/session/survey_session.h"
#include "ui/tasks/task_panel.h"

#include "spherewalk/base/error.h"

#include <QCheckBox>
#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace spherewalk::ui {

namespace fs = std::filesystem;

PlacePresenter::PlacePresenter(TaskList& tasks, QObject* parent) : QObject(parent), m_tasks(tasks) {
}

void PlacePresenter::setDataset(const QString& folder) {
    if (folder == m_dataset) {
        return;
    }
    m_dataset = folder;
    m_words.clear();
    m_exported.clear();
    try {
        m_hasDepths = jobs::hasDepths(fs::path(folder.toStdString()));
    } catch (const Error& error) {
        m_hasDepths = false;
        m_words = coreWords(error.sentence());
    }
    emit changed();
}

void PlacePresenter::exportNow(const std::set<jobs::PlaceFormat>& formats) {
    if (!canExport()) {
        return;
    }
    m_words.clear();
    m_exported.clear();
    jobs::PlaceOptions options;
    options.formats = formats;
    const QFileInfo dataset(m_dataset);
    const QString folder =
        freeFolder(dataset.dir().filePath(dataset.completeBaseName()), QStringLiteral(".place"));
    m_task = m_tasks.start(
        tr("Writing the place of %1").arg(QFileInfo(m_dataset).fileName()), this,
        [dataset = fs::path(m_dataset.toStdString()), to = fs::path(folder.toStdString()),
         options](ProgressSink& progress, const std::stop_token& stop) {
            return jobs::exportPlace(dataset, to, options, progress, stop);
        },
        [this, folder](const jobs::PlaceReport& report) { show(folder, report); });
    connect(m_task, &Task::ended, this, [this, task = m_task.data()] { ended(*task); });
    emit changed();
}

void PlacePresenter::show(const QString& folder, const jobs::PlaceReport& report) {
    m_exported = folder;
    m_words = tr("%1: %L2 m² of surfaces. From the photos there is a surface in %L3 % of all directions; the "
                 "rest are holes. Two photos or more show %L4 % of it.")
                  .arg(folder)
                  .arg(report.areaM2, 0, 'f', 1)
                  .arg(100 * report.seenShare, 0, 'f', 1)
                  .arg(100 * report.seenTwiceShare, 0, 'f', 1);
}

void PlacePresenter::ended(const Task& task) {
    if (task.state() == Task::State::Failed) {
        m_words = task.sentence();
    } else if (task.state() == Task::State::Stopped) {
        m_words = tr("Stopped; nothing was written.");
    }
    emit changed();
}

PlacePanel::PlacePanel(PlacePresenter& presenter, QWidget* parent)
    : QGroupBox(tr("The place for other programs"), parent), m_presenter(presenter) {
    auto* layout = new QVBoxLayout(this);
    auto* formats = new QHBoxLayout;
    layout->addLayout(formats);
    addFormat(jobs::PlaceFormat::Ply, tr("Points (PLY)"),
              tr("Every vertex with colour, normal, and how many photos show it"));
    addFormat(jobs::PlaceFormat::Gltf, tr("Mesh (glTF)"), tr("One file that viewers and game engines open"));
    addFormat(jobs::PlaceFormat::Obj, tr("Mesh (OBJ)"), tr("The same as text"));
    addFormat(jobs::PlaceFormat::Occupancy, tr("Map for robots"),
              tr("Where a robot can drive, as Nav2 and map_server read it"));
    for (const auto& [format, box] : m_formats) {
        formats->addWidget(box);
    }
    formats->addStretch(1);
    m_export = new QPushButton(tr("Write"), this);
    m_export->setObjectName("placeNow");
    connect(m_export, &QPushButton::clicked, this, [this] { m_presenter.exportNow(chosen()); });
    m_progress = new TaskBar("stopPlace", tr("Stop; nothing is written then"), this);
    auto* row = new QHBoxLayout;
    row->addWidget(m_export);
    row->addWidget(m_progress, 1);
    row->addStretch(0);
    layout->addLayout(row);
    m_words = new ToldLabel(this);
    m_words->setObjectName("placeWords");
    m_open = new QPushButton(tr("Open its folder"), this);
    m_open->setObjectName("openPlace");
    connect(m_open, &QPushButton::clicked, this, [this] { emit openRequested(m_presenter.exported()); });
    auto* after = new QHBoxLayout;
    after->addWidget(m_words, 1);
    after->addWidget(m_open, 0, Qt::AlignTop);
    layout->addLayout(after);
    connect(&presenter, &PlacePresenter::changed, this, &PlacePanel::showAll);
    showAll();
}

void PlacePanel::addFormat(jobs::PlaceFormat format, const QString& text, const QString& hint) {
    auto* box = new QCheckBox(text, this);
    const std::string_view name = jobs::name(format);
    box->setObjectName(QLatin1String(name.data(), static_cast<qsizetype>(name.size())));
    box->setToolTip(hint);
    box->setChecked(format == jobs::PlaceFormat::Gltf);
    connect(box, &QCheckBox::toggled, this, &PlacePanel::showAll);
    m_formats.emplace_back(format, box);
}

std::set<jobs::PlaceFormat> PlacePanel::chosen() const {
    std::set<jobs::PlaceFormat> formats;
    for (const auto& [format, box] : m_formats) {
        if (box->isChecked()) {
            formats.insert(format);
        }
    }
    return formats;
}

void PlacePanel::showAll() {
    const bool canExport = m_presenter.canExport();
    for (const auto& [format, box] : m_formats) {
        box->setEnabled(canExport);
    }
    m_export->setEnabled(canExport && !chosen().empty());
    m_progress->setTask(m_presenter.task());
    const bool isTold = m_presenter.hasDepths() || !m_presenter.words().isEmpty();
    m_words->tell(isTold
                      ? Told(m_presenter.words())
                      : Told(tr("A dataset with the depths of two photos or more is needed: export one with "
                                "depth as its scene model."),
                             Cure::ExportDepth));
    m_words->setVisible(!m_words->text().isEmpty());
    m_open->setVisible(!m_presenter.exported().isEmpty());
}

} // namespace spherewalk::ui
