// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/capture_fixture.h"
#include "expect_error.h"

#include "spherewalk/base/json.h"

namespace spherewalk::camera {
namespace {

using namespace std::chrono_literals;
using test::answering;
using test::answerOsc;
using test::closeSilently;
using test::expectError;
using test::losingTheAnswer;
using testing::ElementsAre;
using testing::HasSubstr;

class CaptureTest : public test::CaptureFixture {};

TEST_F(CaptureTest, TakesTheStationsPhoto) {
    const ShotOutcome outcome = capture().shoot(17, {});
    EXPECT_EQ(outcome.shot.step, survey::ShotStep::Downloaded);
    EXPECT_EQ(outcome.sentence, "");
    EXPECT_EQ(lastShot().station, 17);
    EXPECT_EQ(lastShot().cameraSerial, "00123456");
    EXPECT_EQ(lastShot().baseline.totalEntries, 2);
    ASSERT_TRUE(outcome.photo.has_value());
    EXPECT_EQ(outcome.photo->width, 2048);
    EXPECT_GE(outcome.exposing, 3500ms);
    expectPhoto(outcome.shot.id, 2);
    EXPECT_EQ(triggers(), 1);
}

TEST_F(CaptureTest, RecordsEachStepBeforeTheNextBegins) {
    capture().shoot(1, {});
    EXPECT_THAT(log.only({"begin", "camera.takePicture", "started", "taken", "downloaded"}),
                ElementsAre("begin", "camera.takePicture", "started", "taken", "downloaded"));
    const std::vector<std::string> events = log.events();
    const auto begin = std::find(events.begin(), events.end(), "begin");
    EXPECT_EQ(*(begin + 1), "camera.takePicture"); // nothing comes between the baseline and the trigger
    EXPECT_EQ(*(begin - 1), "camera.listFiles");
    const auto taken = std::find(events.begin(), events.end(), "taken");
    EXPECT_THAT(std::vector<std::string>(taken + 1, events.end()),
                ElementsAre("camera.listFiles", camera.files[2].path, "downloaded"));
}

TEST_F(CaptureTest, TriggersNothingIfTheIntentCannotBeRecorded) {
    journal.onRecorded = [](const std::string&) { throw Error(ErrorKind::Full, "the disk is full"); };
    expectError(ErrorKind::Full, "disk is full", [&] { capture().shoot(1, {}); });
    EXPECT_EQ(triggers(), 0);
}

TEST_F(CaptureTest, TakesManyPhotosEachForItsStation) {
    for (int station = 0; station < 10; ++station) {
        nextPhotoLooks(static_cast<char>('a' + station));
        const ShotOutcome outcome = capture().shoot(station, {});
        EXPECT_EQ(outcome.shot.step, survey::ShotStep::Downloaded) << outcome.sentence;
        expectPhoto(outcome.shot.id, static_cast<std::size_t>(station) + 2);
    }
    EXPECT_EQ(triggers(), 10);
}

TEST_F(CaptureTest, PollsAtTheIntervalUntilDone) {
    capture().connect({});
    capture().prepare({});
    capture().shoot(1, {});
    EXPECT_EQ(camera.count("/osc/commands/status"), 8); // at 0, 0.5, ... 3.5 s
}

TEST_F(CaptureTest, WaitsASecondBetweenSettingsAndTrigger) {
    std::optional<Clock::TimePoint> set;
    std::optional<Clock::TimePoint> triggered;
    const auto noteAt = [this](std::optional<Clock::TimePoint>& when) {
        return [this, &when](const auto& normal) {
            when = clock.now();
            return normal();
        };
    };
    camera.fault("camera.setOptions", noteAt(set), 2);
    camera.fault("camera.takePicture", noteAt(triggered));
    capture().shoot(1, {});
    EXPECT_GE(*triggered - *set, 1s);
}

TEST_F(CaptureTest, RefusesACameraOfAnUnknownLevel) {
    camera.apiLevels = "[3]";
    expectError(ErrorKind::Unsupported, "API level", [&] { capture().connect({}); });
    expectError(ErrorKind::Unsupported, "API level", [&] { capture().shoot(1, {}); });
    EXPECT_EQ(camera.count("camera.setOptions"), 0);
}

TEST_F(CaptureTest, BeginsNoShotOverFilesThatCannotBeCompared) {
    capture().prepare({});
    camera.hostOfUrls = "relative";
    expectError(ErrorKind::Unsupported, "API level 1", [&] { capture().shoot(1, {}); });
    EXPECT_TRUE(journal.shots.empty());
    EXPECT_EQ(triggers(), 0);
}

TEST_F(CaptureTest, StopsTheRunWhenThisComputersDiskFails) {
    std::filesystem::remove(folder.path());
    expectError(ErrorKind::Io, "camera-00123456", [&] { capture().prepare({}); });
    EXPECT_EQ(camera.options["sleepDelay"], 180); // nothing is changed that could not be put back
    std::filesystem::create_directory(folder.path());
    capture().prepare({});
    std::filesystem::remove_all(folder.path());
    expectError(ErrorKind::Io, "shot-1", [&] { capture().shoot(1, {}); });
    EXPECT_EQ(lastShot().step, survey::ShotStep::Taken);
    std::filesystem::create_directory(folder.path());
    EXPECT_EQ(capture().settle({}).at(0).shot.step, survey::ShotStep::Downloaded);
}

TEST_F(CaptureTest, RefusesWhatIsNoCamera) {
    camera.fault("/osc/info", answering(test::answerPage()));
    expectError(ErrorKind::Unsupported, "not a spherical camera", [&] { capture().connect({}); });
}

TEST_F(CaptureTest, ConnectsAtTheThirdTry) {
    camera.fault("/osc/info", answering(closeSilently()), 1);
    EXPECT_EQ(capture().connect({}).model, "RICOH THETA V");
}

TEST_F(CaptureTest, RefusesACameraThatCannotShoot) {
    camera.cameraErrors = Json::array({"NO_MEMORY"});
    expectError(ErrorKind::Full, "storage is full", [&] { capture().prepare({}); });
    camera.cameraErrors = Json::array({"HIGH_TEMPERATURE"});
    expectError(ErrorKind::Busy, "too hot", [&] { capture().prepare({}); });
    camera.cameraErrors = Json::array();
    camera.isPluginRunning = true;
    expectError(ErrorKind::Busy, "plug-in", [&] { capture().prepare({}); });
    camera.isPluginRunning = false;
    camera.battery = 0.1;
    expectError(ErrorKind::Busy, "10 %", [&] { capture().prepare({}); });
    camera.battery = 0.5;
    camera.options["remainingPictures"] = 0;
    expectError(ErrorKind::Full, "storage is full", [&] { capture().prepare({}); });
}

TEST_F(CaptureTest, WarnsOfWhatWillSoonMatter) {
    camera.cameraErrors = Json::array({"NO_DATE_SETTING", "SOMETHING_NEW"});
    camera.battery = 0.3;
    camera.options["remainingPictures"] = 12;
    const CameraReadiness readiness = capture().prepare({});
    EXPECT_THAT(readiness.warnings, ElementsAre(HasSubstr("clock"), HasSubstr("SOMETHING_NEW"),
                                                HasSubstr("30 %"), HasSubstr("only 12 more")));
    EXPECT_EQ(readiness.remainingPhotos, 12);
}

TEST_F(CaptureTest, StopsBeforeAShotWhenStorageIsFull) {
    capture().shoot(1, {});
    camera.options["remainingPictures"] = 0;
    expectError(ErrorKind::Full, "storage is full", [&] { capture().shoot(2, {}); });
    EXPECT_EQ(triggers(), 1);
}

TEST_F(CaptureTest, AppliesItsSettingsAgainAfterARestartOfTheCamera) {
    capture().shoot(1, {});
    camera.restart();
    camera.options["captureMode"] = "video";
    camera.options["sleepDelay"] = 180;
    EXPECT_EQ(capture().shoot(2, {}).shot.step, survey::ShotStep::Downloaded);
    EXPECT_EQ(camera.options["sleepDelay"], 65535);
    capture().disconnect({});
    EXPECT_EQ(camera.options["sleepDelay"], 180);
}

TEST_F(CaptureTest, HoldsTheProfileAtEveryShot) {
    camera.options.update(Json::parse(R"({"exposureProgram": 2, "iso": 0, "whiteBalance": "auto"})"));
    options.profile = survey::parseProfile("iso=200");
    start();
    EXPECT_TRUE(capture().shoot(1, {}).warnings.empty());
    camera.options["iso"] = 0; // as after sleep
    const int before = camera.count("camera.getOptions");
    EXPECT_TRUE(capture().shoot(2, {}).warnings.size() == 1);
    EXPECT_EQ(camera.options["iso"], 200);
    EXPECT_EQ(camera.count("camera.getOptions"),
              before + 4); // the check, its repair's, the times', and the photo's
    EXPECT_TRUE(capture().shoot(3, {}).warnings.empty());
    EXPECT_EQ(camera.count("camera.getOptions"), before + 6);
}

TEST_F(CaptureTest, LetsTheCameraSleepAgainAfterAStop) {
    capture().prepare({});
    EXPECT_EQ(camera.options["sleepDelay"], 65535);
    EXPECT_TRUE(capture().disconnectWithin(10s));
    EXPECT_EQ(camera.options["sleepDelay"], 180);
}

TEST_F(CaptureTest, DoesNotWaitLongForACameraThatIsGone) {
    capture().prepare({});
    camera.fault("camera.setOptions", answering(test::neverAnswer()), 10);
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_FALSE(capture().disconnectWithin(20ms));
    EXPECT_LT(std::chrono::steady_clock::now() - begin, 180ms);
}

TEST_F(CaptureTest, WatchesTheCameraAtEveryShot) {
    capture().shoot(1, {});
    camera.battery = 0.3;
    EXPECT_THAT(capture().shoot(2, {}).warnings, ElementsAre(HasSubstr("30 %")));
    EXPECT_TRUE(capture().shoot(3, {}).warnings.empty()); // said once
    camera.cameraErrors = Json::array({"HIGH_TEMPERATURE"});
    expectError(ErrorKind::Busy, "too hot", [&] { capture().shoot(4, {}); });
    EXPECT_EQ(triggers(), 3);
}

TEST_F(CaptureTest, ForetellsThePhotosThatStorageAndBatteryAllow) {
    camera.battery = 0.9;
    camera.options["remainingPictures"] = 1000;
    capture().shoot(1, {});
    EXPECT_EQ(capture().photosLeft(), 1000);
    for (int station = 2; station <= 11; ++station) {
        camera.battery -= 0.005;
        capture().shoot(station, {});
    }
    EXPECT_NEAR(double(capture().photosLeft().value()), (0.85 - 0.15) / 0.005, 20);
    camera.options["remainingPictures"] = 60;
    capture().shoot(12, {});
    EXPECT_EQ(capture().photosLeft(), 60);
}

TEST_F(CaptureTest, SetsTheClockOnceAndByItself) {
    camera.options["dateTimeZone"] = "1970:01:01 00:00:00+00:00";
    int alone = 0;
    camera.fault(
        "camera.setOptions",
        [&](const auto& normal) {
            alone += camera.lastOptions().contains("dateTimeZone") ? 1 : 0;
            EXPECT_TRUE(!camera.lastOptions().contains("dateTimeZone") || camera.lastOptions().size() == 1);
            return normal();
        },
        20);
    capture().prepare({});
    EXPECT_EQ(alone, 1);
    EXPECT_NE(camera.options["dateTimeZone"], "1970:01:01 00:00:00+00:00");
    capture().prepare({});
    EXPECT_EQ(alone, 1);
}

TEST_F(CaptureTest, WaitsForACameraThatIsAwayBetweenTwoShots) {
    capture().shoot(1, {});
    camera.fault("/osc/info", answering(closeSilently()), 8);
    const ShotOutcome outcome = capture().shoot(2, {});
    EXPECT_EQ(outcome.shot.step, survey::ShotStep::Downloaded);
    EXPECT_THAT(outcome.warnings, ElementsAre(HasSubstr("did not answer for")));
    expectPhoto(2, 3);
}

TEST_F(CaptureTest, GoesOnWhenTheCameraGoesAwayWhileItIsPrepared) {
    capture().shoot(1, {});
    camera.fault("camera.listFiles", answering(closeSilently()), 3);
    EXPECT_EQ(capture().shoot(2, {}).shot.step, survey::ShotStep::Downloaded);
    EXPECT_EQ(triggers(), 2);
}

class CaptureProfileTest : public test::CaptureFixture {
  protected:
    CaptureProfileTest() {
        camera.options.update(Json::parse(R"({"exposureProgram": 2, "iso": 0, "whiteBalance": "auto"})"));
        options.profile = survey::parseProfile("iso=200");
        start();
    }

