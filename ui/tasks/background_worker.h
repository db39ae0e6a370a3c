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

/// A thread for short work without progress and stop, such as decoding pictures. The latest work is done
/// first. Longer jobs are tasks, which people see and can stop. Threads: post() and results are on the GUI
/// thread.
class BackgroundWorker : public QObject {
    Q_OBJECT

  public:
    /// Hands over the result on the GUI thread. It is not called after the worker is destroyed.
    using Deliver = std::function<void()>;
    /// Runs on the worker's thread and returns the delivery. Errors: it must throw none.
    using Work = std::function<Deliver()>;

    explicit BackgroundWorker(QObject* parent = nullptr);
    /// Drops waiting work and waits for the end of the current work.
    ~BackgroundWorker() override;

    /// Adds work; it replaces waiting work of the same key.
    void post(const QString& key, Work work);
    /// Puts the waiting work of this key first. Without such work, nothing happens.
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
    std::deque<Item> m_waiting; ///< The latest work is at the front.
    std::jthread m_thread;      ///< The last member, as it uses the others until it ends.
};

} // namespace spherewalk::ui
