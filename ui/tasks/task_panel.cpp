// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tasks/task_panel.h"

#include "ui/look/duration_text.h"
#include "ui/look/icon.h"
#include "ui/look/icon_label.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

namespace spherewalk::ui {

namespace {

/// One task.
class TaskRow : public QWidget {
  public:
    TaskRow(Task* task, QWidget* parent)
        : QWidget(parent),
          m_task(task),
          m_icon(new IconLabel(QString(), kIconPx, this)),
          m_words(new QLabel(this)),
          m_bar(new QProgressBar(this)),
          m_left(new QLabel(this)),
          m_stop(new QToolButton(this)) {
        auto* row = new QHBoxLayout(this);
        row->setContentsMargins(8, 2, 8, 2);
        m_words->setTextInteractionFlags(Qt::TextSelectableByMouse);
        m_words->setWordWrap(true);
        m_bar->setRange(0, kSteps);
        m_bar->setTextVisible(false);
        m_bar->setFixedWidth(180);
        m_bar->setAccessibleName(task->title());
        m_left->setFixedWidth(110);
        m_stop->setIcon(ui::icon("stop"));
        m_stop->setAutoRaise(true);
        m_stop->setToolTip(TaskPanel::tr("Stop; what is complete stays"));
        m_stop->setAccessibleName(TaskPanel::tr("Stop %1").arg(task->title()));
        row->addWidget(m_icon);
        row->addWidget(m_words, 1);
        row->addWidget(m_bar);
        row->addWidget(m_left);
        row->addWidget(m_stop);
        connect(m_stop, &QToolButton::clicked, task, &Task::stop);
        connect(task, &Task::progressed, this, [this] { showTask(); });
        connect(task, &Task::ended, this, [this] { showTask(); });
        connect(task, &QObject::destroyed, this, &QObject::deleteLater);
        showTask();
    }

  private:
    static constexpr int kSteps = 1000;
    static constexpr int kIconPx = 18;

    void showTask() {
        using State = Task::State;
        const State state = m_task->state();
        const QString words = state == State::Running   ? m_task->step()
                              : state == State::Done    ? TaskPanel::tr("done")
                              : state == State::Stopped ? TaskPanel::tr("stopped")
                                                        : m_task->sentence();
        m_words->setText(words.isEmpty() ? m_task->title() : m_task->title() + "  –  " + words);
        const QString name = state == State::Running   ? "play"
                             : state == State::Done    ? "good"
                             : state == State::Stopped ? "stop"
                                                       : "failed";
        m_icon->setIcon(name);
        m_bar->setValue(qRound(kSteps * m_task->fraction()));
        m_bar->setVisible(m_task->isRunning());
        m_stop->setVisible(m_task->isRunning());
        m_left->setText(m_task->left() ? TaskPanel::tr("%1 left").arg(durationText(*m_task->left()))
                                       : QString());
    }

    Task* m_task;
    IconLabel* m_icon;
    QLabel* m_words;
    QProgressBar* m_bar;
    QLabel* m_left;
    QToolButton* m_stop;
};

} // namespace

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
