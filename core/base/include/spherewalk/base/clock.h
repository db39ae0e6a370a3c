// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <stop_token>

namespace spherewalk {

/// Time as the program sees it, so that tests can move it by hand. Threads: all functions may be called from
/// any.
class Clock {
  public:
    using Duration = std::chrono::steady_clock::duration;
    using TimePoint = std::chrono::steady_clock::time_point;

    virtual ~Clock() = default;

    /// Monotonic time, for intervals.
    virtual TimePoint now() const = 0;
    /// The time of day, for records; it may jump.
    virtual std::chrono::system_clock::time_point utc() const = 0;
    /// Returns after the duration, or at once when a stop is asked for: true if the full time has passed.
    virtual bool sleep(Duration duration, const std::stop_token& stop) = 0;
};

/// The machine's own clock.
Clock& systemClock();

} // namespace spherewalk
