// SPDX-License-Identifier: GPL-3.0-or-later
#include "photo/camera_time.h"

#include "spherewalk/base/text.h"

namespace spherewalk::practice {

namespace {

std::string twoDigits(int number) {
    return {static_cast<char>('0' + number / 10 % 10), static_cast<char>('0' + number % 10)};
}

} // namespace

std::string exifTime(const ZonedTime& time) {
    using namespace std::chrono;
    const auto local = time_point_cast<seconds>(time.utc) + time.zone;
    const auto day = floor<days>(local);
    const year_month_day date(day);
    const hh_mm_ss clock(local - day);
    const int year = static_cast<int>(date.year());
    return twoDigits(year / 100) + twoDigits(year) + ":" +
           twoDigits(static_cast<int>(static_cast<unsigned>(date.month()))) + ":" +
           twoDigits(static_cast<int>(static_cast<unsigned>(date.day()))) + " " +
           twoDigits(static_cast<int>(clock.hours().count())) + ":" +
           twoDigits(static_cast<int>(clock.minutes().count())) + ":" +
           twoDigits(static_cast<int>(clock.seconds().count()));
}

std::string zoneText(std::chrono::minutes zone) {
    const int total = static_cast<int>(zone.count());
    const int size = total < 0 ? -total : total;
    return (total < 0 ? "-" : "+") + twoDigits(size / 60) + ":" + twoDigits(size % 60);
}

std::optional<ZonedTime> parseDateTimeZone(std::string_view text) {
    using namespace std::chrono;
    constexpr std::string_view kShape = "dddd:dd:dd dd:dd:dd+dd:dd";
    if (text.size() != kShape.size()) {
        return std::nullopt;
    }
    for (std::size_t i = 0; i < kShape.size(); ++i) {
        const bool fits = kShape[i] == 'd'   ? text[i] >= '0' && text[i] <= '9'
                          : kShape[i] == '+' ? text[i] == '+' || text[i] == '-'
                                             : text[i] == kShape[i];
        if (!fits) {
            return std::nullopt;
        }
    }
    const year_month_day date{year(digitsAt(text, 0, 4)), month(static_cast<unsigned>(digitsAt(text, 5, 2))),
                              day(static_cast<unsigned>(digitsAt(text, 8, 2)))};
    const int hour = digitsAt(text, 11, 2);
    const int minute = digitsAt(text, 14, 2);
    const int second = digitsAt(text, 17, 2);
    const minutes size{60 * digitsAt(text, 20, 2) + digitsAt(text, 23, 2)};
    if (!date.ok() || hour > 23 || minute > 59 || second > 59 || size > hours(14)) {
        return std::nullopt;
    }
    ZonedTime time;
    time.zone = text[19] == '-' ? -size : size;
    time.utc = sys_days(date) + hours(hour) + minutes(minute) + seconds(second) - time.zone;
    return time;
}

} // namespace spherewalk::practice
