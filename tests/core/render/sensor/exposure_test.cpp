// SPDX-License-Identifier: Apache-2.0
#include "sensor/effects.h"

#include "spherewalk/render/colour_correction.h"
#include "spherewalk/render/sensor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace spherewalk::render {

namespace {

constexpr int kFrameWidth = 320;
constexpr int kFrameHeight = 240;
const CameraModel kFrameCamera(CameraIntrinsics::pinhole(kFrameWidth, kFrameHeight, 1.2));

/// Where the border of a black and a white half of the world is, in a camera that is turned to the left.
double borderPx(double turnRad) {
    return kFrameCamera.intrinsics().cx + kFrameCamera.intrinsics().fx * std::tan(turnRad);
}

/// A camera that turns about its y axis, the picture's vertical.
Sensor::PoseAt turning(double radPerS) {
    return [radPerS](double timeS) {
        return Rigid3{Eigen::Quaterniond(Eigen::AngleAxisd(-radPerS * timeS, Eigen::Vector3d::UnitY())),
                      Eigen::Vector3d::Zero()};
    };
}

double turnOf(const Rigid3& pose) {
    const Eigen::Vector3d ahead = pose.rotation.conjugate() * Eigen::Vector3d::UnitZ();
    return std::atan2(ahead.x(), ahead.z());
}

/// The world's right half is white. Pixels on the border have the light of their part.
void makeHalves(const Rigid3& pose, View& view) {
    view.picture = RgbImage(kFrameWidth, kFrameHeight);
    const double border = borderPx(turnOf(pose));
    for (int x = 0; x < kFrameWidth; ++x) {
        const double light = std::clamp(x + 0.5 - border, 0.0, 1.0);
        const auto value = static_cast<std::uint8_t>(std::lround(255 * storedValue(light)));
        for (int y = 0; y < kFrameHeight; ++y) {
            std::fill_n(view.picture.at(x, y), 3, value);
        }
    }
}

const Sensor::MakeView kHalves = [](const Rigid3& pose, double, bool, View& view) { makeHalves(pose, view); };

SensorModel linear(double exposureS, double lineDelayS = 0, int mostViews = 64) {
    SensorModel model;
    model.tone.gamma = 1;
    model.exposure.timeS = exposureS;
    model.shutter = {lineDelayS, mostViews};
    return model;
}

/// A row's pixel, as a share of the white at its right end.
double whiteness(const RgbImage& picture, int x, int row) {
    return static_cast<double>(picture.at(x, row)[1]) / picture.at(kFrameWidth - 1, row)[1];
}

/// Where a row's border is: black pixels from the left, and the dark parts of grey ones.
double borderOf(const RgbImage& picture, int row) {
    double dark = 0;
    for (int x = 0; x < kFrameWidth; ++x) {
        dark += 1 - whiteness(picture, x, row);
    }
    return dark - 0.5;
}

/// The length of a row's ramp from black to white: its standard deviation is length / sqrt(12).
double rampOf(const RgbImage& picture, int row) {
    const double middle = borderOf(picture, row);
    double square = 0; // integral of (x - middle)^2 over the ramp's rise
    for (int x = 0; x + 1 < kFrameWidth; ++x) {
        const double rise = whiteness(picture, x + 1, row) - whiteness(picture, x, row);
        square += rise * (x + 0.5 - middle) * (x + 0.5 - middle);
    }
    return std::sqrt(12 * square);
}

} // namespace

TEST(Exposure, BlursByTheMotionDuringIt) {
    for (const double lengthPx : {5.0, 20.0, 50.0}) {
        constexpr double kExposureS = 0.02;
        const double radPerS = std::atan(lengthPx / kFrameCamera.intrinsics().fx) / kExposureS;
        Sensor sensor(linear(kExposureS), kFrameCamera);
        View view;
        const SensorReport report = sensor.take(kHalves, turning(radPerS), 0, 0, view);
        const double ends = borderPx(radPerS * kExposureS / 2) - borderPx(-radPerS * kExposureS / 2);
        // Views blur by the step between them: a box of a step is convolved with the motion, twice.
        EXPECT_NEAR(rampOf(view.picture, kFrameHeight / 2), ends, 0.4) << lengthPx;
        EXPECT_NEAR(borderOf(view.picture, kFrameHeight / 2), borderPx(0), 0.1) << lengthPx;
        EXPECT_LE(report.stepPx, 1);
        EXPECT_GE(report.views, lengthPx);
    }
}

TEST(Exposure, BlursNothingThatStands) {
    Sensor sensor(linear(0.02, 3e-5), kFrameCamera);
    View view;
    const SensorReport report = sensor.take(kHalves, turning(0), 0, 0, view);
    View still;
    makeHalves({}, still);
    Sensor instant(linear(0), kFrameCamera);
    instant.take(0, still);
    EXPECT_EQ(view.picture, still.picture);
    EXPECT_LE(report.views, 4);
}

