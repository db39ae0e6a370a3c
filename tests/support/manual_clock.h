// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/clock.h"

#include <chrono>
#include <mutex>

namespace spherewalk::test {

/// A clock that stands still until it is moved; sleeping moves it. Threads: any.
class ManualClock : public Clock {
  public:
    TimePoint now() const override {
        const std::scoped_lock lock(m_mutex);
        return TimePoint{} + std::chrono::hours(1) + m_passed;
    }

    std::chrono::system_clock::time_point utc() const override {
        const std::scoped_lock lock(m_mutex);
        return std::chrono::sys_days(std::chrono::year(2026) / 3 / 4) +
               std::chrono::round<std::chrono::microseconds>(m_passed + m_jumped);
    }

    bool sleep(Duration duration, const std::stop_token& stop) override {
        if (stop.stop_requested()) {
            return false;
        }
        advance(duration);
        return !stop.stop_requested();
    }

    void advance(Duration duration) {
        const std::scoped_lock lock(m_mutex);
        m_passed += duration;
    }

    /// Sets the time of day, as a person or a time server does; monotonic time goes on.
    void jump(Duration duration) {
        const std::scoped_lock lock(m_mutex);
        m_jumped += duration;
    }

    Duration passed() const {
        const std::scoped_lock lock(m_mutex);
        return m_passed;
    }

  private:
    mutable std::mutex m_mutex;
    Duration m_passed{0};
    Duration m_jumped{0};
};

} // namespace spherewalk::test
