// SPDX-License-Identifier: GPL-3.0-or-later
// Cameras of API level 1, and cameras that want a password.
#include "capture/practice_fixture.h"
#include "expect_error.h"
#include "http/scripted_server.h"
#include "osc/session_note.h"

#include "spherewalk/camera/live_preview.h"

namespace spherewalk::camera {
namespace {

using practice::CameraModel;
using practice::FaultKind;
using test::expectError;

class CameraLevels : public test::PracticeFixture {
  protected:
    void runModel(CameraModel model) {
        cameraOptions.model = model;
        runCamera();
    }

    int commands(const std::string& name) {
        const auto counts = practice().stats().commands;
        const auto found = counts.find(name);
        return found == counts.end() ? 0 : found->second;
    }
};

TEST_F(CameraLevels, AThetaSIsSwitchedToLevelTwoBeforeAnythingElse) {
    runModel(CameraModel::ThetaS);
    for (int station = 1; station <= 3; ++station) {
        expectRightPhoto(shoot(station));
    }
    EXPECT_EQ(commands("camera.startSession"), 1);
    EXPECT_EQ(commands("camera.listImages"), 0);
}

TEST_F(CameraLevels, AThetaSThatFallsBackIsSwitchedAgainAndGetsItsSettingsBack) {
    runModel(CameraModel::ThetaS);
    expectRightPhoto(shoot(1));
    int station = 1;
    for (const char* on : {"/osc/info", "/osc/state", "camera.getOptions", "camera.listFiles",
                           "camera.takePicture", "/osc/commands/status"}) {
        SCOPED_TRACE(on);
        arm(FaultKind::LevelOne, on);
        ++station;
        expectRightPhoto(shoot(station));
        EXPECT_EQ(exposuresOf(station), 1);
    }
    arm(FaultKind::Reboot, "/osc/info", 1, 20);
    expectRightPhoto(shoot(++station));
    arm(FaultKind::Sleep, "camera.getOptions", 1, 20);
    expectRightPhoto(shoot(++station));
}

TEST_F(CameraLevels, ACameraOfLevelOneTakesPhotosInSessions) {
    runModel(CameraModel::LevelOne);
    for (int station = 1; station <= 5; ++station) {
        expectRightPhoto(shoot(station));
    }
    EXPECT_EQ(commands("camera.startSession"), 1);
    EXPECT_EQ(commands("camera.getImage"), 5);
    FileQuery query;
    query.startPosition = 1;
    query.entryCount = 3;
    const FileList files = client->listFiles(query, {});
    EXPECT_EQ(files.totalEntries, 5);
    ASSERT_EQ(files.entries.size(), 3U);
    EXPECT_EQ(files.entries[0].fileUrl, "/100RICOH/R0010004.JPG");
    capture().disconnect({});
}

TEST_F(CameraLevels, ASessionThatHasEndedIsBegunAnew) {
    runModel(CameraModel::LevelOne);
    expectRightPhoto(shoot(1));
    int station = 1;
    for (const char* on : {"/osc/info", "camera.getOptions", "camera.takePicture"}) {
        SCOPED_TRACE(on);
        arm(FaultKind::LevelOne, on); // which ends the session
        ++station;
        expectRightPhoto(shoot(station));
        EXPECT_EQ(exposuresOf(station), 1);
    }
    arm(FaultKind::ExecuteThenDrop, "camera.takePicture");
    expectRightPhoto(shoot(++station));
    arm(FaultKind::ForgetIds, "/osc/commands/status");
    expectRightPhoto(shoot(++station));
    practice().arm({FaultKind::CutDownload, "/files", 0, 1, 3000});
    expectRightPhoto(shoot(++station));
    practice().arm({FaultKind::Refuse, "camera.startSession", 0, 1, 0, 0, "cameraInExclusiveUse"});
    start();
    expectError(ErrorKind::Busy, "close the other program", [&] { shoot(9); });
}

TEST_F(CameraLevels, AllClientsOfACameraOfLevelOneShareItsSessionAndTheLastClosesIt) {
    runModel(CameraModel::LevelOne);
    const ShotOutcome taken = capture().expose(1, {});
    ASSERT_EQ(taken.shot.step, survey::ShotStep::Taken) << taken.sentence;
    auto fetcher = client->another();
    EXPECT_EQ(downloadPhoto(*fetcher, systemClock(), taken.shot.fileUrl, folder / "1.jpg",
                            captureOptions.download, {})
                  .width,
              1024);
    EXPECT_EQ(commands("camera.startSession"), 1);
    fetcher.reset();
    EXPECT_EQ(commands("camera.closeSession"), 0);
    start(); // the program ends, and begins again
    EXPECT_EQ(commands("camera.closeSession"), 1);
    expectRightPhoto(shoot(2));
    EXPECT_EQ(commands("camera.startSession"), 2);
}

TEST_F(CameraLevels, TheSessionOfAProgramThatWasKilledIsTakenOver) {
    runModel(CameraModel::LevelOne);
    client->info({});
    client->getOptions({"iso"}, {});
    // What a program leaves that can neither close its session nor forget it.
    auto killed = std::move(client);
    start();
    expectRightPhoto(shoot(1));
    EXPECT_EQ(commands("camera.updateSession"), 1);
    EXPECT_EQ(commands("camera.closeSession"), 0);
}

TEST_F(CameraLevels, TheSessionOfAnotherUserOrComputerIsNotTakenOver) {
    runModel(CameraModel::LevelOne);
    OscClient telephone({"127.0.0.1", practice().port()}, oscOptions, systemClock());
    telephone.info({});
    telephone.getOptions({"iso"}, {});
    SessionNote({"127.0.0.1", practice().port()}).clear(); // which is not on the telephone
    expectError(ErrorKind::Busy, "close the other program", [&] { shoot(1); });
    EXPECT_EQ(telephone.getOptions({"iso"}, {})["iso"], 0);
}

TEST_F(CameraLevels, ASessionWhoseNameWasLostOnTheWayIsGoneOnWith) {
    runModel(CameraModel::LevelOne);
    arm(FaultKind::ExecuteThenDrop, "camera.startSession");
    expectRightPhoto(shoot(1));
    EXPECT_EQ(commands("camera.startSession"), 2);
}

TEST_F(CameraLevels, ASessionIsNamedOnlyWhereItBelongs) {
    runModel(CameraModel::LevelOne);
    client->info({});
    EXPECT_EQ(client->listFiles({}, {}).totalEntries, 0); // the practice camera refuses a session there
    EXPECT_EQ(commands("camera.startSession"), 0);
}

class CameraPassword : public test::PracticeFixture {
  protected:
    CameraPassword() {
        cameraOptions.digestUser = "THETAYL00123456";
        cameraOptions.digestPassword = "00123456";
        oscOptions.http.credentials = [this]() -> std::optional<Credentials> {
            ++asked;
            return credentials;
        };
    }

