// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"
#include "made_jpeg.h"

#include "spherewalk/jpeg/jpeg.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>

namespace spherewalk {
namespace {

double meanDifference(const RgbImage& a, const RgbImage& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.values().size(); ++i) {
        sum += std::abs(a.values()[i] - b.values()[i]);
    }
    return sum / static_cast<double>(a.values().size());
}

TEST(Jpeg, EncodingKeepsThePictureWithinItsQuality) {
    const RgbImage picture = test::madePicture(120, 75);
    const RgbImage read = jpeg::decode(jpeg::encode(picture, 95), "a.jpg");
    ASSERT_EQ(read.width(), 120);
    ASSERT_EQ(read.height(), 75);
    EXPECT_LT(meanDifference(picture, read), 6);
    EXPECT_GT(meanDifference(picture, jpeg::decode(jpeg::encode(picture, 20), "a.jpg")),
              meanDifference(picture, read));
}

TEST(Jpeg, KeepsRedGreenAndBlueInOrder) {
    RgbImage picture(16, 16);
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 16; ++x) {
            picture.at(x, y)[0] = 200;
            picture.at(x, y)[1] = 100;
            picture.at(x, y)[2] = 20;
        }
    }
    const RgbImage read = jpeg::decode(jpeg::encode(picture, 95), "a.jpg");
    EXPECT_NEAR(read.at(8, 8)[0], 200, 3);
    EXPECT_NEAR(read.at(8, 8)[1], 100, 3);
    EXPECT_NEAR(read.at(8, 8)[2], 20, 3);
}

TEST(Jpeg, EncodesBaseline420) {
    const jpeg::Info info = jpeg::readInfo(jpeg::encode(test::madePicture(37, 21), 90), "a.jpg");
    EXPECT_EQ(info.width, 37);
    EXPECT_EQ(info.height, 21);
    EXPECT_EQ(info.components, 3);
    EXPECT_EQ(info.mcuWidth, 16);
    EXPECT_EQ(info.mcuHeight, 16);
    EXPECT_EQ(info.restartInterval, 0);
    EXPECT_FALSE(info.progressive);
}

TEST(Jpeg, InfoTellsSamplingAndKind) {
    const RgbImage picture = test::madePicture(40, 40);
    const auto info = [&](const test::JpegForm& form) {
        return jpeg::readInfo(test::madeJpeg(picture, form), "a.jpg");
    };
    EXPECT_EQ(info({.isGrey = true}).components, 1);
    EXPECT_EQ(info({.isGrey = true}).mcuWidth, 8);
    EXPECT_EQ(info({.vertical = 1}).mcuWidth, 16);
    EXPECT_EQ(info({.vertical = 1}).mcuHeight, 8);
    EXPECT_EQ(info({.horizontal = 1, .vertical = 1}).mcuWidth, 8);
    EXPECT_TRUE(info({.isProgressive = true}).progressive);
    EXPECT_EQ(info({.restartInterval = 5}).restartInterval, 5);
}

/// All pixels of the right lower quarter.
MaskImage rightLowerQuarter(int width, int height) {
    MaskImage where(width, height);
    for (int y = height / 2; y < height; ++y) {
        for (int x = width / 2; x < width; ++x) {
            *where.at(x, y) = 255;
        }
    }
    return where;
}

TEST(Jpeg, PixelsAreReplacedWhereTheyShallAndNowhereElse) {
    const RgbImage picture = test::madePicture(160, 96);
    RgbImage other(160, 96);
    std::fill(other.values().begin(), other.values().end(), std::uint8_t{200});
    for (const bool isProgressive : {false, true}) {
        for (const int sampling : {1, 2}) {
            const Bytes before = test::madeJpeg(
                picture, {.horizontal = sampling, .vertical = sampling, .isProgressive = isProgressive});
            const Bytes after = jpeg::withPixels(before, other, rightLowerQuarter(160, 96), "a.jpg");
            const RgbImage old = jpeg::decode(before, "a.jpg");
            const RgbImage read = jpeg::decode(after, "a.jpg");
            // The quarter begins where a unit of 16 pixels does; colours reach over by a pixel.
            for (int y = 0; y < 96; ++y) {
                for (int x = 0; x < 160; ++x) {
                    const bool isInside = x >= 80 && y >= 48;
                    const bool isBeside = x >= 78 && y >= 46;
                    if (!isBeside) {
                        ASSERT_TRUE(std::equal(read.at(x, y), read.at(x, y) + 3, old.at(x, y)))
                            << x << " " << y;
                    } else if (isInside && x > 81 && y > 49) {
                        ASSERT_NEAR(read.at(x, y)[1], 200, 4) << x << " " << y;
                    }
                }
            }
        }
    }
}