    /// The camera forgets the profile between the last look and the exposure.
    void forgetAtTheTrigger() {
        camera.fault("camera.takePicture", [&](const auto& normal) {
            camera.options["exposureProgram"] = 2;
            camera.options["iso"] = 0;
            return normal();
        });
    }
};

TEST_F(CaptureProfileTest, AsksAPersonAboutAPhotoThatMayBeExposedOtherwise) {
    capture().prepare({});
    forgetAtTheTrigger();
    const ShotOutcome outcome = capture().shoot(1, {});
    EXPECT_EQ(outcome.shot.step, survey::ShotStep::Unclear);
    EXPECT_THAT(outcome.sentence, HasSubstr("exposed differently"));
    EXPECT_TRUE(journal.photos.empty());
    EXPECT_EQ(capture().shoot(1, {}).shot.step,
              survey::ShotStep::Downloaded); // the profile is in force again
    EXPECT_EQ(camera.options["iso"], 200);
}

TEST_F(CaptureProfileTest, AsksAlsoAboutOneThatAKilledRunLeft) {
    capture().prepare({});
    forgetAtTheTrigger();
    journal.onRecorded = [](const std::string& event) {
        if (event == "started") {
            throw Error(ErrorKind::Io, "the program's death");
        }
    };
    expectError(ErrorKind::Io, "death", [&] { capture().shoot(1, {}); });
    journal.onRecorded = [](const std::string&) {};
    start();
    EXPECT_EQ(capture().settle({}).at(0).shot.step, survey::ShotStep::Unclear);
}

TEST_F(CaptureTest, RefusesToShootWithAnotherCamera) {
    capture().shoot(1, {});
    camera.serial = "00999999";
    expectError(ErrorKind::NotFound, "00999999 instead of 00123456", [&] { capture().shoot(2, {}); });
    EXPECT_EQ(triggers(), 1);
}

TEST_F(CaptureTest, TriesAMomentaryRefusalAgainAsANewShot) {
    camera.fault("camera.takePicture", answering(answerOsc("serviceUnavailable", 503)), 2);
    const ShotOutcome outcome = capture().shoot(1, {});
    EXPECT_EQ(outcome.shot.step, survey::ShotStep::Downloaded);
    EXPECT_THAT(log.only({"begin", "camera.takePicture", "notTaken", "started"}),
                ElementsAre("begin", "camera.takePicture", "notTaken", "begin", "camera.takePicture",
                            "notTaken", "begin", "camera.takePicture", "started"));
    expectPhoto(3, 2);
}

TEST_F(CaptureTest, RepairsTheModeAfterARefusalOnce) {
    capture().prepare({});
    camera.options["captureMode"] = "video";
    EXPECT_EQ(capture().shoot(1, {}).shot.step, survey::ShotStep::Downloaded);
    camera.fault("camera.takePicture", answering(answerOsc("disabledCommand", 403)), 2);
    const ShotOutcome outcome = capture().shoot(2, {});
    EXPECT_EQ(outcome.shot.step, survey::ShotStep::NotTaken);
    EXPECT_THAT(outcome.sentence, HasSubstr("words of the camera"));
    EXPECT_EQ(outcome.problem, ErrorKind::Busy);
    EXPECT_EQ(camera.files.size(), 3U);
}

TEST_F(CaptureTest, ReportsARefusalThatStays) {
    camera.fault("camera.takePicture", answering(answerOsc("noFreeSpace", 403)));
    const ShotOutcome outcome = capture().shoot(1, {});
    EXPECT_EQ(outcome.shot.step, survey::ShotStep::NotTaken);
    EXPECT_EQ(outcome.problem, ErrorKind::Full);
    EXPECT_EQ(triggers(), 1);
}

TEST_F(CaptureTest, SendsOneTriggerWhenTheAnswerIsLost) {
    camera.fault("camera.takePicture", losingTheAnswer());
    const ShotOutcome outcome = capture().shoot(1, {});
    EXPECT_EQ(outcome.shot.step, survey::ShotStep::Downloaded);
    EXPECT_EQ(triggers(), 1);
    EXPECT_EQ(camera.files.size(), 3U);
    expectPhoto(outcome.shot.id, 2);
}

TEST_F(CaptureTest, SendsOneTriggerWhenItIsDroppedBeforeItCounts) {
    camera.fault("camera.takePicture", answering(closeSilently()));
    const ShotOutcome outcome = capture().shoot(1, {});
    EXPECT_EQ(outcome.shot.step, survey::ShotStep::NotTaken);
    EXPECT_EQ(outcome.problem, ErrorKind::NotFound);
    EXPECT_GE(clock.passed(), 30s); // proof takes until the deadline
    EXPECT_EQ(triggers(), 1);
    EXPECT_EQ(lastShot().step, survey::ShotStep::NotTaken);
    EXPECT_EQ(capture().shoot(1, {}).shot.step, survey::ShotStep::Downloaded); // free to be taken again
    expectPhoto(2, 2);
}

TEST_F(CaptureTest, FindsThePhotoWhateverBadAnswerTheTriggerGot) {
    for (const auto& answer :
         {test::answerJson(""), test::answerJson("{"), test::answerPage(), answerOsc("unexpected", 503),
          answerOsc("brandNew", 400), test::answerJson("{}", 503), test::neverAnswer()}) {
        const auto before = camera.files.size();
        camera.fault("camera.takePicture", [&](const auto& normal) {
            normal();
            return answer;
        });
        const ShotOutcome outcome = capture().shoot(1, {});
        EXPECT_EQ(outcome.shot.step, survey::ShotStep::Downloaded) << answer.bytes;
        EXPECT_EQ(camera.files.size(), before + 1) << answer.bytes;
        expectPhoto(outcome.shot.id, before);
    }
}

TEST_F(CaptureTest, FindsThePhotoWhenTheIdIsForgotten) {
    camera.tellsEndOnce = true;
    camera.fault(
        "/osc/commands/status", [](const auto& normal) { return normal(); }, 7);
    camera.fault("/osc/commands/status", losingTheAnswer());
    const ShotOutcome outcome = capture().shoot(1, {});
    EXPECT_EQ(outcome.shot.step, survey::ShotStep::Downloaded);
    expectPhoto(outcome.shot.id, 2);
    EXPECT_EQ(triggers(), 1);
}

TEST_F(CaptureTest, FindsThePhotoWhenDoneComesWithoutItsName) {
    camera.tellsFileUrl = false;
    const ShotOutcome outcome = capture().shoot(1, {});
    EXPECT_EQ(outcome.shot.step, survey::ShotStep::Downloaded);
    expectPhoto(outcome.shot.id, 2);
}

TEST_F(CaptureTest, DoesNotTakeAnOldFileForTheNewOne) {
    camera.fault("/osc/commands/status", [&](const auto&) {
        return test::answerJson(R"({"state":"done","results":{"fileUrl":"http://h)" + camera.files[1].path +
                                R"("}})");
    });
    const ShotOutcome outcome = capture().shoot(1, {});
    EXPECT_EQ(outcome.shot.step, survey::ShotStep::Downloaded);
    expectPhoto(outcome.shot.id, 2);
}

