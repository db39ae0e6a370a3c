// SPDX-License-Identifier: GPL-3.0-or-later
// Photos of the practice camera: what they show, what they say about themselves, and what the truth says.
#include "expect_error.h"
#include "photo/exposure.h"
#include "random.h"
#include "temporary_folder.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/base/file.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/photo/metadata.h"
#include "spherewalk/practice/theta_jpeg.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace spherewalk::practice {
namespace {

using test::expectError;
using namespace std::chrono_literals;

PracticeCameraOptions smallCamera(bool isPlain = true) {
    PracticeCameraOptions options;
    options.width = 512;
    options.isPlain = isPlain;
    return options;
}

ExposureSettings settingsOf(int shot) {
    ExposureSettings settings;
    settings.shot = shot;
    settings.standing = shot;
    settings.nominalPositionM = {2.1, 1.8, 1.2};
    settings.time = {std::chrono::sys_days(std::chrono::year(2026) / 2 / 28) + 23h, 90min};
    return settings;
}

double meanOf(const RgbImage& picture) {
    double sum = 0;
    for (const std::uint8_t value : picture.values()) {
        sum += value;
    }
    return sum / static_cast<double>(picture.values().size());
}

TEST(PracticeExposure, TheSameSeedAndShotGiveTheSameFile) {
    const PracticeCameraOptions options = smallCamera(false);
    const Exposer one(options);
    const Exposer two(options);
    const ExposedPhoto first = one.expose(settingsOf(3), {});
    const ExposedPhoto second = two.expose(settingsOf(3), {});
    EXPECT_EQ(first.jpeg, second.jpeg);
    EXPECT_EQ(first.truth.positionM, second.truth.positionM);
    EXPECT_EQ(first.truth.roomFromPhoto->coeffs(), second.truth.roomFromPhoto->coeffs());
}

TEST(PracticeExposure, AnotherShotOrSeedGivesAnother) {
    PracticeCameraOptions options = smallCamera();
    const ExposedPhoto first = Exposer(options).expose(settingsOf(3), {});
    const ExposedPhoto next = Exposer(options).expose(settingsOf(4), {});
    options.errors.seed = 99;
    const ExposedPhoto other = Exposer(options).expose(settingsOf(3), {});
    EXPECT_NE(first.jpeg, next.jpeg);
    EXPECT_NE(first.truth.positionM, next.truth.positionM);
    EXPECT_NE(first.truth.positionM, other.truth.positionM);
}

TEST(PracticeExposure, TheTruthIsThatOfTheErrors) {
    const PracticeCameraOptions options = smallCamera();
    const Exposer exposer(options);
    for (int shot = 1; shot <= 20; ++shot) {
        const ExposureSettings settings = settingsOf(shot);
        const Rigid3 pose = options.errors.truePose(settings.nominalPositionM, shot);
        const Truth truth = exposer.expose(settings, {}).truth;
        EXPECT_EQ(truth.shot, shot);
        EXPECT_EQ(truth.nominalPositionM, settings.nominalPositionM);
        EXPECT_EQ(truth.positionM, pose.translation);
        EXPECT_EQ(truth.roomFromPhoto->coeffs(), pose.rotation.coeffs());
        EXPECT_THAT(truth.time, testing::StartsWith("2026-02-28T23:00:00"));
    }
}

TEST(PracticeExposure, TheHashIsThatOfTheFile) {
    const PracticeCameraOptions options = smallCamera();
    const ExposedPhoto photo = Exposer(options).expose(settingsOf(1), {});
    EXPECT_EQ(photo.truth.sha256, sha256Hex(photo.jpeg));
}

TEST(PracticeExposure, ALevelledPhotoKeepsItsYawAndLosesItsTilt) {
    const PracticeCameraOptions options = smallCamera();
    const Exposer exposer(options);
    for (int shot = 1; shot <= 10; ++shot) {
        ExposureSettings settings = settingsOf(shot);
        const YawPitchRoll tilted = yawPitchRoll(*exposer.expose(settings, {}).truth.roomFromPhoto);
        settings.levelled = true;
        const YawPitchRoll level = yawPitchRoll(*exposer.expose(settings, {}).truth.roomFromPhoto);
        EXPECT_NEAR(level.yaw.value(), tilted.yaw.value(), 1e-9);
        EXPECT_NEAR(level.pitch.value(), 0, 1e-9);
        EXPECT_NEAR(level.roll.value(), 0, 1e-9);
        EXPECT_GT(std::abs(tilted.pitch.value()) + std::abs(tilted.roll.value()), 1e-6);
    }
}

TEST(PracticeExposure, TheFileTellsItsSettings) {
    const PracticeCameraOptions options = smallCamera();
    const Exposer exposer(options);
    ExposureSettings settings = settingsOf(1);
    settings.exposureTimeS = 0.25;
    settings.isoSpeed = 640;
    settings.hasFixedWhiteBalance = true;
    const photo::PhotoMetadata told = photo::readMetadata(exposer.expose(settings, {}).jpeg, "photo");
    EXPECT_EQ(told.make, "RICOH");
    EXPECT_EQ(told.model, "RICOH THETA V");
    EXPECT_EQ(told.width, 512);
    EXPECT_EQ(told.height, 256);
    EXPECT_NEAR(told.exposureS.value(), 0.25, 1e-6);
    EXPECT_EQ(told.iso, 640);
    EXPECT_EQ(told.hasFixedWhiteBalance, true);
    EXPECT_EQ(told.takenAt, "2026-03-01T00:30:00") << "the camera's local time";
    EXPECT_EQ(told.timeZone, "+01:30");
    EXPECT_THAT(told.remarks, testing::IsEmpty());
}

TEST(PracticeExposure, AutomaticSettingsAreToldAsChosen) {
    const PracticeCameraOptions options = smallCamera();
    const photo::PhotoMetadata told =
        photo::readMetadata(Exposer(options).expose(settingsOf(1), {}).jpeg, "photo");
    EXPECT_NEAR(told.exposureS.value(), 1.0 / 60, 1e-6);
    EXPECT_EQ(told.iso, 200);
    EXPECT_EQ(told.hasFixedWhiteBalance, false);
}

TEST(PracticeExposure, TheFileTellsTheTiltAboutAsTheTruth) {
    PracticeCameraOptions options = smallCamera();
    options.errors.tiltSigma = Degrees(8);
    const Exposer exposer(options);
    for (int shot = 1; shot <= 20; ++shot) {
        const ExposedPhoto photo = exposer.expose(settingsOf(shot), {});
        const YawPitchRoll angles = yawPitchRoll(*photo.truth.roomFromPhoto);
        const photo::PhotoMetadata told = photo::readMetadata(photo.jpeg, "photo");
        ASSERT_TRUE(told.theta && told.panorama);
        EXPECT_EQ(told.theta->isLevelled, false);
        // Noise of 0.3 degrees, and GPano's signs: pitch is the opposite of ours.
        EXPECT_NEAR(told.panorama->pitch->value(), -Degrees(angles.pitch).value(), 1.5) << shot;
        EXPECT_NEAR(told.panorama->roll->value(), Degrees(angles.roll).value(), 1.5) << shot;
        EXPECT_NEAR(told.theta->inclinationPitch->value(), told.panorama->pitch->value(), 0.2) << shot;
    }
}

TEST(PracticeExposure, MetadataSurvivesTheWayThroughTheFile) {
    test::Random random(12);
    SCOPED_TRACE(random.seed());
    RgbImage picture(512, 256);
    for (int i = 0; i < 40; ++i) {
        ThetaTags tags;
        tags.time = std::chrono::sys_seconds(std::chrono::seconds(random.integer(1, 2'000'000'000)));
        tags.timeZone = std::chrono::minutes(15 * random.integer(-48, 56));
        tags.exposureTimeS = 1.0 / random.integer(1, 8000);
        tags.isoSpeed = random.integer(1, 6400);
        tags.hasFixedWhiteBalance = i % 2 == 0;
        tags.levelled = i % 3 == 0;
        tags.posePitchDeg = random.uniform(-89, 89);
        tags.poseRollDeg = random.uniform(-179, 179);
        tags.inclinationPitchDeg = random.uniform(-89, 89);
        tags.inclinationRollDeg = random.uniform(-179, 179);
        tags.byteOrder = i % 4 < 2 ? ThetaTags::ByteOrder::Big : ThetaTags::ByteOrder::Little;
        const photo::PhotoMetadata told = photo::readMetadata(thetaJpeg(picture, tags), "photo");
        EXPECT_NEAR(told.exposureS.value() / tags.exposureTimeS, 1, 1e-3);
        EXPECT_EQ(told.iso, tags.isoSpeed);
        EXPECT_EQ(told.hasFixedWhiteBalance, tags.hasFixedWhiteBalance);
        ASSERT_TRUE(told.theta && told.panorama) << i;
        EXPECT_EQ(told.theta->isLevelled, tags.levelled);
        EXPECT_EQ(told.theta->serial, tags.serial);
        EXPECT_EQ(told.theta->firmware, "Rev3821") << "the maker note's spelling of 3.82.1";
        EXPECT_NEAR(told.theta->inclinationPitch->value(), tags.inclinationPitchDeg, 0.11);
        EXPECT_NEAR(told.theta->inclinationRoll->value(), tags.inclinationRollDeg, 0.11);
        EXPECT_EQ(told.panorama->projection, "equirectangular");
        EXPECT_NEAR(told.panorama->pitch->value(), tags.posePitchDeg, 0.11);
        EXPECT_NEAR(told.panorama->roll->value(), tags.poseRollDeg, 0.11);
        EXPECT_EQ(told.panorama->fullWidth, 512);
        EXPECT_EQ(told.timeZone, zoneText(tags.timeZone));
    }
}

TEST(PracticeExposure, DefectsAreWhatTheySay) {
    const PracticeCameraOptions options = smallCamera();
    const Exposer exposer(options);
    ExposureSettings settings = settingsOf(1);
    settings.defect = PhotoDefect::Empty;
    EXPECT_TRUE(exposer.expose(settings, {}).jpeg.empty());
    settings.defect = PhotoDefect::Small;
    EXPECT_EQ(jpeg::readInfo(exposer.expose(settings, {}).jpeg, "photo").width, 640);
    settings.defect = PhotoDefect::NoMakerNote;
    const photo::PhotoMetadata without = photo::readMetadata(exposer.expose(settings, {}).jpeg, "photo");
    EXPECT_FALSE(without.theta);
    EXPECT_EQ(without.model, "RICOH THETA V");
    settings.defect = PhotoDefect::HostileMakerNote;
    const photo::PhotoMetadata hostile = photo::readMetadata(exposer.expose(settings, {}).jpeg, "photo");
    EXPECT_FALSE(hostile.theta && hostile.theta->isLevelled) << "its offsets lead nowhere";
}

TEST(PracticeExposure, PlainPhotosOfASurveyDiffer) {
    const PracticeCameraOptions options = smallCamera();
    const Exposer exposer(options);
    std::set<std::string> hashes;
    for (int shot = 1; shot <= 200; ++shot) {
        hashes.insert(sha256Hex(exposer.expose(settingsOf(shot), {}).jpeg));
    }
    EXPECT_EQ(hashes.size(), 200U);
}

TEST(PracticeExposure, APreviewShowsThePhotoSmall) {
    PracticeCameraOptions options = smallCamera(false);
    const Exposer exposer(options);
    const RgbImage preview = jpeg::decode(exposer.preview(settingsOf(2), {256, 128}, {}), "preview");
    const RgbImage photo = jpeg::decode(exposer.expose(settingsOf(2), {}).jpeg, "photo");
    ASSERT_EQ(preview.width(), 256);
    EXPECT_NEAR(meanOf(preview), meanOf(photo), 3);
    double difference = 0;
    for (int y = 0; y < 128; ++y) {
        for (int x = 0; x < 256; ++x) {
            difference += std::abs(int{preview.at(x, y)[1]} - int{photo.at(2 * x, 2 * y)[1]});
        }
    }
    EXPECT_LT(difference / (256 * 128), 14);
}

TEST(PracticeExposure, GivenPhotosAreServedByTheirPlace) {
    const test::TemporaryFolder folder;
    PracticeCameraOptions options = smallCamera();
    options.photoFolder = folder.path();
    test::Random random(5);
    SCOPED_TRACE(random.seed());
    for (int i = 0; i < 6; ++i) {
        const std::string name = std::string(1, static_cast<char>('a' + i)) + ".jpg";
        writeFile(folder / name, jpeg::encode(RgbImage(64 + 2 * i, 32 + i), 80));
        options.photos.push_back({name, random.vector(), random.rotation()});
    }
    const Exposer exposer(options);
    for (int i = 0; i < 50; ++i) {
        ExposureSettings settings = settingsOf(i + 1);
        settings.nominalPositionM = random.vector();
        const Truth truth = exposer.expose(settings, {}).truth;
        for (const PlacedPhoto& photo : options.photos) {
            EXPECT_LE((truth.positionM - settings.nominalPositionM).norm(),
                      (photo.positionM - settings.nominalPositionM).norm() + 1e-12);
        }
    }
    const ExposureSettings settings = settingsOf(1);
    EXPECT_EQ(jpeg::readInfo(exposer.preview(settings, {128, 64}, {}), "preview").height, 64);
    options.photos.push_back({"missing.jpg", {0, 0, 0}, {}});
    expectError(ErrorKind::NotFound, "missing.jpg", [&] { Exposer{options}; });
}

TEST(PracticeExposure, DrawingStopsWhenAsked) {
    const PracticeCameraOptions options = smallCamera(false);
    const Exposer exposer(options);
    std::stop_source stop;
    stop.request_stop();
    expectError(ErrorKind::Stopped, "", [&] { exposer.expose(settingsOf(1), stop.get_token()); });
}

} // namespace
} // namespace spherewalk::practice
