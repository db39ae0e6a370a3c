// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

namespace spherewalk::practice {

/// What ails the camera.
struct CameraCondition {
    std::optional<double> battery; ///< none: falls as pictures are taken
    bool isFull = false;
    bool isOutOfRoom = false; ///< full, and has been asked for a picture since
    bool isHot = false;
    bool isClockUnset = false;
    bool hasPlugin = false;
    bool saysUnknownThings = false;
    std::uint64_t serialShift = 0; ///< not 0: another camera
    double slowness = 1;
};

} // namespace spherewalk::practice
