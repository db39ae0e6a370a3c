// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

namespace spherewalk::practice {

/// A moment, and the zone in which the camera tells it.
struct ZonedTime {
    std::chrono::system_clock::time_point utc;
    std::chrono::minutes zone{0};
};

/// The local time in the spelling of Exif, "2026:01:02 03:04:05".
std::string exifTime(const ZonedTime& time);

/// The offset from UTC, "+01:30".
std::string zoneText(std::chrono::minutes zone);

/// The moment that exifTime() and zoneText() together spell, as in the option dateTimeZone. Returns nothing
/// for any other text, and for a moment that does not exist.
std::optional<ZonedTime> parseDateTimeZone(std::string_view text);

} // namespace spherewalk::practice
