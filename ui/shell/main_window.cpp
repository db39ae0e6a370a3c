// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/main_window.h"

#include "ui/align/align_mode.h"
#include "ui/capture/capture_mode.h"
#include "ui/export/export_mode.h"
#include "ui/frame/mode.h"
#include "ui/frame/settings.h"
#include "ui/look/icon.h"
#include "ui/look/told_label.h"
#include "ui/map/plan_view.h"
#include "ui/plan/plan_mode.h"
#include "ui/plan/plan_storage.h"
#include "ui/preview/preview_mode.h"
#include "ui/remote/phone_remote.h"
#include "ui/remote/remote_form.h"
#include "ui/review/review_mode.h"
#include "ui/shell/help_window.h"
#include "ui/shell/start_page.h"
#include "ui/shell/tour.h"
#include "ui/tasks/task.h"
#include "ui/tasks/task_panel.h"

#include "spherewalk/base/error.h"
#include "spherewalk/jobs/demo.h"

#include <QAction>
#include <QActionGroup>
#include <QCloseEvent>
#include <QCoreApplication>
#include <QDesktopServices>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QMenuBar>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>
#include <QUndoGroup>
#include <QVBoxLayout>

#include <algorithm>

namespace spherewalk::ui {

QList<Mode*> makeModes(TaskList& tasks, QWidget* parent) {
    return {
        new PlanMode(tasks, parent),  new CaptureMode(tasks, parent), new ReviewMode(tasks, parent),
        new AlignMode(tasks, parent), new PreviewMode(tasks, parent), new ExportMode(tasks, parent),
    };
}

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent),
      m_tour(new Tour(this)),
      m_pages(new QStackedWidget(this)),
      m_start(new StartPage(this)),
      m_bar(new QToolBar(tr("Modes"), this)),
      m_modeActions(new QActionGroup(this)),
      m_undo(new QUndoGroup(this)),
      m_plan(new SurveyPlanView(this)),
      m_planDock(new QDockWidget(tr("Plan of the room"), this)),
      m_tasksDock(new QDockWidget(tr("Tasks"), this)),
      m_cure(new ToldLabel(this)),
      m_counts(new QLabel(this)),
      m_tasksButton(new QToolButton(this)) {
    setWindowTitle(tr("Spherewalk"));
    resize(1280, 800);
    makeTour();
    setAcceptDrops(true);
    m_pages->addWidget(m_start);
    makeDocks();
    makeBar();
    makeRemote();
    makeMenus();
    makeStart();
    m_counts->setObjectName("counts");
    m_cure->setObjectName("cure");
    m_cure->setWordWrap(false);
    m_cure->hide();
    connect(statusBar(), &QStatusBar::messageChanged, this,
            [this](const QString& message) { m_cure->setVisible(m_cure->hasLink() && !message.isEmpty()); });
    QDesktopServices::setUrlHandler(kLinkScheme, this, "follow");
    statusBar()->addPermanentWidget(m_cure);
    statusBar()->addPermanentWidget(m_counts);
    statusBar()->addPermanentWidget(m_tasksButton);
    restoreGeometry(Settings().windowGeometry());
    restoreState(Settings().windowState());
    showMode(nullptr);
    enableModes();
    showTasks();
}

MainWindow::~MainWindow() {
    QDesktopServices::unsetUrlHandler(kLinkScheme);
    closeSurvey();
    m_tasks.stopAll();
}

/// Puts the strip of the tour above the pages.
void MainWindow::makeTour() {
    auto* column = new QWidget(this);
    auto* layout = new QVBoxLayout(column);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_tour);
    layout->addWidget(m_pages, 1);
    setCentralWidget(column);
    connect(m_tour, &Tour::pageWanted, this, [this](const QString& page) { showPage(page, {}); });
    connect(m_tour, &Tour::photosWanted, this, [this] {
        CaptureDesk& desk = findMode<CaptureMode>()->desk();
        if (m_session && !desk.isComplete() && !desk.isRunning()) {
            desk.runPractice();
        }
    });
}

