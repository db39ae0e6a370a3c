// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/capture_fixture.h"
#include "expect_error.h"
#include "random.h"

#include "spherewalk/base/json.h"

#include <set>

namespace spherewalk::camera {
namespace {

using namespace std::chrono_literals;
using test::answering;
using test::closeSilently;
using test::expectError;

/// The program's death at an instant.
struct Killed {};

class CaptureRecoveryTest : public test::CaptureFixture {
  protected:
    /// Runs shoot() until the journal has recorded the event, then kills the program and starts it anew.
    void killAfter(const std::string& event, std::int64_t station = 1) {
        journal.onRecorded = [event](const std::string& recorded) {
            if (recorded == event) {
                throw Killed{};
            }
        };
        EXPECT_THROW(capture().shoot(station, {}), Killed);
        journal.onRecorded = [](const std::string&) {};
        start();
    }

    /// The trigger has left and works on the camera, but the program dies before it hears the answer.
    void killDuringTrigger(std::int64_t station = 1) {
        std::stop_source death;
        camera.fault("camera.takePicture", [&](const auto& normal) {
            normal();
            death.request_stop();
            return test::neverAnswer();
        });
        expectError(ErrorKind::Stopped, "", [&] { capture().shoot(station, death.get_token()); });
        start();
    }

