// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

namespace spherewalk {

/// The time as the program sees it, so that tests can move it by hand. Threads: any.
class Clock {
  public:
    using Duration = std::chrono::steady_clock::duration;
    using TimePoint = std::chrono::steady_clock::time_point;

    virtual ~Clock() = default;

    /// Monotonic time, for intervals.
    virtual TimePoint now() const = 0;
    /// The time of day, for records. It jumps when somebody sets the machine's clock.
    virtual std::chrono::system_clock::time_point utc() const = 0;
    /// Returns true after the whole duration, or false as soon as a stop is requested.
    virtual bool sleep(Duration duration, const std::stop_token& stop) = 0;
};

/// The machine's own clock.
Clock& systemClock();

/// A moment as ISO 8601 in UTC with milliseconds: "2026-01-02T03:04:05.678Z".
std::string isoUtc(std::chrono::system_clock::time_point moment);

/// The moment that a text of isoUtc() spells. Any other text gives nothing.
std::optional<std::chrono::system_clock::time_point> parseIsoUtc(std::string_view text);

/// A duration as people say it: "8 s", "3 min 20 s", "2 h 17 min". A negative one gives "0 s".
std::string humanDuration(std::chrono::duration<double> duration);

} // namespace spherewalk
