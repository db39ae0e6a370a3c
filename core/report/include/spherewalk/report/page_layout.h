// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/polygon.h"

#include <Eigen/Core>

namespace spherewalk::report {

/// A sheet of paper. Units: millimetres; the origin is the upper left corner, y down.
struct Paper {
    double widthMm = 297;
    double heightMm = 210;
};

/// Places a room, drawn to scale, on a page of A4.
struct PageLayout {
    Paper paper;                                            ///< Upright where the room is drawn larger so.
    int scale = 50;                                         ///< One metre on paper stands for `scale` metres.
    Eigen::Vector2d originMm = Eigen::Vector2d::Zero();     ///< The place of originInRoom on the paper.
    Eigen::Vector2d originInRoom = Eigen::Vector2d::Zero(); ///< Metres.

    /// Millimetres on the paper from metres in the room.
    Eigen::Vector2d paperFromRoom(const Eigen::Vector2d& pInRoom) const;
};

inline constexpr double kMarginMm = 10; ///< Free on all sides, because most printers need some.
inline constexpr double kTitleMm = 22;  ///< Height of the title below the upper margin.
inline constexpr double kFooterMm = 16; ///< Height of the scale above the lower margin.

/// The layout at the largest round scale (1:10, 15, 20, 25, 30, 40, 50, 75, 100 ...) at which the room fits.
/// Range: at least one corner.
PageLayout layoutOf(const Polygon& outline);

} // namespace spherewalk::report
