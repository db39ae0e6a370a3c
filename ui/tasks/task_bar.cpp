// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tasks/task_bar.h"

#include "ui/look/quantity_text.h"

namespace spherewalk::ui {

namespace {

constexpr int kSteps = 1000;

} // namespace

TaskBar::TaskBar(QWidget* parent) : QProgressBar(parent) {
    setRange(0, kSteps);
    hide();
}

void TaskBar::setTask(Task* task) {
    if (m_task) {
        m_task->disconnect(this);
    }
    m_task = task;
    if (task != nullptr) {
        setAccessibleName(task->title());
        connect(task, &Task::progressed, this, &TaskBar::showTask);
        connect(task, &Task::ended, this, &TaskBar::showTask);
    }
    showTask();
}

void TaskBar::showTask() {
    setVisible(m_task && m_task->isRunning());
    if (!m_task) {
        return;
    }
    setValue(qRound(kSteps * m_task->fraction()));
    const auto left = m_task->left();
    setFormat(left ? tr("%1, %2 left").arg(m_task->step(), durationText(*left)) : m_task->step());
}

} // namespace spherewalk::ui