void MainWindow::makeDocks() {
    m_planDock->setObjectName("plan");
    m_planDock->setWidget(m_plan);
    addDockWidget(Qt::RightDockWidgetArea, m_planDock);
    connect(m_planDock->toggleViewAction(), &QAction::triggered, this,
            [this](bool isWanted) { m_wantsPlan = isWanted; });
    m_tasksDock->setObjectName("tasks");
    m_tasksDock->setWidget(new TaskPanel(m_tasks, m_tasksDock));
    addDockWidget(Qt::BottomDockWidgetArea, m_tasksDock);
    m_tasksDock->hide();
    m_tasksButton->setObjectName("tasksButton");
    m_tasksButton->setIcon(ui::icon("tasks"));
    m_tasksButton->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_tasksButton->setAutoRaise(true);
    m_tasksButton->setToolTip(tr("Show what runs, and what has ended (Ctrl+T)"));
    connect(m_tasksButton, &QToolButton::clicked, this,
            [this] { m_tasksDock->setVisible(!m_tasksDock->isVisible()); });
    connect(&m_tasks, &TaskList::started, this, [this] {
        statusBar()->clearMessage(); // it is of what was done before
        showTasks();
    });
    connect(&m_tasks, &TaskList::ended, this, [this](const Task* task) {
        showTasks();
        if (task->state() == Task::State::Failed) {
            say({tr("%1: %2").arg(task->title(), task->sentence()), task->told().cure});
        }
    });
}

void MainWindow::makeBar() {
    m_bar->setObjectName("modes");
    m_bar->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    m_bar->setIconSize({28, 28});
    m_bar->setMovable(false);
    m_bar->setContextMenuPolicy(Qt::PreventContextMenu);
    m_bar->setStyleSheet("QToolBar { background: palette(window); border: none; padding: 2px; }");
    addToolBar(Qt::LeftToolBarArea, m_bar);
    QAction* home = m_bar->addAction(ui::icon("home"), tr("Start"), this, [this] { showMode(nullptr); });
    home->setToolTip(tr("The start page (Ctrl+0)"));
    home->setShortcut(QKeySequence("Ctrl+0"));
    addAction(home);
    m_modes = makeModes(m_tasks, this);
    int number = 0;
    for (Mode* mode : std::as_const(m_modes)) {
        m_pages->addWidget(mode);
        QAction* action =
            m_bar->addAction(mode->icon(), mode->title(), this, [this, mode] { showMode(mode); });
        action->setCheckable(true);
        action->setShortcut(QKeySequence(QString("Ctrl+%1").arg(number + 1)));
        action->setToolTip(
            tr("%1 (%2)").arg(mode->hint(), action->shortcut().toString(QKeySequence::NativeText)));
        m_modeActions->addAction(action);
        addAction(action);
        connect(mode, &Mode::message, this, &MainWindow::say);
        connect(mode, &Mode::subjectChanged, this, &MainWindow::showSubject);
        connect(mode, &Mode::openRequested, this, &MainWindow::openSurvey);
        connect(mode, &Mode::newRequested, this, &MainWindow::beginSurvey);
        connect(mode, &Mode::pageRequested, this, &MainWindow::showPage);
        ++number;
    }
}

/// Lets a phone be the remote of the capture page. The remote is off until a person turns it on in its form.
void MainWindow::makeRemote() {
    auto* capture = findMode<CaptureMode>();
    m_remote = new PhoneRemote(capture->desk(), systemClock(), LocalServer::kUsualPort, this);
    connect(m_remote, &PhoneRemote::changed, capture,
            [this, capture] { capture->showRemote(m_remote->isOn()); });
    connect(capture, &CaptureMode::remoteWanted, this, [this] {
        auto* form = findChild<RemoteForm*>();
        if (form == nullptr) {
            form = new RemoteForm(*m_remote, LocalServer::localAddresses(), this);
            form->setAttribute(Qt::WA_DeleteOnClose);
        }
        form->show();
        form->raise();
        form->activateWindow();
    });
}

void MainWindow::makeStart() {
    connect(m_start, &StartPage::openRequested, this, &MainWindow::openSurvey);
    connect(m_start, &StartPage::chooseRequested, this, &MainWindow::chooseSurvey);
    connect(m_start, &StartPage::newRequested, this, &MainWindow::beginSurvey);
    connect(m_start, &StartPage::practiceRequested, this, &MainWindow::runPractice);
    connect(m_start, &StartPage::tourRequested, this, &MainWindow::runTour);
}

