// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/page_panel.h"

#include "ui/export/page_words.h"
#include "ui/frame/settings.h"
#include "ui/look/words.h"
#include "ui/tasks/task_panel.h"

#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>

namespace spherewalk::ui {

namespace fs = std::filesystem;

PagePresenter::PagePresenter(TaskList& tasks, QObject* parent) : SurveyPresenter(parent), m_tasks(tasks) {
}

void PagePresenter::setSession(SurveySession* session) {
    m_words.clear();
    m_page.clear();
    SurveyPresenter::setSession(session);
}

bool PagePresenter::canExport() const {
    return session() != nullptr && session()->state().counts.stationsWithPhoto > 0 && task() == nullptr;
}

void PagePresenter::exportNow() {
    if (!canExport()) {
        return;
    }
    m_words.clear();
    m_page.clear();
    const QFileInfo survey(QString::fromStdString(session()->path().string()));
    const QString folder =
        freeFolder(survey.dir().filePath(survey.completeBaseName()), QStringLiteral(".web"));
    const QString measured =
        Settings().measuredReport(QString::fromStdString(session()->store().info().uuid));
    const jobs::WebOptions options{QLocale().bcp47Name().toStdString(), pageWord, measured.toStdString()};
    m_task = m_tasks.start(
        tr("Writing the page of %1").arg(QFileInfo(folder).completeBaseName()), this,
        [survey = session()->path(), to = fs::path(folder.toStdString()),
         options](ProgressSink& progress, const std::stop_token& stop) {
            return jobs::exportWeb(survey, to, options, progress, stop);
        },
        [this, folder](const jobs::WebReport& report) { show(folder, report); });
    connect(m_task, &Task::ended, this, [this, task = m_task.data()] { ended(*task); });
    emit changed();
}

void PagePresenter::show(const QString& folder, const jobs::WebReport& report) {
    m_page = folder + QStringLiteral("/index.html");
    m_words = tr("%1: %n photo(s), %2. Distances can be measured in %3 of them. Share the whole folder.",
                 nullptr, static_cast<int>(report.photos))
                  .arg(folder, bytesText(report.totalBytes))
                  .arg(report.withDepth);
}

void PagePresenter::ended(const Task& task) {
    if (task.state() == Task::State::Failed) {
        m_words = task.sentence();
    } else if (task.state() == Task::State::Stopped) {
        m_words = tr("Stopped; nothing was written.");
    }
    emit changed();
}

PagePanel::PagePanel(PagePresenter& presenter, QWidget* parent)
    : QGroupBox(tr("A page to share"), parent), m_presenter(presenter) {
    auto* row = new QHBoxLayout(this); // one row: the page has no more room on a small screen
    m_export = new QPushButton(tr("Write the page"), this);
    m_export->setObjectName("pageNow");
    m_export->setToolTip(tr("Plan, panoramas to walk through, distances, and the notes of the review, in a "
                            "folder that any browser opens. Nothing needs to be installed."));
    connect(m_export, &QPushButton::clicked, &presenter, &PagePresenter::exportNow);
    m_progress = new TaskBar("stopPage", tr("Stop; nothing is written then"), this);
    m_words = new QLabel(this);
    m_words->setObjectName("pageWords");
    m_words->setWordWrap(true);
    m_words->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_open = new QPushButton(tr("Look at it"), this);
    m_open->setObjectName("openPage");
    connect(m_open, &QPushButton::clicked, this, [this] { emit openRequested(m_presenter.page()); });
    row->addWidget(m_export);
    row->addWidget(m_progress, 1);
    row->addWidget(m_words, 1);
    row->addStretch(0);
    row->addWidget(m_open);
    connect(&presenter, &PagePresenter::changed, this, &PagePanel::showAll);
    showAll();
}

void PagePanel::showAll() {
    m_export->setEnabled(m_presenter.canExport());
    m_progress->setTask(m_presenter.task());
    m_words->setText(m_presenter.words());
    m_words->setVisible(!m_words->text().isEmpty());
    m_open->setVisible(!m_presenter.page().isEmpty());
}

} // namespace spherewalk::ui
