// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/align/room_tags.h"
#include "spherewalk/geometry/angle.h"

#include <Eigen/Core>

#include <cmath>

namespace spherewalk::align {

constexpr double kHungM = 0.16;

/// The corners of an upright tag whose front looks along this heading.
inline photo::TagCorners<Eigen::Vector3d> hung(const Eigen::Vector3d& middle, Radians facing,
                                               double sizeM = kHungM) {
    const Eigen::Vector3d right =
        sizeM / 2 * Eigen::Vector3d(-std::sin(facing.value()), std::cos(facing.value()), 0);
    const Eigen::Vector3d up = sizeM / 2 * Eigen::Vector3d::UnitZ();
    return {middle - right + up, middle + right + up, middle + right - up, middle - right - up};
}

} // namespace spherewalk::align