TEST(Jpeg, ReplacingNothingKeepsAllCoefficientsAndSegments) {
    const Bytes before = jpeg::encode(test::madePicture(75, 37), 90);
    const Bytes after = jpeg::withPixels(before, RgbImage(75, 37), MaskImage(75, 37), "a.jpg");
    EXPECT_EQ(jpeg::decode(after, "a.jpg"), jpeg::decode(before, "a.jpg"));
    EXPECT_EQ(jpeg::segments(after, "a.jpg").size(), jpeg::segments(before, "a.jpg").size());
}

TEST(Jpeg, PixelsOfAnotherSizeAndGreyPicturesAreRefused) {
    const RgbImage picture = test::madePicture(64, 32);
    const MaskImage where(64, 32);
    const Bytes grey = test::madeJpeg(picture, {.isGrey = true});
    test::expectError(ErrorKind::Unsupported, "it is grey",
                      [&] { jpeg::withPixels(grey, picture, where, "a.jpg"); });
    const Bytes colour = jpeg::encode(picture, 90);
    test::expectError(ErrorKind::InvalidInput, "its size is 64 x 32",
                      [&] { jpeg::withPixels(colour, RgbImage(62, 31), where, "a.jpg"); });
    Bytes cut(colour.begin(), colour.begin() + static_cast<std::ptrdiff_t>(colour.size() / 2));
    test::expectError(ErrorKind::Corrupt, "replace a part of a.jpg",
                      [&] { jpeg::withPixels(cut, picture, where, "a.jpg"); });
}

TEST(Jpeg, GreyBecomesEqualRedGreenAndBlue) {
    const RgbImage read = jpeg::decode(test::madeJpeg(test::madePicture(19, 11), {.isGrey = true}), "a.jpg");
    for (int y = 0; y < 11; ++y) {
        for (int x = 0; x < 19; ++x) {
            EXPECT_EQ(read.at(x, y)[0], read.at(x, y)[1]);
            EXPECT_EQ(read.at(x, y)[0], read.at(x, y)[2]);
        }
    }
}

TEST(Jpeg, ReducedSizesAreRoundedUp) {
    const Bytes bytes = jpeg::encode(test::madePicture(41, 17), 90);
    for (const int denominator : {1, 2, 4, 8}) {
        const RgbImage read = jpeg::decode(bytes, "a.jpg", denominator);
        EXPECT_EQ(read.width(), (41 + denominator - 1) / denominator);
        EXPECT_EQ(read.height(), (17 + denominator - 1) / denominator);
    }
}

TEST(Jpeg, RefusesWhatCannotBeAsked) {
    const Bytes bytes = jpeg::encode(test::madePicture(16, 16), 90);
    test::expectError(ErrorKind::InvalidInput, "not by 3", [&] { jpeg::decode(bytes, "a.jpg", 3); });
    test::expectError(ErrorKind::InvalidInput, "quality 0", [] { jpeg::encode(RgbImage(8, 8), 0); });
    test::expectError(ErrorKind::InvalidInput, "quality 101", [] { jpeg::encode(RgbImage(8, 8), 101); });
    test::expectError(ErrorKind::InvalidInput, "0 x 0", [] { jpeg::encode(RgbImage(), 90); });
    test::expectError(ErrorKind::InvalidInput, "65501 x 1", [] { jpeg::encode(RgbImage(65501, 1), 90); });
}

} // namespace
} // namespace spherewalk
