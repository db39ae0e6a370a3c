// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "http/scripted_server.h"
#include "manual_clock.h"
#include "structural_jpeg.h"

#include "spherewalk/base/json.h"
#include "spherewalk/camera/live_preview.h"

#include <chrono>
#include <deque>
#include <mutex>
#include <thread>

namespace spherewalk::camera {
namespace {

using namespace std::chrono_literals;
using test::expectError;
using test::ServerAction;
using test::ServerRequest;
using test::structuralJpeg;
using testing::ElementsAre;
using testing::HasSubstr;

/// The head of a live preview, and these pictures.
std::string preview(const std::vector<std::string>& jpegs) {
    std::string bytes =
        "HTTP/1.1 200 OK\r\nConnection: Keep-Alive\r\nContent-Type: multipart/x-mixed-replace; "
        "boundary=\"---osclivepreview---\"\r\n\r\n";
    for (const std::string& jpeg : jpegs) {
        bytes += "---osclivepreview---\r\nContent-type: image/jpeg\r\n\r\n" + jpeg + "\r\n\r\n";
    }
    return bytes;
}

/// A camera that answers previews as scripted, one after the other.
class LivePreviewTest : public testing::Test {
  protected:
    std::int64_t show(const std::stop_token& stop = {}) {
        return showLivePreview(
            client, clock, options, [this](const PreviewFrame& frame) { widths.push_back(frame.width); },
            stop);
    }

    ServerAction handle(const ServerRequest& request) {
        const std::scoped_lock lock(mutex);
        const Json message = Json::parse(request.body);
        if (message["name"] == "camera.getOptions") {
            return test::answerJson(
                Json{{"state", "done"}, {"results", {{"options", cameraOptions}}}}.dump());
        }
        if (message["name"] == "camera.setOptions") {
            cameraOptions.update(message["parameters"]["options"]);
            return test::answerJson(R"({"state":"done"})");
        }
        ServerAction action = answers.front();
        answers.pop_front();
        return action;
    }

    std::mutex mutex;
    Json cameraOptions = Json::object();
    std::deque<ServerAction> answers;
    std::vector<int> widths;
    test::ManualClock clock;
    test::ScriptedServer server{[this](const ServerRequest& request) { return handle(request); }};
    OscClient client{parseEndpoint(server.address()), {}, clock};
    PreviewOptions options;
};

TEST_F(LivePreviewTest, GivesThePicturesUntilTheCameraEndsIt) {
    answers.push_back(
        {preview({structuralJpeg(640, 320), structuralJpeg(1024, 512)}), ServerAction::Then::Close});
    EXPECT_EQ(show(), 2);
    EXPECT_THAT(widths, ElementsAre(640, 1024));
}

TEST_F(LivePreviewTest, SaysWhenPicturesCease) {
    answers.push_back({preview({structuralJpeg(640, 320)}), ServerAction::Then::Stall});
    options.frameTimeout = 80ms;
    expectError(ErrorKind::Timeout, "no picture of its preview for 0.08 s", [&] { show(); });
    EXPECT_THAT(widths, ElementsAre(640));
}

TEST_F(LivePreviewTest, BytesWithoutPicturesDoNotKeepItAlive) {
    answers.push_back({preview({std::string(500'000, 'x')}), ServerAction::Then::Stall});
    options.frameTimeout = 80ms;
    expectError(ErrorKind::Timeout, "no picture", [&] { show(); });
}

TEST_F(LivePreviewTest, StopsAtOnceWhileNothingComes) {
    answers.push_back({preview({}), ServerAction::Then::Stall});
    std::stop_source source;
    std::chrono::steady_clock::time_point asked;
    const std::jthread stopper([&] {
        server.waitForCount("/osc/commands/execute", 2);
        asked = std::chrono::steady_clock::now();
        source.request_stop();
    });
    expectError(ErrorKind::Stopped, "", [&] { show(source.get_token()); });
    EXPECT_LT(std::chrono::steady_clock::now() - asked, 200ms);
}

TEST_F(LivePreviewTest, AsksAgainWhenTheCameraIsNotReady) {
    answers.push_back(test::answerOsc("disabledCommand", 403));
    answers.push_back(test::answerOsc("serviceUnavailable", 503));
    answers.push_back({preview({structuralJpeg(640, 320)}), ServerAction::Then::Close});
    EXPECT_EQ(show(), 1);
    EXPECT_GE(clock.passed(), 1s);
}

TEST_F(LivePreviewTest, SaysWhyTheCameraRefuses) {
    answers.assign(4, test::answerOsc("disabledCommand", 403));
    expectError(ErrorKind::Busy, "refused to show its preview", [&] { show(); });
    EXPECT_TRUE(answers.empty());
    answers.push_back({test::answerOsc("unknownCommand", 200).bytes, ServerAction::Then::Close});
    expectError(ErrorKind::Unsupported, "refused to show its preview", [&] { show(); });
}

TEST_F(LivePreviewTest, ChoosesPicturesThatWeakWiFiCarries) {
    const auto format = [](int width, int rate) {
        return Json{{"width", width}, {"height", width / 2}, {"framerate", rate}};
    };
    cameraOptions = {
        {"previewFormat", format(1920, 8)},
        {"previewFormatSupport", {format(1920, 8), format(1024, 30), format(1024, 8), format(640, 8)}}};
    answers.push_back({preview({}), ServerAction::Then::Close});
    EXPECT_EQ(show(), 0);
    EXPECT_EQ(cameraOptions["previewFormat"], format(1024, 8));
    EXPECT_GE(clock.passed(), 1s); // a setting needs a second to settle
}

TEST(PreviewOptions, AreChecked) {
    PreviewOptions options;
    options.maxFrameBytes = 0;
    expectError(ErrorKind::InvalidInput, "maxFrameBytes", [&] { options.validate(); });
}

} // namespace
} // namespace spherewalk::camera
