// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "made/noise_photo.h"

#include "spherewalk/align/features.h"
#include "spherewalk/align/match_pairs.h"
#include "spherewalk/jpeg/jpeg.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stop_token>

namespace spherewalk::align {

using test::expectError;
using test::noisePhoto;

namespace {

constexpr double kPi = std::numbers::pi;

FeatureOptions smallOptions() {
    FeatureOptions options;
    options.width = 512;
    options.most = 600;
    return options;
}

Eigen::Quaterniond turnBy(double degrees, const Eigen::Vector3d& axis) {
    return Eigen::Quaterniond(Eigen::AngleAxisd(degrees * kPi / 180, axis));
}

/// Of b's features, the share that a shows too within the angle, once turned into its frame.
double shareFoundAgain(const Features& a, const Features& b, const Eigen::Quaterniond& aFromB,
                       double withinRad) {
    int found = 0;
    for (const Eigen::Vector3f& inB : b.bearings) {
        const Eigen::Vector3d expected = aFromB * inB.cast<double>();
        found += std::any_of(a.bearings.begin(), a.bearings.end(), [&](const Eigen::Vector3f& inA) {
            return (inA.cast<double>() - expected).norm() < withinRad;
        });
    }
    return static_cast<double>(found) / b.count();
}

std::string nameOf(const testing::TestParamInfo<Detector>& info) {
    return std::string(name(info.param));
}

} // namespace

class EachDetector : public testing::TestWithParam<Detector> {};

TEST_P(EachDetector, GivesUnitBearingsWithSigmasAndDescriptors) {
    FeatureOptions options = smallOptions();
    options.detector = GetParam();
    const Features features = detectFeatures(noisePhoto(Eigen::Quaterniond::Identity()), options);
    ASSERT_GT(features.count(), 300);
    ASSERT_LE(features.count(), options.most);
    const auto count = static_cast<std::size_t>(features.count());
    ASSERT_EQ(features.sigmasRad.size(), count);
    ASSERT_EQ(features.responses.size(), count);
    ASSERT_EQ(features.descriptors.size(), count * static_cast<std::size_t>(features.descriptorBytes));
    const double pixelRad = 2 * kPi / options.width;
    for (std::size_t i = 0; i < count; ++i) {
        ASSERT_NEAR(features.bearings[i].norm(), 1, 1e-6);
        ASSERT_GE(features.bearings[i].z(), std::sin(options.lowestElevation.value()) - 1e-6);
        ASSERT_GT(features.sigmasRad[i], 0.01 * pixelRad);
        ASSERT_LT(features.sigmasRad[i], 4 * pixelRad);
    }
}

/// An offset of the detector's own points up in one photo and down in the other.
TEST_P(EachDetector, HasNoBiasBetweenAPhotoAndTheSameUpsideDown) {
    FeatureOptions options = smallOptions();
    options.detector = GetParam();
    options.lowestElevation = Degrees(-90);
    const Eigen::Quaterniond rolled = turnBy(180, Eigen::Vector3d::UnitX());
    const Features a = detectFeatures(noisePhoto(Eigen::Quaterniond::Identity()), options);
    const Features b = detectFeatures(noisePhoto(rolled), options);
    const auto matches = matchFeatures(a, b, {});
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    int count = 0;
    const double pixelRad = 2 * kPi / options.width;
    for (const Correspondence& match : matches) {
        const Eigen::Vector3d inA = rolled * match.inB;
        if ((inA - match.inA).norm() < 2 * pixelRad && std::abs(inA.z()) < 0.7) {
            const SphericalDirection from = sphericalDirection(match.inA);
            const SphericalDirection to = sphericalDirection(inA);
            sum += Eigen::Vector2d(wrapped(to.azimuth - from.azimuth).value(),
                                   (to.elevation - from.elevation).value());
            ++count;
        }
    }
    ASSERT_GT(count, 100);
    const Eigen::Vector2d biasPx = sum / count / pixelRad / 2; // it is in both
    EXPECT_LT(std::abs(biasPx.x()), 0.03);
    EXPECT_LT(std::abs(biasPx.y()), 0.03);
}

TEST_P(EachDetector, FindsNothingInABlackPhoto) {
    FeatureOptions options = smallOptions();
    options.detector = GetParam();
    EXPECT_EQ(detectFeatures(RgbImage(1024, 512), options).count(), 0);
}

INSTANTIATE_TEST_SUITE_P(Features, EachDetector,
                         testing::Values(Detector::Sift, Detector::Akaze, Detector::Orb), nameOf);

TEST(Features, AreTheSameWhereverTheSeamIs) {
    FeatureOptions options = smallOptions();
    options.most = 3000;
    const Eigen::Quaterniond turned = turnBy(180, Eigen::Vector3d::UnitZ());
    const Features a = detectFeatures(noisePhoto(Eigen::Quaterniond::Identity()), options);
    const Features b = detectFeatures(noisePhoto(turned), options);
    EXPECT_NEAR(a.count(), b.count(), 0.02 * a.count());
    const double withinRad = 0.1 * 2 * kPi / options.width;
    EXPECT_GT(shareFoundAgain(a, b, turned, withinRad), 0.95);
    EXPECT_GT(shareFoundAgain(b, a, turned.conjugate(), withinRad), 0.95);
}

TEST(Features, AreFoundAllAroundTheSphereAndEvenly) {
    FeatureOptions options = smallOptions();
    options.lowestElevation = Degrees(-90);
    const Features features = detectFeatures(noisePhoto(Eigen::Quaterniond::Identity()), options);
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Eigen::Vector3f& bearing : features.bearings) {
        spread += bearing.cast<double>() * bearing.cast<double>().transpose() / features.count();
    }
    EXPECT_LT((spread - Eigen::Matrix3d::Identity() / 3).cwiseAbs().maxCoeff(), 0.05);
}

