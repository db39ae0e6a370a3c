// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/report/page_layout.h"

#include <array>
#include <utility>

namespace spherewalk::report {

using Eigen::Vector2d;

namespace {

constexpr double kMmAMetre = 1000;
constexpr double kLabelsMm = 8; ///< around the outline, for the names of corners and the walls' lengths

} // namespace

Vector2d PageLayout::paperFromRoom(const Vector2d& pInRoom) const {
    const Vector2d mm = (pInRoom - originInRoom) * (kMmAMetre / scale);
    return originMm + Vector2d(mm.x(), -mm.y());
}

PageLayout layoutOf(const Polygon& outline) {
    const Bounds2 room = bounds(outline);
    const Vector2d size = room.greatest - room.least;
    PageLayout layout;
    if (size.y() > size.x()) {
        std::swap(layout.paper.widthMm, layout.paper.heightMm);
    }
    const Vector2d space(layout.paper.widthMm - 2 * (kMarginMm + kLabelsMm),
                         layout.paper.heightMm - 2 * (kMarginMm + kLabelsMm) - kTitleMm - kFooterMm);
    constexpr std::array<int, 6> kScales = {10, 20, 25, 50, 100, 200};
    for (int power = 1;; power *= 10) { // after 1:200 comes 1:250, then 1:500 ...
        for (const int scale : kScales) {
            layout.scale = scale * power;
            const Vector2d drawn = size * (kMmAMetre / layout.scale);
            if (drawn.x() <= space.x() && drawn.y() <= space.y()) {
                layout.originInRoom = 0.5 * (room.least + room.greatest);
                layout.originMm = {0.5 * layout.paper.widthMm,
                                   kMarginMm + kLabelsMm + kTitleMm + 0.5 * space.y()};
                return layout;
            }
        }
    }
}

} // namespace spherewalk::report
