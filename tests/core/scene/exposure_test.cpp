// SPDX-License-Identifier: GPL-3.0-or-later
#include "sweep_cost.h"

#include "spherewalk/practice/practice_room.h"
#include "spherewalk/render/colour_correction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace spherewalk::scene {

namespace {

RgbImage photoAt(double x, double y) {
    return practice::PracticeRoom().spherical({Eigen::Quaterniond::Identity(), {x, y, 1.2}}, {256, 128});
}

RgbImage times(RgbImage picture, const Gains& gains) {
    for (std::size_t i = 0; i < picture.values().size(); ++i) {
        const float value = std::round(gains[i % 3] * static_cast<float>(picture.values()[i]));
        picture.values()[i] = static_cast<std::uint8_t>(std::min(255.0F, value));
    }
    return picture;
}

/// A photo of the practice room with its true depth.
struct Known {
    Known(double x, double y, double yaw, const Gains& gains)
        : pose{Eigen::Quaterniond(Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ())), {x, y, 1.2}} {
        const practice::PracticeRoom room;
        picture = times(room.spherical(pose, {256, 128}), gains);
        const DepthImage range = room.sphericalRange(pose, {256, 128});
        depth = {Image<float, 1>(256, 128), MaskImage(256, 128)};
        for (std::size_t i = 0; i < range.values().size(); ++i) {
            depth.inverseM.values()[i] = 1 / range.values()[i];
            depth.sure.values()[i] = 255;
        }
    }

    KnownPhoto photo() const { return {{&picture, pose}, &depth}; }

    Rigid3 pose;
    RgbImage picture;
    PhotoDepth depth;
};

/// turn: of the other photo.
Gains gains(const RgbImage& photo, const RgbImage& other,
            const Eigen::Quaterniond& turn = Eigen::Quaterniond::Identity()) {
    const PosedPicture turned{&other, {turn, Eigen::Vector3d::Zero()}};
    return gainsTo({&photo, {}}, {&turned, 1}).front();
}

} // namespace

TEST(ExposureBySurfaces, IsRightToHalfAPercentAStepAway) {
    const Gains darker{0.6F, 0.75F, 0.9F};
    const Known one(2.0, 1.6, 0.4, {1, 1, 1});
    const Known other(2.8, 2.2, -0.9, darker);
    const auto light = sharedLight(one.photo(), other.photo());
    ASSERT_TRUE(light);
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(light->gains[c] * darker[c], 1, 0.005) << c;
    }
}

// Nearly half of what both photos show is a wall 35 cm away, of which each shows another place in a
// direction.
TEST(ExposureByDistances, IsRightToAPercentBesideAWall) {
    practice::PracticeRoomOptions options;
    options.style = practice::RoomStyle::Flat;
    options.sizeM = {8, 6, 2.5};
    const practice::PracticeRoom flat(options);
    const Gains darker{0.96F, 0.97F, 0.98F};
    const Rigid3 pose{Eigen::Quaterniond::Identity(), {3.6, 2.6, 1.2}};
    const Rigid3 aside{Eigen::Quaterniond::Identity(), {3.6, 1.8, 1.2}};
    const RgbImage picture = flat.spherical(pose, {256, 128});
    const RgbImage other = times(flat.spherical(aside, {256, 128}), darker);
    Image<float, 1> inverseM(256, 128);
    const DepthImage range = flat.sphericalRange(pose, {256, 128});
    std::transform(range.values().begin(), range.values().end(), inverseM.values().begin(),
                   [](float m) { return 1 / m; });
    const PosedPicture posed{&other, aside};
    const Gains near = gainsTo({&picture, pose}, inverseM, {&posed, 1}).front();
    const Gains alongDirections = gainsTo({&picture, pose}, {&posed, 1}).front();
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(near[c] * darker[c], 1, 0.01) << c;
        EXPECT_GT(std::abs(alongDirections[c] * darker[c] - 1), 0.015) << c; // else this tests nothing
    }
}

