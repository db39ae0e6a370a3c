// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tasks/task_panel.h"

#include "ui/look/icon.h"
#include "ui/look/told_label.h"
#include "ui/look/words.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

namespace spherewalk::ui {

namespace {

constexpr int kSteps = 1000;

/// The row of one task.
class TaskRow : public QWidget {
  public:
    TaskRow(Task* task, QWidget* parent)
        : QWidget(parent),
          m_task(task),
          m_icon(new IconLabel(QString(), kIconPx, this)),
          m_words(new ToldLabel(this)) {
        auto* row = new QHBoxLayout(this);
        row->setContentsMargins(8, 2, 8, 2);
        auto* bar = new TaskBar("stopTask", TaskPanel::tr("Stop; what is complete stays"), this);
        bar->setTask(task);
        row->addWidget(m_icon);
        row->addWidget(m_words, 1);
        row->addWidget(bar, 1);
        connect(task, &Task::ended, this, [this] { showTask(); });
        connect(task, &QObject::destroyed, this, &QObject::deleteLater);
        showTask();
    }

  private:
    static constexpr int kIconPx = 18;

    void showTask() {
        using State = Task::State;
        const State state = m_task->state();
        Told told = state == State::Running   ? Told() // the bar says it
                    : state == State::Done    ? Told(TaskPanel::tr("done"))
                    : state == State::Stopped ? Told(TaskPanel::tr("stopped"))
                                              : m_task->told();
        told.text = told.isEmpty() ? m_task->title() : m_task->title() + "  –  " + told.text;
        m_words->tell(told);
        const QString name = state == State::Running   ? "play"
                             : state == State::Done    ? "good"
                             : state == State::Stopped ? "stop"
                                                       : "failed";
        m_icon->setIcon(name);
    }

    Task* m_task;
    IconLabel* m_icon;
    ToldLabel* m_words;
};

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

TaskPanel::TaskPanel(TaskList& tasks, QWidget* parent) : QWidget(parent) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    auto* scroll = new QScrollArea(this);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    auto* list = new QWidget(scroll);
    m_rows = new QVBoxLayout(list);
    m_rows->setContentsMargins(0, 4, 0, 4);
    m_rows->setSpacing(2);
    m_empty = new QLabel(tr("Nothing runs."), list);
    m_empty->setContentsMargins(12, 4, 12, 4);
    m_rows->addWidget(m_empty);
    m_rows->addStretch();
    scroll->setWidget(list);
    layout->addWidget(scroll);
    for (Task* task : tasks.tasks()) {
        add(task);
    }
    connect(&tasks, &TaskList::started, this, &TaskPanel::add);
}

void TaskPanel::add(Task* task) {
    m_empty->hide();
    m_rows->insertWidget(0, new TaskRow(task, this));
}

} // namespace spherewalk::ui
