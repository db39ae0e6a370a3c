// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tasks/task_list.h"

#include <algorithm>

namespace spherewalk::ui {

TaskList::TaskList(QObject* parent) : QObject(parent) {
}

TaskList::~TaskList() {
    stopAll();
}

bool TaskList::hasRunning() const {
    return std::any_of(m_tasks.begin(), m_tasks.end(), [](const Task* task) { return task->isRunning(); });
}

void TaskList::stopAll() {
    const QList<Task*> tasks = m_tasks; // some are forgotten as they end
    for (Task* task : tasks) {          // all at once, then wait for each
        task->stop();
    }
    for (Task* task : tasks) {
        task->stopAndWait();
    }
}

Task* TaskList::begin(const QString& title, Task::Work work) {
    auto* task = new Task(title, std::move(work), this);
    m_tasks << task;
    connect(task, &Task::ended, this, [this, task] {
        emit ended(task);
        forgetOld();
    });
    emit started(task);
    return task;
}

void TaskList::forgetOld() {
    auto endedCount =
        std::count_if(m_tasks.begin(), m_tasks.end(), [](const Task* task) { return !task->isRunning(); });
    for (auto task = m_tasks.begin(); task != m_tasks.end() && endedCount > kMostEnded;) {
        if ((*task)->isRunning()) {
            ++task;
            continue;
        }
        (*task)->deleteLater();
        task = m_tasks.erase(task);
        --endedCount;
    }
}

} // namespace spherewalk::ui
