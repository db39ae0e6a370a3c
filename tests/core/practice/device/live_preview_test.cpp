// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/json.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/practice/practice_camera.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <httplib.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <future>
#include <optional>

namespace spherewalk::practice {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// What came of a preview.
struct Seen {
    int status = 0;
    std::string contentType;
    std::string bytes;
};

class PracticePreview : public testing::Test {
  protected:
    void run(PracticeCameraOptions options) {
        m_camera.emplace(std::move(options));
        m_camera->start();
        execute("camera.setOptions", {{"options", {{"previewFormat", kFormat}}}});
    }

    void run() {
        PracticeCameraOptions options;
        options.width = 512;
        run(options);
    }

    PracticeCamera& camera() { return *m_camera; }

    Json execute(const std::string& command, const Json& parameters = Json::object()) {
        httplib::Client client("127.0.0.1", m_camera->port());
        const auto answer =
            client.Post("/osc/commands/execute", Json{{"name", command}, {"parameters", parameters}}.dump(),
                        "application/json");
        return answer ? Json::parse(answer->body) : Json();
    }

    /// Reads the preview until it ends, or until enough(bytes so far) holds.
    Seen watch(const std::function<bool(const std::string&)>& enough = [](const auto&) { return false; }) {
        httplib::Client client("127.0.0.1", m_camera->port());
        Seen seen;
        httplib::Request request;
        request.method = "POST";
        request.path = "/osc/commands/execute";
        request.body = R"({"name":"camera.getLivePreview"})";
        request.set_header("Content-Type", "application/json");
        request.response_handler = [&](const httplib::Response& response) {
            seen.status = response.status;
            seen.contentType = response.get_header_value("Content-Type");
            return true;
        };
        request.content_receiver = [&](const char* data, std::size_t size, std::uint64_t, std::uint64_t) {
            seen.bytes.append(data, size);
            m_hasBegun = true;
            m_hasBegun.notify_all();
            return !enough(seen.bytes);
        };
        client.send(request);
        return seen;
    }

    /// The first picture, which came with its part's head.
    static Bytes firstPicture(const Seen& seen) {
        const std::size_t begin = seen.bytes.find("\r\n\r\n") + 4;
        const std::size_t end = seen.bytes.find("\xff\xd9\r\n\r\n", begin) + 2;
        return {seen.bytes.begin() + static_cast<std::ptrdiff_t>(begin),
                seen.bytes.begin() + static_cast<std::ptrdiff_t>(end)};
    }

    static bool hasPicture(const std::string& bytes) {
        return bytes.find("\xff\xd9\r\n\r\n") != std::string::npos;
    }

    /// Returns once something of a preview has come.
    void awaitBegin() { m_hasBegun.wait(false); }

    inline static const Json kFormat = {{"width", 640}, {"height", 320}, {"framerate", 30}};

  private:
    std::optional<PracticeCamera> m_camera;
    std::atomic<bool> m_hasBegun = false;
};

TEST_F(PracticePreview, ComesAsTheThetaFramesIt) {
    run();
    const Seen seen = watch(hasPicture);
    EXPECT_EQ(seen.status, 200);
    EXPECT_EQ(seen.contentType, "multipart/x-mixed-replace; boundary=\"---osclivepreview---\"");
    EXPECT_THAT(seen.bytes,
                StartsWith("---osclivepreview---\r\nContent-type: image/jpeg\r\nContent-Length: " +
                           std::to_string(firstPicture(seen).size()) + "\r\n\r\n\xff\xd8"));
}

TEST_F(PracticePreview, ShowsTheNextPhotoSmall) {
    PracticeCameraOptions options;
    options.width = 1280;
    options.jpegQuality = 95;
    run(options);
    camera().setPosition({1.5, 2.0, 1.2});
    const RgbImage shown = jpeg::decode(firstPicture(watch(hasPicture)), "the preview");
    ASSERT_EQ(shown.width(), 640);
    execute("camera.takePicture");
    httplib::Client client("127.0.0.1", camera().port());
    Json files;
    while (files.empty()) {
        files =
            execute("camera.listFiles",
                    {{"fileType", "image"}, {"entryCount", 1}, {"maxThumbSize", 0}})["results"]["entries"];
    }
    const std::string url = files[0]["fileUrl"];
    const auto file = client.Get(url.substr(url.find("/files/")).c_str());
    const RgbImage photo = jpeg::decode(bytesOf(file->body), "the photo", 2);
    double sum = 0;
    for (std::size_t i = 0; i < photo.values().size(); ++i) {
        sum += std::abs(photo.values()[i] - shown.values()[i]);
    }
    EXPECT_LT(sum / static_cast<double>(photo.values().size()), 5.0);
}

TEST_F(PracticePreview, EndsWhenAPictureIsTaken) {
    run();
    auto seen = std::async(std::launch::async, [&] { return watch(); });
    awaitBegin();
    EXPECT_EQ(execute("camera.takePicture")["state"], "inProgress");
    EXPECT_EQ(seen.get().status, 200);
}

TEST_F(PracticePreview, EndsWhenAnotherClientBegins) {
    run();
    auto first = std::async(std::launch::async, [&] { return watch(); });
    awaitBegin();
    EXPECT_EQ(watch(hasPicture).status, 200);
    EXPECT_EQ(first.get().status, 200);
}

TEST_F(PracticePreview, IsRefusedWhileAPictureIsTaken) {
    PracticeCameraOptions options;
    options.width = 512;
    options.timeScale = 1;
    run(options);
    execute("camera.setOptions", {{"options", {{"exposureDelay", 10}}}});
    execute("camera.takePicture");
    const Seen seen = watch();
    EXPECT_EQ(seen.status, 403);
    EXPECT_THAT(seen.bytes, HasSubstr("disabledCommand"));
}

TEST_F(PracticePreview, CanLackABoundaryAndStateAWrongLength) {
    run();
    camera().arm({FaultKind::PreviewWithoutBoundary, "camera.getLivePreview", 0, 1, 0});
    camera().arm({FaultKind::PreviewWrongLength, "camera.getLivePreview", 0, 1, 77});
    EXPECT_THAT(watch(hasPicture).bytes, StartsWith("Content-type: image/jpeg\r\nContent-Length: 77\r\n"));
}

TEST_F(PracticePreview, CanStallAfterSoManyPictures) {
    run();
    camera().arm({FaultKind::PreviewStall, "camera.getLivePreview", 1, 1, 0});
    auto seen = std::async(std::launch::async, [&] { return watch(); });
    awaitBegin();
    constexpr std::chrono::milliseconds kSeveralPictures(150);
    EXPECT_EQ(seen.wait_for(kSeveralPictures), std::future_status::timeout);
    execute("camera.takePicture");
    EXPECT_THAT(seen.get().bytes, Not(HasSubstr("\r\n\r\n---osclivepreview---")));
}

} // namespace
} // namespace spherewalk::practice
