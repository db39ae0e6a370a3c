// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/base/fixed_random.h"
#include "spherewalk/base/statistics.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/render/colour_correction.h"
#include "spherewalk/render/sensor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace spherewalk::render {

using test::expectError;

namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 240;

CameraModel camera(double fieldRad = 1) {
    return CameraModel(CameraIntrinsics::pinhole(kWidth, kHeight, fieldRad));
}

std::uint8_t stored(double light) {
    return static_cast<std::uint8_t>(std::lround(255 * storedValue(light)));
}

View flat(std::uint8_t value) {
    View view;
    view.picture = RgbImage(kWidth, kHeight);
    std::fill(view.picture.values().begin(), view.picture.values().end(), value);
    return view;
}

View colourful(std::uint64_t seed) {
    FixedRandom random(seed);
    View view;
    view.picture = RgbImage(kWidth, kHeight);
    for (std::uint8_t& value : view.picture.values()) {
        value = static_cast<std::uint8_t>(random.below(256));
    }
    return view;
}

/// A sensor whose picture is proportional to light.
SensorModel linear() {
    SensorModel model;
    model.tone.gamma = 1;
    return model;
}

View taken(const SensorModel& model, View view, std::uint64_t frame = 0, int threads = 0) {
    Sensor sensor(model, camera(), threads);
    sensor.take(frame, view);
    return view;
}

struct Moments {
    double mean = 0;
    double variance = 0;
};

/// Of one channel.
Moments momentsOf(const RgbImage& picture, int channel = 1) {
    double sum = 0;
    double squares = 0;
    const double count = static_cast<double>(picture.width()) * picture.height();
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const double value = picture.at(x, y)[channel];
            sum += value;
            squares += value * value;
        }
    }
    return {sum / count, squares / count - sum / count * (sum / count)};
}

/// Everything that needs no motion.
SensorModel everything() {
    SensorModel model;
    model.exposure = {0.008, 0.01, 3, {}};
    model.vignetting = {0.7, {-0.1, 0, 0}};
    model.defocus.diameterPx = 3.5;
    model.noise = {4000, 6};
    model.whiteBalance = {{0.6, 1, 0.8}, {1.7, 1, 1.2}, false};
    model.tone.knots = {0, 0.45, 0.8, 1};
    model.jpegQuality = 85;
    return model;
}

} // namespace

TEST(Sensor, ChangesNothingWithoutEffects) {
    const View view = colourful(1);
    EXPECT_EQ(taken({}, view).picture, view.picture);
    SensorModel throughLight; // through linear light and back
    throughLight.tone.knots = {0, 1};
    EXPECT_EQ(taken(throughLight, view).picture, view.picture);
}

TEST(Sensor, GivesTheSameBytesOnAnyNumberOfThreads) {
    const View view = colourful(2);
    const RgbImage one = taken(everything(), view, 5, 1).picture;
    for (const int threads : {2, 3, 8}) {
        EXPECT_EQ(taken(everything(), view, 5, threads).picture, one) << threads;
    }
}

/// The digest is that of a machine with GCC 12, x86-64 and glibc 2.36: it may differ nowhere.
TEST(Sensor, GivesTheSameBytesOnAnyMachine) {
    const RgbImage picture = taken(everything(), colourful(3), 7).picture;
    EXPECT_EQ(sha256Hex(ByteView(picture.values().data(), picture.values().size())),
              "6920de1389454daec7a3a5c49b1b2fd2c053132dfd0604f7bf37884aacb822ac");
}

TEST(Sensor, ShotNoiseHasTheVarianceOfItsMeanTimesTheGain) {
    for (const double gainDb : {0.0, 6.0206, 12.0412}) {
        SensorModel model = linear();
        model.noise.fullWellE = 1500;
        model.exposure.gainDb = gainDb;
        const double gain = std::pow(10, gainDb / 20);
        const double perElectron = 255 / model.noise.fullWellE * gain; // EMVA 1288's K, grey levels
        for (const double light : {0.1, 0.3, 0.6}) {
            const std::uint8_t value = stored(light / gain);
            const double expected = 255 * gain * linearLight(value / 255.0);
            const Moments moments = momentsOf(taken(model, flat(value)).picture);
            EXPECT_NEAR(moments.mean, expected, 0.02 * std::sqrt(expected)) << light << " " << gainDb;
            const double rounding = 1.0 / 12;
            EXPECT_NEAR((moments.variance - rounding) / moments.mean, perElectron, 0.03 * perElectron)
                << light << " " << gainDb;
        }
    }
}