    ShotOutcome settleOne() {
        std::vector<ShotOutcome> outcomes = capture().settle({});
        EXPECT_EQ(outcomes.size(), 1U);
        return outcomes.empty() ? ShotOutcome{} : outcomes.front();
    }
};

TEST_F(CaptureRecoveryTest, ProgramsThatAreKilledLeaveTheCamerasSleepToTheLastOne) {
    killAfter("begin");
    killAfter("taken");
    EXPECT_EQ(camera.options["sleepDelay"], 65535);
    capture().prepare({});
    capture().disconnect({});
    EXPECT_EQ(camera.options["sleepDelay"], 180);
    EXPECT_EQ(camera.options["offDelay"], 64800);
    camera.options["sleepDelay"] = 300; // by its owner
    capture().prepare({});
    capture().disconnect({});
    EXPECT_EQ(camera.options["sleepDelay"], 300);
}

TEST_F(CaptureRecoveryTest, NothingOpenNeedsNothing) {
    EXPECT_TRUE(capture().settle({}).empty());
    EXPECT_EQ(clock.passed(), 0s);
}

TEST_F(CaptureRecoveryTest, AShotKilledBeforeItsTriggerIsProvedNotTakenAfterTheDeadline) {
    killAfter("begin");
    const auto begun = clock.passed();
    EXPECT_EQ(settleOne().shot.step, survey::ShotStep::NotTaken);
    EXPECT_GE(clock.passed() - begun, 30s);
    EXPECT_EQ(triggers(), 0);
    EXPECT_EQ(capture().shoot(1, {}).shot.step, survey::ShotStep::Downloaded);
    EXPECT_EQ(triggers(), 1);
}

TEST_F(CaptureRecoveryTest, AShotKilledDuringItsTriggerIsFoundWhileStillExposing) {
    killDuringTrigger();
    const auto begun = clock.passed();
    EXPECT_EQ(settleOne().shot.step, survey::ShotStep::Downloaded);
    EXPECT_LT(clock.passed() - begun, 10s); // as soon as the file is there, not at the deadline
    expectPhoto(1, 2);
    EXPECT_EQ(triggers(), 1);
}

TEST_F(CaptureRecoveryTest, ACameraThatSeemsIdleWhileExposingIsNotTriggeredAgain) {
    camera.showsShooting = false;
    camera.processing = 25s;
    killDuringTrigger();
    const ShotOutcome outcome = capture().shoot(1, {}); // settles by itself before anything new
    EXPECT_EQ(outcome.shot.step, survey::ShotStep::Downloaded);
    EXPECT_EQ(outcome.shot.id, 1);
    expectPhoto(1, 2);
    EXPECT_EQ(triggers(), 1);
}

TEST_F(CaptureRecoveryTest, AnOpenShotOfAnotherStationIsSettledBeforeTheNext) {
    killDuringTrigger(1);
    EXPECT_EQ(capture().shoot(2, {}).shot.step, survey::ShotStep::Downloaded);
    expectPhoto(1, 2);
    expectPhoto(2, 3);
    EXPECT_EQ(triggers(), 2);
}

TEST_F(CaptureRecoveryTest, AnEarlierShotWithoutAPhotoIsNotedWithItsStationBesideTheSentence) {
    killAfter("begin");
    const ShotOutcome outcome = capture().shoot(2, {});
    EXPECT_EQ(outcome.shot.step, survey::ShotStep::Downloaded);
    ASSERT_EQ(outcome.earlier.size(), 1U);
    EXPECT_EQ(outcome.earlier[0].station, 1);
    EXPECT_EQ(outcome.earlier[0].sentence, "The camera has taken no photo; it can be taken again.");
}

TEST_F(CaptureRecoveryTest, AShotThatIsTakenButCannotBeFetchedIsTakenAgainOnlyWhenAskedAgain) {
    capture().prepare({});
    camera.nextPhoto = test::jpegBytes(640, 320);
    EXPECT_EQ(capture().shoot(1, {}).shot.step, survey::ShotStep::Taken);
    camera.nextPhoto = test::jpegBytes(2048, 1024);
    start();
    const ShotOutcome outcome = capture().shoot(1, {});
    EXPECT_EQ(outcome.shot.step, survey::ShotStep::Taken);
    EXPECT_EQ(outcome.problem, ErrorKind::Corrupt);
    EXPECT_EQ(triggers(), 1);
    EXPECT_EQ(capture().shoot(1, {}).shot.step, survey::ShotStep::Downloaded);
    EXPECT_EQ(triggers(), 2);
}

TEST_F(CaptureRecoveryTest, NoSettingIsChangedWhileAShotMayBeExposed) {
    camera.showsShooting = false; // nothing but the journal tells that the camera is at work
    killDuringTrigger();
    const int before = camera.count("camera.setOptions");
    camera.fault(
        "camera.setOptions",
        [&](const auto& normal) {
            EXPECT_EQ(camera.files.size(), 3U) << "changed while the camera was exposing";
            return normal();
        },
        10);
    capture().prepare({});
    EXPECT_GT(camera.count("camera.setOptions"), before);
}

TEST_F(CaptureRecoveryTest, TheDeadlineCountsFromTheIntentionByTheClockOfDay) {
    killAfter("begin");
    clock.advance(1h);
    const auto begun = clock.passed();
    EXPECT_EQ(settleOne().shot.step, survey::ShotStep::NotTaken);
    EXPECT_LT(clock.passed() - begun, 10s);
    EXPECT_GE(clock.passed() - begun, options.confirmTime); // never at the first look
}

TEST_F(CaptureRecoveryTest, AClockSetBackMakesTheWaitNoLongerThanTheAllowance) {
    killAfter("begin");
    clock.jump(-24h);
    const auto begun = clock.passed();
    EXPECT_EQ(settleOne().shot.step, survey::ShotStep::NotTaken);
    EXPECT_GE(clock.passed() - begun, 30s);
    EXPECT_LT(clock.passed() - begun, 40s);
}

TEST_F(CaptureRecoveryTest, AClockSetForwardDoesNotHideAnExposureOfOrdinaryLength) {
    camera.showsShooting = false;
    killDuringTrigger();
    clock.jump(24h);
    EXPECT_EQ(settleOne().shot.step, survey::ShotStep::Unclear);
    EXPECT_EQ(lastShot().fileUrl.substr(0, 7), "http://");
    EXPECT_EQ(triggers(), 1);
}

TEST_F(CaptureRecoveryTest, APictureByTheButtonAfterADeathIsAskedAbout) {
    killAfter("begin"); // the trigger never left, and the camera is carried on
    clock.advance(40s);
    camera.addFile();
    const ShotOutcome outcome = settleOne();
    EXPECT_EQ(outcome.shot.step, survey::ShotStep::Unclear);
    EXPECT_NE(outcome.sentence.find("was taken 40 s after the shutter"), std::string::npos)
        << outcome.sentence;
    EXPECT_NE(outcome.shot.fileUrl, "");
    EXPECT_EQ(capture().shoot(1, {}).shot.step, survey::ShotStep::Downloaded); // taken again
    expectPhoto(2, 3);
}

TEST_F(CaptureRecoveryTest, APictureBeforeTheIntentionIsAskedAbout) {
    killAfter("begin");
    camera.addFile();
    camera.files.back().takenAt = "2026:03:04 00:59:00+01:00";
    EXPECT_EQ(settleOne().shot.step, survey::ShotStep::Unclear);
}

TEST_F(CaptureRecoveryTest, AStartedShotOwnsAPictureOfItsTimeOnly) {
    killAfter("started");
    camera.restart(); // the picture is lost, and the id too
    clock.advance(60s);
    camera.addFile();
    EXPECT_EQ(settleOne().shot.step, survey::ShotStep::Unclear);
}

TEST_F(CaptureRecoveryTest, ACameraThatTellsNoTimesIsAskedAboutUnlessItWasTriggered) {
    camera.tellsTimes = false;
    killDuringTrigger();
    EXPECT_EQ(settleOne().shot.step, survey::ShotStep::Unclear);
    killAfter("started", 2);
    camera.tellsEndOnce = true;
    clock.advance(10s);
    camera.fault("/osc/commands/status", answering(test::answerOsc("invalidParameterValue", 400)), 5);
    EXPECT_EQ(settleOne().shot.step, survey::ShotStep::Downloaded);
}

TEST_F(CaptureRecoveryTest, AnIntentionAtTheEndsOfTimeDoesNoHarm) {
    for (const auto when :
         {std::chrono::system_clock::time_point::min(), std::chrono::system_clock::time_point::max()}) {
        killAfter("begin");
        journal.shots.rbegin()->second.intendedAt = when;
        EXPECT_EQ(settleOne().shot.step, survey::ShotStep::NotTaken);
    }
}

TEST_F(CaptureRecoveryTest, AStartedShotIsFollowedByItsId) {
    killAfter("started");
    const auto begun = clock.passed();
    EXPECT_EQ(settleOne().shot.step, survey::ShotStep::Downloaded);
    EXPECT_LT(clock.passed() - begun, 5s);
    expectPhoto(1, 2);
    EXPECT_EQ(triggers(), 1);
}

TEST_F(CaptureRecoveryTest, AStartedShotWhoseIdIsForgottenIsFoundByItsFile) {
    killAfter("started");
    clock.advance(10s);
    camera.tellsEndOnce = true;
    camera.fault("/osc/commands/status", answering(test::answerOsc("invalidParameterValue", 400)), 2);
    EXPECT_EQ(settleOne().shot.step, survey::ShotStep::Downloaded);
    expectPhoto(1, 2);
}

TEST_F(CaptureRecoveryTest, AStartedShotLostByARestartOfTheCameraIsNotTaken) {
    killAfter("started");
    camera.restart();
    EXPECT_EQ(settleOne().shot.step, survey::ShotStep::NotTaken);
    EXPECT_EQ(capture().shoot(1, {}).shot.step, survey::ShotStep::Downloaded);
    expectPhoto(2, 2);
}

TEST_F(CaptureRecoveryTest, ATakenShotIsOnlyDownloaded) {
    killAfter("taken");
    EXPECT_EQ(settleOne().shot.step, survey::ShotStep::Downloaded);
    expectPhoto(1, 2);
    EXPECT_EQ(triggers(), 1);
    EXPECT_EQ(camera.count("camera.setOptions"), 2); // those of the first run
}

TEST_F(CaptureRecoveryTest, ATakenShotIsDownloadedThoughTheCameraIsFull) {
    killAfter("taken");
    camera.cameraErrors = Json::array({"NO_MEMORY"});
    camera.options["remainingPictures"] = 0;
    EXPECT_EQ(settleOne().shot.step, survey::ShotStep::Downloaded);
}

TEST_F(CaptureRecoveryTest, ADownloadThatWasKilledStartsAnew) {
    std::stop_source death;
    camera.fault("camera.takePicture", [&](const auto& normal) {
        camera.fault("/files/150100525831424d42079d18e0b6c300/100RICOH/R0010050.JPG", [&](const auto& whole) {
            test::ServerAction half = whole();
            half.bytes.resize(half.bytes.size() / 2);
            half.then = test::ServerAction::Then::Stall;
            death.request_stop();
            return half;
        });
        return normal();
    });
    expectError(ErrorKind::Stopped, "", [&] { capture().shoot(1, death.get_token()); });
    writeFile(folder / "shot-1.incoming.1-0.part", bytesOf("left by a kill")); // what a real kill leaves
    start();
    EXPECT_EQ(settleOne().shot.step, survey::ShotStep::Downloaded);
    expectPhoto(1, 2);
    capture().prepare({});
    capture().disconnect({});
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST_F(CaptureRecoveryTest, APhotoOnAnotherCameraWaitsForIt) {
    killAfter("taken");
    camera.serial = "00999999";
    const ShotOutcome outcome = settleOne();
    EXPECT_EQ(outcome.shot.step, survey::ShotStep::Taken);
    EXPECT_EQ(outcome.problem, ErrorKind::NotFound);
    EXPECT_EQ(lastShot().step, survey::ShotStep::Taken);
}

TEST_F(CaptureRecoveryTest, AnOpenShotOfAnotherCameraIsUnclear) {
    killDuringTrigger();
    camera.serial = "00999999";
    EXPECT_EQ(settleOne().shot.step, survey::ShotStep::Unclear);
}

TEST_F(CaptureRecoveryTest, AnOpenShotIsUnclearIfTwoFilesAreNew) {
    killDuringTrigger();
    clock.advance(10s);
    camera.addFile();
    EXPECT_EQ(settleOne().shot.step, survey::ShotStep::Unclear);
}

TEST_F(CaptureRecoveryTest, AnOpenShotStaysOpenWhileTheCameraIsAway) {
    killDuringTrigger();
    capture().connect({});
    camera.fault("/osc/state", answering(closeSilently()), 1000);
    camera.fault("/osc/info", answering(closeSilently()), 1000);
    camera.fault("camera.listFiles", answering(closeSilently()), 1000);
    expectError(ErrorKind::Network, "broke", [&] { capture().settle({}); });
    EXPECT_EQ(lastShot().step, survey::ShotStep::Intended);
    EXPECT_GE(clock.passed(), options.reconnectTime);
}

/// Kills the program again and again at random instants, and loses answers at random; at the end each station
/// has its own photo, and the camera was triggered once for each shot that it took.
TEST_F(CaptureRecoveryTest, AnyDeathAtAnyInstantLeavesEachStationItsOwnPhoto) {
    const std::vector<std::string> steps{"begin", "started", "taken", "downloaded"};
    for (unsigned seed = 0; seed < 8; ++seed) {
        SCOPED_TRACE(seed);
        test::Random random(seed);
        for (int station = 0; station < 3; ++station) {
            const auto shotOfStation = [&]() -> const survey::Shot* {
                for (const auto& [id, shot] : journal.shots) {
                    if (shot.station == static_cast<std::int64_t>(100 * seed) + station &&
                        shot.step == survey::ShotStep::Downloaded) {
                        return &shot;
                    }
                }
                return nullptr;
            };
            const std::size_t filesBefore = camera.files.size();
            while (shotOfStation() == nullptr) {
                camera.clearFaults();
                nextPhotoLooks(static_cast<char>('a' + random.integer(0, 25)));
                camera.showsShooting = random.integer(0, 1) == 1;
                std::stop_source death;
                if (const int fate = random.integer(0, 3); fate < 3) {
                    camera.fault("camera.takePicture", [&, fate](const auto& normal) {
                        if (fate > 0) {
                            normal();
                        }
                        return fate < 2 ? (death.request_stop(), test::neverAnswer()) : closeSilently();
                    });
                }
                const std::string deadly = random.integer(0, 3) == 0 ? "" : steps[random.integer(0, 3)];
                journal.onRecorded = [&](const std::string& event) {
                    if (event == deadly) {
                        throw Killed{};
                    }
                };
                try {
                    start();
                    if (random.integer(0, 1) == 0) {
                        capture().settle(death.get_token());
                    }
                    if (shotOfStation() == nullptr) {
                        capture().shoot(static_cast<std::int64_t>(100 * seed) + station, death.get_token());
                    }
                } catch (const Killed&) {
                    clock.advance(std::chrono::milliseconds(random.integer(0, 5000)));
                } catch (const Error& error) {
                    ASSERT_EQ(name(error.kind()), name(ErrorKind::Stopped)) << error.sentence();
                    clock.advance(std::chrono::milliseconds(random.integer(0, 5000)));
                }
            }
            journal.onRecorded = [](const std::string&) {};
            expectPhoto(shotOfStation()->id, filesBefore);
            EXPECT_EQ(camera.files.size(), filesBefore + 1) << "a second exposure";
        }
    }
}

} // namespace
} // namespace spherewalk::camera
