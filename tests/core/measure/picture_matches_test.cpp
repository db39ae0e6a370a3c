// SPDX-License-Identifier: GPL-3.0-or-later
#include "random.h"

#include "spherewalk/measure/picture_matches.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace spherewalk::measure {

namespace {

/// Squares of all sizes and shades, moved.
RgbImage squares(unsigned seed, int right, int down) {
    test::Random random(seed);
    RgbImage picture(320, 240);
    for (int i = 0; i < 400; ++i) {
        const int x = random.integer(10, 290) + right;
        const int y = random.integer(10, 210) + down;
        const int size = random.integer(3, 12);
        const auto grey = static_cast<std::uint8_t>(random.integer(60, 255));
        for (int v = y; v < std::min(240, y + size); ++v) {
            for (int u = x; u < std::min(320, x + size); ++u) {
                std::fill_n(picture.at(u, v), 3, grey);
            }
        }
    }
    return picture;
}

} // namespace

TEST(PictureMatches, SayWhereAThingIsInBoth) {
    const auto matches = pictureMatches(PictureFeatures(squares(1, 0, 0)), PictureFeatures(squares(1, 9, 4)));
    ASSERT_GT(matches.size(), 50U);
    const auto right = std::count_if(matches.begin(), matches.end(), [](const PictureMatch& match) {
        return (match.inB - match.inA - Eigen::Vector2d(9, 4)).norm() < 1;
    });
    EXPECT_GT(static_cast<double>(right), 0.9 * static_cast<double>(matches.size()));
}

TEST(PictureMatches, AreOnlyOfThingsWithinReach) {
    const PictureFeatures a(squares(1, 0, 0));
    const PictureFeatures b(squares(1, 9, 4));
    for (const PictureMatch& match : pictureMatches(a, b, 5)) {
        EXPECT_LE((match.inB - match.inA).norm(), 5.001);
    }
    EXPECT_GE(pictureMatches(a, b, 12).size(), pictureMatches(a, b).size());
}

TEST(PictureMatches, AreNoneWithoutTexture) {
    const PictureFeatures none(RgbImage(64, 64));
    EXPECT_TRUE(pictureMatches(none, PictureFeatures(squares(1, 0, 0)), 5).empty());
    EXPECT_TRUE(pictureMatches(none, none).empty());
}

} // namespace spherewalk::measure