TEST(Sensor, ReadNoiseAddsItsVarianceAtEachLevel) {
    SensorModel model = linear();
    model.noise = {1500, 20};
    const double perElectron = 255 / 1500.0;
    for (const double light : {0.2, 0.5}) {
        const Moments moments = momentsOf(taken(model, flat(stored(light))).picture);
        const double expected = perElectron * moments.mean + perElectron * perElectron * 400 + 1.0 / 12;
        EXPECT_NEAR(moments.variance, expected, 0.03 * expected) << light;
    }
}

TEST(Sensor, NoiseIsNormalAndIndependent) {
    SensorModel model = linear();
    model.noise.fullWellE = 300;
    const RgbImage first = taken(model, flat(188), 1).picture;
    const RgbImage second = taken(model, flat(188), 2).picture;
    model.seed = 2;
    const RgbImage reseeded = taken(model, flat(188), 1).picture;
    const Moments moments = momentsOf(first);
    const auto correlation = [&](const auto& a, const auto& b) {
        double sum = 0;
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x + 1 < kWidth; ++x) {
                sum += (a(x, y) - moments.mean) * (b(x, y) - moments.mean);
            }
        }
        return sum / (kWidth - 1) / kHeight / moments.variance;
    };
    const auto of = [](const RgbImage& picture, int channel, int right) {
        return [&picture, channel, right](int x, int y) {
            return double{1} * picture.at(x + right, y)[channel];
        };
    };
    EXPECT_NEAR(correlation(of(first, 1, 0), of(first, 1, 0)), 1, 0.02);
    EXPECT_LT(std::abs(correlation(of(first, 1, 0), of(first, 1, 1))), 0.02);
    EXPECT_LT(std::abs(correlation(of(first, 1, 0), of(first, 0, 0))), 0.02);
    EXPECT_LT(std::abs(correlation(of(first, 1, 0), of(first, 2, 0))), 0.02);
    EXPECT_LT(std::abs(correlation(of(first, 1, 0), of(second, 1, 0))), 0.02);
    EXPECT_LT(std::abs(correlation(of(first, 1, 0), of(reseeded, 1, 0))), 0.02);
    for (const auto& [sigmas, share] : {std::pair{1.0, 0.6827}, {2.0, 0.9545}, {3.0, 0.9973}}) {
        const double bound = sigmas * std::sqrt(moments.variance);
        const auto inside = std::count_if(first.values().begin(), first.values().end(), [&](double value) {
            return std::abs(value - moments.mean) < bound;
        });
        EXPECT_NEAR(static_cast<double>(inside) / (3.0 * kWidth * kHeight), share, 0.01) << sigmas;
    }
}

TEST(Sensor, ExposureAndGainMultiplyLightUntilItIsWhite) {
    const double light = linearLight(120 / 255.0);
    const auto value = [&](ExposureModel exposure, std::uint8_t of = 120) {
        SensorModel model = linear();
        model.exposure = exposure;
        return double{1} * taken(model, flat(of)).picture.at(5, 5)[0];
    };
    EXPECT_NEAR(value({0.005, 0.01, 0, {}}), 255 * light / 2, 0.51);
    EXPECT_NEAR(value({0.02, 0.01, 0, {}}), 255 * light * 2, 0.51);
    EXPECT_NEAR(value({0, 0, 6.0206, {}}), 255 * light * 2, 0.51);
    EXPECT_NEAR(value({0.005, 0, 0, {}}), 255 * light, 0.51) << "the time alone changes no brightness";
    EXPECT_EQ(value({0.02, 0.01, 6, {}}, 220), 255);
}

TEST(Sensor, NaturalVignettingIsTheFourthPowerOfTheCosine) {
    SensorModel model = linear();
    model.vignetting.natural = 1;
    const CameraModel wide = camera(1.9);
    Sensor sensor(model, wide);
    View view = flat(255);
    sensor.take(0, view);
    for (int y = 0; y < kHeight; y += 7) {
        for (int x = 0; x < kWidth; x += 7) {
            const double cosine = wide.ray({x, y})->z();
            EXPECT_NEAR(view.picture.at(x, y)[1], 255 * std::pow(cosine, 4), 0.52) << x << " " << y;
        }
    }
}

