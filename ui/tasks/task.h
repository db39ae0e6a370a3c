// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/progress.h"

#include <QObject>
#include <QStringList>
#include <QTimer>

#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

namespace spherewalk::ui {

/// A long job on a thread of its own, as the window sees it. Threads: all functions and signals on the GUI
/// thread; the job's progress is looked at 20 times a second, however often it speaks. Made by
/// TaskList::start().
class Task : public QObject {
    Q_OBJECT

  public:
    enum class State { Running, Done, Failed, Stopped };
    Q_ENUM(State)

    /// Hands over the job's result; called on the GUI thread.
    using Deliver = std::function<void()>;
    using Work = std::function<Deliver(ProgressSink&, const std::stop_token&)>;

    Task(QString title, Work work, QObject* parent);
    /// Stops the job and waits for it; what it would have delivered is dropped.
    ~Task() override;

    QString title() const { return m_title; }

    State state() const { return m_state; }

    bool isRunning() const { return m_state == State::Running; }

    /// Done so far, in [0, 1].
    double fraction() const { return m_fraction; }

    /// What is being done, for people.
    QString step() const { return m_step; }

    /// At the pace so far; nothing while it is not known, or when the job has ended.
    std::optional<std::chrono::seconds> left() const { return m_left; }

    /// Why it failed; empty otherwise.
    QString sentence() const { return m_sentence; }

    /// What the job wanted people to read although it went on, oldest first.
    QStringList warnings() const { return m_warnings; }

    /// Asks the job to stop; it ends soon after, as Stopped, unless it is done before.
    void stop();
    /// The same, and returns when the job's thread and the task have ended. Nothing is delivered any more.
    void stopAndWait();

  signals:
    void progressed();
    void warned(const QString& sentence);
    /// The last signal. If the job succeeded, its result has been delivered before.
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
    QString m_step;
    std::optional<std::chrono::seconds> m_left;
    QString m_sentence;
    QStringList m_warnings;
    QTimer m_timer;
    TimeLeft m_timeLeft;
    std::unique_ptr<Shared> m_shared; ///< what both threads touch
    std::jthread m_thread;            ///< last: it ends before what it uses
};

} // namespace spherewalk::ui
