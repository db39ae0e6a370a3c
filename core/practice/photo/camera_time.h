// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

namespace spherewalk::practice {

/// A moment and the offset of the zone that it is told in.
struct ZonedTime {
    std::chrono::system_clock::time_point utc;
    std::chrono::minutes zone{0};
};

/// "2026:01:02 03:04:05", in the zone.
std::string exifTime(const ZonedTime& time);

/// "+01:30".
std::string zoneText(std::chrono::minutes zone);

/// exifTime and zoneText together, as OSC spells dateTimeZone; nothing for anything else.
std::optional<ZonedTime> parseDateTimeZone(std::string_view text);

} // namespace spherewalk::practice