TEST(Features, OfTheFirstHalfAreSpreadAsAll) {
    const Features features = detectFeatures(noisePhoto(Eigen::Quaterniond::Identity()), smallOptions());
    for (int octant = 0; octant < 8; ++octant) {
        const auto isThere = [octant](const Eigen::Vector3f& bearing) {
            return static_cast<int>((std::atan2(bearing.y(), bearing.x()) / kPi + 1) * 3.999) == octant;
        };
        const auto half = features.bearings.begin() + features.count() / 2;
        const auto inFirst = std::count_if(features.bearings.begin(), half, isThere);
        const auto inAll = std::count_if(features.bearings.begin(), features.bearings.end(), isThere);
        EXPECT_NEAR(static_cast<double>(inFirst), static_cast<double>(inAll) / 2, 12) << "octant " << octant;
    }
}

TEST(Features, KeepOutOfTheMask) {
    const FeatureOptions options = smallOptions();
    MaskImage mask(64, 32);
    std::fill(mask.values().begin(), mask.values().end(), std::uint8_t{255});
    for (int y = 0; y < mask.height(); ++y) {
        std::fill_n(mask.at(0, y), 32, std::uint8_t{0}); // the left half: azimuth above 0
    }
    const Features features = detectFeatures(noisePhoto(Eigen::Quaterniond::Identity()), options, mask);
    ASSERT_GT(features.count(), 200);
    EXPECT_TRUE(std::all_of(features.bearings.begin(), features.bearings.end(),
                            [](const Eigen::Vector3f& bearing) { return bearing.y() < 0; }));
}

TEST(Features, OfAJpegDecodedSmallAreThoseOfThePicture) {
    const FeatureOptions options = smallOptions();
    const RgbImage photo = noisePhoto(Eigen::Quaterniond::Identity());
    const Features ofPicture = detectFeatures(photo, options);
    const Features ofJpeg = detectFeatures(jpeg::encode(photo, 95), "a photo", options);
    EXPECT_GT(
        shareFoundAgain(ofPicture, ofJpeg, Eigen::Quaterniond::Identity(), 0.3 * 2 * kPi / options.width),
        0.8);
}

TEST(Features, AreTheSameEachTime) {
    const RgbImage photo = noisePhoto(Eigen::Quaterniond::Identity());
    EXPECT_EQ(detectFeatures(photo, smallOptions()), detectFeatures(photo, smallOptions()));
}

TEST(Features, RefuseOptionsOutOfRange) {
    FeatureOptions options;
    options.width = 1000;
    expectError(ErrorKind::InvalidInput, "width", [&] { options.validate(); });
    options = {};
    options.most = 0;
    expectError(ErrorKind::InvalidInput, "most", [&] { options.validate(); });
    options = {};
    options.leastContrast = std::nan("");
    expectError(ErrorKind::InvalidInput, "leastContrast", [&] { options.validate(); });
    options = {};
    options.lowestElevation = Radians(std::nan(""));
    expectError(ErrorKind::InvalidInput, "lowestElevation", [&] { options.validate(); });
}

TEST(Features, RefuseATinyPicture) {
    expectError(ErrorKind::InvalidInput, "64 x 32",
                [] { detectFeatures(RgbImage(10, 5), FeatureOptions()); });
}

TEST(Features, AreNotLookedForAfterAStop) {
    std::stop_source stop;
    stop.request_stop();
    expectError(ErrorKind::Stopped, "",
                [&] { detectFeatures(RgbImage(1024, 512), FeatureOptions(), {}, stop.get_token()); });
}

} // namespace spherewalk::align
