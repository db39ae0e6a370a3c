// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera_clock.h"

#include "spherewalk/base/text.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace spherewalk::camera {

using namespace std::chrono;

std::string cameraTime(system_clock::time_point time, minutes zone) {
    const auto local = floor<seconds>(time) + zone;
    const auto day = floor<days>(local);
    const year_month_day date(day);
    const hh_mm_ss clock(local - day);
    const int offset = static_cast<int>(zone.count());
    std::array<char, 64> spelled{};
    std::snprintf(spelled.data(), spelled.size(), "%04d:%02u:%02u %02d:%02d:%02d%c%02d:%02d",
                  static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
                  static_cast<unsigned>(date.day()), static_cast<int>(clock.hours().count()),
                  static_cast<int>(clock.minutes().count()), static_cast<int>(clock.seconds().count()),
                  offset < 0 ? '-' : '+', std::abs(offset) / 60, std::abs(offset) % 60);
    return spelled.data();
}

// By places, as a zone behind UTC begins with a dash.
std::optional<system_clock::time_point> parseCameraTime(std::string_view text) {
    constexpr std::string_view kShape = "0000:00:00 00:00:00+00:00";
    if (text.size() != kShape.size()) {
        return std::nullopt;
    }
    for (std::size_t i = 0; i < kShape.size(); ++i) {
        const bool fits = kShape[i] == '0' || text[i] == kShape[i] || (kShape[i] == '+' && text[i] == '-');
        if (!fits) {
            return std::nullopt;
        }
    }
    const year_month_day date{year(digitsAt(text, 0, 4)), month(static_cast<unsigned>(digitsAt(text, 5, 2))),
                              day(static_cast<unsigned>(digitsAt(text, 8, 2)))};
    const std::array<int, 5> parts{digitsAt(text, 11, 2), digitsAt(text, 14, 2), digitsAt(text, 17, 2),
                                   digitsAt(text, 20, 2), digitsAt(text, 23, 2)};
    for (const int part : parts) {
        if (part < 0 || part > 60) {
            return std::nullopt;
        }
    }
    if (!date.ok()) {
        return std::nullopt;
    }
    const minutes zone = hours(parts[3]) + minutes(parts[4]);
    return sys_days(date) + hours(parts[0]) + minutes(parts[1]) + seconds(parts[2]) -
           (text[19] == '-' ? -zone : zone);
}

minutes localZone(system_clock::time_point time) {
    const std::time_t moment = system_clock::to_time_t(time);
    std::tm local{};
    return ::localtime_r(&moment, &local) == nullptr ? minutes(0) : minutes(local.tm_gmtoff / 60);
}

} // namespace spherewalk::camera
