// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/fixed_random.h"
#include "spherewalk/photo/tag_fit.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>

namespace spherewalk::photo {

namespace {

constexpr double kPitch = 0.002;
constexpr int kNumber = 23;
constexpr double kLensBlurPx = 0.5;

/// A tag as a camera would take it: each pixel is the mean of rays over its square, blurred by a lens.
struct MadePicture {
    TagCorners<Eigen::Vector2d> corners;
    std::vector<TagPixel> pixels;
};

/// turnRad: of the tag about the vertical. cellPx: pixels to a cell, about.
MadePicture made(double cellPx, double turnRad, double noise, std::uint64_t seed,
                 double blurPx = kLensBlurPx) {
    constexpr int kRays = 256;
    FixedRandom random(seed);
    const double half = 4 * cellPx * kPitch;
    const Eigen::Vector2d shift(kPitch * random.uniform(), kPitch * random.uniform());
    const auto project = [&](double x, double y) -> Eigen::Vector2d {
        const double depth = 1 + 1.5 * half * x * std::sin(turnRad);
        return shift + half * Eigen::Vector2d(x * std::cos(turnRad), y) / depth;
    };
    MadePicture picture;
    picture.corners = {project(-1, -1), project(1, -1), project(1, 1), project(-1, 1)};
    const TagCells cells = tagCells(kNumber);
    const auto isWhite = [&](const Eigen::Vector2d& at) {
        // The inverse of project(): first x, then y with its depth.
        const Eigen::Vector2d p = (at - shift) / half;
        const double x = p.x() / (std::cos(turnRad) - 1.5 * half * p.x() * std::sin(turnRad));
        const double y = p.y() * (1 + 1.5 * half * x * std::sin(turnRad));
        const double column = 4 * (x + 1);
        const double row = 4 * (y + 1);
        return column < 0 || row < 0 || column >= 8 || row >= 8 ||
               cells[static_cast<std::size_t>(8 * static_cast<int>(row) + static_cast<int>(column))];
    };
    const int reach = static_cast<int>(6 * cellPx);
    for (int v = -reach; v <= reach; ++v) {
        for (int u = -reach; u <= reach; ++u) {
            double white = 0;
            for (int ray = 0; ray < kRays; ++ray) {
                const Eigen::Vector2d inside((ray % 16 + 0.5) / 16 - 0.5, (ray / 16 + 0.5) / 16 - 0.5);
                const Eigen::Vector2d bent(random.normal(blurPx), random.normal(blurPx));
                white += isWhite(kPitch * (Eigen::Vector2d(u, v) + inside + bent)) ? 1.0 / kRays : 0;
            }
            const double grey = std::round(40 + 160 * white + (noise > 0 ? random.normal(noise) : 0));
            picture.pixels.push_back({kPitch * Eigen::Vector2d(u, v), grey});
        }
    }
    return picture;
}

TagCorners<Eigen::Vector2d> moved(TagCorners<Eigen::Vector2d> corners, double byPx) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
        corners[i] += byPx * kPitch * Eigen::Vector2d(i % 2 == 0 ? 1 : -0.7, i < 2 ? 0.6 : -1);
    }
    return corners;
}

double worstPx(const TagFit& fit, const MadePicture& picture) {
    double worst = 0;
    for (std::size_t i = 0; i < fit.corners.size(); ++i) {
        worst = std::max(worst, (fit.corners[i] - picture.corners[i]).norm() / kPitch);
    }
    return worst;
}

} // namespace

TEST(TagFit, FindsCornersFromAPixelAway) {
    for (const double cellPx : {2.5, 5.0, 12.0, 20.0}) {
        for (const double turnRad : {0.0, 0.7}) {
            const MadePicture picture = made(cellPx, turnRad, 1, 5);
            const auto fit =
                fittedTag(tagCells(kNumber), picture.pixels, kPitch, moved(picture.corners, 0.8));
            ASSERT_TRUE(fit) << cellPx << ", " << turnRad;
            EXPECT_LT(worstPx(*fit, picture), 0.06) << cellPx << ", " << turnRad;
            EXPECT_LT(worstPx(*fit, picture) * kPitch, 6 * fit->sigma) << cellPx << ", " << turnRad;
        }
    }
}

// A picture as sharp as its pixels, whose rows lie along the tag's edges, tells least of where they are.
TEST(TagFit, FindsCornersInAPictureThatNoLensBlurs) {
    const MadePicture picture = made(5, 0, 1, 5, 0);
    const auto fit = fittedTag(tagCells(kNumber), picture.pixels, kPitch, moved(picture.corners, 0.5));
    ASSERT_TRUE(fit);
    EXPECT_LT(worstPx(*fit, picture), 0.04);
    EXPECT_LT(worstPx(*fit, picture) * kPitch, 3 * fit->sigma);
}

TEST(TagFit, LightThatFallsFromAsideMovesNothing) {
    MadePicture picture = made(6, 0.4, 1, 6);
    for (TagPixel& pixel : picture.pixels) {
        pixel.grey *= 1 + 8 * pixel.at.x();
    }
    const auto fit = fittedTag(tagCells(kNumber), picture.pixels, kPitch, moved(picture.corners, 0.5));
    ASSERT_TRUE(fit);
    EXPECT_LT(worstPx(*fit, picture), 0.06);
}

TEST(TagFit, WhiteThatSpreadsMovesNothing) {
    MadePicture picture = made(6, 0.4, 0, 7);
    for (TagPixel& pixel : picture.pixels) {
        pixel.grey = 255 * std::pow(pixel.grey / 255, 1 / 2.2);
    }
    const auto fit = fittedTag(tagCells(kNumber), picture.pixels, kPitch, moved(picture.corners, 0.5));
    ASSERT_TRUE(fit);
    EXPECT_LT(worstPx(*fit, picture), 0.06);
}

TEST(TagFit, ATagOfAnotherNumberIsNone) {
    const MadePicture picture = made(6, 0, 1, 8);
    EXPECT_FALSE(fittedTag(tagCells(kNumber + 1), picture.pixels, kPitch, picture.corners));
}

TEST(TagFit, ATagThatIsHalfCoveredIsNone) {
    MadePicture picture = made(6, 0, 1, 9);
    for (TagPixel& pixel : picture.pixels) {
        pixel.grey = pixel.at.x() > 0 ? 120 : pixel.grey;
    }
    EXPECT_FALSE(fittedTag(tagCells(kNumber), picture.pixels, kPitch, picture.corners));
}

TEST(TagFit, NothingIsNoTag) {
    EXPECT_FALSE(fittedTag(tagCells(1), {}, kPitch, {}));
    std::vector<TagPixel> even(400);
    for (std::size_t i = 0; i < even.size(); ++i) {
        even[i] = {{kPitch * static_cast<double>(i % 20), kPitch * static_cast<double>(i / 20)}, 128};
    }
    const double side = 20 * kPitch;
    EXPECT_FALSE(fittedTag(tagCells(1), even, kPitch,
                           {Eigen::Vector2d(0, 0), Eigen::Vector2d(side, 0), Eigen::Vector2d(side, side),
                            Eigen::Vector2d(0, side)}));
    EXPECT_FALSE(fittedTag(tagCells(1), even, kPitch, {})); // All corners at one place.
}

} // namespace spherewalk::photo
