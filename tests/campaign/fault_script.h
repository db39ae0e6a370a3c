// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "random.h"

#include "spherewalk/practice/practice_camera.h"

#include <vector>

namespace spherewalk::campaign {

/// A camera of any kind that is supported: model, password, and how its doubtful points are answered.
practice::PracticeCameraOptions randomCamera(test::Random& random, const std::filesystem::path& folder);

/// A few of all faults, at calls of a survey of some stations.
std::vector<practice::Fault> randomScript(test::Random& random);

inline constexpr const char* kUser = "THETAYL00123456";
inline constexpr const char* kPassword = "00123456";

} // namespace spherewalk::campaign
