// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "random.h"

#include "spherewalk/compare/steadiness.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace spherewalk::compare {

namespace {

/// Squares of all sizes and shades, moved.
PictureFeatures scatteredSquares(int right) {
    test::Random random(7);
    RgbImage picture(320, 240);
    for (int i = 0; i < 400; ++i) {
        const int x = random.integer(20, 280) + right;
        const int y = random.integer(10, 210);
        const int size = random.integer(3, 12);
        const auto grey = static_cast<std::uint8_t>(random.integer(60, 255));
        for (int v = y; v < y + size; ++v) {
            for (int u = x; u < x + size; ++u) {
                std::fill_n(picture.at(u, v), 3, grey);
            }
        }
    }
    return PictureFeatures(picture);
}

} // namespace

TEST(Steadiness, SeesNothingInAViewThatIsWrongInTheSameWay) {
    const Steadiness steady =
        steadiness({scatteredSquares(0), scatteredSquares(5)}, {scatteredSquares(3), scatteredSquares(8)});
    EXPECT_NEAR(steady.medianPx.value(), 0, 0.05);
    EXPECT_LT(steady.p95Px.value(), 0.5);
    EXPECT_GT(steady.things, 50U);
}

TEST(Steadiness, SeesHowMuchAViewJumps) {
    const Steadiness jump =
        steadiness({scatteredSquares(0), scatteredSquares(0)}, {scatteredSquares(3), scatteredSquares(7)});
    EXPECT_NEAR(jump.medianPx.value(), 4, 0.1);
}

TEST(Steadiness, IsTheSameInBothDirectionsOfTime) {
    const Frame early{scatteredSquares(0), scatteredSquares(1)};
    const Frame late{scatteredSquares(3), scatteredSquares(6)};
    const Steadiness onward = steadiness(early, late);
    const Steadiness back = steadiness(late, early);
    EXPECT_NEAR(onward.medianPx.value(), back.medianPx.value(), 0.02);
    EXPECT_NEAR(onward.medianPx.value(), 2, 0.1);
    EXPECT_LE(onward.medianPx.value(), onward.p95Px.value());
}

TEST(Steadiness, IsUnknownWithoutThingsToFollow) {
    const PictureFeatures even{RgbImage(320, 240)};
    EXPECT_FALSE(steadiness({scatteredSquares(0), even}, {scatteredSquares(3), even}).medianPx);
    test::expectError(ErrorKind::InvalidInput, "sizes", [&] {
        steadiness({even, PictureFeatures(RgbImage(9, 9))}, {even, even});
    });
}

} // namespace spherewalk::compare
