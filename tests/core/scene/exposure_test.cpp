// SPDX-License-Identifier: GPL-3.0-or-later
#include "sweep_cost.h"

#include "spherewalk/practice/practice_room.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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

} // namespace

TEST(Exposure, LeavesPhotosOfOneExposureAsTheyAre) {
    const Gains gains = gainsTo(photoAt(2.5, 2), photoAt(2.9, 2.2), Eigen::Matrix3d::Identity());
    EXPECT_EQ(gains, (Gains{1, 1, 1}));
}

TEST(Exposure, FindsWhatMakesPhotosAsBrightAsEachOther) {
    const Gains darker{0.6F, 0.7F, 0.8F};
    const Gains gains =
        gainsTo(photoAt(2.5, 2), times(photoAt(2.7, 2.1), darker), Eigen::Matrix3d::Identity());
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(gains[c] * darker[c], 1, 0.04) << c;
    }
}

TEST(Exposure, GoesByWhatIsSeenWhenThePhotoWasTurned) {
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(1.1, Eigen::Vector3d::UnitZ()));
    const RgbImage turned = practice::PracticeRoom().spherical({turn, {2.6, 2.1, 1.2}}, {256, 128});
    const Gains darker{0.7F, 0.7F, 0.6F};
    const Gains gains = gainsTo(photoAt(2.5, 2), times(turned, darker), turn.conjugate().toRotationMatrix());
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(gains[c] * darker[c], 1, 0.04) << c;
    }
}

TEST(Exposure, OfTheOtherPhotoIsTheReciprocal) {
    const RgbImage a = photoAt(2.5, 2);
    const RgbImage b = times(photoAt(2.6, 2), {0.6F, 0.7F, 0.8F});
    const Gains forth = gainsTo(a, b, Eigen::Matrix3d::Identity());
    const Gains back = gainsTo(b, a, Eigen::Matrix3d::Identity());
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_GT(forth[c], 1.1F) << c;
        EXPECT_NEAR(forth[c] * back[c], 1, 0.02) << c;
    }
}

TEST(Exposure, SaysNothingWhereAllIsBurnt) {
    RgbImage white(256, 128);
    std::fill(white.values().begin(), white.values().end(), std::uint8_t{255});
    EXPECT_EQ(gainsTo(photoAt(2.5, 2), white, Eigen::Matrix3d::Identity()), (Gains{1, 1, 1}));
}

} // namespace spherewalk::scene
