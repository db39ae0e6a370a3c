// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/test_camera.h"
#include "expect_error.h"

#include "spherewalk/camera/osc_client.h"

namespace spherewalk::camera {
namespace {

using namespace std::chrono_literals;
using test::answerJson;
using test::answerOsc;
using test::answerPage;
using test::closeSilently;
using test::expectError;
using test::neverAnswer;
using test::ServerAction;

class OscClientTest : public testing::Test {
  protected:
    static OscOptions quick() {
        OscOptions options;
        options.http.requestTimeout = 200ms;
        options.http.stallTimeout = 200ms;
        options.statusTimeout = 200ms;
        return options;
    }

    static test::TestCamera::Fault always(const ServerAction& action) {
        return [action](const auto&) { return action; };
    }

    static ServerAction bare(const std::string& body) { return answerJson(body); }

    test::ManualClock clock;
    test::EventLog log;
    test::TestCamera camera{clock, log};
    OscClient client{parseEndpoint(camera.address()), quick(), clock};
};

TEST_F(OscClientTest, AsksACameraForAllItOffers) {
    camera.addFile("R0010048.JPG");
    EXPECT_EQ(client.info({}).serialNumber, "00123456");
    EXPECT_TRUE(client.state({}).isIdle());
    EXPECT_EQ(client.getOptions({"captureMode", "sleepDelay"}, {})["sleepDelay"], 180);
    EXPECT_EQ(client.listFiles({}, {}).totalEntries, 1);
    EXPECT_EQ(client.takePicture({}).state, CommandReply::State::InProgress);
    EXPECT_EQ(client.status("306", {}).state, CommandReply::State::InProgress);
}

TEST_F(OscClientTest, RepeatsWhatGetsNoUsableAnswer) {
    for (const ServerAction& useless :
         {closeSilently(), neverAnswer(), bare(""), bare("{\"state\":"), bare("[]"), bare("{}"),
          bare("{\"state\":NaN}"), bare("{\"state\":1e999}"), bare(std::string(1'000'000, '['))}) {
        const int before = camera.count("/osc/state");
        camera.fault("/osc/state", always(useless), 2);
        EXPECT_TRUE(client.state({}).isIdle());
        EXPECT_GE(camera.count("/osc/state"), before + 3);
    }
}

TEST_F(OscClientTest, GivesUpAfterThreeUselessAnswersASecondApart) {
    camera.fault("/osc/state", always(bare("no json")), 100);
    expectError(ErrorKind::Corrupt, "not valid JSON", [&] { client.state({}); });
    EXPECT_EQ(camera.count("/osc/state"), 3);
    EXPECT_EQ(clock.passed(), 2s);
}

TEST_F(OscClientTest, NamesAnEmptyAnswer) {
    camera.fault("/osc/state", always(bare("")), 100);
    expectError(ErrorKind::Corrupt, "empty answer", [&] { client.state({}); });
}

TEST_F(OscClientTest, BacksOffWhileTheCameraIsBusy) {
    camera.fault("camera.listFiles", always(answerOsc("serviceUnavailable", 503)), 2);
    camera.fault("camera.listFiles", always({test::httpAnswer(503, "text/html", "<html>busy</html>")}));
    client.listFiles({}, {});
    EXPECT_EQ(clock.passed(), 7s); // 1, 2, and 4
}

TEST_F(OscClientTest, ReportsACameraThatStaysBusy) {
    camera.fault("camera.listFiles", always(answerOsc("deviceBusy", 503)), 100);
    expectError(ErrorKind::Busy, "try again", [&] { client.listFiles({}, {}); });
    EXPECT_EQ(camera.count("camera.listFiles"), 4);
}

TEST_F(OscClientTest, TellsARefusalInTheCamerasWordsWithAdvice) {
    camera.fault("camera.setOptions", always(answerOsc("invalidParameterValue", 400)), 2);
    expectError(ErrorKind::InvalidInput, "words of the camera", [&] { client.setOptions({{"iso", 1}}, {}); });
    expectError(ErrorKind::InvalidInput, "does not allow", [&] { client.setOptions({{"iso", 1}}, {}); });
    EXPECT_EQ(camera.count("camera.setOptions"), 2);
}

TEST_F(OscClientTest, GoesByTheCodeWhateverTheHttpStatus) {
    camera.fault("camera.setOptions", always(answerOsc("cameraInExclusiveUse", 200)));
    expectError(ErrorKind::Busy, "close the other", [&] { client.setOptions({{"iso", 1}}, {}); });
}

TEST_F(OscClientTest, TriesAnUnknownErrorOnceMore) {
    camera.fault("camera.listFiles", always(answerOsc("brandNew", 400)));
    client.listFiles({}, {});
    EXPECT_EQ(camera.count("camera.listFiles"), 2);
    camera.fault("camera.listFiles", always(answerOsc("brandNew", 400)), 2);
    expectError(ErrorKind::Unsupported, "words of the camera", [&] { client.listFiles({}, {}); });
}

TEST_F(OscClientTest, TellsAWebPageFromACamera) {
    camera.fault("/osc/info", always(answerPage(200)));
    expectError(ErrorKind::Unsupported, "is not a spherical camera (it sent a web page)",
                [&] { client.info({}); });
    camera.fault("/osc/info", always(answerPage(404)));
    expectError(ErrorKind::Unsupported, camera.address(), [&] { client.info({}); });
    camera.fault("/osc/info", always(answerJson("{}", 404)));
    expectError(ErrorKind::Unsupported, "knows no /osc/info", [&] { client.info({}); });
    camera.fault("/osc/info", always(answerJson(R"({"name":"printer"})")));
    expectError(ErrorKind::Unsupported, "which model", [&] { client.info({}); });
    camera.fault("/osc/info", always({"HTTP/1.1 302 X\r\nLocation: /login\r\nContent-Length: 0\r\n\r\n"}));
    expectError(ErrorKind::Unsupported, "redirects", [&] { client.info({}); });
    camera.fault("/osc/info", always({test::httpAnswer(401, "text/html", "<html>")}));
    expectError(ErrorKind::Unsupported, "password", [&] { client.info({}); });
}

TEST_F(OscClientTest, TakesOnePictureAtMostWhateverTheAnswer) {
    client.info({}); // so that there is a connection to be reused
    int expected = 0;
    for (const ServerAction& answer :
         {closeSilently(), neverAnswer(), bare(""), bare("{"), answerPage(),
          answerOsc("serviceUnavailable", 503), answerOsc("unexpected", 503),
          ServerAction{"HTTP/1.1 200 X\r\nContent-Len", ServerAction::Then::Close},
          ServerAction{"HTTP/1.1 200 X\r\nContent-Length: 50\r\n\r\n{\"st", ServerAction::Then::Close}}) {
        camera.fault("camera.takePicture", always(answer));
        try {
            EXPECT_EQ(client.takePicture({}).state, CommandReply::State::Error);
        } catch (const Error& error) {
            EXPECT_NE(error.kind(), ErrorKind::Internal) << error.sentence();
        }
        EXPECT_EQ(camera.count("camera.takePicture"), ++expected) << answer.bytes;
    }
}

TEST_F(OscClientTest, KnowsWhetherTheCameraItselfRefused) {
    camera.fault("camera.takePicture", always(answerOsc("disabledCommand", 403)));
    EXPECT_TRUE(client.takePicture({}).isFromCamera);
    camera.fault("camera.takePicture", always({test::httpAnswer(503, "text/plain", "overloaded")}));
    EXPECT_FALSE(client.takePicture({}).isFromCamera);
}

TEST_F(OscClientTest, LeavesASecondBetweenSettingAndShooting) {
    client.setOptions({{"iso", 100}}, {});
    client.takePicture({});
    EXPECT_EQ(clock.passed(), 1s);
    client.takePicture({});
    EXPECT_EQ(clock.passed(), 1s);
}

TEST_F(OscClientTest, ReturnsAForgottenId) {
    const CommandReply reply = client.status("1", {});
    EXPECT_EQ(reply.error, OscErrorCode::InvalidParameterValue);
}

TEST_F(OscClientTest, FindsNoOptionsIfOneIsUnknown) {
    EXPECT_EQ(client.findOptions({"captureMode", "_new"}, {}), std::nullopt);
    expectError(ErrorKind::Unsupported, "settings", [&] { client.getOptions({"_new"}, {}); });
}

TEST_F(OscClientTest, FindsAFileFarDownTheList) {
    for (int i = 0; i < 120; ++i) {
        camera.addFile("R" + std::to_string(i) + ".JPG");
    }
    const auto found = client.findFile("http://elsewhere" + camera.files.front().path, {});
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->name, "R0.JPG");
    EXPECT_EQ(client.findFile("http://h/files/none.JPG", {}), std::nullopt);
}

TEST_F(OscClientTest, DownloadsFromWhereTheCameraWasReached) {
    camera.addFile("R1.JPG", "photo");
    std::string got;
    client.download("http://192.168.1.1" + camera.files[0].path, 99,
                    [&](ByteView bytes) { got += textOf(bytes); }, {});
    EXPECT_EQ(got, "photo");
}

TEST_F(OscClientTest, StopsWhileWaitingToTryAgain) {
    std::stop_source stop;
    camera.fault("/osc/state", [&](const auto&) {
        stop.request_stop();
        return answerOsc("serviceUnavailable", 503);
    });
    expectError(ErrorKind::Stopped, "Stopped", [&] { client.state(stop.get_token()); });
    EXPECT_EQ(camera.count("/osc/state"), 1);
}

TEST(OscOptions, ScalesTheCamerasPaceButNotTheNetworks) {
    const OscOptions fast = OscOptions().scaled(0.01);
    EXPECT_EQ(fast.applyPause, 10ms);
    EXPECT_EQ(fast.busyPause, 10ms);
    EXPECT_EQ(fast.http.requestTimeout, 20s);
}

TEST(OscOptions, RefusesValuesOutOfRange) {
    OscOptions options;
    options.attempts = 0;
    expectError(ErrorKind::InvalidInput, "attempts", [&] { options.validate(); });
}

} // namespace
} // namespace spherewalk::camera
