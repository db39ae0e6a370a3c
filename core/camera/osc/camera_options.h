// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json_fwd.h"
#include "spherewalk/survey/capture_profile.h"

#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::camera {

/// Names of all options by which a camera may keep a profile.
const std::vector<std::string>& profileOptionNames();
/// Names of the options that list what the camera offers in its present program.
std::vector<std::string> profileSupportNames();

/// The camera's number for the exposure program that the profile implies.
int exposureProgram(const survey::CaptureProfile& profile);

/// The profile as options of this camera. known: what the camera says of profileOptionNames() and
/// profileSupportNames(); options that it does not know are left out. Errors: InvalidInput for a value that
/// the camera does not offer, with its nearest ones.
Json profileOptions(const survey::CaptureProfile& profile, const Json& known);

/// Sentences about settings that the profile fixes and this camera does not let a program set.
std::vector<std::string> profileLacks(const survey::CaptureProfile& profile, const Json& known);

/// Whether two values of an option are the same to a camera: numbers within a thousandth.
bool isSameOption(const Json& a, const Json& b);

/// "The camera's ISO is 0 instead of 200".
std::string optionDifference(const std::string& name, const Json& wanted, const Json& found);

/// The moment as the option dateTimeZone spells it, "2026:01:02 03:04:05-03:30", in this zone east of UTC.
std::string cameraTime(std::chrono::system_clock::time_point time, std::chrono::minutes zone);

/// The moment that is spelled so; nothing for anything else. Units: UTC.
std::optional<std::chrono::system_clock::time_point> parseCameraTime(std::string_view text);

/// The time zone of this computer at that moment, east of UTC.
std::chrono::minutes localZone(std::chrono::system_clock::time_point time);

} // namespace spherewalk::camera