Mode* MainWindow::mode() const {
    return qobject_cast<Mode*>(m_pages->currentWidget());
}

template <class Wanted>
Wanted* MainWindow::findMode() const {
    for (Mode* mode : m_modes) {
        if (auto* found = qobject_cast<Wanted*>(mode)) {
            return found;
        }
    }
    return nullptr;
}

/// Lets Ctrl+Z act on the page's own stack, or else on the survey's.
void MainWindow::chooseUndo(Mode* mode) {
    QUndoStack* own = mode != nullptr ? mode->undoStack() : nullptr;
    QUndoStack* stack = own != nullptr ? own : m_session ? m_session->undoStack() : nullptr;
    if (stack != nullptr) {
        m_undo->addStack(stack);
    }
    m_undo->setActiveStack(stack);
}

void MainWindow::showMode(Mode* mode) {
    chooseUndo(mode);
    QWidget* page = mode != nullptr ? static_cast<QWidget*>(mode) : m_start;
    for (int i = 0; i < m_pages->count(); ++i) { // pages out of sight do not make the window wider
        const bool isShown = m_pages->widget(i) == page;
        const auto policy = isShown ? QSizePolicy::Preferred : QSizePolicy::Ignored;
        m_pages->widget(i)->setSizePolicy(policy, policy);
    }
    m_pages->setCurrentWidget(page);
    const QList<QAction*> actions = m_modeActions->actions();
    for (qsizetype i = 0; i < m_modes.size(); ++i) {
        actions[i]->setChecked(m_modes[i] == mode);
    }
    showBars();
    showSubject();
    m_planDock->setVisible(m_wantsPlan && m_session && mode != nullptr && mode->wantsPlan());
    if (mode != nullptr) {
        mode->activated();
    } else {
        m_start->setRecent(Settings().recentSurveys());
    }
}

/// Hides menus and bars on the whole screen, where the page wants that.
void MainWindow::showBars() {
    const Mode* shown = mode();
    const bool isWhole = isFullScreen() && shown != nullptr && shown->takesWholeScreen();
    for (QWidget* bar : std::initializer_list<QWidget*>{menuBar(), m_bar, statusBar()}) {
        bar->setVisible(!isWhole);
    }
    for (Mode* mode : std::as_const(m_modes)) {
        mode->setWholeScreen(isWhole && mode == shown);
    }
}

void MainWindow::showPage(const QString& name, const QString& part) {
    for (Mode* mode : std::as_const(m_modes)) {
        if (mode->objectName() == name) {
            showMode(mode);
            mode->showPart(part);
        }
    }
}

void MainWindow::enableModes() {
    const QList<QAction*> actions = m_modeActions->actions();
    for (qsizetype i = 0; i < m_modes.size(); ++i) {
        actions[i]->setEnabled(m_session || m_modes[i]->worksWithoutSurvey());
    }
    m_import->setEnabled(m_session != nullptr);
}

bool MainWindow::openSurvey(const QString& folder) {
    Mode* shown = mode();
    try {
        auto session = SurveySession::open(folder);
        closeSurvey();
        m_session = std::move(session);
    } catch (const Error& error) {
        say(coreTold(error.sentence()));
        return false;
    }
    m_plan->setSession(m_session.get());
    for (Mode* mode : std::as_const(m_modes)) {
        mode->setSession(m_session.get());
    }
    connect(m_session.get(), &SurveySession::changed, this, &MainWindow::showSubject);
    connect(m_session.get(), &SurveySession::readOnlyChanged, this, &MainWindow::showSubject);
    Settings().addRecentSurvey(folder);
    enableModes();
    showMode(shown != nullptr || m_modes.isEmpty() ? shown : m_modes.first());
    return true;
}