TEST_F(CaptureTest, SurvivesALinkThatBreaksWhilePolling) {
    camera.fault("/osc/commands/status", answering(closeSilently()), 20);
    camera.fault(
        "/osc/info", [](const auto& normal) { return normal(); }, 2);
    camera.fault("/osc/info", answering(closeSilently()), 6);
    const ShotOutcome outcome = capture().shoot(1, {});
    EXPECT_EQ(outcome.shot.step, survey::ShotStep::Downloaded);
    EXPECT_EQ(triggers(), 1);
    expectPhoto(outcome.shot.id, 2);
}

TEST_F(CaptureTest, ReportsAShotCancelledAtTheCamera) {
    camera.fault("/osc/commands/status", answering(answerOsc("canceledShooting", 403)));
    const ShotOutcome outcome = capture().shoot(1, {});
    EXPECT_EQ(outcome.shot.step, survey::ShotStep::NotTaken);
    EXPECT_THAT(outcome.sentence, HasSubstr("cancelled"));
}

TEST_F(CaptureTest, LeavesAShotOpenThatNeverEndsAndSettlesItAfterARestart) {
    camera.isStuck = true;
    camera.showsShooting = false;
    expectError(ErrorKind::Timeout, "switch it off and on", [&] { capture().shoot(1, {}); });
    EXPECT_EQ(lastShot().step, survey::ShotStep::Started);
    expectError(ErrorKind::Timeout, "switch it off and on", [&] { capture().shoot(1, {}); });
    EXPECT_EQ(triggers(), 1);
    camera.isStuck = false;
    camera.restart();
    start();
    EXPECT_EQ(capture().settle({}).at(0).shot.step, survey::ShotStep::NotTaken);
    EXPECT_EQ(capture().shoot(1, {}).shot.step, survey::ShotStep::Downloaded);
}

