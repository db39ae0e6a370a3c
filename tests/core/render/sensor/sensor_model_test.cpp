// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"
#include "temporary_folder.h"

#include "spherewalk/base/bytes.h"
#include "spherewalk/base/file.h"
#include "spherewalk/render/camera_info.h"
#include "spherewalk/render/sensor.h"

#include <gtest/gtest.h>

#include <limits>

namespace spherewalk::render {

using test::expectError;

namespace {

SensorModel everyEffect() {
    SensorModel model;
    model.seed = 18446744073709551615ULL;
    model.exposure = {0.01, 0.02, 6, AutoExposure{0.25, 0.001, 0.03, 12, 0.75}};
    model.shutter = {3e-5, 100};
    model.vignetting = {0.5, {-0.1, 0.02, -0.003}};
    model.defocus = {1.5, 2, 0.7};
    model.noise = {9000, 4.5};
    model.whiteBalance = {{0.5, 1, 0.7}, {2, 1, 1.5}, true};
    model.tone = {2.2, {0, 0.4, 1}};
    model.jpegQuality = 80;
    model.depth = {0.3, 8, 0.001, 0.002};
    return model;
}

void refuses(const std::string& yaml, const std::string& because) {
    expectError(ErrorKind::InvalidInput, because, [&] { parseSensor(yaml, "s.yaml"); });
}

} // namespace

TEST(SensorModel, ReadsBackWhatItWrites) {
    EXPECT_EQ(parseSensor(sensorYaml(everyEffect()), "s"), everyEffect());
    EXPECT_EQ(parseSensor(sensorYaml(SensorModel()), "s"), SensorModel());
    SensorModel automatic; // its numbers are those that are not written for other sections
    automatic.exposure.automatic.emplace();
    EXPECT_EQ(parseSensor(sensorYaml(automatic), "s"), automatic);
    SensorModel views;
    views.shutter.mostViews = 7;
    EXPECT_EQ(parseSensor(sensorYaml(views), "s"), views);
}

TEST(SensorModel, IsOffWhereAnEntryIsMissing) {
    EXPECT_EQ(parseSensor("seed: 1", "s"), SensorModel());
    const SensorModel noise = parseSensor("noise: {full_well_e: 8000}", "s");
    EXPECT_EQ(noise.noise.fullWellE, 8000);
    EXPECT_EQ(noise.noise.readE, 0);
}

TEST(SensorModel, StandsBesideACameraInfo) {
    const test::TemporaryFolder folder;
    const CameraIntrinsics camera = CameraIntrinsics::pinhole(64, 48, 1);
    const auto file = folder.path() / "camera.yaml";
    writeFile(file, bytesOf(cameraInfoYaml(camera, "robot") + sensorYaml(everyEffect())));
    EXPECT_EQ(readSensor(file), everyEffect());
    EXPECT_EQ(readCameraInfo(file), camera);
    expectError(ErrorKind::NotFound, "none.yaml", [&] { readSensor(folder.path() / "none.yaml"); });
}

TEST(SensorModel, RefusesWhatItDoesNotKnow) {
    refuses("nose: {full_well_e: 8000}", "s.yaml: the entry nose is unknown; there are auto_exposure, d");
    refuses("noise: {full_well: 8000}",
            "noise/full_well is unknown; there are noise/full_well_e, noise/read_e");
    refuses("noise: 8000", "noise holds no entries");
    refuses("noise: {full_well_e: many}", "noise/full_well_e is not a number");
    refuses("vignetting: {radial: [1, 2]}", "vignetting/radial has 2 numbers, not 3");
    refuses("jpeg: {quality: 1.5}", "jpeg/quality is not a whole number");
    refuses("seed: -1", "seed is not a whole number");
    refuses("{", "not valid YAML");
    refuses("[1, 2]", "it holds no entries");
    refuses("sensor: 3", "it holds no entries");
    refuses("", "it holds no entries");
}

TEST(SensorModel, RefusesWhatNoSensorHas) {
    refuses("exposure: {time_s: 2}", "exposure/time_s 2; it must be from 0 to 1");
    refuses("exposure: {time_s: .nan}", "exposure/time_s");
    refuses("noise: {full_well_e: -1}", "noise/full_well_e -1");
    refuses("noise: {read_e: 3}", "without noise/full_well_e");
    refuses("shutter: {most_views: 1}", "shutter/most_views 1");
    refuses("jpeg: {quality: 101}", "jpeg/quality 101");
    refuses("tone_curve: {gamma: 0.05}", "tone_curve/gamma 0.05");
    refuses("tone_curve: {knots: [0, 0.5, 0.4]}", "tone_curve/knots that fall");
    refuses("tone_curve: {knots: [0]}", "tone_curve/knots that fall, or one");
    refuses("auto_exposure: {least_time_s: 0.01, most_time_s: 0.001}", "least_time_s above most_time_s");
    refuses("depth: {least_m: 3, most_m: 2}", "depth/least_m above most_m");
    refuses("white_balance: {response: [1, 0, 1]}", "white_balance/response 0");
    refuses("defocus: {focus_m: 0}", "defocus/focus_m 0");
    const CameraModel camera(CameraIntrinsics::pinhole(64, 48, 1));
    SensorModel wrong;
    wrong.depth.sigmaM = std::numeric_limits<double>::infinity();
    expectError(ErrorKind::InvalidInput, "depth/sigma_m", [&] { Sensor(wrong, camera); });
}

} // namespace spherewalk::render
