// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace spherewalk::ui {

/// A thread for short work that nobody waits for: pictures that are decoded while the user looks on. What was
/// asked for last is done first. Longer jobs, which people want to see and stop, are tasks. Threads: posted
/// to and delivered on the GUI thread.
class BackgroundWorker : public QObject {
    Q_OBJECT

  public:
    /// Called on the GUI thread with what the work has made; not called once the worker has been destroyed.
    using Deliver = std::function<void()>;
    /// Called on the worker's thread. Errors: none may leave it.
    using Work = std::function<Deliver()>;

    explicit BackgroundWorker(QObject* parent = nullptr);
    /// Drops what is waiting, and waits for what is being done.
    ~BackgroundWorker() override;

    /// What waits under the same key is replaced.
    void post(const QString& key, Work work);
    /// Does next what waits under this key; nothing if it does not wait.
    void hurry(const QString& key);
    void dropWaiting();

  private:
    struct Item {
        QString key;
        Work work;
    };

    void run(const std::stop_token& stop);

    std::mutex m_mutex;
    std::condition_variable_any m_posted;
    std::deque<Item> m_waiting; ///< the latest at the front
    std::jthread m_thread;      ///< last: it ends before what it uses
};

} // namespace spherewalk::ui
