// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tasks/task.h"

#include "ui/look/core_words.h"

#include "spherewalk/base/error.h"

#include <algorithm>
#include <utility>

namespace spherewalk::ui {

namespace {

constexpr std::chrono::milliseconds kLookInterval{50};

} // namespace

/// The end of the job's thread: state, sentence and delivery.
struct Task::Ending {
    State state = State::Failed;
    Told told;
    Deliver deliver;
};

struct Task::Shared : ProgressSink {
    std::mutex mutex;
    double fraction = 0;
    QString step;
    QStringList warnings; ///< Warnings that the window has not seen yet.
    std::optional<Ending> ending;

    void progress(double done, std::string_view activity) override {
        const std::scoped_lock lock(mutex);
        fraction = done;
        step = QString::fromUtf8(activity.data(), static_cast<qsizetype>(activity.size()));
    }

    void warning(std::string_view sentence) override {
        const std::scoped_lock lock(mutex);
        warnings << QString::fromUtf8(sentence.data(), static_cast<qsizetype>(sentence.size()));
    }
};

Task::Task(QString title, Work work, QObject* parent)
    : QObject(parent),
      m_title(std::move(title)),
      m_timeLeft(std::chrono::steady_clock::now()),
      m_shared(std::make_unique<Shared>()),
      m_thread([this, job = std::move(work)](const std::stop_token& stop) { run(job, stop); }) {
    connect(&m_timer, &QTimer::timeout, this, &Task::look);
    m_timer.start(kLookInterval);
}

Task::~Task() {
    m_thread.request_stop();
    join();
}

void Task::stop() {
    m_thread.request_stop();
}

void Task::join() {
    if (m_thread.joinable()) {
        m_thread.join();
    }
}

void Task::stopAndWait() {
    m_thread.request_stop();
    join();
    if (!isRunning()) {
        return;
    }
    {
        const std::scoped_lock lock(m_shared->mutex);
        m_shared->ending->deliver = nullptr;
    }
    finish(); // the call that the thread posted finds nothing to do
}

void Task::run(const Work& work, const std::stop_token& stop) {
    Ending ending;
    try {
        ending.deliver = work(*m_shared, stop);
        ending.state = State::Done;
    } catch (const Error& error) {
        ending.state = error.kind() == ErrorKind::Stopped ? State::Stopped : State::Failed;
        ending.told = coreTold(error.sentence());
    } catch (const std::exception& defect) { // whatever no module translated
        ending.told = tr("Spherewalk met a defect of its own: %1.").arg(QString::fromUtf8(defect.what()));
    }
    {
        const std::scoped_lock lock(m_shared->mutex);
        m_shared->ending = std::move(ending);
    }
    QMetaObject::invokeMethod(this, &Task::finish, Qt::QueuedConnection);
}

QString Task::step() const {
    return coreWords(m_step);
}

void Task::look() {
    QStringList warnings;
    {
        const std::scoped_lock lock(m_shared->mutex);
        if (m_shared->fraction == m_fraction && m_shared->step == m_step && m_shared->warnings.isEmpty()) {
            return;
        }
        m_fraction = m_shared->fraction;
        m_step = m_shared->step;
        warnings.swap(m_shared->warnings);
    }
    const auto left = m_timeLeft.at(std::chrono::steady_clock::now(), m_fraction);
    m_left = left ? std::optional(std::chrono::round<std::chrono::seconds>(*left)) : std::nullopt;
    m_warnings << warnings;
    for (const QString& warning : warnings) {
        emit warned(warning);
    }
    emit progressed();
}

void Task::finish() {
    if (!isRunning()) {
        return;
    }
    look();
    m_timer.stop();
    Ending ending;
    {
        const std::scoped_lock lock(m_shared->mutex);
        ending = std::exchange(m_shared->ending, Ending{}).value();
    }
    m_state = ending.state;
    m_left.reset();
    m_told = m_state == State::Failed ? ending.told : Told();
    m_fraction = m_state == State::Done ? 1 : m_fraction;
    if (ending.deliver) {
        ending.deliver();
    }
    emit progressed();
    emit ended();
}

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
