// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/survey_session.h"
#include "ui/tasks/task_list.h"

#include <QList>
#include <QMainWindow>

#include <memory>

class QActionGroup;
class QLabel;
class QStackedWidget;
class QToolBar;
class QUndoGroup;

namespace spherewalk::ui {

class Mode;
class StartPage;
class SurveyPlanView;

/// The program's window: the modes in a bar at the left, the plan of the open survey always in sight, and the
/// tasks that run.
class MainWindow : public QMainWindow {
    Q_OBJECT

  public:
    explicit MainWindow(QWidget* parent = nullptr);
    ~MainWindow() override;

    /// Opens the survey and shows its first mode; if it cannot be opened, says why in the status line and
    /// keeps what is shown. Returns whether it was opened.
    bool openSurvey(const QString& folder);
    void closeSurvey();

    SurveySession* session() const { return m_session.get(); }

    TaskList& tasks() { return m_tasks; }

    QList<Mode*> modes() const { return m_modes; }

    /// Null: the start page.
    void showMode(Mode* mode);

  protected:
    void closeEvent(QCloseEvent* event) override;

  private:
    void addModes();
    void addMenus();
    void chooseUndo(Mode* mode);
    void chooseSurvey();
    void showCounts();
    void say(const QString& sentence);

    TaskList m_tasks;
    std::unique_ptr<SurveySession> m_session;
    QList<Mode*> m_modes;
    QStackedWidget* m_pages;
    StartPage* m_start;
    QToolBar* m_bar;
    QActionGroup* m_modeActions;
    QUndoGroup* m_undo;
    SurveyPlanView* m_plan;
    QDockWidget* m_planDock;
    QLabel* m_counts;
};

} // namespace spherewalk::ui
