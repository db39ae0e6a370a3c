// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/measure_summary.h"

#include <gtest/gtest.h>

#include <vector>

namespace spherewalk::jobs {

namespace {

/// A view in which so many features are displaced by so many pixels each.
Comparison displaced(std::size_t features, double px) {
    Comparison comparison;
    comparison.matched = std::vector<int>(features, static_cast<int>(100 * px));
    return comparison;
}

SceneLikeness together(const std::vector<Comparison>& views) {
    SceneSummary summary(render::SceneKind::Depth, render::Sampling::Bilinear, Places::Features);
    for (const Comparison& view : views) {
        summary.add(view, {});
    }
    return summary.result();
}

} // namespace

TEST(SceneSummary, IsNotLedByViewsInWhichAHandfulIsMatched) {
    EXPECT_EQ(together({displaced(100, 1), displaced(20, 2), displaced(19, 500)}).medianPx, 1.5);
}

TEST(SceneSummary, TakesWhatThereIsWhereLittleIsMatched) {
    EXPECT_EQ(together({displaced(3, 1), displaced(19, 4)}).medianPx, 2.5);
}

TEST(SceneSummary, HasNoMedianWithoutMatches) {
    const SceneLikeness likeness = together({displaced(0, 0), displaced(0, 0)});
    EXPECT_EQ(likeness.medianPx, std::nullopt);
    EXPECT_EQ(likeness.p95Px, std::nullopt);
    EXPECT_EQ(likeness.views.size(), 2U);
}

} // namespace spherewalk::jobs
