// SPDX-License-Identifier: GPL-3.0-or-later
#include "server/practice_camera_fixture.h"
#include "temporary_folder.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/practice/truth.h"

#include <chrono>

namespace spherewalk::practice {
namespace {

TEST_F(PracticeCameraHttp, APhotoRunsFromTriggerToDownload) {
    run();
    EXPECT_EQ(state()["_latestFileUrl"], "");
    const Json begun = execute("camera.takePicture");
    EXPECT_EQ(begun["name"], "camera.takePicture");
    EXPECT_EQ(begun["state"], "inProgress");
    EXPECT_EQ(begun["progress"]["completion"], 0.0);
    const Json done = finished(begun["id"]);
    const std::string url = done["results"]["fileUrl"];
    EXPECT_THAT(url, testing::MatchesRegex(camera().url() + "/files/[0-9a-f]+/100RICOH/R0010001.JPG"));
    EXPECT_EQ(state()["_latestFileUrl"], url);
    EXPECT_EQ(state()["_captureStatus"], "idle");

    const Json entry = list(kNewest)["entries"][0];
    const Bytes bytes = download(url.substr(camera().url().size()));
    EXPECT_EQ(entry["fileUrl"], url);
    EXPECT_EQ(entry["size"], bytes.size());
    EXPECT_EQ(entry["width"], 512);
    EXPECT_EQ(entry["_projectionType"], "Equirectangular");
    const jpeg::Info info = jpeg::readInfo(bytes, "photo");
    EXPECT_EQ(info.width, 512);
    EXPECT_EQ(info.height, 256);
    EXPECT_EQ(info.mcuWidth, 16);
    EXPECT_EQ(camera().stats().exposures, 1);
    EXPECT_EQ(camera().stats().commands.at("camera.takePicture"), 1);
}

TEST_F(PracticeCameraHttp, TheTruthIsThePhotoThatTheRoomShowsThere) {
    run();
    post("/practice/pose", {{"x", 1.7}, {"y", 2.1}, {"z", 1.1}});
    const std::string path = shoot();
    camera().setPosition({2.4, 1.2, 1.3});
    shoot();
    const std::vector<Truth> truths = readTruth(camera().truthFile());
    ASSERT_EQ(truths.size(), 2U);
    const Truth& truth = truths[0];
    EXPECT_EQ(truth.urlPath, path);
    EXPECT_EQ(truth.file, "R0010001.JPG");
    EXPECT_EQ(truth.shot, 1);
    EXPECT_EQ(truth.nominalPositionM, Eigen::Vector3d(1.7, 2.1, 1.1));
    EXPECT_EQ(truths[1].nominalPositionM, Eigen::Vector3d(2.4, 1.2, 1.3));
    EXPECT_LT((truth.positionM - truth.nominalPositionM).norm(), 0.02);
    EXPECT_NE(truth.positionM, truth.nominalPositionM);
    const Bytes bytes = download(path);
    EXPECT_EQ(truth.sha256, sha256Hex(bytes));

    ASSERT_TRUE(truth.roomFromPhoto);
    const Rigid3 pose{*truth.roomFromPhoto, truth.positionM};
    const RgbImage expected = PracticeRoom().spherical(pose, {512, 256});
    const RgbImage photo = jpeg::decode(bytes, "photo");
    double sum = 0;
    for (std::size_t i = 0; i < photo.values().size(); ++i) {
        const double difference = double(photo.values()[i]) - double(expected.values()[i]);
        sum += difference * difference;
    }
    EXPECT_LT(std::sqrt(sum / double(photo.values().size())), 12); // what JPEG's 4:2:0 costs at this size
}

/// The number in this element of the photo's XMP.
double gpano(const Bytes& jpeg, const std::string& name) {
    const std::string content(jpeg.begin(), jpeg.end());
    const std::size_t at = content.find("<GPano:" + name + ">");
    if (at == std::string::npos) {
        ADD_FAILURE() << "no " << name;
        return 0;
    }
    return std::stod(content.substr(at + name.size() + 8, 20));
}

TEST_F(PracticeCameraHttp, TheFileTellsTheTiltWithGooglesSigns) {
    PracticeCameraOptions options = small();
    options.errors.tiltSigma = Degrees(8);
    run(options);
    for (int i = 0; i < 5; ++i) {
        const Bytes bytes = download(shoot());
        const YawPitchRoll truth = yawPitchRoll(*readTruth(camera().truthFile()).back().roomFromPhoto);
        EXPECT_NEAR(gpano(bytes, "PosePitchDegrees"), -Degrees(truth.pitch).value(), 1.3);
        EXPECT_NEAR(gpano(bytes, "PoseRollDegrees"), Degrees(truth.roll).value(), 1.3);
    }
}

TEST_F(PracticeCameraHttp, ALevelledPhotoHasNoTilt) {
    PracticeCameraOptions options = small();
    options.levelled = true;
    run(options);
    const Bytes bytes = download(shoot());
    const YawPitchRoll truth = yawPitchRoll(*readTruth(camera().truthFile()).back().roomFromPhoto);
    EXPECT_NEAR(truth.pitch.value(), 0, 1e-12);
    EXPECT_NEAR(truth.roll.value(), 0, 1e-12);
    EXPECT_EQ(gpano(bytes, "PosePitchDegrees"), 0);
    EXPECT_EQ(gpano(bytes, "PoseRollDegrees"), 0);
}

TEST_F(PracticeCameraHttp, AnIdAnswersDoneOnceAndIsThenForgotten) {
    run();
    const std::string id = execute("camera.takePicture")["id"];
    EXPECT_EQ(finished(id)["state"], "done");
    expectRefusal(post("/osc/commands/status", {{"id", id}}, 400), "invalidParameterValue");
    expectRefusal(post("/osc/commands/status", {{"id", "1"}}, 400), "invalidParameterValue");
    expectRefusal(post("/osc/commands/status", Json::object(), 400), "missingParameter");
    const std::string next = execute("camera.takePicture")["id"];
    EXPECT_EQ(std::stoi(next), std::stoi(id) + 1);
}

TEST_F(PracticeCameraHttp, AnIdAnswersDoneForEverIfAsked) {
    PracticeCameraOptions options = small();
    options.doneAnswers = 0;
    run(options);
    const std::string id = execute("camera.takePicture")["id"];
    const Json first = finished(id);
    EXPECT_EQ(first, post("/osc/commands/status", {{"id", id}}));
}

TEST_F(PracticeCameraHttp, ASecondTriggerDuringAnExposureIsRefusedAndStopIsPrompt) {
    PracticeCameraOptions options = small();
    options.timeScale = 1;
    run(options);
    const std::string id = execute("camera.takePicture")["id"];
    expectRefusal(execute("camera.takePicture", Json::object(), 403), "disabledCommand");
    EXPECT_EQ(state()["_captureStatus"], "shooting");
    EXPECT_EQ(post("/osc/commands/status", {{"id", id}})["state"], "inProgress");
    const auto begin = std::chrono::steady_clock::now();
    camera().stop();
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(500));
    EXPECT_EQ(camera().stats().exposures, 0);
    EXPECT_EQ(camera().stats().commands.at("camera.takePicture"), 2);
}

TEST_F(PracticeCameraHttp, ASelfTimerCanBeStopped) {
    PracticeCameraOptions options = small();
    options.timeScale = 1;
    run(options);
    execute("camera.setOptions", {{"options", {{"exposureDelay", 10}}}});
    expectRefusal(execute("camera._stopSelfTimer", Json::object(), 403), "disabledCommand");
    const std::string id = execute("camera.takePicture")["id"];
    EXPECT_EQ(state()["_captureStatus"], "self-timer countdown");
    execute("camera._stopSelfTimer");
    expectRefusal(finished(id, 403), "canceledShooting");
    EXPECT_EQ(state()["_captureStatus"], "idle");
}

TEST_F(PracticeCameraHttp, AFullStorageRefusesToShoot) {
    PracticeCameraOptions options = small();
    options.storageBytes = 10'000;
    run(options);
    expectRefusal(execute("camera.takePicture", Json::object(), 403), "disabledCommand");
    EXPECT_EQ(state()["_cameraError"], Json::array({"NO_MEMORY"}));
}

TEST_F(PracticeCameraHttp, TheSameSeedTakesTheSamePhotos) {
    run();
    const std::string path = shoot();
    const Bytes bytes = download(path);
    const Truth truth = readTruth(camera().truthFile()).at(0);
    TearDown();
    run();
    EXPECT_EQ(shoot(), path);
    const Truth again = readTruth(camera().truthFile()).at(0);
    EXPECT_EQ(again.positionM, truth.positionM);
    EXPECT_EQ(again.roomFromPhoto->coeffs(), truth.roomFromPhoto->coeffs());
    EXPECT_EQ(jpeg::decode(download(path), "photo"), jpeg::decode(bytes, "photo"));
    TearDown();
    PracticeCameraOptions other = small();
    other.errors.seed = 2;
    run(other);
    shoot();
    EXPECT_NE(readTruth(camera().truthFile()).at(0).positionM, truth.positionM);
}

TEST_F(PracticeCameraHttp, ServesTheNearestPhotoOfAFolderUnchanged) {
    const test::TemporaryFolder folder;
    const auto photo = [&](const std::string& name, std::uint8_t grey) {
        RgbImage picture(512, 256);
        std::fill(picture.values().begin(), picture.values().end(), grey);
        const Bytes bytes = jpeg::encode(picture, 90);
        writeFile(folder / name, bytes);
        return bytes;
    };
    const Bytes west = photo("west.jpg", 50);
    const Bytes east = photo("east.jpg", 200);
    PracticeCameraOptions options = small();
    options.photoFolder = folder.path();
    options.photos = {{"west.jpg", {0, 0, 1.2}, {}}, {"east.jpg", {3, 0, 1.2}, yawRotation(Radians(0.5))}};
    run(options);
    camera().setPosition({0.4, 0.3, 1.2});
    EXPECT_EQ(download(shoot()), west);
    camera().setPosition({2.4, 0.3, 1.2});
    EXPECT_EQ(download(shoot()), east);
    const auto truths = readTruth(camera().truthFile());
    EXPECT_FALSE(truths.at(0).roomFromPhoto);
    EXPECT_EQ(truths.at(1).positionM, Eigen::Vector3d(3, 0, 1.2));
    EXPECT_TRUE(truths.at(1).roomFromPhoto);
}

} // namespace
} // namespace spherewalk::practice
