// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/bytes.h"
#include "spherewalk/base/image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace spherewalk {
namespace {

TEST(Image, BeginsWithZeros) {
    const RgbImage picture(5, 3);
    EXPECT_EQ(picture.values().size(), 45);
    EXPECT_TRUE(std::ranges::all_of(picture.values(), [](int value) { return value == 0; }));
    EXPECT_TRUE(RgbImage().empty());
    EXPECT_TRUE(RgbImage(4, 0).empty());
}

TEST(Image, HasRowsOneAfterTheOther) {
    RgbaImage picture(7, 4);
    std::iota(picture.values().begin(), picture.values().end(), std::uint8_t{0});
    for (int y = 0; y < picture.height(); ++y) {
        EXPECT_EQ(picture.row(y).size(), 28);
        EXPECT_EQ(picture.row(y).data(), picture.at(0, y));
        for (int x = 0; x < picture.width(); ++x) {
            EXPECT_EQ(picture.at(x, y)[2], 4 * (7 * y + x) + 2);
        }
    }
    const RgbaImage& constant = picture;
    EXPECT_EQ(constant.row(3).back(), 111);
}

TEST(Image, IsEqualOnlyToOneOfTheSameShape) {
    DepthImage picture(6, 2);
    EXPECT_EQ(picture, DepthImage(6, 2));
    EXPECT_NE(picture, DepthImage(2, 6));
    EXPECT_NE(picture, DepthImage(3, 4));
    picture.at(5, 1)[0] = 0.5F;
    EXPECT_NE(picture, DepthImage(6, 2));
}

TEST(Bytes, AreViewedAsTextAndBack) {
    const std::string_view words("h\0\xc3\xa9", 4);
    const ByteView bytes = bytesOf(words);
    EXPECT_EQ(bytes.size(), 4);
    EXPECT_EQ(bytes[3], 0xa9);
    EXPECT_EQ(textOf(bytes), words);
    EXPECT_TRUE(textOf({}).empty());
}

} // namespace
} // namespace spherewalk
