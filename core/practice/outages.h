// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/practice/fault.h"

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace spherewalk::practice {

/// Keeps a TCP port from other programs while nothing listens on it, so that connections are refused.
class PortHolder {
  public:
    PortHolder() = default;
    ~PortHolder();
    PortHolder(const PortHolder&) = delete;
    PortHolder& operator=(const PortHolder&) = delete;

    /// The port that was taken, any that is free if 0 is asked for; 0 if it is not to be had.
    int hold(const std::string& host, int port);

  private:
    int m_socket = -1;
};

/// A thread on which the camera is away and comes back, as the threads that serve its port end meanwhile.
class Outages {
  public:
    using Endure = std::function<void(const Fault&, const std::stop_token&)>;

    explicit Outages(Endure endure) : m_endure(std::move(endure)) {}

    ~Outages() { finish(); }

    Outages(const Outages&) = delete;
    Outages& operator=(const Outages&) = delete;

    void start();
    /// Threads: any; returns at once.
    void begin(const Fault& outage);
    /// Cuts short what is going on.
    void finish();

  private:
    void run(const std::stop_token& stop);

    Endure m_endure;
    std::mutex m_mutex;
    std::condition_variable_any m_changed;
    std::deque<Fault> m_waiting;
    std::jthread m_thread;
};

} // namespace spherewalk::practice
