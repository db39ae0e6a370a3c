// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/fixed_random.h"
#include "spherewalk/compare/sensor_fit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace spherewalk::compare {

namespace {

constexpr int kWidth = 640;
constexpr int kHeight = 480;

/// Slopes of all brightnesses, with a texture in a part of the picture.
RgbImage room(double texturedShare) {
    FixedRandom random(5);
    RgbImage picture(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const bool isTextured = (y / 60 * 60 + x / 60 * 60) % 100 < 100 * texturedShare;
            const double texture = isTextured ? 20 * random.uniform() : 0;
            const double base = 20 + 190.0 * x / kWidth + 10.0 * y / kHeight + texture;
            for (int c = 0; c < 3; ++c) {
                picture.at(x, y)[c] = static_cast<std::uint8_t>(base * (1 - 0.08 * c));
            }
        }
    }
    return picture;
}

RgbImage taken(const render::SensorModel& sensor, const RgbImage& of) {
    render::View view;
    view.picture = of;
    render::Sensor(sensor, CameraModel(CameraIntrinsics::pinhole(kWidth, kHeight, 1))).take(3, view);
    return view.picture;
}

std::vector<ColourSample> colours(const RgbImage& view, const RgbImage& picture) {
    const Image<float, 1> exact(kWidth, kHeight);
    return colourSamples(view, {exact, MaskImage(kWidth, kHeight)}, picture).samples;
}

SensorFit fitted(const render::SensorModel& sensor, double texturedShare = 0.2) {
    const RgbImage view = room(texturedShare);
    const RgbImage picture = taken(sensor, view);
    return fittedSensor(colours(view, picture), noiseSamples(picture));
}

} // namespace

TEST(SensorFit, FindsTheNoiseThatWasAdded) {
    for (const auto& [well, read] : {std::pair{3000.0, 0.0}, {6000.0, 30.0}, {10000.0, 60.0}}) {
        render::SensorModel sensor;
        sensor.noise = {well, read};
        const SensorFit fit = fitted(sensor);
        ASSERT_TRUE(fit.hasNoise) << well;
        // Slope and offset of the line are told apart less well where both parts of the noise are large.
        EXPECT_NEAR(fit.sensor.noise.fullWellE, well, (read > 0 ? 0.2 : 0.1) * well);
        EXPECT_NEAR(fit.sensor.noise.readE, read, 12 + 0.15 * read) << well;
    }
}

TEST(SensorFit, FindsGainAndGainsOfColour) {
    render::SensorModel sensor;
    sensor.exposure.gainDb = -3;
    sensor.whiteBalance.gains = {1.3, 1, 0.8};
    sensor.noise.fullWellE = 8000;
    const SensorFit fit = fitted(sensor);
    ASSERT_TRUE(fit.hasExposure);
    EXPECT_NEAR(fit.sensor.exposure.gainDb, -3, 0.1);
    EXPECT_NEAR(fit.sensor.whiteBalance.gains[0], 1.3, 0.02);
    EXPECT_EQ(fit.sensor.whiteBalance.gains[1], 1);
    EXPECT_NEAR(fit.sensor.whiteBalance.gains[2], 0.8, 0.015);
    EXPECT_NEAR(fit.sensor.noise.fullWellE, 8000, 800);
}

TEST(SensorFit, TheFittedSensorTakesPicturesAsNoisyAsTheRobots) {
    render::SensorModel sensor;
    sensor.exposure.gainDb = -2;
    sensor.noise = {2000, 15};
    const RgbImage view = room(0.2);
    const SensorFit fit = fitted(sensor);
    const auto deviation = [&](const render::SensorModel& of) {
        const RgbImage picture = taken(of, view);
        double sum = 0;
        for (const NoiseSample& sample : noiseSamples(picture)) {
            sum += std::sqrt(sample.variance.mean());
        }
        return sum;
    };
    EXPECT_NEAR(deviation(fit.sensor) / deviation(sensor), 1, 0.04);
}

TEST(SensorFit, SaysWhatPicturesDoNotTell) {
    const SensorFit none = fittedSensor({}, {});
    EXPECT_FALSE(none.hasExposure);
    EXPECT_FALSE(none.hasNoise);
    EXPECT_THAT(none.why,
                testing::ElementsAre(testing::HasSubstr("Exposure and white balance cannot be told"),
                                     testing::HasSubstr("Noise cannot be told")));
    EXPECT_EQ(none.sensor, render::SensorModel());
    RgbImage flat(kWidth, kHeight);
    std::fill(flat.values().begin(), flat.values().end(), std::uint8_t{100});
    EXPECT_FALSE(fittedSensor(colours(flat, flat), noiseSamples(flat)).hasNoise) << "no noise at all";
    std::fill(flat.values().begin(), flat.values().end(), std::uint8_t{255});
    EXPECT_TRUE(noiseSamples(flat).empty()) << "clipped";
}

} // namespace spherewalk::compare
