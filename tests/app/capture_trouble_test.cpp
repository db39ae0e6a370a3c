// SPDX-License-Identifier: GPL-3.0-or-later
// What this computer can do to a capture: a sentence, and nothing lost.
#include "cli_run.h"
#include "temporary_folder.h"

#include "spherewalk/practice/practice_camera.h"
#include "spherewalk/practice/truth.h"
#include "spherewalk/store/survey_store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <optional>
#include <unistd.h>

namespace spherewalk {
namespace {

using test::runCli;
using testing::HasSubstr;

class CaptureTrouble : public testing::Test {
  protected:
    CaptureTrouble() {
        startCamera(0.02);
        const auto made = runCli({"new", survey, "--rect", "0,0,2,1.6", "--ceiling", "2.6", "--step", "0.6"});
        EXPECT_EQ(made.status, 0) << made.errors;
    }

    void startCamera(double timeScale, practice::CameraModel model = practice::CameraModel::ThetaV) {
        practice::PracticeCameraOptions options;
        options.model = model;
        options.width = 1024;
        options.isPlain = true;
        options.timeScale = timeScale;
        options.truthFile = folder / "truth.jsonl";
        camera.emplace(options);
        camera->start();
    }

    std::vector<std::string> capture() const {
        return {
            "capture",      survey, "--practice", "--camera", "127.0.0.1:" + std::to_string(camera->port()),
            "--time-scale", "0.02"};
    }

    /// Every station has its photo, and the camera took no other.
    void expectComplete() {
        const auto result = runCli(capture());
        EXPECT_EQ(result.status, 0) << result.errors;
        const auto store = store::SurveyStore::open(survey, store::Access::Read);
        EXPECT_TRUE(store.check(noProgress(), {}).isSound());
        EXPECT_TRUE(store.stationsWithoutPhoto().empty());
        EXPECT_EQ(practice::readTruth(folder / "truth.jsonl").size(), store.photos().size());
    }

    int commands(const std::string& name) const {
        const auto counts = camera->stats().commands;
        const auto found = counts.find(name);
        return found == counts.end() ? 0 : found->second;
    }

    test::TemporaryFolder folder;
    std::optional<practice::PracticeCamera> camera;
    std::string survey = (folder / "Messe M\xc3\xbcnchen \xe6\xb8\xac\xe9\x87\x8f 1.spherewalk").string();
};

TEST_F(CaptureTrouble, ACameraOfLevelOneIsUsedInOneSessionWhichIsClosed) {
    camera.reset();
    startCamera(0.02, practice::CameraModel::LevelOne);
    expectComplete();
    EXPECT_EQ(commands("camera.startSession"), 1);
    EXPECT_EQ(commands("camera.closeSession"), 1);
    const auto listed =
        runCli({"camera", "list", "--camera", "127.0.0.1:" + std::to_string(camera->port()), "--json"});
    ASSERT_EQ(listed.status, 0) << listed.errors;
    EXPECT_GT(listed.json()["total"], 0);
}

TEST_F(CaptureTrouble, ACameraThatKeepsNoExposureStopsAtTheSecondStation) {
    camera->arm({practice::FaultKind::ResetSettings, "camera.getOptions", 0, 10'000});
    std::vector<std::string> fixed = capture();
    fixed.insert(fixed.end(), {"--profile", "iso=200"});
    const auto result = runCli(fixed);
    EXPECT_EQ(result.status, 1);
    EXPECT_THAT(result.errors, HasSubstr("--profile camera"));
    EXPECT_EQ(practice::readTruth(folder / "truth.jsonl").size(), 1U);
}

TEST_F(CaptureTrouble, APathWithSpacesAndLettersOfAnyScriptIsAPath) {
    expectComplete();
}

TEST_F(CaptureTrouble, AFullDiskEndsTheRunWithASentenceAndNoPhotoIsTakenTwice) {
    // No file may grow beyond this, as on a disk with so little left: the survey fits, a photo does not.
    const auto refused = runCli(capture(), {"", 5'000});
    EXPECT_NE(refused.status, 0);
    EXPECT_THAT(refused.errors, HasSubstr("full"));
    expectComplete();
}

TEST_F(CaptureTrouble, ASurveyThatMayNotBeWrittenIsLeftAlone) {
    std::filesystem::permissions(survey,
                                 std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
    const auto refused = runCli(capture(), {.obeysPermissions = true});
    std::filesystem::permissions(survey, std::filesystem::perms::owner_all);
    EXPECT_NE(refused.status, 0);
    EXPECT_THAT(refused.errors, HasSubstr(survey));
    EXPECT_EQ(camera->stats().exposures, 0);
    expectComplete();
}

TEST_F(CaptureTrouble, ASecondProgramOnTheSurveyIsSentAway) {
    startCamera(0.1); // The first program is at work for some seconds.
    std::vector<std::string> command = capture();
    command.insert(command.begin(), SPHEREWALK_CLI);
    test::Program first(command);
    while (camera->stats().commands.empty() && !first.endsWithin(std::chrono::milliseconds(5))) {
    }
    const auto second = runCli(capture());
    EXPECT_NE(second.status, 0);
    EXPECT_THAT(second.errors, HasSubstr("another program"));
    EXPECT_EQ(first.wait(), 0) << first.errors();
    expectComplete();
}

TEST_F(CaptureTrouble, APasswordComesFromTheEnvironment) {
    practice::PracticeCameraOptions options;
    options.width = 1024;
    options.isPlain = true;
    options.digestUser = "THETAYL00123456";
    options.digestPassword = "00123456";
    practice::PracticeCamera guarded(options);
    guarded.start();
    const std::vector<std::string> info{"camera", "info", "--camera",
                                        "127.0.0.1:" + std::to_string(guarded.port())};
    const auto refused = runCli(info);
    EXPECT_NE(refused.status, 0);
    EXPECT_THAT(refused.errors, HasSubstr("password"));
    ::setenv("SPHEREWALK_CAMERA_USER", "THETAYL00123456", 1);
    ::setenv("SPHEREWALK_CAMERA_PASSWORD", "00123456", 1);
    const auto answered = runCli(info);
    ::unsetenv("SPHEREWALK_CAMERA_USER");
    ::unsetenv("SPHEREWALK_CAMERA_PASSWORD");
    EXPECT_EQ(answered.status, 0) << answered.errors;
    EXPECT_THAT(answered.output, HasSubstr("RICOH THETA V"));
}

} // namespace
} // namespace spherewalk