TEST(Sensor, RadialVignettingIsItsPolynomial) {
    SensorModel model = linear();
    model.vignetting.radial = {-0.3, 0.1, -0.2};
    const View view = taken(model, flat(255));
    const double corner = std::hypot(kWidth / 2.0 - 0.5, kHeight / 2.0 - 0.5);
    for (int x = 0; x < kWidth; x += 3) {
        const double r = std::hypot(x - (kWidth - 1) / 2.0, 0.5) / corner;
        const double factor = 1 - 0.3 * std::pow(r, 2) + 0.1 * std::pow(r, 4) - 0.2 * std::pow(r, 6);
        EXPECT_NEAR(view.picture.at(x, kHeight / 2)[0], 255 * factor, 0.6) << x;
    }
}

TEST(Sensor, WhiteBalanceTradesColourForNoise) {
    SensorModel model = linear();
    model.whiteBalance = {{0.5, 1, 0.25}, {2, 1, 4}, false};
    const RgbImage exact = taken(model, flat(188)).picture;
    EXPECT_NEAR(exact.at(9, 9)[0], exact.at(9, 9)[1], 1);
    EXPECT_NEAR(exact.at(9, 9)[2], exact.at(9, 9)[1], 1);
    model.noise.fullWellE = 2000;
    const RgbImage noisy = taken(model, flat(188)).picture;
    EXPECT_NEAR(momentsOf(noisy, 0).variance / momentsOf(noisy, 1).variance, 2, 0.1);
    EXPECT_NEAR(momentsOf(noisy, 2).variance / momentsOf(noisy, 1).variance, 4, 0.2);
}

TEST(Sensor, ToneCurveIsGammaThenKnots) {
    for (const double gamma : {0.5, 1.0, 2.2}) {
        SensorModel model;
        model.tone = {gamma, {0, 0.8, 1}};
        for (const int value : {0, 20, 90, 160, 255}) {
            const double after = std::pow(linearLight(value / 255.0), 1 / gamma);
            const double expected = after < 0.5 ? 1.6 * after : 0.8 + 0.4 * (after - 0.5);
            EXPECT_NEAR(taken(model, flat(static_cast<std::uint8_t>(value))).picture.at(3, 4)[2],
                        255 * expected, 0.6)
                << gamma << " " << value;
        }
    }
}

TEST(Sensor, JpegIsThatOfItsQuality) {
    const View view = colourful(4);
    SensorModel model;
    model.jpegQuality = 30;
    EXPECT_EQ(taken(model, view).picture, jpeg::decode(jpeg::encode(view.picture, 30), "j"));
}

TEST(Sensor, HasOnePixelOrARow) {
    for (const auto& [width, height] : {std::pair{1, 1}, {7, 1}, {1, 5}}) {
        SensorModel model = everything();
        model.exposure.automatic.emplace();
        model.whiteBalance.isAutomatic = true;
        model.shutter.lineDelayS = 1e-4;
        model.defocus.diameterPx = 30;
        Sensor sensor(model, CameraModel(CameraIntrinsics::pinhole(width, height, 1)));
        View view;
        const auto grey = [&](const Rigid3&, double, bool, View& made) {
            made.picture = RgbImage(width, height);
            std::fill(made.picture.values().begin(), made.picture.values().end(), std::uint8_t{120});
        };
        for (std::uint64_t frame = 0; frame < 5; ++frame) {
            sensor.take(
                grey, [](double) { return Rigid3(); }, 0, frame, view);
        }
        EXPECT_EQ(view.picture.width(), width);
        EXPECT_NEAR(view.picture.at(0, 0)[1], 140, 60) << width << " " << height;
    }
}

TEST(Sensor, RefusesAViewOfAnotherSize) {
    Sensor sensor(everything(), CameraModel(CameraIntrinsics::pinhole(64, 48, 1)));
    View view = flat(3);
    expectError(ErrorKind::InvalidInput, "64 x 48", [&] { sensor.take(0, view); });
}

// -------- defocus

namespace {

/// The light around a point after the sensor: its sum, and the mean square distance along x and y.
struct Spot {
    double sum = 0;
    double meanSquareX = 0;
    double meanSquareY = 0;
};

Spot spotOf(const SensorModel& model, const DepthImage& depth = {}) {
    View view = flat(0);
    constexpr int kPoint = 2; // pixels along a side, full white
    for (int y = 0; y < kPoint; ++y) {
        for (int x = 0; x < kPoint; ++x) {
            std::fill_n(view.picture.at(100 + x, 100 + y), 3, std::uint8_t{255});
        }
    }
    view.depth = depth;
    SensorModel bright = model;
    bright.tone.gamma = 1;
    const View out = taken(bright, view);
    Spot spot;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const double value = out.picture.at(x, y)[1];
            spot.sum += value;
            spot.meanSquareX += value * (x - 100.5) * (x - 100.5);
            spot.meanSquareY += value * (y - 100.5) * (y - 100.5);
        }
    }
    spot.meanSquareX /= spot.sum;
    spot.meanSquareY /= spot.sum;
    return spot;
}

