// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

namespace spherewalk::camera {

/// The moment as the option dateTimeZone spells it, "2026:01:02 03:04:05-03:30", in this zone east of UTC.
std::string cameraTime(std::chrono::system_clock::time_point time, std::chrono::minutes zone);

/// The moment that is spelled so; nothing for anything else. Units: UTC.
std::optional<std::chrono::system_clock::time_point> parseCameraTime(std::string_view text);

/// Of this computer, at that moment, east of UTC.
std::chrono::minutes localZone(std::chrono::system_clock::time_point time);

} // namespace spherewalk::camera
