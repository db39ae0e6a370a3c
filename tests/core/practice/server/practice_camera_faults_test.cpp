// SPDX-License-Identifier: GPL-3.0-or-later
#include "server/practice_camera_fixture.h"

#include "spherewalk/base/json.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/practice/truth.h"

#include <algorithm>
#include <set>

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

/// One request on a connection of its own, and what came back byte by byte.
class RawAnswer {
  public:
    RawAnswer(int port, const std::string& path, const std::string& body) {
        httplib::Client client("127.0.0.1", port);
        client.set_read_timeout(std::chrono::milliseconds(300));
        const auto answer = client.Post(path.c_str(), body, "application/json");
        isAnswered = static_cast<bool>(answer);
        status = answer ? answer->status : 0;
        content = answer ? answer->body : "";
    }

    bool isAnswered = false;
    int status = 0;
    std::string content;
};

TEST_F(PracticeCameraHttp, EveryFaultHasANameOfItsOwn) {
    run();
    std::set<std::string> names;
    for (int kind = 0; kind <= static_cast<int>(FaultKind::NoMoreTrouble); ++kind) {
        const std::string spelled(name(static_cast<FaultKind>(kind)));
        EXPECT_NE(spelled, "unknown") << kind;
        EXPECT_TRUE(names.insert(spelled).second) << spelled;
        post("/practice/faults", {{"fault", spelled}, {"on", "nothing"}});
    }
    post("/practice/faults",
         Json::array({{{"fault", "refuse"}, {"on", "/osc/info"}, {"code", "deviceBusy"}},
                      {{"fault", "refuse"}, {"on", "/osc/info"}, {"code", "corruptedFile"}}}));
    expectRefusal(get("/osc/info", 503), "deviceBusy");
    expectRefusal(get("/osc/info", 403), "corruptedFile");
    post("/practice/faults", {{"fault", "refuse"}, {"code", "noSuchCode"}}, 400);
    post("/practice/faults", {{"fault", "slow"}, {"amount", -1}}, 400);
}

TEST_F(PracticeCameraHttp, AnswersAreSpoiltAsAsked) {
    run();
    const auto state = [&](FaultKind kind, std::uint64_t byte = 0) {
        camera().arm({kind, "/osc/state", 0, 1, byte});
        return RawAnswer(camera().port(), "/osc/state", "");
    };
    const std::string whole = RawAnswer(camera().port(), "/osc/state", "").content;
    EXPECT_EQ(state(FaultKind::EmptyBody).content, "");
    EXPECT_THAT(state(FaultKind::WebPage).content, testing::StartsWith("<!DOCTYPE html>"));
    EXPECT_TRUE(Json::parse(state(FaultKind::MalformedJson).content, nullptr, false).is_discarded());
    EXPECT_EQ(state(FaultKind::TruncatedJson, 20).content, whole.substr(0, 20));
    EXPECT_EQ(state(FaultKind::ShortLength).content, whole.substr(0, whole.size() / 2));
    EXPECT_FALSE(state(FaultKind::LongLength).isAnswered);
    EXPECT_EQ(state(FaultKind::Chunked).content, whole);
    EXPECT_FALSE(state(FaultKind::NeverAnswer).isAnswered);
    EXPECT_FALSE(state(FaultKind::DropAfterHeader).isAnswered);
    EXPECT_EQ(RawAnswer(camera().port(), "/osc/state", "").content, whole);
}

TEST_F(PracticeCameraHttp, AnIdCanBeStuckAndDoneCanLackItsFile) {
    PracticeCameraOptions options = small();
    options.doneAnswers = 0;
    options.isPlain = true;
    run(options);
    camera().arm({FaultKind::DoneWithoutUrl, ""});
    camera().arm({FaultKind::UrlOfOtherHost, ""});
    const Json id = execute("camera.takePicture")["id"];
    EXPECT_FALSE(finished(id)["results"].contains("fileUrl"));
    EXPECT_THAT(finished(id)["results"]["fileUrl"].get<std::string>(),
                testing::StartsWith("http://192.0.2.1:81/files"));
    camera().arm({FaultKind::StuckInProgress, ""});
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(post("/osc/commands/status", {{"id", id}})["state"], "inProgress");
    }
}

TEST_F(PracticeCameraHttp, PhotosAreSpoiltAsAsked) {
    PracticeCameraOptions options = small();
    options.isPlain = true;
    run(options);
    const auto photo = [&](FaultKind kind) {
        camera().arm({kind, "camera.takePicture"});
        return download(shoot());
    };
    EXPECT_TRUE(photo(FaultKind::EmptyPhoto).empty());
    EXPECT_EQ(jpeg::readInfo(photo(FaultKind::SmallPhoto), "photo").height, 360);
    const auto text = [](const Bytes& bytes) { return std::string(bytes.begin(), bytes.end()); };
    EXPECT_THAT(text(photo(FaultKind::NoMakerNote)), testing::Not(testing::HasSubstr("Ricoh")));
    EXPECT_THAT(text(photo(FaultKind::HostileMakerNote)), testing::HasSubstr("\xff\xff\xff\xf0"));
    EXPECT_EQ(list(kNewest)["totalEntries"], 4);
}