TEST(ToldGains, FollowThePowerOfLightAndAreNoneWhereNothingDiffers) {
    const auto gains = toldGains(std::vector<std::optional<double>>{-3, std::nullopt, -1});
    ASSERT_TRUE(gains[0] && gains[2]);
    EXPECT_FALSE(gains[1]);
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR((*gains[0])[c] / (*gains[2])[c], std::pow(4, 1 / 2.2), 1e-5);
    }
    // A camera that states the same always does not tell how its photos differ.
    EXPECT_EQ(toldGains(std::vector<std::optional<double>>{-2, -2, std::nullopt}),
              std::vector<std::optional<Gains>>(3));
    EXPECT_TRUE(toldGains({}).empty());
}

// Behind a wall, a photo shows something else at whatever distance.
TEST(ExposureByDistances, FollowsTheSettingsWherePlacesDiffer) {
    const Gains darker{0.5F, 0.5F, 0.5F};
    const Known one(2.0, 1.6, 0.4, {1, 1, 1});
    const Known beside(2.8, 2.2, -0.9, darker);
    practice::PracticeRoomOptions options;
    options.style = practice::RoomStyle::Flat;
    options.sizeM = {8, 6, 2.5};
    const RgbImage elsewhere =
        times(practice::PracticeRoom(options).spherical(beside.pose, {256, 128}), darker);
    const auto off = [&](const RgbImage& picture, const std::optional<Gains>& told) {
        PosedPicture photo = one.photo().photo;
        photo.gains = Gains{1, 1, 1};
        PosedPicture its{&picture, beside.pose};
        its.gains = told;
        return std::abs(gainsTo(photo, one.depth.inverseM, {&its, 1}).front()[1] * darker[1] - 1);
    };
    const Gains right{2, 2, 2};
    EXPECT_GT(off(elsewhere, std::nullopt), 0.1); // else this tests nothing
    EXPECT_LT(off(elsewhere, right), 0.7 * off(elsewhere, std::nullopt));
    EXPECT_LT(off(beside.picture, right), 0.01);
    EXPECT_LT(off(beside.picture, Gains{1, 1, 1}), 0.05); // where places agree, wrong settings do little
}

TEST(ExposureByDistances, FollowsPlacesAlsoBesideAPhotoWhoseSettingsAreNotKnown) {
    const Gains darker{0.5F, 0.5F, 0.5F};
    const Known one(2.0, 1.6, 0.4, {1, 1, 1});
    const Known beside(2.8, 2.2, -0.9, darker);
    PosedPicture photo = one.photo().photo;
    photo.gains = Gains{1, 1, 1};
    std::vector<PosedPicture> others(2, beside.photo().photo);
    others[0].gains = Gains{1.5F, 1.5F, 1.5F};
    for (const Gains& gains : gainsTo(photo, one.depth.inverseM, others)) {
        EXPECT_NEAR(gains[1] * darker[1], 1, 0.03);
    }
}

TEST(ExposureBySurfaces, IsWhatTheSettingsTellWhereNothingIsShared) {
    Known one(2.0, 1.6, 0.4, {1, 1, 1});
    const Known other(2.8, 2.2, -0.9, {1, 1, 1});
    std::fill(one.depth.sure.values().begin(), one.depth.sure.values().end(), std::uint8_t{0});
    KnownPhoto photo = one.photo();
    KnownPhoto its = other.photo();
    EXPECT_FALSE(sharedLight(photo, its));
    photo.photo.gains = Gains{1, 1, 1};
    its.photo.gains = Gains{1.5F, 1.5F, 1.5F};
    const auto light = sharedLight(photo, its);
    ASSERT_TRUE(light);
    EXPECT_EQ(light->gains, *its.photo.gains);
    // What photos share counts twenty times as much.
    SharedLight measured;
    measured.gains = {1.2F, 1.2F, 1.2F};
    const auto gains = commonGains(2, std::vector<ExposureRatio>{{0, 1, *light}, {0, 1, measured}});
    EXPECT_NEAR(gains[1][0] / gains[0][0], std::exp((20 * std::log(1.2) + std::log(1.5)) / 21), 1e-5);
}

