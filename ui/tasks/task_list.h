// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tasks/task.h"

#include <QList>
#include <QPointer>

#include <memory>
#include <type_traits>
#include <utility>

namespace spherewalk::ui {

/// The long jobs of the window: those that run, and the latest that have ended. Threads: the GUI thread.
class TaskList : public QObject {
    Q_OBJECT

  public:
    explicit TaskList(QObject* parent = nullptr);
    /// As stopAll().
    ~TaskList() override;

    /// Runs the job, Result(ProgressSink&, std::stop_token), on a thread of its own. If it succeeds and the
    /// receiver still lives, done(Result) is called on the GUI thread, or done() if there is no result. An
    /// error becomes Task::sentence(). The job must not touch what the GUI thread may change or destroy.
    /// Owner: the list; a task that has ended is forgotten when kMostEnded newer ones have.
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

    /// Oldest first.
    QList<Task*> tasks() const { return m_tasks; }

    bool hasRunning() const;
    /// Stops all and waits for them, as when the window closes. Nothing more is delivered; what the jobs had
    /// completed on disk stays.
    void stopAll();

  signals:
    void started(spherewalk::ui::Task* task);
    /// The task may be forgotten when the event loop runs next.
    void ended(spherewalk::ui::Task* task);

  private:
    Task* begin(const QString& title, Task::Work work);
    void forgetOld();

    QList<Task*> m_tasks;
};

} // namespace spherewalk::ui
