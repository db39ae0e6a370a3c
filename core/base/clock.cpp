// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/base/clock.h"

#include "spherewalk/base/text.h"

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <ctime>
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

// The calendar is the system's: C++20's is missing in GCC 10.
std::string isoUtc(std::chrono::system_clock::time_point moment) {
    const auto seconds = std::chrono::floor<std::chrono::seconds>(moment);
    const auto milliseconds = std::chrono::floor<std::chrono::milliseconds>(moment - seconds);
    const std::time_t time = std::chrono::system_clock::to_time_t(seconds);
    std::tm date{};
    ::gmtime_r(&time, &date);
    return padded(date.tm_year + 1900, 4) + "-" + padded(date.tm_mon + 1, 2) + "-" + padded(date.tm_mday, 2) +
           "T" + padded(date.tm_hour, 2) + ":" + padded(date.tm_min, 2) + ":" + padded(date.tm_sec, 2) + "." +
           padded(milliseconds.count(), 3) + "Z";
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
    std::tm date{};
    date.tm_year = number(0, 4) - 1900;
    date.tm_mon = number(5, 2) - 1;
    date.tm_mday = number(8, 2);
    const std::tm asked = date;
    const std::time_t day = ::timegm(&date); // which moves the 30th of February to March
    // The clock's nanoseconds end in 2262.
    if (date.tm_mon != asked.tm_mon || date.tm_mday != asked.tm_mday || number(0, 4) < 1700 ||
        number(0, 4) > 2260 || number(11, 2) > 23 || number(14, 2) > 59 || number(17, 2) > 59) {
        return std::nullopt;
    }
    return std::chrono::system_clock::time_point(std::chrono::seconds(day)) +
           std::chrono::hours(number(11, 2)) + std::chrono::minutes(number(14, 2)) +
           std::chrono::seconds(number(17, 2)) + std::chrono::milliseconds(number(20, 3));
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
