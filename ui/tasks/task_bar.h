// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tasks/task.h"

#include <QPointer>
#include <QProgressBar>

namespace spherewalk::ui {

/// How far a task is, what it does, and how long it will take. Hidden while none runs.
class TaskBar : public QProgressBar {
    Q_OBJECT

  public:
    explicit TaskBar(QWidget* parent = nullptr);

    /// Null: none.
    void setTask(Task* task);

  private:
    void showTask();

    QPointer<Task> m_task;
};

} // namespace spherewalk::ui
