// SPDX-License-Identifier: GPL-3.0-or-later
#include "random.h"

#include "spherewalk/measure/displacement.h"

#include <gtest/gtest.h>

#include <cmath>

namespace spherewalk::measure {

namespace {

const CameraModel kCamera(CameraIntrinsics::pinhole(320, 240, 1.0));

DepthImage plane(float z) {
    DepthImage depth(320, 240);
    std::fill(depth.values().begin(), depth.values().end(), z);
    return depth;
}

/// Blobs at random places, moved.
RgbImage blobs(int right, int down) {
    test::Random random(3);
    RgbImage picture(320, 240);
    for (int i = 0; i < 400; ++i) {
        const int x = random.integer(10, 300) + right;
        const int y = random.integer(10, 220) + down;
        const int size = random.integer(2, 6);
        const int grey = random.integer(60, 255);
        for (int v = y; v < y + size; ++v) {
            for (int u = x; u < x + size; ++u) {
                std::fill_n(picture.at(u, v), 3, static_cast<std::uint8_t>(grey));
            }
        }
    }
    return picture;
}

} // namespace

TEST(ExactDisplacement, IsNothingForTheTrueDepth) {
    EXPECT_NEAR(quantile(exactDisplacements(kCamera, {}, {0.3, 0.1, 0}, plane(2), plane(2)), 1).value(), 0,
                1e-9);
}

TEST(ExactDisplacement, IsTheParallaxOfAWrongDepth) {
    // A camera at the origin, the photo 0.2 m to its right, a wall at 2 m that was taken to be at 4 m.
    const auto errors = exactDisplacements(kCamera, {}, {0.2, 0, 0}, plane(2), plane(4));
    const double expected = kCamera.intrinsics().fx * 0.2 * (1 / 2.0 - 1 / 4.0);
    EXPECT_NEAR(quantile(errors, 0.5).value(), expected, 0.1 * expected);
}

TEST(ExactDisplacement, OfAPhotoThatIsOnlyTurnedIsItsWholeParallax) {
    const auto errors = exactDisplacements(kCamera, {}, {0.2, 0, 0}, plane(2), {});
    const double expected = kCamera.intrinsics().fx * 0.2 / 2;
    EXPECT_NEAR(quantile(errors, 0.5).value(), expected, 0.15 * expected);
}

TEST(ExactDisplacement, LeavesOutWhereNoDepthIsKnown) {
    EXPECT_TRUE(exactDisplacements(kCamera, {}, {0.2, 0, 0}, plane(HUGE_VALF), plane(2)).empty());
}

TEST(MatchedDisplacement, FindsHowFarAPictureWasMoved) {
    const auto errors = matchedDisplacements(blobs(0, 0), blobs(6, 3));
    ASSERT_GT(errors.size(), 30U);
    EXPECT_NEAR(quantile(errors, 0.5).value(), std::hypot(6, 3), 0.3);
    EXPECT_NEAR(quantile(errors, 0.95).value(), std::hypot(6, 3), 1);
}

TEST(MatchedDisplacement, FindsNothingWithoutTexture) {
    const auto none = matchedDisplacements(RgbImage(64, 64), RgbImage(64, 64));
    EXPECT_TRUE(none.empty());
    EXPECT_FALSE(quantile(none, 0.5)); // not known, which is not 0
}

} // namespace spherewalk::measure
