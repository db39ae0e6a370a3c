// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tasks/task.h"

#include <QPointer>
#include <QWidget>

class QProgressBar;
class QPushButton;
class QVBoxLayout;

namespace spherewalk::ui {

/// Shows the progress, the step and the time left of a task, with a button that stops it. The bar hides
/// itself while no task runs.
class TaskBar : public QWidget {
    Q_OBJECT

  public:
    /// stopName: object name of the button. stopHint: its tool tip, which says what a stopped task keeps.
    explicit TaskBar(const QString& stopName, const QString& stopHint = {}, QWidget* parent = nullptr);

    /// Null: no task.
    void setTask(Task* task);

  private:
    void showTask();

    QPointer<Task> m_task;
    QProgressBar* m_progress;
    QPushButton* m_stop;
};

/// Lists the tasks, newest first, each with its progress and a button that stops it.
class TaskPanel : public QWidget {
    Q_OBJECT

  public:
    explicit TaskPanel(TaskList& tasks, QWidget* parent = nullptr);

  private:
    void add(Task* task);

    QVBoxLayout* m_rows;
    QWidget* m_empty;
};

} // namespace spherewalk::ui
