// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/polygon.h"

#include <Eigen/Core>

namespace spherewalk::sheet {

/// Paper. Units: millimetres; the origin is the upper left corner, y down.
struct Paper {
    double widthMm = 297;
    double heightMm = 210;
};

/// How a room is drawn to scale on a page of A4.
struct PageLayout {
    Paper paper;                                            ///< upright for a room that is deeper than wide
    int scale = 50;                                         ///< 1 : scale
    Eigen::Vector2d originMm = Eigen::Vector2d::Zero();     ///< on the paper, of the room's point below
    Eigen::Vector2d originInRoom = Eigen::Vector2d::Zero(); ///< metres

    Eigen::Vector2d paperFromRoom(const Eigen::Vector2d& pInRoom) const;
};

inline constexpr double kMarginMm = 15; ///< free on all sides, as most printers need some
inline constexpr double kTitleMm = 22;  ///< more at the top, for the title
inline constexpr double kFooterMm = 16; ///< more at the bottom, for the scale

/// The largest of the usual scales (1:10, 20, 25, 50, 100, 200, 250, 500 ... ) at which the room fits. Range:
/// at least one corner.
PageLayout layoutOf(const Polygon& outline);

} // namespace spherewalk::sheet
