// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tasks/task_list.h"

#include <QWidget>

class QVBoxLayout;

namespace spherewalk::ui {

/// The tasks, newest first, each with its progress and a button that stops it.
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
