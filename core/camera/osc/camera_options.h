// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json.h"
#include "spherewalk/survey/capture_profile.h"

#include <string>
#include <vector>

namespace spherewalk::camera {

/// The options by which a camera keeps a profile, all that it may know.
const std::vector<std::string>& profileOptionNames();
/// The same with "Support": what the camera offers in its present program.
std::vector<std::string> profileSupportNames();

/// The camera's number for what the profile leaves to it.
int exposureProgram(const survey::CaptureProfile& profile);

/// The profile as options of this camera. known: what the camera says of profileOptionNames() and
/// profileSupportNames(); options that it does not know are left out. Errors: InvalidInput for a value that
/// the camera does not offer, with its nearest ones.
Json profileOptions(const survey::CaptureProfile& profile, const Json& known);

/// What the profile fixes and this camera does not let be set, as sentences.
std::vector<std::string> profileLacks(const survey::CaptureProfile& profile, const Json& known);

/// Whether two values of an option are the same to a camera: numbers within a thousandth.
bool isSameOption(const Json& a, const Json& b);

/// "The camera's ISO is 0 instead of 200".
std::string optionDifference(const std::string& name, const Json& wanted, const Json& found);

} // namespace spherewalk::camera
