// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/report/page_layout.h"

#include <array>
#include <utility>

namespace spherewalk::report {

using Eigen::Vector2d;

namespace {

constexpr double kMmAMetre = 1000;
constexpr double kLabelsMm = 8; ///< around the outline, for the names of corners and the walls' lengths

/// The space for the drawing on this paper.
Vector2d spaceOn(const Paper& paper) {
    return {paper.widthMm - 2 * (kMarginMm + kLabelsMm),
            paper.heightMm - 2 * (kMarginMm + kLabelsMm) - kTitleMm - kFooterMm};
}

/// The scale after this one: 10, 15, 20, 25, 30, 40, 50, 75, 100, 150 ...
int next(int scale) {
    constexpr std::array<int, 8> kScales = {10, 15, 20, 25, 30, 40, 50, 75};
    int power = 1;
    while (scale >= 100 * power) {
        power *= 10;
    }
    for (const int candidate : kScales) {
        if (candidate * power > scale) {
            return candidate * power;
        }
    }
    return 100 * power;
}

} // namespace

Vector2d PageLayout::paperFromRoom(const Vector2d& pInRoom) const {
    const Vector2d mm = (pInRoom - originInRoom) * (kMmAMetre / scale);
    return originMm + Vector2d(mm.x(), -mm.y());
}

PageLayout layoutOf(const Polygon& outline) {
    const Bounds2 room = bounds(outline);
    const Vector2d size = room.greatest - room.least;
    std::array<Paper, 2> papers = {Paper{}, Paper{Paper().heightMm, Paper().widthMm}};
    if (size.y() > size.x()) {
        std::swap(papers[0], papers[1]);
    }
    PageLayout layout;
    for (layout.scale = 10;; layout.scale = next(layout.scale)) {
        for (const Paper& paper : papers) {
            const Vector2d space = spaceOn(paper);
            if ((size * (kMmAMetre / layout.scale) - space).maxCoeff() <= 0) {
                layout.paper = paper;
                layout.originInRoom = 0.5 * (room.least + room.greatest);
                layout.originMm = {0.5 * paper.widthMm, kMarginMm + kLabelsMm + kTitleMm + 0.5 * space.y()};
                return layout;
            }
        }
    }
}

} // namespace spherewalk::report
