// SPDX-License-Identifier: GPL-3.0-or-later
// The workflow against a practice camera that does everything wrong that it can. Whatever happens, each
// station ends with its own photo, taken with the profile's exposure.
#include "capture/practice_fixture.h"
#include "expect_error.h"

namespace spherewalk::camera {
namespace {

using practice::FaultKind;
using test::expectError;
using testing::HasSubstr;

struct Call {
    std::string on;
    bool isTrigger = false;
};

void PrintTo(const Call& call, std::ostream* out) {
    *out << call.on;
}

class FaultOfOneRequest : public test::PracticeFixture, public testing::WithParamInterface<Call> {};

TEST_P(FaultOfOneRequest, IsOvercomeAndSendsNoSecondTrigger) {
    runCamera();
    expectRightPhoto(shoot(0));
    int station = 0;
    for (const FaultKind kind :
         {FaultKind::NeverAnswer, FaultKind::DropBeforeExecuting, FaultKind::ExecuteThenDrop,
          FaultKind::ServiceUnavailable, FaultKind::EmptyBody, FaultKind::MalformedJson,
          FaultKind::TruncatedJson, FaultKind::ShortLength, FaultKind::LongLength, FaultKind::Chunked}) {
        SCOPED_TRACE(practice::name(kind));
        ++station;
        arm(kind, GetParam().on);
        ShotOutcome outcome = shoot(station);
        if (outcome.shot.step == survey::ShotStep::NotTaken) { // which is right only if nothing was done
            EXPECT_TRUE(GetParam().isTrigger);
            EXPECT_EQ(exposuresOf(station), 0);
            EXPECT_NE(outcome.sentence, "");
            outcome = shoot(station);
        }
        expectRightPhoto(outcome);
        EXPECT_EQ(exposuresOf(station), 1);
    }
    EXPECT_EQ(practice().stats().exposures, station + 1);
}

INSTANTIATE_TEST_SUITE_P(All, FaultOfOneRequest,
                         testing::Values(Call{"/osc/info"}, Call{"/osc/state"}, Call{"camera.getOptions"},
                                         Call{"camera.setOptions"}, Call{"camera.listFiles"},
                                         Call{"camera.takePicture", true}, Call{"/osc/commands/status"}));

class PracticeFaults : public test::PracticeFixture {};

TEST_F(PracticeFaults, EveryRefusalOfATriggerIsToldOrRepeatedOnce) {
    runCamera();
    int station = 0;
    for (const char* code : {"unknownCommand", "disabledCommand", "missingParameter", "invalidParameterName",
                             "invalidParameterValue", "tooManyParameters", "powerOffSequenceRunning",
                             "serviceUnavailable", "unexpected", "deviceBusy", "noFreeSpace",
                             "canceledShooting", "corruptedFile", "invalidFileFormat", "serverError"}) {
        SCOPED_TRACE(code);
        ++station;
        practice().arm({FaultKind::Refuse, "camera.takePicture", 0, 1, 0, 0, code});
        ShotOutcome outcome = shoot(station);
        if (outcome.shot.step == survey::ShotStep::NotTaken) {
            EXPECT_NE(outcome.sentence, "");
            EXPECT_EQ(exposuresOf(station), 0);
            outcome = shoot(station);
        }
        expectRightPhoto(outcome);
        EXPECT_EQ(exposuresOf(station), 1);
    }
}

TEST_F(PracticeFaults, WhatIsSaidOfAShotDoesNotMatterIfItsFileIsThere) {
    runCamera();
    int station = 0;
    for (const FaultKind kind : {FaultKind::ForgetIds, FaultKind::DoneWithoutUrl, FaultKind::UrlOfOtherHost,
                                 FaultKind::StuckInProgress, FaultKind::UnknownValues}) {
        SCOPED_TRACE(practice::name(kind));
        arm(kind, "/osc/commands/status");
        const ShotOutcome outcome = shoot(++station);
        expectRightPhoto(outcome);
        EXPECT_EQ(exposuresOf(station), 1);
    }
}

TEST_F(PracticeFaults, ADownloadIsStartedAgain) {
    runCamera();
    int station = 0;
    for (const FaultKind kind :
         {FaultKind::MissingFile, FaultKind::CutDownload, FaultKind::StallDownload,
          FaultKind::CorruptDownload, FaultKind::ServiceUnavailable, FaultKind::NeverAnswer}) {
        SCOPED_TRACE(practice::name(kind));
        practice().arm({kind, "/files", 0, 1, 20'000}); // behind the metadata, where a decoder sees it
        expectRightPhoto(shoot(++station));
        EXPECT_EQ(exposuresOf(station), 1);
    }
}

TEST_F(PracticeFaults, APhotoThatIsNoneStaysOnTheCameraAndIsTold) {
    runCamera();
    int station = 0;
    for (const FaultKind kind : {FaultKind::EmptyPhoto, FaultKind::SmallPhoto}) {
        SCOPED_TRACE(practice::name(kind));
        arm(kind, "camera.takePicture");
        const ShotOutcome outcome = shoot(++station);
        EXPECT_EQ(outcome.shot.step, survey::ShotStep::Taken);
        EXPECT_NE(outcome.sentence, "");
        expectRightPhoto(shoot(station));
    }
    for (const FaultKind kind : {FaultKind::NoMakerNote, FaultKind::HostileMakerNote}) {
        arm(kind, "camera.takePicture");
        expectRightPhoto(shoot(++station));
    }
}

TEST_F(PracticeFaults, ACameraThatSleepsOrRestartsBetweenShotsGetsItsSettingsBack) {
    runCamera();
    expectRightPhoto(shoot(1));
    int station = 1;
    for (const FaultKind kind : {FaultKind::Sleep, FaultKind::Reboot, FaultKind::RefuseConnections}) {
        for (const char* on : {"/osc/info", "/osc/state", "camera.getOptions", "camera.listFiles"}) {
            SCOPED_TRACE(std::string(practice::name(kind)) + " " + on);
            arm(kind, on, 1, 20);
            const ShotOutcome outcome = shoot(++station);
            expectRightPhoto(outcome);
            EXPECT_EQ(exposuresOf(station), 1);
        }
    }
}

TEST_F(PracticeFaults, ARestartWhileThePictureIsProcessedLosesItAndIsTold) {
    runCamera();
    expectRightPhoto(shoot(1));
    arm(FaultKind::Reboot, "exposing", 1, 10);
    const ShotOutcome lost = shoot(2);
    EXPECT_EQ(lost.shot.step, survey::ShotStep::NotTaken);
    EXPECT_EQ(exposuresOf(2), 0);
    expectRightPhoto(shoot(2));
    EXPECT_EQ(exposuresOf(2), 1);
}

TEST_F(PracticeFaults, ARestartAfterThePictureIsWrittenLosesNothing) {
    captureOptions.profile.reset();
    runCamera();
    shoot(1);
    arm(FaultKind::Reboot, "written", 1, 10);
    EXPECT_EQ(shoot(2).shot.step, survey::ShotStep::Downloaded);
    EXPECT_EQ(exposuresOf(2), 1);
}

TEST_F(PracticeFaults, ARestartAfterThePictureIsWrittenLeavesNoProofOfItsExposure) {
    runCamera();
    expectRightPhoto(shoot(1));
    arm(FaultKind::Reboot, "written", 1, 10);
    const ShotOutcome outcome = shoot(2);
    EXPECT_EQ(outcome.shot.step, survey::ShotStep::Unclear);
    EXPECT_THAT(outcome.sentence, HasSubstr("R0010002.JPG"));
    expectRightPhoto(shoot(2));
}

TEST_F(PracticeFaults, ASleepDuringADownloadOnlyDelaysIt) {
    runCamera();
    arm(FaultKind::Sleep, "/files", 1, 20);
    ShotOutcome outcome = shoot(1);
    // A busy machine may wake the camera only after several tries.
    for (int i = 0; i < 100 && outcome.shot.step == survey::ShotStep::Taken; ++i) {
        outcome = capture().settle({}).at(0);
    }
    expectRightPhoto(outcome);
    EXPECT_EQ(exposuresOf(1), 1);
}

TEST_F(PracticeFaults, SettingsThatAreLostAreSetAgainOrThePhotoIsDoubted) {
    runCamera();
    expectRightPhoto(shoot(1));
    int station = 1;
    for (const char* on : {"/osc/info", "/osc/state", "camera.getOptions"}) {
        arm(FaultKind::ResetSettings, on);
        const ShotOutcome outcome = shoot(++station);
        EXPECT_FALSE(outcome.warnings.empty());
        expectRightPhoto(outcome);
    }
    for (const char* on : {"camera.listFiles", "camera.takePicture"}) { // after the last look
        arm(FaultKind::ResetSettings, on);
        const ShotOutcome outcome = shoot(++station);
        EXPECT_EQ(outcome.shot.step, survey::ShotStep::Unclear);
        EXPECT_THAT(outcome.sentence, HasSubstr("exposed differently"));
        expectRightPhoto(shoot(station));
    }
}

TEST_F(PracticeFaults, APictureByTheButtonIsGivenToNoStation) {
    runCamera();
    int station = 0;
    for (const char* on : {"/osc/info", "camera.takePicture", "exposing", "/osc/commands/status"}) {
        SCOPED_TRACE(on);
        arm(FaultKind::ExtraPhoto, on);
        expectRightPhoto(shoot(++station));
    }
    arm(FaultKind::ExtraPhoto, "camera.takePicture");
    arm(FaultKind::ExecuteThenDrop, "camera.takePicture");
    const ShotOutcome outcome = shoot(++station);
    EXPECT_EQ(outcome.shot.step, survey::ShotStep::Unclear) << "two new files, and no word which is which";
    EXPECT_NE(outcome.sentence, "");
    expectRightPhoto(shoot(station));
}

TEST_F(PracticeFaults, ARunEndsWithASentenceWhenTheCameraCanTakeNoMore) {
    runCamera();
    expectRightPhoto(shoot(1));
    const auto ends = [&](FaultKind kind, ErrorKind error, const char* word, double amount = 0) {
        SCOPED_TRACE(practice::name(kind));
        arm(kind, "/osc/info", 1, amount);
        expectError(error, word, [&] { shoot(2); });
        practice().disarm();
    };
    ends(FaultKind::StorageFull, ErrorKind::Full, "full");
    ends(FaultKind::Battery, ErrorKind::Busy, "10 %", 0.9);
    ends(FaultKind::Hot, ErrorKind::Busy, "too hot");
    ends(FaultKind::Plugin, ErrorKind::Busy, "plug-in");
    ends(FaultKind::OtherSerial, ErrorKind::NotFound, "Another camera");
    EXPECT_EQ(exposuresOf(2), 0);
    arm(FaultKind::StorageFull, "camera.takePicture");
    expectError(ErrorKind::Full, "full", [&] { shoot(2); });
    practice().disarm();
    expectRightPhoto(shoot(2));
}

TEST_F(PracticeFaults, AClockThatIsUnsetIsSet) {
    runCamera();
    arm(FaultKind::ClockUnset, "/osc/info");
    capture().connect({});
    capture().prepare({});
    expectRightPhoto(shoot(1));
    EXPECT_THAT(truths().at(0).time, testing::Not(testing::StartsWith("1970")));
}

TEST_F(PracticeFaults, ACounterThatBeginsAnewMixesNothingUp) {
    runCamera();
    expectRightPhoto(shoot(1));
    arm(FaultKind::RestartCounter, "/osc/info");
    expectRightPhoto(shoot(2)); // its file has the first one's name
    arm(FaultKind::RestartCounter, "camera.takePicture");
    const ShotOutcome outcome = shoot(3);
    if (outcome.shot.step == survey::ShotStep::Unclear) {
        EXPECT_NE(outcome.sentence, "");
        expectRightPhoto(shoot(3));
    } else {
        expectRightPhoto(outcome);
    }
}

TEST_F(PracticeFaults, ANameGivenAgainIsNotTakenForThePhotoThatHadIt) {
    runCamera();
    practice().setPosition({1, 0, 1});
    const survey::Shot taken = capture().expose(1, {}).shot;
    ASSERT_EQ(taken.step, survey::ShotStep::Taken);
    practice().befall({FaultKind::RestartCounter, ""});
    practice().setPosition({2, 0, 1});
    practice().befall({FaultKind::ExtraPhoto, ""}); // under the same name
    const ShotOutcome outcome = capture().fetch(taken, {});
    EXPECT_EQ(outcome.shot.step, survey::ShotStep::Taken);
    EXPECT_THAT(outcome.sentence, HasSubstr("another photo"));
    EXPECT_TRUE(journal.photos.empty());
}

TEST_F(PracticeFaults, ASlowCameraIsWaitedFor) {
    runCamera();
    arm(FaultKind::Slow, "/osc/info", 1, 30);
    expectRightPhoto(shoot(1));
    expectRightPhoto(shoot(2));
}

} // namespace
} // namespace spherewalk::camera
