// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/error.h"

#include <QMetaObject>
#include <QObject>

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>

namespace spherewalk::ui {

/// Computes on a thread of its own what changes faster than it can be computed: an input that waits is
/// replaced by a newer one, and the one that runs is asked to stop. For work that is too short and too
/// frequent to be a Task. Threads: functions on the GUI thread, where results are delivered as well.
template <class Input, class Result>
class LatestOnly {
  public:
    /// May throw Error{Stopped}, and nothing else, to give up.
    using Compute = std::function<Result(const Input&, const std::stop_token&)>;
    using Deliver = std::function<void(Result)>;

    /// Owner: the receiver must outlive the object, best by having it as a member.
    LatestOnly(QObject* receiver, Compute compute, Deliver deliver)
        : m_receiver(receiver),
          m_compute(std::move(compute)),
          m_deliver(std::move(deliver)),
          m_thread([this](const std::stop_token& end) { run(end); }) {}

    /// Waits for what runs, which is asked to stop; delivers nothing more.
    ~LatestOnly() {
        {
            const std::scoped_lock lock(m_mutex);
            m_current.request_stop();
        }
        m_thread.request_stop();
        m_wake.notify_all();
    }

    LatestOnly(const LatestOnly&) = delete;
    LatestOnly& operator=(const LatestOnly&) = delete;

    void post(Input input) {
        {
            const std::scoped_lock lock(m_mutex);
            m_waiting = std::move(input);
            m_current.request_stop();
            ++m_posted;
        }
        m_wake.notify_all();
    }

    /// Whether a result is still to be delivered.
    bool isBusy() const { return m_delivered != m_posted; }

  private:
    void run(const std::stop_token& end) {
        for (;;) {
            std::unique_lock lock(m_mutex);
            if (!m_wake.wait(lock, end, [this] { return m_waiting.has_value(); })) {
                return;
            }
            const Input input = std::move(*std::exchange(m_waiting, std::nullopt));
            const std::uint64_t number = m_posted;
            m_current = std::stop_source();
            const std::stop_token stop = m_current.get_token();
            lock.unlock();
            try {
                auto result = std::make_shared<Result>(m_compute(input, stop));
                QMetaObject::invokeMethod(
                    m_receiver, [this, number, result] { take(number, std::move(*result)); },
                    Qt::QueuedConnection);
            } catch (const Error&) { // stopped: a newer input waits, or the end
            }
        }
    }

    void take(std::uint64_t number, Result result) {
        m_delivered = number;
        if (number == m_posted) { // else a newer one is on its way
            m_deliver(std::move(result));
        }
    }

    QObject* m_receiver;
    Compute m_compute;
    Deliver m_deliver;
    std::mutex m_mutex;
    std::condition_variable_any m_wake;
    std::optional<Input> m_waiting;
    std::stop_source m_current;
    std::uint64_t m_posted = 0;    ///< written on the GUI thread under the lock
    std::uint64_t m_delivered = 0; ///< GUI thread only
    std::jthread m_thread;         ///< last: it ends before what it uses
};

} // namespace spherewalk::ui
