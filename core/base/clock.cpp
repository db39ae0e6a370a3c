// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/base/clock.h"

#include "spherewalk/base/text.h"

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <mutex>

namespace spherewalk {

namespace {

std::string padded(long long number, std::size_t width) {
    std::string digits = std::to_string(number);
    return digits.size() < width ? std::string(width - digits.size(), '0') + digits : digits;
}

class SystemClock : public Clock {
  public:
    TimePoint now() const override { return std::chrono::steady_clock::now(); }

    std::chrono::system_clock::time_point utc() const override { return std::chrono::system_clock::now(); }

    bool sleep(Duration duration, const std::stop_token& stop) override {
        std::mutex mutex;
        std::condition_variable_any wakeUp;
        std::unique_lock lock(mutex);
        wakeUp.wait_for(lock, stop, duration, [] { return false; });
        return !stop.stop_requested();
    }
};

} // namespace

Clock& systemClock() {
    static SystemClock clock;
    return clock;
}

std::string isoUtc(std::chrono::system_clock::time_point moment) {
    const auto milliseconds = std::chrono::floor<std::chrono::milliseconds>(moment);
    const auto day = std::chrono::floor<std::chrono::days>(milliseconds);
    const std::chrono::year_month_day date(day);
    const std::chrono::hh_mm_ss time(milliseconds - day);
    return padded(int(date.year()), 4) + "-" + padded(unsigned(date.month()), 2) + "-" +
           padded(unsigned(date.day()), 2) + "T" + padded(time.hours().count(), 2) + ":" +
           padded(time.minutes().count(), 2) + ":" + padded(time.seconds().count(), 2) + "." +
           padded(time.subseconds().count(), 3) + "Z";
}

std::optional<std::chrono::system_clock::time_point> parseIsoUtc(std::string_view text) {
    constexpr std::string_view kShape = "0000-00-00T00:00:00.000Z";
    if (text.size() != kShape.size()) {
        return std::nullopt;
    }
    for (std::size_t i = 0; i < kShape.size(); ++i) {
        const bool isDigit = text[i] >= '0' && text[i] <= '9';
        if (kShape[i] == '0' ? !isDigit : text[i] != kShape[i]) {
            return std::nullopt;
        }
    }
    const auto number = [&](std::size_t at, std::size_t count) { return digitsAt(text, at, count); };
    const std::chrono::year_month_day date(std::chrono::year(number(0, 4)),
                                           std::chrono::month(static_cast<unsigned>(number(5, 2))),
                                           std::chrono::day(static_cast<unsigned>(number(8, 2))));
    // The clock's nanoseconds end in 2262.
    if (!date.ok() || date.year() < std::chrono::year(1700) || date.year() > std::chrono::year(2260) ||
        number(11, 2) > 23 || number(14, 2) > 59 || number(17, 2) > 59) {
        return std::nullopt;
    }
    return std::chrono::sys_days(date) + std::chrono::hours(number(11, 2)) +
           std::chrono::minutes(number(14, 2)) + std::chrono::seconds(number(17, 2)) +
           std::chrono::milliseconds(number(20, 3));
}

std::string humanDuration(std::chrono::duration<double> duration) {
    const long long seconds = std::llround(std::max(0.0, duration.count()));
    if (seconds < 60) {
        return text(seconds, " s");
    }
    if (seconds < 3600) {
        return text(seconds / 60, " min ", seconds % 60, " s");
    }
    return text(seconds / 3600, " h ", seconds / 60 % 60, " min");
}

} // namespace spherewalk
