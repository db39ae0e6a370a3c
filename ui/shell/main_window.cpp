// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/main_window.h"

#include "ui/plan/survey_plan_view.h"
#include "ui/shell/mode.h"
#include "ui/shell/modes.h"
#include "ui/shell/start_page.h"

#include "spherewalk/base/error.h"

#include <QAction>
#include <QActionGroup>
#include <QDockWidget>
#include <QFileDialog>
#include <QLabel>
#include <QMenuBar>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolBar>
#include <QUndoGroup>

namespace spherewalk::ui {

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent),
      m_pages(new QStackedWidget(this)),
      m_start(new StartPage(this)),
      m_bar(new QToolBar(tr("Modes"), this)),
      m_modeActions(new QActionGroup(this)),
      m_undo(new QUndoGroup(this)),
      m_plan(new SurveyPlanView(this)),
      m_planDock(new QDockWidget(tr("Plan of the room"), this)),
      m_counts(new QLabel(this)) {
    setWindowTitle(tr("Spherewalk"));
    setCentralWidget(m_pages);
    m_pages->addWidget(m_start);
    connect(m_start, &StartPage::openRequested, this, &MainWindow::openSurvey);
    connect(m_start, &StartPage::chooseRequested, this, &MainWindow::chooseSurvey);
    m_bar->setObjectName("modes");
    m_bar->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    m_bar->setMovable(false);
    addToolBar(Qt::LeftToolBarArea, m_bar);
    m_planDock->setObjectName("plan");
    m_planDock->setWidget(m_plan);
    addDockWidget(Qt::RightDockWidgetArea, m_planDock);
    statusBar()->addPermanentWidget(m_counts);
    addModes();
    addMenus();
    showMode(nullptr);
}

MainWindow::~MainWindow() {
    m_tasks.stopAll();
    closeSurvey();
}

void MainWindow::addModes() {
    m_modes = makeModes(m_tasks, this);
    int number = 0;
    for (Mode* mode : std::as_const(m_modes)) {
        m_pages->addWidget(mode);
        QAction* action =
            m_bar->addAction(mode->icon(), mode->title(), this, [this, mode] { showMode(mode); });
        action->setCheckable(true);
        action->setShortcut(QKeySequence(Qt::CTRL | static_cast<Qt::Key>(Qt::Key_1 + number)));
        action->setToolTip(mode->hint());
        m_modeActions->addAction(action);
        connect(mode, &Mode::message, this, &MainWindow::say);
        connect(mode, &Mode::openRequested, this, &MainWindow::openSurvey);
        ++number;
    }
}

void MainWindow::addMenus() {
    QMenu* file = menuBar()->addMenu(tr("&File"));
    QAction* open = file->addAction(tr("&Open survey..."), this, &MainWindow::chooseSurvey);
    open->setShortcut(QKeySequence::Open);
    QAction* close = file->addAction(tr("&Close survey"), this, &MainWindow::closeSurvey);
    close->setShortcut(QKeySequence::Close);
    QAction* quit = file->addAction(tr("&Quit"), this, &QWidget::close);
    quit->setShortcut(QKeySequence::Quit);
}

/// What Ctrl+Z means now: the mode's own stack, else the survey's.
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
    m_pages->setCurrentWidget(mode != nullptr ? static_cast<QWidget*>(mode) : m_start);
    const QList<QAction*> actions = m_modeActions->actions();
    for (qsizetype i = 0; i < m_modes.size(); ++i) {
        actions[i]->setChecked(m_modes[i] == mode);
    }
    m_planDock->setVisible(mode != nullptr && !mode->showsPlan());
    if (mode != nullptr) {
        mode->activated();
    }
}

bool MainWindow::openSurvey(const QString& folder) {
    try {
        auto session = SurveySession::open(folder);
        closeSurvey();
        m_session = std::move(session);
    } catch (const Error& error) {
        say(QString::fromStdString(error.sentence()));
        return false;
    }
    m_plan->setSession(m_session.get());
    for (Mode* mode : std::as_const(m_modes)) {
        mode->setSession(m_session.get());
    }
    connect(m_session.get(), &SurveySession::changed, this, &MainWindow::showCounts);
    showCounts();
    setWindowTitle(tr("%1 - Spherewalk").arg(m_session->name()));
    setWindowFilePath(folder);
    if (m_pages->currentWidget() == m_start && !m_modes.isEmpty()) {
        showMode(m_modes.first());
    }
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
    m_plan->setSession(nullptr);
    m_session.reset();
    m_counts->clear();
    setWindowTitle(tr("Spherewalk"));
    setWindowFilePath({});
    showMode(nullptr);
}

void MainWindow::showCounts() {
    const store::Counts counts = m_session->store().counts();
    m_counts->setText(
        tr("%1 of %2 stations have a photo").arg(counts.stationsWithPhoto).arg(counts.stations));
}

void MainWindow::say(const QString& sentence) {
    statusBar()->showMessage(sentence);
}

void MainWindow::chooseSurvey() {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Open survey"));
    if (!folder.isEmpty()) {
        openSurvey(folder);
    }
}

void MainWindow::closeEvent(QCloseEvent* event) {
    closeSurvey();
    QMainWindow::closeEvent(event);
}

} // namespace spherewalk::ui