TEST_F(CaptureTest, LeavesAShotOpenWhileTheCameraStaysBusy) {
    camera.isStuck = true;
    expectError(ErrorKind::Busy, "stays busy", [&] { capture().shoot(1, {}); });
    EXPECT_EQ(lastShot().step, survey::ShotStep::Started);
}

TEST_F(CaptureTest, TakesAPhotoThatComesAtTheVeryDeadline) {
    camera.processing = 29'900ms;
    EXPECT_EQ(capture().shoot(1, {}).shot.step, survey::ShotStep::Downloaded);
}

TEST_F(CaptureTest, TakesAPhotoThatComesAfterTheDeadline) {
    camera.processing = 40s;
    EXPECT_EQ(capture().shoot(1, {}).shot.step, survey::ShotStep::Downloaded);
    EXPECT_EQ(triggers(), 1);
}

TEST_F(CaptureTest, WaitsLongerForLongExposures) {
    camera.options["shutterSpeed"] = 60;
    camera.options["_filter"] = "Noise Reduction";
    camera.processing = 160s;
    camera.showsShooting = false;
    EXPECT_EQ(capture().shoot(1, {}).shot.step, survey::ShotStep::Downloaded);
}

TEST_F(CaptureTest, AsksAPersonWhenTwoPhotosAreNew) {
    camera.fault("camera.takePicture", [&](const auto& normal) {
        normal();
        camera.addFile(); // somebody presses the button
        return closeSilently();
    });
    const ShotOutcome outcome = capture().shoot(1, {});
    EXPECT_EQ(outcome.shot.step, survey::ShotStep::Unclear);
    EXPECT_THAT(outcome.sentence, HasSubstr("2 new photos"));
    EXPECT_EQ(lastShot().note, outcome.sentence);
    EXPECT_TRUE(journal.photos.empty());
}

