// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tasks/task.h"

#include <QPointer>
#include <QWidget>

class QProgressBar;
class QPushButton;

namespace spherewalk::ui {

/// How far a task is, what it does, how long it will take, and a button that stops it. Hidden while none
/// runs.
class TaskBar : public QWidget {
    Q_OBJECT

  public:
    /// stopName: the button's. stopHint: what is kept of a task that is stopped; may be empty.
    explicit TaskBar(const QString& stopName, const QString& stopHint = {}, QWidget* parent = nullptr);

    /// Null: none.
    void setTask(Task* task);

  private:
    void showTask();

    QPointer<Task> m_task;
    QProgressBar* m_progress;
    QPushButton* m_stop;
};

} // namespace spherewalk::ui