// Four photos as a camera develops them whose values end softly at white.
TEST(HighlightRolloff, IsFoundToThreeHundredthsAndIsNoneWhereValuesAreCut) {
    const std::vector<float> exposures{0.7F, 1, 1.4F, 0.9F};
    for (const double rolloff : {0.3, 0.2, 0.12, 0.0}) {
        std::vector<Known> photos;
        for (std::size_t i = 0; i < exposures.size(); ++i) {
            const auto step = static_cast<double>(i);
            Known& known = photos.emplace_back(2.0 + 0.3 * step, 1.6, 0.4 * step, Gains{1, 1, 1});
            for (std::uint8_t& value : known.picture.values()) {
                value = static_cast<std::uint8_t>(
                    render::exposedValue(value, static_cast<double>(exposures[i]), rolloff) + 0.5);
            }
        }
        std::vector<ExposureRatio> ratios;
        for (std::size_t i = 0; i < photos.size(); ++i) {
            for (std::size_t k = 0; k < photos.size(); ++k) {
                const auto light = i == k ? std::nullopt : sharedLight(photos[i].photo(), photos[k].photo());
                if (light) {
                    ratios.push_back({i, k, *light});
                }
            }
        }
        ASSERT_EQ(ratios.size(), 12U);
        const std::vector<Gains> gains = commonGains(photos.size(), ratios);
        EXPECT_NEAR(gains[1][1] / gains[2][1], exposures[2] / exposures[1], 0.03) << rolloff;
        EXPECT_NEAR(highlightRolloff(gains, ratios), rolloff, 0.03) << rolloff;
    }
    EXPECT_EQ(highlightRolloff({}, {}), 0);
}

TEST(ExposureBySurfaces, IsNotToldWithoutPlacesThatBothSee) {
    const Known one(2.0, 1.6, 0, {1, 1, 1});
    Known unsure(2.4, 1.6, 0, {1, 1, 1});
    std::fill(unsure.depth.sure.values().begin(), unsure.depth.sure.values().end(), std::uint8_t{0});
    EXPECT_FALSE(sharedLight(one.photo(), unsure.photo()));
    const Known dark(2.4, 1.6, 0, {0.01F, 0.01F, 0.01F});
    EXPECT_FALSE(sharedLight(one.photo(), dark.photo()));
    Known elsewhere(2.4, 1.6, 0, {1, 1, 1}); // its depths are of another room
    std::fill(elsewhere.depth.inverseM.values().begin(), elsewhere.depth.inverseM.values().end(), 5.0F);
    EXPECT_FALSE(sharedLight(one.photo(), elsewhere.photo()));
}

TEST(CommonGains, FitRatiosThatContradictEachOtherAndLeaveTheMeanAlone) {
    // Round the three photos, the logarithms add up to 0.03 instead of 0.
    const auto gain = [](double log) {
        const auto value = static_cast<float>(std::exp(log));
        return Gains{value, 1 / value, 1};
    };
    const std::vector<ExposureRatio> ratios{
        {0, 1, {gain(0.11)}}, {1, 2, {gain(0.21)}}, {2, 0, {gain(-0.29)}}};
    const std::vector<Gains> gains = commonGains(4, ratios);
    ASSERT_EQ(gains.size(), 4U);
    EXPECT_NEAR(std::log(gains[1][0] / gains[0][0]), 0.10, 1e-4);
    EXPECT_NEAR(std::log(gains[2][0] / gains[1][0]), 0.20, 1e-4);
    EXPECT_NEAR(std::log(gains[0][0] * gains[1][0] * gains[2][0]), 0, 1e-5);
    EXPECT_NEAR(std::log(gains[1][1] / gains[0][1]), -0.10, 1e-4);
    EXPECT_EQ(gains[1][2], 1);
    EXPECT_EQ(gains[3], (Gains{1, 1, 1})); // nothing joins it
}