void MainWindow::closeSurvey() {
    if (!m_session) {
        return;
    }
    m_tasks.stopAll();
    for (Mode* mode : std::as_const(m_modes)) {
        mode->setSession(nullptr);
    }
    m_tour->end(); // it was of that survey
    m_plan->setSession(nullptr);
    m_undo->removeStack(m_session->undoStack());
    m_session.reset();
    enableModes();
    showMode(nullptr);
}

/// Names what the page shows in the title and the status line: a subject of its own, or the survey.
void MainWindow::showSubject() {
    const Mode::Subject own = mode() != nullptr ? mode()->subject() : Mode::Subject();
    const QString name = !own.name.isEmpty() ? own.name : m_session ? m_session->name() : QString();
    setWindowFilePath(own.name.isEmpty() && m_session ? m_session->folder() : QString());
    setWindowTitle(name.isEmpty() ? tr("Spherewalk") : tr("%1 - Spherewalk").arg(name));
    m_counts->setText(own.name.isEmpty() ? countsText() : own.note);
}

QString MainWindow::countsText() const {
    if (!m_session) {
        return {};
    }
    const store::Counts& counts = m_session->state().counts;
    const QString words =
        tr("%1 of %2 stations have a photo").arg(counts.stationsWithPhoto).arg(counts.stations);
    return m_session->isReadOnly() ? tr("%1; another program writes").arg(words) : words;
}

void MainWindow::showTasks() {
    const QList<Task*> all = m_tasks.tasks();
    const auto running =
        std::count_if(all.begin(), all.end(), [](const Task* task) { return task->isRunning(); });
    m_tasksButton->setText(running == 0 ? tr("Tasks") : tr("%n task(s)", nullptr, static_cast<int>(running)));
}

void MainWindow::say(const Told& told) {
    constexpr int kGapsPx = 40; // around what always stands there
    const bool isHere = mode() != nullptr && linkTo(told.cure).path() == mode()->objectName();
    m_cure->tell({{}, isHere ? Cure::None : told.cure});
    const int taken =
        m_counts->width() + m_tasksButton->width() + (m_cure->hasLink() ? m_cure->sizeHint().width() : 0);
    const int room = statusBar()->width() - taken - kGapsPx;
    statusBar()->showMessage(statusBar()->fontMetrics().elidedText(told.text, Qt::ElideRight, room));
    statusBar()->setToolTip(told.text);
    m_cure->setVisible(m_cure->hasLink());
}

void MainWindow::follow(const QUrl& link) {
    const QString page = link.path().section('/', 0, 0);
    const QString part = link.path().section('/', 1);
    if (page == QLatin1String("guide")) {
        return help().showPage(part);
    }
    const auto found = std::find_if(m_modes.cbegin(), m_modes.cend(),
                                    [&](const Mode* mode) { return mode->objectName() == page; });
    if (found == m_modes.cend() || !(m_session || (*found)->worksWithoutSurvey())) {
        return showMode(nullptr); // where surveys are opened
    }
    showPage(page, part);
}

void MainWindow::chooseSurvey() {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Open survey"), surveysPlace());
    if (!folder.isEmpty()) {
        openSurvey(folder);
    }
}

void MainWindow::beginSurvey() {
    closeSurvey();
    if (auto* plan = findMode<PlanMode>()) {
        showMode(plan);
    }
}

bool MainWindow::openPractice() {
    auto* capture = findMode<CaptureMode>();
    if (capture == nullptr) {
        return false;
    }
    const QString folder = freeFolder(surveysPlace() + "/" + tr("practice room"), ".spherewalk");
    try {
        jobs::newPracticeSurvey(folder.toStdString(), capture->desk().practiceSettings().stepM);
    } catch (const Error& error) {
        say(coreTold(error.sentence()));
        return false;
    }
    return openSurvey(folder);
}

void MainWindow::runPractice() {
    if (openPractice()) {
        auto* capture = findMode<CaptureMode>();
        showMode(capture);
        capture->desk().runPractice();
    }
}

void MainWindow::runTour() {
    if (openPractice()) {
        m_tour->begin();
    }
}

void MainWindow::closeEvent(QCloseEvent* event) {
    Settings().setWindow(saveGeometry(), saveState());
    closeSurvey();
    m_tasks.stopAll();
    QMainWindow::closeEvent(event);
}

} // namespace spherewalk::ui