TEST_F(CaptureTest, TrustsTheCamerasNameForTheFileAmongTwoNewOnes) {
    camera.fault("/osc/commands/status", [&](const auto& normal) {
        camera.addFile("R_button.JPG");
        return normal();
    });
    const ShotOutcome outcome = capture().shoot(1, {});
    EXPECT_EQ(outcome.shot.step, survey::ShotStep::Downloaded);
    expectPhoto(outcome.shot.id, 3);
}

TEST_F(CaptureTest, AsksAPersonWhenTheCameraWasReset) {
    camera.fault("camera.takePicture", [&](const auto&) {
        camera.files.clear();
        camera.addFile("R0010001.JPG");
        return closeSilently();
    });
    const ShotOutcome outcome = capture().shoot(1, {});
    EXPECT_EQ(outcome.shot.step, survey::ShotStep::Unclear);
    EXPECT_THAT(outcome.sentence, HasSubstr("reset"));
}

TEST_F(CaptureTest, AsksAPersonWhenAnotherCameraTakesTheAddress) {
    camera.fault("camera.takePicture", [&](const auto& normal) {
        normal();
        camera.serial = "00999999";
        return closeSilently();
    });
    const ShotOutcome outcome = capture().shoot(1, {});
    EXPECT_EQ(outcome.shot.step, survey::ShotStep::Unclear);
    EXPECT_THAT(outcome.sentence, HasSubstr("00123456"));
    EXPECT_EQ(triggers(), 1);
}

