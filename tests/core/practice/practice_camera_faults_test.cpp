// SPDX-License-Identifier: GPL-3.0-or-later
#include "practice_camera_fixture.h"

namespace spherewalk::practice {
namespace {

TEST_F(PracticeCameraHttp, ADropBeforeExecutingTakesNoPhoto) {
    run();
    post("/practice/faults", {{"fault", "drop-before-executing"}, {"on", "camera.takePicture"}});
    httplib::Client fresh("127.0.0.1", camera().port());
    EXPECT_FALSE(
        fresh.Post("/osc/commands/execute", "{\"name\":\"camera.takePicture\"}", "application/json"));
    EXPECT_EQ(state()["_captureStatus"], "idle");
    const Json stats = get("/practice/stats");
    EXPECT_EQ(stats["commands"]["camera.takePicture"], 1) << "what arrived is counted";
    EXPECT_EQ(stats["exposures"], 0);
    EXPECT_EQ(list(kNewest)["totalEntries"], 0);
    EXPECT_THAT(shoot(), testing::HasSubstr("R0010001.JPG"));
}

TEST_F(PracticeCameraHttp, ExecuteThenDropTakesThePhotoAndDoesNotSaySo) {
    run();
    camera().arm({FaultKind::ExecuteThenDrop, "camera.takePicture"});
    httplib::Client fresh("127.0.0.1", camera().port());
    EXPECT_FALSE(
        fresh.Post("/osc/commands/execute", "{\"name\":\"camera.takePicture\"}", "application/json"));
    while (state()["_latestFileUrl"] == "") {
        std::this_thread::yield();
    }
    EXPECT_EQ(list(kNewest)["totalEntries"], 1);
    EXPECT_EQ(camera().stats().commands.at("camera.takePicture"), 1);
}

TEST_F(PracticeCameraHttp, TheNextCallsAreUnavailableAsOftenAsAsked) {
    run();
    camera().arm({FaultKind::ServiceUnavailable, "/osc/info", 1, 2});
    get("/osc/info");
    get("/osc/info", 503);
    get("/osc/info", 503);
    get("/osc/info");
    post("/practice/faults", {{"fault", "service-unavailable"}, {"count", 100}});
    expectRefusal(execute("camera.takePicture", Json::object(), 503), "serviceUnavailable");
    post("/practice/faults", {{"fault", "none"}});
    get("/osc/info");
}

TEST_F(PracticeCameraHttp, ADownloadIsCutAtTheByte) {
    run();
    const std::string path = shoot();
    const Bytes whole = download(path);
    for (const std::uint64_t byte : {std::uint64_t{0}, std::uint64_t{777}, std::uint64_t{whole.size() - 1}}) {
        camera().arm({FaultKind::CutDownload, "/files", 0, 1, byte});
        httplib::Client fresh("127.0.0.1", camera().port());
        std::string received;
        const auto answer = fresh.Get(path.c_str(), [&](const char* data, size_t size) {
            received.append(data, size);
            return true;
        });
        EXPECT_FALSE(answer);
        EXPECT_EQ(received.size(), byte);
    }
    EXPECT_EQ(download(path), whole);
}

TEST_F(PracticeCameraHttp, AForgottenIdLosesNoPhoto) {
    run();
    const std::string id = execute("camera.takePicture")["id"];
    camera().arm({FaultKind::ForgetIds, ""});
    expectRefusal(post("/osc/commands/status", {{"id", id}}, 400), "invalidParameterValue");
    while (state()["_latestFileUrl"] == "") {
        std::this_thread::yield();
    }
    EXPECT_EQ(list(kNewest)["totalEntries"], 1);
}

} // namespace
} // namespace spherewalk::practice
