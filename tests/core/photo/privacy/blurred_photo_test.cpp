// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"

#include "spherewalk/base/file.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/photo/blurred_photo.h"
#include "spherewalk/photo/metadata.h"
#include "spherewalk/practice/theta_jpeg.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace spherewalk::photo {
namespace {

using survey::PrivateRegion;

constexpr EquirectSize kSize{1024, 512};

PrivateRegion regionAt(double azimuthDeg, double elevationDeg, double sizeDeg = 30) {
    return {Degrees(azimuthDeg), Degrees(elevationDeg), Degrees(sizeDeg), Degrees(sizeDeg)};
}

/// Grey noise in patches of 4 x 4 pixels, which JPEG keeps.
RgbImage noise() {
    RgbImage picture(kSize.width, kSize.height);
    std::mt19937 random(5);
    for (int y = 0; y < kSize.height; y += 4) {
        for (int x = 0; x < kSize.width; x += 4) {
            const auto value = static_cast<std::uint8_t>(random() % 256);
            for (int i = 0; i < 16; ++i) {
                std::fill_n(picture.at(x + i % 4, y + i / 4), 3, value);
            }
        }
    }
    return picture;
}

/// Mean square of the difference between neighbours along a row, in and out of the region.
double sharpness(const RgbImage& picture, const PrivateRegion& region) {
    const survey::RegionFrame frame(region);
    double sum = 0;
    int count = 0;
    for (int y = 0; y < kSize.height; ++y) {
        for (int x = 0; x < kSize.width; ++x) {
            const int next = (x + 1) % kSize.width;
            if (frame.contains(direction(kSize, Eigen::Vector2d(x, y))) &&
                frame.contains(direction(kSize, Eigen::Vector2d(next, y)))) {
                sum += std::pow(picture.at(x, y)[1] - picture.at(next, y)[1], 2);
                ++count;
            }
        }
    }
    return sum / std::max(1, count);
}

} // namespace

TEST(BlurRegions, LeavesNothingSharpAtPolesAndSeam) {
    for (const PrivateRegion& region :
         {regionAt(0, 0), regionAt(180, 10), regionAt(-179, -20), regionAt(40, 90), regionAt(-100, -88),
          regionAt(10, 60, 150), regionAt(77, 45, 4)}) {
        RgbImage picture = noise();
        const double before = sharpness(picture, region);
        const MaskImage changed = blurRegions(picture, std::array{region});
        EXPECT_LT(sharpness(picture, region), 0.01 * before) << Degrees(region.azimuth).value();
        const RgbImage original = noise();
        const survey::RegionFrame frame(region);
        int outside = 0;
        for (int y = 0; y < kSize.height; ++y) {
            for (int x = 0; x < kSize.width; ++x) {
                const bool isIn = frame.contains(direction(kSize, Eigen::Vector2d(x, y)));
                EXPECT_EQ(*changed.at(x, y) != 0, isIn) << x << " " << y;
                outside +=
                    !isIn && !std::equal(picture.at(x, y), picture.at(x, y) + 3, original.at(x, y)) ? 1 : 0;
            }
        }
        EXPECT_EQ(outside, 0) << "only the region changes";
    }
}

TEST(BlurredPhoto, KeepsWhatTheCameraSaysAndNoThumbnail) {
    for (const auto order : {practice::ThetaTags::ByteOrder::Big, practice::ThetaTags::ByteOrder::Little}) {
        practice::ThetaTags tags;
        tags.byteOrder = order;
        const Bytes original = practice::thetaJpeg(noise(), tags);
        const PrivateRegion region = regionAt(60, 0);
        const Bytes blurred = blurredPhoto(original, std::array{region}, "photo");
        EXPECT_EQ(readMetadata(blurred, "blurred"), readMetadata(original, "original"));
        const auto pictures = [](ByteView bytes) {
            int count = 0;
            for (std::size_t i = 0; i + 2 < bytes.size(); ++i) {
                count += bytes[i] == 0xFF && bytes[i + 1] == jpeg::kSoi && bytes[i + 2] == 0xFF ? 1 : 0;
            }
            return count;
        };
        EXPECT_EQ(pictures(original), 2) << "the photo and its thumbnail";
        EXPECT_EQ(pictures(blurred), 1);
        const RgbImage before = jpeg::decode(original, "original");
        const RgbImage after = jpeg::decode(blurred, "blurred");
        EXPECT_LT(sharpness(after, region), 0.02 * sharpness(before, region));
        int different = 0;
        for (int y = 0; y < kSize.height; ++y) { // the half that looks away
            different += std::equal(before.at(600, y), before.at(1000, y), after.at(600, y)) ? 0 : 1;
        }
        EXPECT_EQ(different, 0) << "other blocks keep their coefficients";
    }
}

TEST(BlurredPhoto, DropsWhatElseMayHoldAPicture) {
    Bytes photo = jpeg::encode(noise(), 90);
    const Bytes hidden = jpeg::encode(RgbImage(16, 16), 50);
    for (const std::uint8_t marker : {0xE0, 0xE2, 0xED, 0xFE}) {
        const std::size_t length = hidden.size() + 2;
        Bytes segment{0xFF, marker, static_cast<std::uint8_t>(length >> 8U),
                      static_cast<std::uint8_t>(length)};
        segment.insert(segment.end(), hidden.begin(), hidden.end());
        photo.insert(photo.begin() + 2, segment.begin(), segment.end());
    }
    photo.insert(photo.end(), hidden.begin(), hidden.end());
    const Bytes blurred = blurredPhoto(photo, std::array{regionAt(0, 0)}, "photo");
    EXPECT_EQ(std::search(blurred.begin(), blurred.end(), hidden.begin(), hidden.end()), blurred.end());
    EXPECT_EQ(jpeg::decode(blurred, "blurred").width(), kSize.width);
}

TEST(BlurredPhoto, StaysByteForByteWithoutRegions) {
    const Bytes photo = practice::thetaJpeg(noise(), {});
    EXPECT_EQ(blurredPhoto(photo, {}, "photo"), photo);
}

TEST(BlurredPhoto, BlursGreyPhotosToo) {
    const Bytes grey = readFile(SPHEREWALK_TEST_DATA "/faces/grey.jpg");
    const PrivateRegion region = regionAt(0, 0, 60);
    const RgbImage after = jpeg::decode(blurredPhoto(grey, std::array{region}, "grey.jpg"), "blurred");
    RgbImage expected = jpeg::decode(grey, "grey.jpg");
    blurRegions(expected, std::array{region});
    EXPECT_EQ(after.width(), expected.width());
    EXPECT_NEAR(*after.at(after.width() / 2, after.height() / 2),
                *expected.at(expected.width() / 2, expected.height() / 2), 6);
}

} // namespace spherewalk::photo
