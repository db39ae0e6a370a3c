// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/look/told.h"

#include "spherewalk/base/progress.h"

#include <QList>
#include <QObject>
#include <QPointer>
#include <QStringList>
#include <QTimer>

#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <type_traits>
#include <utility>

namespace spherewalk::ui {

/// A long job on a thread of its own, as the window shows it. TaskList::start() makes tasks. progressed()
/// comes at most 20 times a second. Threads: all functions and signals are on the GUI thread.
class Task : public QObject {
    Q_OBJECT

  public:
    enum class State { Running, Done, Failed, Stopped };
    Q_ENUM(State)

    /// Hands over the result of the job on the GUI thread.
    using Deliver = std::function<void()>;
    using Work = std::function<Deliver(ProgressSink&, const std::stop_token&)>;

    Task(QString title, Work work, QObject* parent);
    /// Stops the job, waits for its end and drops its result.
    ~Task() override;

    QString title() const { return m_title; }

    State state() const { return m_state; }

    bool isRunning() const { return m_state == State::Running; }

    /// Returns the completed share, in [0, 1].
    double fraction() const { return m_fraction; }

    /// Names the step that is on, in the user's language where that is known.
    QString step() const;

    /// Estimates the time left. Returns nothing before an estimate is possible and after the end.
    std::optional<std::chrono::seconds> left() const { return m_left; }

    /// Says why the job failed; empty otherwise.
    QString sentence() const { return m_told.text; }

    /// Returns sentence(), with the place of its cure.
    const Told& told() const { return m_told; }

    /// Returns the warnings of the job, oldest first.
    QStringList warnings() const { return m_warnings; }

    /// Asks the job to stop. It soon ends as Stopped, or as Done if it was done before.
    void stop();
    /// Does the same and waits for the end of the thread. No result is delivered.
    void stopAndWait();

  signals:
    void progressed();
    void warned(const QString& sentence);
    /// The last signal of a task. The result of a job that succeeded has been delivered before.
    void ended();

  private:
    struct Shared;
    struct Ending;

    void run(const Work& work, const std::stop_token& stop);
    void look();
    void join();
    void finish();

    QString m_title;
    State m_state = State::Running;
    double m_fraction = 0;
    QString m_step; ///< As the core says it.
    std::optional<std::chrono::seconds> m_left;
    Told m_told;
    QStringList m_warnings;
    QTimer m_timer;
    TimeLeft m_timeLeft;
    std::unique_ptr<Shared> m_shared; ///< State that both threads use.
    std::jthread m_thread;            ///< The last member, as it uses the others until it ends.
};

/// The long jobs of the window: all that run, and the latest that have ended. Threads: the GUI thread.
class TaskList : public QObject {
    Q_OBJECT

  public:
    explicit TaskList(QObject* parent = nullptr);
    /// Calls stopAll().
    ~TaskList() override;

    /// Runs job(ProgressSink&, std::stop_token) on a thread of its own. If it succeeds and the receiver still
    /// lives, done(result) follows on the GUI thread, or done() for a job without a result. An error becomes
    /// Task::sentence(). Threads: the job must not use what the GUI thread may change or destroy.
    /// Owner: the list, which deletes an ended task once kMostEnded newer tasks have ended.
    template <class Job, class Done>
    Task* start(const QString& title, QObject* receiver, Job job, Done done) {
        return begin(title,
                     [job = std::move(job), done = std::move(done), guard = QPointer<QObject>(receiver)](
                         ProgressSink& progress, const std::stop_token& stop) mutable -> Task::Deliver {
                         using Result = decltype(job(progress, stop));
                         if constexpr (std::is_void_v<Result>) {
                             job(progress, stop);
                             return [guard, done]() mutable {
                                 if (guard) {
                                     done();
                                 }
                             };
                         } else {
                             const auto result = std::make_shared<Result>(job(progress, stop));
                             return [guard, done, result]() mutable {
                                 if (guard) {
                                     done(std::move(*result));
                                 }
                             };
                         }
                     });
    }

    static constexpr int kMostEnded = 20;

    /// Returns the tasks, oldest first.
    QList<Task*> tasks() const { return m_tasks; }

    bool hasRunning() const;
    /// Stops all tasks and waits for their end. No result is delivered; what jobs completed on disk stays.
    void stopAll();

  signals:
    void started(spherewalk::ui::Task* task);
    /// The list can delete the task when the event loop runs next.
    void ended(spherewalk::ui::Task* task);

  private:
    Task* begin(const QString& title, Task::Work work);
    void forgetOld();

    QList<Task*> m_tasks;
};

} // namespace spherewalk::ui