/// A uniform disc has the mean square distance d^2 / 16 along each axis; the point itself adds its own.
double discMeanSquare(double diameter) {
    return diameter * diameter / 16;
}

} // namespace

TEST(Sensor, DefocusMakesDiscsOfTheirDiameter) {
    const double own = spotOf({}).meanSquareX;
    for (const double diameter : {2.0, 4.5, 8.0, 13.0}) {
        SensorModel model;
        model.defocus.diameterPx = diameter;
        const Spot spot = spotOf(model);
        EXPECT_NEAR(spot.sum, 4 * 255, 40) << diameter;
        // A point has more than a pixel's own width, and the rows of a disc are whole: 1/12 each.
        const double tolerance = 0.15 + 0.02 * discMeanSquare(diameter);
        EXPECT_NEAR(spot.meanSquareX - own, discMeanSquare(diameter), tolerance) << diameter;
        EXPECT_NEAR(spot.meanSquareY - own, discMeanSquare(diameter), tolerance) << diameter;
    }
}

TEST(Sensor, DefocusBelowAPixelChangesNothing) {
    SensorModel model;
    model.defocus.diameterPx = 1;
    const View view = colourful(5);
    EXPECT_EQ(taken(model, view).picture, view.picture);
}

TEST(Sensor, DefocusFollowsTheThinLens) {
    SensorModel model;
    model.defocus.apertureMm = 20;
    model.defocus.focusM = 2;
    const double focalPx = camera().intrinsics().fx;
    const double own = spotOf({}).meanSquareX;
    for (const double depthM : {2.0, 1.0, 0.5, 1000.0}) {
        DepthImage depth(kWidth, kHeight);
        std::fill(depth.values().begin(), depth.values().end(), static_cast<float>(depthM));
        const double diameter = focalPx * 0.020 * std::abs(1 / 2.0 - 1 / depthM);
        EXPECT_NEAR(spotOf(model, depth).meanSquareX - own, discMeanSquare(diameter),
                    0.15 + 0.1 * discMeanSquare(diameter))
            << depthM;
    }
    EXPECT_TRUE(Sensor(model, camera()).needsDepth());
    expectError(ErrorKind::InvalidInput, "needs the view's depth", [&] { spotOf(model); });
}

TEST(Sensor, DefocusKeepsAnEvenPictureEvenBesideAJumpOfDepth) {
    SensorModel model;
    model.defocus.apertureMm = 20;
    View view = flat(140);
    view.depth = DepthImage(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            *view.depth.at(x, y) = x < 100 ? 0.4F : y < 50 ? std::numeric_limits<float>::infinity() : 3.0F;
        }
    }
    EXPECT_EQ(taken(model, view).picture, flat(140).picture);
}

// -------- automatic exposure and white balance

TEST(Sensor, ExposesItsFirstFrameAsItAsks) {
    for (const int value : {20, 60, 140, 230}) {
        SensorModel model;
        model.exposure.referenceTimeS = 0.01;
        model.exposure.automatic = AutoExposure{0.18, 1e-5, 0.1, 60, 0.5};
        Sensor sensor(model, camera());
        View view = flat(static_cast<std::uint8_t>(value));
        const SensorReport report = sensor.take(0, view);
        EXPECT_NEAR(std::log2(report.meanLight / 0.18), 0, 1 / 32.0 + 1e-3) << value;
    }
}

TEST(Sensor, FollowsTheLightByItsResponse) {
    SensorModel model;
    model.exposure.referenceTimeS = 0.01;
    model.exposure.automatic = AutoExposure{0.18, 1e-5, 0.02, 24, 0.5};
    Sensor sensor(model, camera());
    View view = flat(stored(0.18));
    EXPECT_NEAR(sensor.take(0, view).meanLight, 0.18, 0.004);
    std::vector<double> stops;
    for (std::uint64_t frame = 1; frame < 8; ++frame) {
        view = flat(stored(0.18 / 8)); // three stops darker from now on
        stops.push_back(std::log2(0.18 / sensor.take(frame, view).meanLight));
    }
    EXPECT_NEAR(stops[0], 3, 0.05);
    EXPECT_NEAR(stops[1], 1.5, 0.08);
    EXPECT_NEAR(stops[2], 0.75, 0.1);
    EXPECT_LT(std::abs(stops[6]), 0.1);
}

