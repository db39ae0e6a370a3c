// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/look/theme.h"
#include "ui/session/survey_session.h"
#include "ui/tasks/task.h"

#include <QList>
#include <QMainWindow>

#include <memory>

class QAction;
class QActionGroup;
class QDockWidget;
class QLabel;
class QStackedWidget;
class QToolBar;
class QToolButton;
class QUndoGroup;
class QUrl;
class QWidget;

namespace spherewalk::ui {

class HelpWindow;
class Mode;
class PhoneRemote;
class StartPage;
class Tour;
class SurveyPlanView;
class TaskList;
class ToldLabel;
struct Dropped;

/// Makes the pages of the window, in the order of the work. Owner: the parent.
QList<Mode*> makeModes(TaskList& tasks, QWidget* parent);

/// The window of the program: pages with a bar at the left, the plan of the open survey, and the tasks.
class MainWindow : public QMainWindow {
    Q_OBJECT

  public:
    explicit MainWindow(QWidget* parent = nullptr);
    ~MainWindow() override;

    /// Opens the survey and shows its first page. Returns false if that fails: the status line says why, and
    /// the window stays as it is.
    bool openSurvey(const QString& folder);
    /// Stops the tasks and closes the survey. Completed work stays.
    void closeSurvey();
    /// Makes a survey of the practice room in surveysPlace() and photographs it.
    void runPractice();
    /// Makes a survey of the practice room and leads through the pages with it.
    void runTour();

    SurveySession* session() const { return m_session.get(); }

    TaskList& tasks() { return m_tasks; }

    QList<Mode*> modes() const { return m_modes; }

    /// Returns the visible page; null: the start page.
    Mode* mode() const;
    /// Null: the start page.
    void showMode(Mode* mode);

    /// Takes photos into the open survey, in a task. positions: a CSV file; empty if nobody knows where they
    /// were taken. photos: their folder.
    void importPhotos(const QString& positions, const QString& photos);

    /// Puts a sentence into the status line, with the link to its cure unless that is the visible page.
    void say(const Told& told);

    /// Goes where a link of linkTo() leads. The start page stands for pages that need an open survey. Other
    /// links of that scheme lead to the start page, too.
    Q_INVOKABLE void follow(const QUrl& link);

  protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

  private:
    void makeDocks();
    void makeBar();
    void makeMenus();
    void makeStart();
    void makeTour();
    void makeRemote();
    bool openPractice();
    void makeRecent(QMenu* recent, QMenu* around);
    void makeView(QMenu* view);
    void take(const Dropped& dropped);
    void addTheme(QMenu* menu, Theme theme, const QString& text);
    void addLanguage(QMenu* menu, const QString& language, const QString& name);
    void chooseUndo(Mode* mode);
    void showPage(const QString& name, const QString& part);
    void chooseSurvey();
    void beginSurvey();
    void showSubject();
    QString countsText() const;
    void showTasks();
    void showAbout();
    void showGuide();
    void showKeys();
    void showBars();
    void chooseImport();
    void chooseFreeImport();
    void importFree(const QString& photos);
    bool openNewByHand(const QString& base);
    void beginByHand();
    HelpWindow& help();
    void enableModes();
    template <class Wanted>
    Wanted* findMode() const;

    TaskList m_tasks;
    std::unique_ptr<SurveySession> m_session;
    QList<Mode*> m_modes;
    Tour* m_tour;
    PhoneRemote* m_remote = nullptr;
    QStackedWidget* m_pages;
    StartPage* m_start;
    QToolBar* m_bar;
    QActionGroup* m_modeActions;
    QUndoGroup* m_undo;
    SurveyPlanView* m_plan;
    QDockWidget* m_planDock;
    QDockWidget* m_tasksDock;
    ToldLabel* m_cure; ///< The link of the sentence in the status line.
    QLabel* m_counts;
    QToolButton* m_tasksButton;
    HelpWindow* m_help = nullptr;
    QAction* m_import = nullptr;
    bool m_wantsPlan = true; ///< Whether the user wants the plan beside the pages.
};

} // namespace spherewalk::ui
