// SPDX-License-Identifier: GPL-3.0-or-later
// What a real camera does to pictures: exposure, colour, noise, a seam, a robot below it, people about it.
#include "expect_error.h"
#include "photo/exposure.h"

#include "spherewalk/jpeg/jpeg.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace spherewalk::practice {
namespace {

RgbImage grey(int value, int width = 256) {
    RgbImage picture(width, width / 2);
    std::fill(picture.values().begin(), picture.values().end(), static_cast<std::uint8_t>(value));
    return picture;
}

struct Spread {
    double mean = 0;
    double sigma = 0;
};

Spread spreadOf(const std::vector<double>& values) {
    Spread spread;
    for (const double value : values) {
        spread.mean += value / static_cast<double>(values.size());
    }
    for (const double value : values) {
        spread.sigma += (value - spread.mean) * (value - spread.mean) / static_cast<double>(values.size());
    }
    spread.sigma = std::sqrt(spread.sigma);
    return spread;
}

TEST(PhotoFlaws, WithoutAnyThePictureStaysAsItIs) {
    RgbImage picture = grey(117);
    addFlaws(picture, {}, 5);
    EXPECT_EQ(picture, grey(117));
}

TEST(PhotoFlaws, TheSameShotHasTheSameOnes) {
    const PhotoFlaws flaws = PhotoFlaws::ofARealCamera(3);
    RgbImage first = grey(117);
    RgbImage second = grey(117);
    RgbImage other = grey(117);
    addFlaws(first, flaws, 5);
    addFlaws(second, flaws, 5);
    addFlaws(other, flaws, 6);
    EXPECT_EQ(first, second);
    EXPECT_NE(first, other);
}

TEST(PhotoFlaws, ExposureChangesLightByAsManyStopsAsItSays) {
    PhotoFlaws flaws;
    flaws.exposureSigmaEv = 0.5;
    std::vector<double> stops;
    for (int shot = 0; shot < 400; ++shot) {
        RgbImage picture = grey(60, 16);
        addFlaws(picture, flaws, shot);
        stops.push_back(2 * std::log2(picture.at(3, 3)[1] / 60.0));
        EXPECT_NEAR(std::log2(lightOf(flaws, shot)), stops.back(), 0.04) << shot; // it is rounded to levels
    }
    EXPECT_NEAR(spreadOf(stops).mean, 0, 0.1);
    EXPECT_NEAR(spreadOf(stops).sigma, 0.5, 0.06);
}

TEST(PhotoFlaws, WhiteBalanceLeavesGreenAlone) {
    PhotoFlaws flaws;
    flaws.whiteBalanceSigma = 0.1;
    RgbImage picture = grey(100);
    addFlaws(picture, flaws, 2);
    EXPECT_EQ(picture.at(9, 9)[1], 100);
    EXPECT_NE(picture.at(9, 9)[0], picture.at(9, 9)[2]);
}

TEST(PhotoFlaws, NoiseHasItsSigma) {
    PhotoFlaws flaws;
    flaws.noiseSigma = 3;
    RgbImage picture = grey(128);
    addFlaws(picture, flaws, 1);
    const std::vector<double> values(picture.values().begin(), picture.values().end());
    EXPECT_NEAR(spreadOf(values).mean, 128, 0.1);
    EXPECT_NEAR(spreadOf(values).sigma, 3, 0.1);
}

TEST(PhotoFlaws, TheRobotIsTheSameInEachPhoto) {
    PhotoFlaws flaws;
    flaws.robotHalfAngleDeg = 30;
    RgbImage dark = grey(20);
    RgbImage bright = grey(220);
    addFlaws(dark, flaws, 1);
    addFlaws(bright, flaws, 2);
    for (int y = 0; y < dark.height(); ++y) {
        const bool isRobot = y >= std::ceil(dark.height() * (1 - 30.0 / 180));
        EXPECT_EQ(std::equal(dark.at(0, y), dark.at(0, y) + 3L * dark.width(), bright.at(0, y)), isRobot)
            << y;
    }
}

TEST(PhotoFlaws, RefusesWhatNoCameraDoes) {
    PhotoFlaws flaws;
    flaws.noiseSigma = std::numeric_limits<double>::quiet_NaN();
    test::expectError(ErrorKind::InvalidInput, "noise", [&] { flaws.validate(); });
    flaws = {};
    flaws.personShare = 1.5;
    test::expectError(ErrorKind::InvalidInput, "person", [&] { flaws.validate(); });
}

TEST(Stitching, TakesTheFrontAheadAndTheBackBehind) {
    const RgbImage picture = stitched(grey(200, 360), grey(50, 360));
    EXPECT_EQ(picture.at(180, 90)[0], 200);
    EXPECT_EQ(picture.at(0, 90)[0], 50);
    EXPECT_NEAR(picture.at(90, 90)[0], 125, 40);
    EXPECT_NEAR(picture.at(10, 0)[0], 125, 40) << "straight up lies on the seam";
}

PracticeCameraOptions cameraWith(const PhotoFlaws& flaws) {
    PracticeCameraOptions options;
    options.width = 512;
    options.errors.anyYaw = false;
    options.errors.tiltSigma = {};
    options.errors.positionSigmaM = 0;
    options.flaws = flaws;
    return options;
}

RgbImage photoOf(const PracticeCameraOptions& options, int shot) {
    ExposureSettings settings;
    settings.shot = shot;
    settings.nominalPositionM = {2.1, 1.8, 1.2};
    return jpeg::decode(Exposer(options).expose(settings, {}).jpeg, "photo");
}

double differenceBetween(const RgbImage& a, const RgbImage& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.values().size(); ++i) {
        sum += std::abs(a.values()[i] - b.values()[i]);
    }
    return sum / static_cast<double>(a.values().size());
}

TEST(PracticePhoto, TwoLensesShowNearThingsFromElsewhere) {
    PhotoFlaws flaws;
    flaws.lensOffsetM = 0.05;
    const RgbImage one = photoOf(cameraWith({}), 1);
    const RgbImage two = photoOf(cameraWith(flaws), 1);
    EXPECT_GT(differenceBetween(one, two), 1);
    flaws.lensOffsetM = 1e-6;
    EXPECT_LT(differenceBetween(one, photoOf(cameraWith(flaws), 1)), 0.1);
}

TEST(PracticePhoto, PeopleAreInAsManyPhotosAsItSays) {
    PhotoFlaws flaws;
    flaws.personShare = 0.5;
    const RgbImage empty = photoOf(cameraWith({}), 0);
    int withPerson = 0;
    for (int shot = 0; shot < 12; ++shot) {
        withPerson += differenceBetween(empty, photoOf(cameraWith(flaws), shot)) > 0.3 ? 1 : 0;
    }
    EXPECT_GE(withPerson, 2);
    EXPECT_LE(withPerson, 10);
}

} // namespace
} // namespace spherewalk::practice