TEST(Sensor, TakesTimeBeforeGainAndEndsAtItsLimits) {
    SensorModel model;
    model.exposure.referenceTimeS = 0.01;
    model.exposure.automatic = AutoExposure{0.18, 0.005, 0.02, 12, 1};
    const auto report = [&](double light) {
        Sensor sensor(model, camera());
        View view = flat(stored(light));
        return sensor.take(0, view);
    };
    EXPECT_NEAR(report(0.18 / 2).exposureTimeS, 0.02, 1e-3);
    EXPECT_NEAR(report(0.18 / 2).gainDb, 0, 0.4);
    EXPECT_NEAR(report(0.18 / 4).exposureTimeS, 0.02, 1e-9);
    EXPECT_NEAR(report(0.18 / 4).gainDb, 6.02, 0.4);
    EXPECT_NEAR(report(0.18 / 200).gainDb, 12, 0.38);
    EXPECT_LE(report(0.18 / 200).gainDb, 12);
    EXPECT_NEAR(report(1).exposureTimeS, 0.005, 1e-9);
    EXPECT_LE(report(0).gainDb, 12) << "in the dark";
}

TEST(Sensor, MakesTheWorldGrey) {
    SensorModel model;
    model.whiteBalance.isAutomatic = true;
    model.whiteBalance.response = {0.8, 1, 0.6};
    Sensor sensor(model, camera());
    View view = flat(150);
    const SensorReport report = sensor.take(0, view);
    EXPECT_NEAR(report.whiteBalance[0], 1 / 0.8, 1 / 256.0);
    EXPECT_NEAR(report.whiteBalance[2], 1 / 0.6, 1 / 256.0);
    EXPECT_NEAR(view.picture.at(5, 5)[0], 150, 1);
    EXPECT_NEAR(view.picture.at(5, 5)[2], 150, 1);
}

// -------- depth

TEST(Sensor, DepthHasTheNoiseOfItsFormula) {
    SensorModel model;
    model.depth = {0.3, 5, 0.002, 0.004};
    Sensor sensor(model, camera());
    for (const double z : {0.5, 1.0, 4.0}) {
        DepthImage depth(kWidth, kHeight);
        std::fill(depth.values().begin(), depth.values().end(), static_cast<float>(z));
        sensor.measureDepth(3, depth);
        const std::vector<double> values(depth.values().begin(), depth.values().end());
        const double mean = std::accumulate(values.begin(), values.end(), 0.0) / values.size();
        const double square = std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
        const double sigma = 0.002 + 0.004 * z * z;
        EXPECT_NEAR(mean, z, 0.02 * sigma) << z;
        EXPECT_NEAR(std::sqrt(square / values.size() - mean * mean), sigma, 0.02 * sigma) << z;
    }
}

TEST(Sensor, DepthOutOfRangeIsWhatRep117Says) {
    SensorModel model;
    model.depth = {0.3, 5, 0, 0};
    DepthImage depth(kWidth, kHeight);
    constexpr float kEndless = std::numeric_limits<float>::infinity();
    *depth.at(0, 0) = 0.2F;
    *depth.at(1, 0) = 7;
    *depth.at(2, 0) = kEndless;
    *depth.at(3, 0) = 1.5F;
    Sensor(model, camera()).measureDepth(0, depth);
    EXPECT_EQ(*depth.at(0, 0), -kEndless);
    EXPECT_EQ(*depth.at(1, 0), kEndless);
    EXPECT_EQ(*depth.at(2, 0), kEndless);
    EXPECT_EQ(*depth.at(3, 0), 1.5F);
}

TEST(Sensor, DepthInMillimetresIsWhatRep118Says) {
    DepthImage depth(8, 1);
    constexpr float kEndless = std::numeric_limits<float>::infinity();
    const std::array<float, 8> metres{0,        1.2344F,  1.2346F,   65.535F,
                                      65.5361F, kEndless, -kEndless, std::numeric_limits<float>::quiet_NaN()};
    std::copy(metres.begin(), metres.end(), depth.values().begin());
    const Image<std::uint16_t, 1> millimetres = depthMillimetres(depth);
    EXPECT_EQ(std::vector<int>(millimetres.values().begin(), millimetres.values().end()),
              (std::vector<int>{0, 1234, 1235, 65535, 0, 0, 0, 0}));
}

} // namespace spherewalk::render
