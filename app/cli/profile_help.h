// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace spherewalk::cli {

/// What an option that takes a capture profile can be given.
inline constexpr const char* kProfileHelp =
    "auto: by the camera, photo by photo; camera: as it is; or what is to be fixed, with commas between: "
    "iso=200, shutter=1/60, ev=-0.3, white-balance=daylight or 5200K, width=5376";

} // namespace spherewalk::cli