TEST(CommonGains, OfAThousandPhotosInALineAreRight) {
    std::vector<ExposureRatio> ratios;
    for (std::size_t i = 0; i + 1 < 1000; ++i) {
        const float gain = i % 2 == 0 ? 1.25F : 0.8F;
        ratios.push_back({i, i + 1, {{gain, gain, gain}}});
    }
    const std::vector<Gains> gains = commonGains(1000, ratios);
    for (std::size_t i = 0; i + 1 < 1000; ++i) {
        ASSERT_NEAR(gains[i + 1][1] / gains[i][1], i % 2 == 0 ? 1.25 : 0.8, 1e-4) << i;
    }
}

TEST(CommonGains, OfNoPhotosAreNone) {
    EXPECT_TRUE(commonGains(0, {}).empty());
    EXPECT_EQ(commonGains(2, {}), (std::vector<Gains>(2, Gains{1, 1, 1})));
}

TEST(Exposure, LeavesPhotosOfOneExposureAsTheyAre) {
    const Gains found = gains(photoAt(2.5, 2), photoAt(2.9, 2.2));
    EXPECT_EQ(found, (Gains{1, 1, 1}));
}

TEST(Exposure, FindsWhatMakesPhotosAsBrightAsEachOther) {
    const Gains darker{0.6F, 0.7F, 0.8F};
    const Gains found = gains(photoAt(2.5, 2), times(photoAt(2.7, 2.1), darker));
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(found[c] * darker[c], 1, 0.04) << c;
    }
}

TEST(Exposure, GoesByWhatIsSeenWhenThePhotoWasTurned) {
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(1.1, Eigen::Vector3d::UnitZ()));
    const RgbImage turned = practice::PracticeRoom().spherical({turn, {2.6, 2.1, 1.2}}, {256, 128});
    const Gains darker{0.7F, 0.7F, 0.6F};
    const Gains found = gains(photoAt(2.5, 2), times(turned, darker), turn);
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(found[c] * darker[c], 1, 0.04) << c;
    }
}

TEST(Exposure, OfTheOtherPhotoIsTheReciprocal) {
    const RgbImage a = photoAt(2.5, 2);
    const RgbImage b = times(photoAt(2.6, 2), {0.6F, 0.7F, 0.8F});
    const Gains forth = gains(a, b);
    const Gains back = gains(b, a);
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_GT(forth[c], 1.1F) << c;
        EXPECT_NEAR(forth[c] * back[c], 1, 0.02) << c;
    }
}

TEST(Exposure, SaysNothingWhereAllIsBurnt) {
    RgbImage white(256, 128);
    std::fill(white.values().begin(), white.values().end(), std::uint8_t{255});
    EXPECT_EQ(gains(photoAt(2.5, 2), white), (Gains{1, 1, 1}));
}

TEST(Exposure, IsTheSameFromSmallerPicturesThatWereMadeBefore) {
    const RgbImage picture = practice::PracticeRoom().spherical({{}, {2.5, 2, 1.2}}, {512, 256});
    const RgbImage other =
        times(practice::PracticeRoom().spherical({{}, {2.7, 2.1, 1.2}}, {512, 256}), {0.6F, 0.7F, 0.8F});
    const PictureSizes sizes(picture);
    const PictureSizes otherSizes(other);
    const Gains each = gains(picture, other);
    const PosedPicture its{&otherSizes.largest(), {}, {}, &otherSizes};
    const Gains small = gainsTo({&sizes.largest(), {}, {}, &sizes}, {&its, 1}).front();
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(small[c], each[c], 0.01) << c;
    }
}

} // namespace spherewalk::scene