TEST_F(PracticeCameraHttp, DownloadsFailAsAsked) {
    PracticeCameraOptions options = small();
    options.isPlain = true;
    run(options);
    const std::string path = shoot();
    const Bytes whole = download(path);
    camera().arm({FaultKind::MissingFile, "/files"});
    get(path, 404);
    camera().arm({FaultKind::CorruptDownload, "/files", 0, 1, 1000});
    const Bytes corrupt = download(path);
    ASSERT_EQ(corrupt.size(), whole.size());
    EXPECT_TRUE(std::equal(whole.begin(), whole.begin() + 1000, corrupt.begin()));
    EXPECT_TRUE(std::equal(whole.begin() + 1064, whole.end(), corrupt.begin() + 1064));
    EXPECT_NE(corrupt, whole);
    camera().arm({FaultKind::StallDownload, "/files", 0, 1, 700});
    httplib::Client fresh("127.0.0.1", camera().port());
    fresh.set_read_timeout(std::chrono::milliseconds(200));
    std::size_t received = 0;
    EXPECT_FALSE(fresh.Get(path.c_str(), [&](const char*, size_t size) {
        received += size;
        return true;
    }));
    EXPECT_EQ(received, 700U);
}

/// Asks until the camera answers again.
Json infoAfterOutage(int port) {
    for (;;) {
        httplib::Client fresh("127.0.0.1", port);
        if (const auto answer = fresh.Get("/osc/info")) {
            return Json::parse(answer->body);
        }
        std::this_thread::yield();
    }
}

TEST_F(PracticeCameraHttp, AReadyCameraSleepsAndForgetsItsExposure) {
    PracticeCameraOptions options = small();
    options.timeScale = 0.05;
    run(options);
    execute("camera.setOptions",
            {{"options", {{"exposureProgram", 9}, {"iso", 200}, {"sleepDelay", 65535}}}});
    camera().arm({FaultKind::Sleep, "/osc/state", 0, 1, 0, 4});
    EXPECT_FALSE(RawAnswer(camera().port(), "/osc/state", "").isAnswered);
    EXPECT_FALSE(RawAnswer(camera().port(), "/osc/state", "").isAnswered) << "its port is closed";
    infoAfterOutage(camera().port());
    const Json values =
        execute("camera.getOptions", {{"optionNames", {"iso", "sleepDelay"}}})["results"]["options"];
    EXPECT_EQ(values["iso"], 0);
    EXPECT_EQ(values["sleepDelay"], 65535);
}

TEST_F(PracticeCameraHttp, ARestartWhileAPictureIsTakenLosesItUnlessItIsWritten) {
    PracticeCameraOptions options = small();
    options.isPlain = true;
    for (const bool isWritten : {false, true}) {
        run(options); // one of its own: the restart may come long after the answer
        camera().arm({FaultKind::Reboot, isWritten ? "written" : "exposing"});
        RawAnswer(camera().port(), "/osc/commands/execute", "{\"name\":\"camera.takePicture\"}");
        while (RawAnswer(camera().port(), "/osc/commands/status", "{\"id\":\"0\"}").isAnswered &&
               camera().stats().exposures == 0 && isWritten) {
            std::this_thread::yield();
        }
        infoAfterOutage(camera().port());
        EXPECT_EQ(camera().stats().exposures, isWritten ? 1 : 0);
    }
}

TEST_F(PracticeCameraHttp, ThingsBefallTheCamera) {
    PracticeCameraOptions options = small();
    options.isPlain = true;
    run(options);
    const auto stateAfter = [&](FaultKind kind, double amount = 0) {
        camera().arm({kind, "/osc/state", 0, 1, 0, amount});
        return state();
    };
    const Json serial = get("/osc/info")["serialNumber"];
    EXPECT_EQ(stateAfter(FaultKind::Plugin)["_pluginRunning"], true);
    expectRefusal(execute("camera.takePicture", Json::object(), 403), "disabledCommand");
    camera().disarm();
    EXPECT_DOUBLE_EQ(stateAfter(FaultKind::Battery, 0.7)["batteryLevel"].get<double>(), 0.3);
    EXPECT_EQ(stateAfter(FaultKind::Hot)["_cameraError"], Json::array({"HIGH_TEMPERATURE"}));
    expectRefusal(execute("camera.takePicture", Json::object(), 403), "disabledCommand");
    camera().disarm();
    EXPECT_EQ(stateAfter(FaultKind::ClockUnset)["_cameraError"], Json::array({"NO_DATE_SETTING"}));
    execute("camera.setOptions", {{"options", {{"dateTimeZone", "2026:01:02 03:04:05+01:00"}}}});
    EXPECT_EQ(state()["_cameraError"], Json::array());
    stateAfter(FaultKind::OtherSerial);
    EXPECT_NE(get("/osc/info")["serialNumber"], serial);
    camera().disarm();
    EXPECT_EQ(get("/osc/info")["serialNumber"], serial);
    stateAfter(FaultKind::ExtraPhoto);
    EXPECT_EQ(list(kNewest)["totalEntries"], 1);
    EXPECT_TRUE(readTruth(camera().truthFile()).at(0).byButton);
    EXPECT_EQ(readTruth(camera().truthFile()).at(0).options["iso"], 0);
    const std::string path = shoot();
    stateAfter(FaultKind::RestartCounter);
    EXPECT_EQ(list(kNewest)["totalEntries"], 0);
    shoot();
    EXPECT_EQ(shoot(), path) << "the name of another picture";
    stateAfter(FaultKind::StorageFull);
    expectRefusal(execute("camera.takePicture", Json::object(), 403), "disabledCommand");
    EXPECT_EQ(state()["_cameraError"], Json::array({"NO_MEMORY"}));
    EXPECT_TRUE(stateAfter(FaultKind::UnknownValues).contains("_newThing"));
}

} // namespace
} // namespace spherewalk::practice
