// SPDX-License-Identifier: Apache-2.0
#include "surface/coordinates.h"
#include "surface/surface_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

namespace spherewalk::render {

namespace {

/// The share of a hole's pixels that stay taken from the second photo. It is upright and has these sides.
double shareLeftInHole(int widthPx, float left, float right, float taken) {
    constexpr int kViewWidth = 90; // no multiple of a cell's
    constexpr int kViewHeight = 45;
    constexpr int kFirst = 20;
    SurfaceCoordinates view;
    view.reset(kViewWidth, kViewHeight);
    const auto inHole = [&](int x) { return x >= kFirst && x < kFirst + widthPx; };
    for (int y = 0; y < view.source.height(); ++y) {
        for (int x = 0; x < view.source.width(); ++x) {
            *view.inverse.at(x, y) = inHole(x) ? taken : x < kFirst ? left : right;
            *view.source.at(x, y) = inHole(x) ? 1 : 0;
            view.sources[view.index(x / kCell, y / kCell)] |= inHole(x) ? 1U << 1 : 0U;
        }
    }
    WorkerPool pool;
    view.reopenNarrow(1, kViewWidth, kViewHeight, pool, 2);
    int stayed = 0;
    for (int y = 0; y < kViewHeight; ++y) {
        for (int x = kFirst; x < kFirst + widthPx; ++x) {
            const bool isTaken = *view.source.at(x, y) == 1;
            EXPECT_EQ(isTaken, *view.inverse.at(x, y) > 0) << x << ' ' << y;
            stayed += isTaken ? 1 : 0;
        }
    }
    return stayed / static_cast<double>(kViewHeight * widthPx);
}

} // namespace

TEST(NarrowHoles, ShowWhatLiesBetweenTheirSides) {
    EXPECT_EQ(shareLeftInHole(9, 0.5F, 0.5F, 0.48F), 1);
    EXPECT_EQ(shareLeftInHole(9, 1, 0.5F, 0.5F), 1); // what a near thing hid before a wall
    EXPECT_EQ(shareLeftInHole(9, 1, 0.5F, 0.7F), 1);
}

TEST(NarrowHoles, ShowNothingBehindOrBeforeBothSides) {
    EXPECT_EQ(shareLeftInHole(9, 1, 0.5F, 0.4F), 0);
    EXPECT_EQ(shareLeftInHole(9, 1, 0.5F, 1.2F), 0);
    EXPECT_EQ(shareLeftInHole(1, 0.5F, 0.5F, 0.1F), 0);
}

TEST(NarrowHoles, ShowNoSpeckOfAnotherPhoto) {
    EXPECT_EQ(shareLeftInHole(8, 0.5F, 0.5F, 0.5F), 0);
    EXPECT_EQ(shareLeftInHole(1, 1, 0.5F, 0.7F), 0);
}

TEST(NarrowHoles, EndWhereAHoleIsWide) {
    EXPECT_EQ(shareLeftInHole(30, 0.5F, 0.5F, 0.1F), 0);
    EXPECT_EQ(shareLeftInHole(40, 0.5F, 0.5F, 0.1F), 1);
    EXPECT_EQ(shareLeftInHole(70, 0.5F, 0.5F, 0.1F), 1); // up to the view's edge
}

TEST(SoftFill, TakesTheColourOfWhatLiesBehind) {
    WorkerPool pool(2);
    RgbImage picture(40, 30);
    MaskImage known(40, 30);
    InverseBuffer inverse;
    fit(inverse, 40, 30);
    for (int y = 0; y < 30; ++y) {
        for (int x = 0; x < 40; ++x) {
            const bool isNear = x < 15;
            std::fill_n(picture.at(x, y), 3, static_cast<std::uint8_t>(isNear ? 200 : 50));
            *inverse.at(x, y) = isNear ? 1.0F : 0.25F;
            *known.at(x, y) = x >= 15 && x < 22 ? 0 : 1;
        }
    }
    const RgbImage before = picture;
    fillSoftly(known, inverse, pool, 2, picture);
    for (int x = 15; x < 22; ++x) {
        EXPECT_NEAR(*picture.at(x, 15), 50, 10) << x;
    }
    EXPECT_EQ(*picture.at(14, 15), *before.at(14, 15));
    EXPECT_EQ(*picture.at(22, 15), *before.at(22, 15));
}

TEST(SoftFill, OfNothingKnownChangesNothing) {
    WorkerPool pool(1);
    RgbImage picture(20, 10);
    std::fill(picture.values().begin(), picture.values().end(), std::uint8_t{77});
    const RgbImage before = picture;
    InverseBuffer inverse;
    fit(inverse, 20, 10);
    fillSoftly(MaskImage(20, 10), inverse, pool, 1, picture);
    EXPECT_EQ(picture, before);
}

} // namespace spherewalk::render