TEST(Exposure, ExposesEachRowAtItsTime) {
    constexpr double kLineDelayS = 1e-4;
    for (const double exposureS : {0.0, 0.004}) {
        for (const double radPerS : {-1.0, 0.5, 3.0}) {
            Sensor sensor(linear(exposureS, kLineDelayS), kFrameCamera);
            View view;
            sensor.take(kHalves, turning(radPerS), 0, 0, view);
            for (int row = 0; row < kFrameHeight; row += 13) {
                EXPECT_NEAR(borderOf(view.picture, row), borderPx(radPerS * kLineDelayS * row), 0.15)
                    << row << " " << radPerS << " " << exposureS;
            }
        }
    }
}

TEST(Exposure, MakesItsMainViewAtTheFramesTime) {
    Sensor sensor(linear(0.01, 1e-5), kFrameCamera);
    std::vector<double> times;
    std::vector<double> mains;
    View view;
    sensor.take(
        [&](const Rigid3& pose, double timeS, bool isMain, View& made) {
            makeHalves(pose, made);
            made.report.offsetM = isMain ? 7 : 0;
            times.push_back(timeS);
            if (isMain) {
                mains.push_back(timeS);
            }
        },
        turning(1), 12.5, 0, view);
    EXPECT_EQ(mains, std::vector<double>{12.5});
    EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
    EXPECT_LE(times.front(), 12.495);
    EXPECT_GE(times.back(), 12.505 + 1e-5 * (kFrameHeight - 1));
    EXPECT_EQ(view.report.offsetM, 7);
    EXPECT_EQ(sensor.times(turning(1), 12.5), times);
}

TEST(Exposure, MakesNoMoreViewsThanAllowedAndSaysSo) {
    Sensor sensor(linear(0.02, 0, 8), kFrameCamera);
    View view;
    const SensorReport report = sensor.take(kHalves, turning(3), 0, 0, view);
    EXPECT_LE(report.views, 8);
    EXPECT_GT(report.stepPx, 1);
    for (const int most : {4, 5, 9, 30}) {
        for (const double lineDelayS : {0.0, 1e-6, 1e-5, 2e-4}) {
            const SensorModel model = linear(0.013, lineDelayS, most);
            EXPECT_LE(Sensor(model, kFrameCamera).times(turning(3), 0).size(),
                      static_cast<std::size_t>(most));
        }
    }
}

TEST(Exposure, SharesOfARowSumUpAndLieAtItsTime) {
    for (const double exposureS : {0.0, 0.003, 0.02}) {
        for (const double delayS : {0.0, 2e-5, 3e-4}) {
            for (const double stepS : {0.001, 0.0033, 0.05}) {
                const RowTiming timing(kFrameHeight, 3, exposureS, delayS, stepS);
                EXPECT_EQ(timing.times()[timing.main()], 3);
                for (int row = 0; row < kFrameHeight; row += 17) {
                    std::uint64_t sum = 0;
                    double middle = 0;
                    for (std::size_t view = 0; view < timing.times().size(); ++view) {
                        sum += timing.share(row, view);
                        middle += timing.share(row, view) * timing.times()[view] / RowTiming::kOne;
                    }
                    EXPECT_EQ(sum, RowTiming::kOne);
                    EXPECT_NEAR(middle, 3 + row * delayS, 1e-3 * stepS + 1e-6)
                        << exposureS << " " << delayS << " " << stepS << " " << row;
                }
            }
        }
    }
}

TEST(Exposure, GivesTheSameBytesOnAnyNumberOfThreads) {
    SensorModel model = linear(0.02, 5e-5);
    model.noise.fullWellE = 3000;
    std::map<int, RgbImage> pictures;
    for (const int threads : {1, 8}) {
        Sensor sensor(model, kFrameCamera, threads);
        View view;
        sensor.take(kHalves, turning(2), 0, 9, view);
        pictures[threads] = view.picture;
    }
    EXPECT_EQ(pictures[1], pictures[8]);
}

TEST(Exposure, FirstAutomaticFrameHasItsOwnBlur) {
    SensorModel model = linear(0);
    model.exposure.referenceTimeS = 0.01;
    model.exposure.automatic = AutoExposure{0.25, 1e-4, 0.02, 0, 1};
    Sensor sensor(model, kFrameCamera);
    View view;
    const SensorReport report = sensor.take(kHalves, turning(2), 0, 0, view);
    EXPECT_NEAR(report.exposureTimeS, 0.005, 0.0005) << "half the picture is white, a quarter is wanted";
    const double ends = borderPx(report.exposureTimeS) - borderPx(-report.exposureTimeS);
    EXPECT_NEAR(view.picture.at(kFrameWidth - 1, 100)[1] / 255.0, 0.5, 0.03);
    EXPECT_NEAR(rampOf(view.picture, 100), ends, 0.8);
}

TEST(Exposure, NumbersOfNoiseHaveMeanZeroAndVarianceOne) {
    const NormalNoise noise(3, 4, 5);
    double sum = 0;
    double squares = 0;
    double cubes = 0;
    constexpr int kCount = 1'000'000;
    for (std::uint64_t i = 0; i < kCount; ++i) {
        for (const float value : noise.at(i)) {
            const auto v = static_cast<double>(value);
            sum += v;
            squares += v * v;
            cubes += v * v * v;
        }
    }
    EXPECT_NEAR(sum / kCount / 3, 0, 0.003);
    EXPECT_NEAR(squares / kCount / 3, 1, 0.004);
    EXPECT_NEAR(cubes / kCount / 3, 0, 0.01);
}

} // namespace spherewalk::render
