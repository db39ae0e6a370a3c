// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tasks/task_bar.h"

#include "ui/look/quantity_text.h"

#include <QHBoxLayout>
#include <QProgressBar>
#include <QPushButton>

namespace spherewalk::ui {

namespace {

constexpr int kSteps = 1000;

} // namespace

TaskBar::TaskBar(const QString& stopName, const QString& stopHint, QWidget* parent)
    : QWidget(parent), m_progress(new QProgressBar(this)), m_stop(new QPushButton(tr("&Stop"), this)) {
    m_progress->setRange(0, kSteps);
    m_stop->setObjectName(stopName);
    m_stop->setToolTip(stopHint);
    connect(m_stop, &QPushButton::clicked, this, [this] {
        if (m_task) {
            m_task->stop();
        }
    });
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_progress, 1);
    layout->addWidget(m_stop);
    hide();
}

void TaskBar::setTask(Task* task) {
    if (m_task) {
        m_task->disconnect(this);
    }
    m_task = task;
    if (task != nullptr) {
        m_progress->setAccessibleName(task->title());
        m_stop->setAccessibleName(tr("Stop %1").arg(task->title()));
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
    m_progress->setValue(qRound(kSteps * m_task->fraction()));
    const auto left = m_task->left();
    m_progress->setFormat(left ? tr("%1, %2 left").arg(m_task->step(), durationText(*left)) : m_task->step());
}

} // namespace spherewalk::ui