    std::optional<Credentials> credentials = Credentials{"THETAYL00123456", "00123456"};
    int asked = 0;
};

TEST_F(CameraPassword, LetsTheWholeWorkflowThrough) {
    runCamera();
    for (int station = 1; station <= 3; ++station) {
        expectRightPhoto(shoot(station));
    }
    EXPECT_EQ(asked, 1);
    EXPECT_EQ(practice().stats().commands.at("camera.takePicture"), 3);
    int commands = 0;
    for (const auto& [name, count] : practice().stats().commands) {
        commands += count;
    }
    // A challenge at the first request, and at each trigger, which goes its own way.
    EXPECT_LE(practice().stats().requests.at("POST /osc/commands/execute"), commands + 1 + 3);
}

TEST_F(CameraPassword, ANonceThatEndsAtAnyRequestIsRenewed) {
    cameraOptions.nonceRequests = 3;
    runCamera();
    for (int station = 1; station <= 4; ++station) {
        expectRightPhoto(shoot(station));
        EXPECT_EQ(exposuresOf(station), 1);
    }
    EXPECT_EQ(asked, 1);
    arm(FaultKind::Reboot, "/osc/info", 1, 10);
    expectRightPhoto(shoot(5));
}

TEST_F(CameraPassword, ATriggerWhoseAnswerIsLostIsNotSentAgainForThePassword) {
    cameraOptions.nonceRequests = 1; // so that every trigger is challenged
    runCamera();
    for (int station = 1; station <= 4; ++station) {
        arm(FaultKind::ExecuteThenDrop, "camera.takePicture");
        expectRightPhoto(shoot(station));
        EXPECT_EQ(exposuresOf(station), 1);
    }
    EXPECT_EQ(practice().stats().commands.at("camera.takePicture"), 4);
}

TEST_F(CameraPassword, AWrongOneIsToldAfterOneTry) {
    runCamera();
    credentials->password = "wrong";
    expectError(ErrorKind::Unsupported, "user name and a password", [&] { client->info({}); });
    EXPECT_EQ(asked, 2);                                           // and the same was said again
    EXPECT_LE(practice().stats().requests.at("GET /osc/info"), 3); // bare, for the nonce, with the answer
    credentials->password = "00123456";                            // asked for anew, and right now
    EXPECT_EQ(client->info({}).model, "RICOH THETA V");
    EXPECT_EQ(asked, 3);
}

TEST_F(CameraPassword, AnotherIsAskedForAtOnceAfterAWrongOne) {
    oscOptions.http.credentials = [this]() -> std::optional<Credentials> {
        return Credentials{"THETAYL00123456", ++asked < 3 ? "wrong " + std::to_string(asked) : "00123456"};
    };
    runCamera();
    EXPECT_EQ(client->info({}).model, "RICOH THETA V");
    EXPECT_EQ(asked, 3);
}

TEST_F(CameraPassword, IsAskedForOnceForAllClientsOfOneCamera) {
    oscOptions.http.credentials =
        rememberingCredentials([this]() -> std::optional<Credentials> { return ++asked, credentials; });
    runCamera();
    client->info({});
    client->another()->info({});
    OscClient(client->endpoint(), oscOptions, systemClock()).info({});
    EXPECT_EQ(asked, 1);
    credentials->password = "wrong";
    practice().stop();
    cameraOptions.digestPassword = "changed";
    runCamera();
    expectError(ErrorKind::Unsupported, "user name and a password", [&] { client->info({}); });
    EXPECT_EQ(asked, 3); // after the one that was known, and after a wrong one
}

TEST_F(CameraPassword, NoneIsToldAsWell) {
    runCamera();
    credentials.reset();
    expectError(ErrorKind::Unsupported, "user name and a password", [&] { capture().connect({}); });
    oscOptions.http.credentials = nullptr;
    start();
    expectError(ErrorKind::Unsupported, "user name and a password", [&] { capture().connect({}); });
}

TEST_F(CameraPassword, AlsoLetsThePreviewThrough) {
    cameraOptions.timeScale = 0;
    runCamera();
    client->info({});
    std::stop_source stop;
    int pictures = 0;
    const auto show = [&] {
        showLivePreview(
            *client, systemClock(), PreviewOptions{}.scaled(kScale),
            [&](const PreviewFrame&) { stop.request_stop(), ++pictures; }, stop.get_token());
    };
    expectError(ErrorKind::Stopped, "", show);
    EXPECT_GE(pictures, 1);
}

TEST_F(CameraPassword, IsNotNeededWhereNoneIsAsked) {
    cameraOptions.digestUser.clear();
    cameraOptions.digestPassword.clear();
    runCamera();
    expectRightPhoto(shoot(1));
    EXPECT_EQ(asked, 0);
}

/// A server that takes any answer to its challenge for a stale one when a picture is asked for, and then
/// closes without a word.
TEST(CameraPasswordOnTheWire, ATriggerIsNeverSentTwiceByTheLibrary) {
    int triggers = 0;
    int answered = 0;
    test::ScriptedServer server([&](const test::ServerRequest& request) -> test::ServerAction {
        const bool hasAnswer = request.head.find("Authorization: Digest") != std::string::npos;
        const bool isTrigger = request.body.find("takePicture") != std::string::npos;
        triggers += isTrigger ? 1 : 0;
        answered += isTrigger && hasAnswer ? 1 : 0;
        const bool isStale = isTrigger && triggers == 1;
        if (!hasAnswer || isStale) {
            const std::string nonce = "nonce" + std::to_string(triggers);
            return {"HTTP/1.1 401 Unauthorized\r\nWWW-Authenticate: Digest realm=\"r\", nonce=\"" + nonce +
                    "\", qop=\"auth\"" + (isStale ? ", stale=true" : "") + "\r\nContent-Length: 0\r\n\r\n"};
        }
        if (isTrigger) {
            return test::closeSilently();
        }
        return test::answerJson(R"({"model":"M","serialNumber":"1"})");
    });
    HttpOptions options;
    options.requestTimeout = std::chrono::seconds(2);
    options.credentials = [] { return Credentials{"u", "p"}; };
    HttpClient http(parseEndpoint(server.address()), options);
    EXPECT_EQ(http.get("/osc/info", {}).status, 200); // and a connection is kept alive
    expectError(ErrorKind::Network, "",
                [&] { http.postOnce("/osc/commands/execute", R"({"name":"camera.takePicture"})", {}); });
    EXPECT_EQ(triggers, 2); // the one that was refused, and the one that may have been done
    EXPECT_EQ(answered, 2);
}

} // namespace
} // namespace spherewalk::camera