TEST_F(CaptureTest, AsksAPersonWhenAnotherCameraAnswersWhilePolling) {
    camera.fault(
        "/osc/commands/status",
        [&](const auto&) {
            camera.serial = "00999999";
            return closeSilently();
        },
        6);
    EXPECT_EQ(capture().shoot(1, {}).shot.step, survey::ShotStep::Unclear);
}

TEST_F(CaptureTest, KeepsAPhotoThatCannotBeFetchedAsTaken) {
    capture().prepare({});
    camera.nextPhoto = test::jpegBytes(640, 320);
    const ShotOutcome outcome = capture().shoot(1, {});
    EXPECT_EQ(outcome.shot.step, survey::ShotStep::Taken);
    EXPECT_EQ(outcome.problem, ErrorKind::Corrupt);
    EXPECT_THAT(outcome.sentence, HasSubstr("640 x 320"));
    EXPECT_EQ(lastShot().step, survey::ShotStep::Taken);
    camera.nextPhoto = test::jpegBytes(2048, 1024);
    EXPECT_EQ(capture().shoot(2, {}).shot.step, survey::ShotStep::Downloaded); // the run may go on
}

TEST_F(CaptureTest, ExposesAndFetchesApart) {
    const ShotOutcome exposed = capture().expose(1, {});
    EXPECT_EQ(exposed.shot.step, survey::ShotStep::Taken);
    EXPECT_TRUE(journal.photos.empty());
    EXPECT_EQ(capture().fetch(exposed.shot, {}).shot.step, survey::ShotStep::Downloaded);
    expectPhoto(exposed.shot.id, 2);
}

