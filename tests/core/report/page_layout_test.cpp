// SPDX-License-Identifier: GPL-3.0-or-later

#include "spherewalk/report/page_layout.h"

#include <gtest/gtest.h>

namespace spherewalk::report {

using Eigen::Vector2d;

namespace {

Polygon rectangle(double width, double depth) {
    return {{100, 200}, {100 + width, 200}, {100 + width, 200 + depth}, {100, 200 + depth}};
}

} // namespace

TEST(PageLayout, AMetreIsAsLongAsTheScaleSays) {
    for (const double width : {0.5, 3.0, 17.0, 420.0, 1900.0}) {
        const PageLayout layout = layoutOf(rectangle(width, 0.7 * width));
        const Vector2d metre = layout.paperFromRoom({101, 200}) - layout.paperFromRoom({100, 200});
        EXPECT_NEAR(metre.x(), 1000.0 / layout.scale, 1e-9);
        EXPECT_NEAR(metre.y(), 0, 1e-9);
    }
}

TEST(PageLayout, EveryCornerLiesWithinTheMargins) {
    for (const auto& [width, depth] : {std::pair(4.0, 3.0), {3.0, 4.0}, {100.0, 1.0}, {0.3, 2000.0}}) {
        const PageLayout layout = layoutOf(rectangle(width, depth));
        for (const Vector2d& corner : rectangle(width, depth)) {
            const Vector2d at = layout.paperFromRoom(corner);
            EXPECT_GE(at.x(), kMarginMm);
            EXPECT_LE(at.x(), layout.paper.widthMm - kMarginMm);
            EXPECT_GE(at.y(), kMarginMm + kTitleMm);
            EXPECT_LE(at.y(), layout.paper.heightMm - kMarginMm - kFooterMm);
        }
    }
}

TEST(PageLayout, TakesTheLargestScaleThatFits) {
    EXPECT_EQ(layoutOf(rectangle(2.4, 1.2)).scale, 10);
    EXPECT_EQ(layoutOf(rectangle(5, 3)).scale, 25);
    EXPECT_EQ(layoutOf(rectangle(5, 4)).scale, 30);
    EXPECT_EQ(layoutOf(rectangle(12, 6)).scale, 50);
    EXPECT_EQ(layoutOf(rectangle(60, 20)).scale, 250);
}

TEST(PageLayout, StandsUprightForADeepRoom) {
    const Paper paper = layoutOf(rectangle(3, 7)).paper;
    EXPECT_LT(paper.widthMm, paper.heightMm);
}

} // namespace spherewalk::report
