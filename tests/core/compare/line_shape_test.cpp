// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"

#include "spherewalk/compare/line_shape.h"
#include "spherewalk/geometry/camera_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace spherewalk::compare {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

/// Dark above, bright below; the border lies at y = 60 + bend(x), to a fraction of a pixel.
RgbImage border(const std::function<double(double)>& bend) {
    RgbImage picture(200, 120);
    for (int y = 0; y < 120; ++y) {
        for (int x = 0; x < 200; ++x) {
            const double below = std::clamp(y + 0.5 - (60 + bend(x)), 0.0, 1.0);
            std::fill_n(picture.at(x, y), 3, static_cast<std::uint8_t>(std::lround(50 + 150 * below)));
        }
    }
    return picture;
}

const PictureLine kLine = pictureLine(Vector2d(10, 60), Vector2d(190, 60));

} // namespace

TEST(LineShape, IsStraightWhereTheLineIsHoweverItIsMovedOrTurned) {
    for (const double move : {0.0, 0.3, 4.0}) {
        const LineShape shape =
            lineShape(border([&](double x) { return move + 0.01 * (x - 100); }), kLine).value();
        EXPECT_LT(shape.rmsPx, 0.1);
        EXPECT_EQ(shape.foundShare, 1);
    }
}

TEST(LineShape, SaysHowFarAsideTheLineIs) {
    EXPECT_NEAR(lineShape(border([](double) { return 4; }), kLine)->offPx, 4, 0.1);
    EXPECT_NEAR(lineShape(border([](double) { return 0; }), kLine)->offPx, 0, 0.1);
}

TEST(LineShape, MeasuresAWaveToATenthOfAPixel) {
    const LineShape shape =
        lineShape(border([](double x) { return 2 * std::sin(2 * M_PI * x / 45); }), kLine).value();
    EXPECT_NEAR(shape.rmsPx, 2 / std::sqrt(2.0), 0.1);
    EXPECT_NEAR(shape.worstPx, 2, 0.2);
}

TEST(LineShape, IsNothingWhereTheViewHasNoEdge) {
    EXPECT_FALSE(lineShape(RgbImage(200, 120), kLine));
    EXPECT_FALSE(lineShape(border([](double) { return 20; }), kLine)) << "out of reach";
    EXPECT_TRUE(lineShape(border([](double) { return 20; }), kLine, 25));
    EXPECT_FALSE(lineShape(RgbImage(1, 1), kLine));
    EXPECT_FALSE(lineShape(border([](double) { return 0; }), {}));
}

TEST(LineShape, RefusesAnEmptyViewAndOtherReaches) {
    test::expectError(ErrorKind::InvalidInput, "empty", [] { lineShape({}, kLine); });
    test::expectError(ErrorKind::InvalidInput, "1 to 100", [] { lineShape(RgbImage(9, 9), kLine, 0.5); });
    test::expectError(ErrorKind::InvalidInput, "finite", [] { pictureLine({0, NAN}, Vector2d(1, 1)); });
}

TEST(LineShape, BendsALineOfTheRoomAsTheLensDoes) {
    const Rigid3 ahead; // along z
    const PictureLine straight = pictureLine(CameraModel(CameraIntrinsics::pinhole(200, 120, 1.2)), ahead,
                                             Vector3d(-9, 0.5, 2), Vector3d(9, 0.5, 2));
    ASSERT_GT(straight.size(), 90U);
    for (const Vector2d& pixel : straight) {
        EXPECT_NEAR(pixel.y(), straight.front().y(), 1e-9);
        EXPECT_GE(pixel.x(), 0);
        EXPECT_LE(pixel.x(), 199);
    }
    EXPECT_TRUE(pictureLine(CameraModel(CameraIntrinsics::pinhole(200, 120, 1.2)), ahead, Vector3d(0, 0, -1),
                            Vector3d(1, 0, -1))
                    .empty())
        << "behind the camera";
}

TEST(Straightness, FindsThePicturesLinesAndTellsTheWorst) {
    const RgbImage truth = border([](double) { return 0; });
    const std::vector<PictureLine> lines = straightLines(truth);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_LT(straightness(truth, lines).worstPx.value(), 0.05);
    const Straightness wavy = straightness(border([](double x) { return std::sin(x / 8); }), lines);
    EXPECT_NEAR(wavy.rmsPx.value(), 1 / std::sqrt(2.0), 0.1);
    EXPECT_EQ(wavy.rmsPx, wavy.worstPx) << "of a single line";
    const Straightness lost = straightness(RgbImage(200, 120), lines);
    EXPECT_FALSE(lost.rmsPx);
    EXPECT_EQ(lost.found, 0U);
    EXPECT_EQ(lost.lines, 1U);
    EXPECT_TRUE(straightLines(RgbImage(1, 1)).empty());
}

} // namespace spherewalk::compare
