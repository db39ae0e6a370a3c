// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/page_panel.h"

#include "ui/frame/settings.h"
#include "ui/look/core_words.h"
#include "ui/look/words.h"
#include "ui/tasks/task_panel.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>

#include <algorithm>
#include <iterator>
#include <string_view>

namespace spherewalk::ui {

namespace {

constexpr const char* kContext = "spherewalk::ui::PageWords";

/// The words of resources/web/words.json.
constexpr std::string_view kWords[] = {
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Panorama"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Panorama of %1. Drag, or use the arrow keys."),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Plan"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Plan of the room with the photos"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Photo"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Station"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "On the floor"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "nothing"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Measure"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Distances"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords",
                      "± is one standard deviation of the depth and of the click. A scale that is wrong for "
                      "the whole room is not in it."),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Remove the last one"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Keys"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Close"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Walk ahead"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Walk back"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Zoom in"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Zoom out"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords",
                      "This page needs JavaScript, which is switched off in this browser."),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::PageWords",
        "This browser shows no 3D graphics (WebGL), so there are no panoramas. Plan and notes work."),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords",
                      "The file %1 could not be read. The folder must be copied whole."),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "1 photo"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "%1 photos"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "made by %1 on %2"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "good"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "doubtful"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "failed the checks"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "not judged"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "accepted by a person"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "no photo"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "photo rejected"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "photo not placed: its alignment failed"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords",
                      "This page was made of a dataset, which has no verdicts and no notes."),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Note: %1"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "x %1 m, y %2 m, %3 m high"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "x %1 m, y %2 m, %3 m high, ± %4 m"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Views that replace this photo are off by %1 pixels."),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "The heading of this photo is not known."),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "This photo has no depth: nothing can be measured in it."),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "The depth there was not measured."),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords",
                      "Choose a point, with a click or with Enter for the middle."),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Choose the other end."),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "There is no photo to walk to in this direction."),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "%1 m ± %2 m"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "turn"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "walk ahead and back"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "look up and down"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "zoom"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "look level"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "measure a distance"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "while measuring: take the middle of the picture"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "while measuring: take back the last point"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "end measuring"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "this list"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Coverage"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords",
                      "Floor within reach of a photo: half the diagonal of the grid's cell"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "covered"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Error of views"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords",
                      "95th percentile of displacement where the photo was left out"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Foretold error of views"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords",
                      "Median displacement that the photos foretell for views from there, at their own "
                      "height, in pixels of a camera of 640 pixels and 57 degrees"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "nothing is known"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "Uncertainty of the heading"),
    QT_TRANSLATE_NOOP(
        "spherewalk::ui::PageWords",
        "Standard deviation of each photo's heading, in pixels of a camera of 640 pixels and 57 degrees"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "%1 px"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "%1 px, the tolerance"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "%1 px and less"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "%1 px and more"),
    QT_TRANSLATE_NOOP("spherewalk::ui::PageWords", "not measured"),
};

} // namespace

std::string pageWord(const std::string& english) {
    const bool isKnown = std::ranges::find(kWords, english) != std::end(kWords);
    return (isKnown ? QCoreApplication::translate(kContext, english.c_str()) : coreWords(english))
        .toStdString();
}

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