TEST_F(CaptureTest, StopsDuringATriggerAndLeavesTheShotOpen) {
    std::stop_source stop;
    camera.fault("camera.takePicture", [&](const auto& normal) {
        normal();
        stop.request_stop();
        return test::neverAnswer();
    });
    expectError(ErrorKind::Stopped, "Stopped", [&] { capture().shoot(1, stop.get_token()); });
    EXPECT_EQ(lastShot().step, survey::ShotStep::Intended);
    EXPECT_EQ(capture().settle({}).at(0).shot.step, survey::ShotStep::Downloaded);
    EXPECT_EQ(triggers(), 1);
}

TEST_F(CaptureTest, StopsBetweenTwoQuestions) {
    std::stop_source stop;
    camera.fault("/osc/commands/status", [&](const auto& normal) {
        stop.request_stop();
        return normal();
    });
    expectError(ErrorKind::Stopped, "Stopped", [&] { capture().shoot(1, stop.get_token()); });
    EXPECT_EQ(lastShot().step, survey::ShotStep::Started);
}

TEST(CaptureOptions, ScalesTheCamerasTimes) {
    const CaptureOptions fast = CaptureOptions().scaled(0.01);
    EXPECT_EQ(fast.pollInterval, 5ms);
    EXPECT_EQ(fast.allowance.of({{"exposureDelay", 10}}), 400ms);
    expectError(ErrorKind::InvalidInput, "time scale", [] { CaptureOptions().scaled(0); });
}

TEST(CaptureOptions, RefusesValuesOutOfRange) {
    CaptureOptions options;
    options.download.check = test::checkJpeg;
    options.validate();
    options.pollInterval = 0ms;
    expectError(ErrorKind::InvalidInput, "pollInterval", [&] { options.validate(); });
}

} // namespace
} // namespace spherewalk::camera
