// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "temporary_folder.h"

#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/sha256.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/practice/practice_camera.h"
#include "spherewalk/practice/truth.h"

#include <httplib.h>

#include <array>
#include <chrono>
#include <netinet/in.h>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>

namespace spherewalk::practice {
namespace {

PracticeCameraOptions small() {
    PracticeCameraOptions options;
    options.width = 512;
    return options;
}

/// A running camera and a client of it.
class PracticeCameraHttp : public testing::Test {
  protected:
    void run(PracticeCameraOptions options = small()) {
        m_camera.emplace(std::move(options));
        m_camera->start();
        m_client.emplace("127.0.0.1", m_camera->port());
        m_client->set_keep_alive(true);
        m_client->set_tcp_nodelay(true);
    }

    void TearDown() override {
        m_client.reset();
        m_camera.reset();
    }

    PracticeCamera& camera() { return *m_camera; }

    httplib::Client& client() { return *m_client; }

    Json get(const std::string& path, int status = 200) { return body(client().Get(path.c_str()), status); }

    Json post(const std::string& path, const Json& request, int status = 200) {
        return body(client().Post(path.c_str(), request.dump(), "application/json;charset=utf-8"), status);
    }

    Json execute(const std::string& command, const Json& parameters = Json::object(), int status = 200) {
        return post("/osc/commands/execute", {{"name", command}, {"parameters", parameters}}, status);
    }

    Json state() { return post("/osc/state", Json::object())["state"]; }

    /// Polls until the capture is no longer in progress; the last answer.
    Json finished(const std::string& id, int status = 200) {
        for (;;) {
            const auto answer =
                client().Post("/osc/commands/status", Json{{"id", id}}.dump(), "application/json");
            if (!answer) {
                ADD_FAILURE() << "no answer to status";
                return {};
            }
            const Json reply = Json::parse(answer->body);
            if (reply["state"] != "inProgress") {
                EXPECT_EQ(answer->status, status) << answer->body;
                return reply;
            }
            std::this_thread::yield();
        }
    }

    /// Takes a photo; the path of its URL.
    std::string shoot() {
        const std::string url = finished(execute("camera.takePicture")["id"])["results"]["fileUrl"];
        return url.substr(url.find("/files/"));
    }

    Json list(const Json& parameters) { return execute("camera.listFiles", parameters)["results"]; }

    Bytes download(const std::string& path) {
        const auto answer = client().Get(path.c_str());
        if (!answer || answer->status != 200) {
            ADD_FAILURE() << "no file at " << path;
            return {};
        }
        return {answer->body.begin(), answer->body.end()};
    }

    void expectRefusal(const Json& answer, const std::string& code) {
        EXPECT_EQ(answer["state"], "error");
        EXPECT_EQ(answer["error"]["code"], code);
    }

  private:
    Json body(const httplib::Result& answer, int status) {
        if (!answer) {
            ADD_FAILURE() << "no answer: " << httplib::to_string(answer.error());
            return {};
        }
        EXPECT_EQ(answer->status, status) << answer->body;
        return Json::parse(answer->body, nullptr, false);
    }

    std::optional<PracticeCamera> m_camera;
    std::optional<httplib::Client> m_client;
};

const Json kNewest = {{"fileType", "image"}, {"entryCount", 10}, {"maxThumbSize", 0}};

TEST_F(PracticeCameraHttp, TellsThatItIsAThetaVOfLevelTwo) {
    run();
    const Json info = get("/osc/info");
    EXPECT_EQ(info["model"], "RICOH THETA V");
    EXPECT_EQ(info["apiLevel"], Json::array({2}));
    EXPECT_EQ(info["endpoints"]["httpPort"], camera().port());
    EXPECT_EQ(info["serialNumber"].get<std::string>().size(), 8U);
    EXPECT_GE(info["uptime"].get<int>(), 0);
}

TEST_F(PracticeCameraHttp, APhotoRunsFromTriggerToDownload) {
    run();
    EXPECT_EQ(state()["_latestFileUrl"], "");
    const Json begun = execute("camera.takePicture");
    EXPECT_EQ(begun["name"], "camera.takePicture");
    EXPECT_EQ(begun["state"], "inProgress");
    EXPECT_EQ(begun["progress"]["completion"], 0.0);
    const Json done = finished(begun["id"]);
    const std::string url = done["results"]["fileUrl"];
    EXPECT_THAT(url, testing::MatchesRegex(camera().url() + "/files/[0-9a-f]+/100RICOH/R0010001.JPG"));
    EXPECT_EQ(state()["_latestFileUrl"], url);
    EXPECT_EQ(state()["_captureStatus"], "idle");

    const Json entry = list(kNewest)["entries"][0];
    const Bytes bytes = download(url.substr(camera().url().size()));
    EXPECT_EQ(entry["fileUrl"], url);
    EXPECT_EQ(entry["size"], bytes.size());
    EXPECT_EQ(entry["width"], 512);
    EXPECT_EQ(entry["_projectionType"], "Equirectangular");
    const jpeg::Info info = jpeg::readInfo(bytes, "photo");
    EXPECT_EQ(info.width, 512);
    EXPECT_EQ(info.height, 256);
    EXPECT_EQ(info.mcuWidth, 16);
    EXPECT_EQ(camera().stats().exposures, 1);
    EXPECT_EQ(camera().stats().commands.at("camera.takePicture"), 1);
}

TEST_F(PracticeCameraHttp, TheTruthIsThePhotoThatTheRoomShowsThere) {
    run();
    post("/practice/pose", {{"x", 1.7}, {"y", 2.1}, {"z", 1.1}});
    const std::string path = shoot();
    camera().setPosition({2.4, 1.2, 1.3});
    shoot();
    const std::vector<Truth> truths = readTruth(camera().truthFile());
    ASSERT_EQ(truths.size(), 2U);
    const Truth& truth = truths[0];
    EXPECT_EQ(truth.urlPath, path);
    EXPECT_EQ(truth.file, "R0010001.JPG");
    EXPECT_EQ(truth.shot, 1);
    EXPECT_EQ(truth.nominalPositionM, Eigen::Vector3d(1.7, 2.1, 1.1));
    EXPECT_EQ(truths[1].nominalPositionM, Eigen::Vector3d(2.4, 1.2, 1.3));
    EXPECT_LT((truth.positionM - truth.nominalPositionM).norm(), 0.02);
    EXPECT_NE(truth.positionM, truth.nominalPositionM);
    const Bytes bytes = download(path);
    EXPECT_EQ(truth.sha256, sha256Hex(bytes));

    ASSERT_TRUE(truth.roomFromPhoto);
    const Rigid3 pose{*truth.roomFromPhoto, truth.positionM};
    const RgbImage expected = PracticeRoom().spherical(pose, {512, 256});
    const RgbImage photo = jpeg::decode(bytes, "photo");
    double sum = 0;
    for (std::size_t i = 0; i < photo.values().size(); ++i) {
        const double difference = double(photo.values()[i]) - double(expected.values()[i]);
        sum += difference * difference;
    }
    EXPECT_LT(std::sqrt(sum / double(photo.values().size())), 12); // what JPEG's 4:2:0 costs at this size
}

/// The number in this element of the photo's XMP.
double gpano(const Bytes& jpeg, const std::string& name) {
    const std::string content(jpeg.begin(), jpeg.end());
    const std::size_t at = content.find("<GPano:" + name + ">");
    if (at == std::string::npos) {
        ADD_FAILURE() << "no " << name;
        return 0;
    }
    return std::stod(content.substr(at + name.size() + 8, 20));
}

TEST_F(PracticeCameraHttp, TheFileTellsTheTiltWithGooglesSigns) {
    PracticeCameraOptions options = small();
    options.errors.tiltSigma = Degrees(8);
    run(options);
    for (int i = 0; i < 5; ++i) {
        const Bytes bytes = download(shoot());
        const YawPitchRoll truth = yawPitchRoll(*readTruth(camera().truthFile()).back().roomFromPhoto);
        EXPECT_NEAR(gpano(bytes, "PosePitchDegrees"), -Degrees(truth.pitch).value(), 1.3);
        EXPECT_NEAR(gpano(bytes, "PoseRollDegrees"), Degrees(truth.roll).value(), 1.3);
    }
}

TEST_F(PracticeCameraHttp, ALevelledPhotoHasNoTilt) {
    PracticeCameraOptions options = small();
    options.levelled = true;
    run(options);
    const Bytes bytes = download(shoot());
    const YawPitchRoll truth = yawPitchRoll(*readTruth(camera().truthFile()).back().roomFromPhoto);
    EXPECT_NEAR(truth.pitch.value(), 0, 1e-12);
    EXPECT_NEAR(truth.roll.value(), 0, 1e-12);
    EXPECT_EQ(gpano(bytes, "PosePitchDegrees"), 0);
    EXPECT_EQ(gpano(bytes, "PoseRollDegrees"), 0);
}

TEST_F(PracticeCameraHttp, AnIdAnswersDoneOnceAndIsThenForgotten) {
    run();
    const std::string id = execute("camera.takePicture")["id"];
    EXPECT_EQ(finished(id)["state"], "done");
    expectRefusal(post("/osc/commands/status", {{"id", id}}, 400), "invalidParameterValue");
    expectRefusal(post("/osc/commands/status", {{"id", "1"}}, 400), "invalidParameterValue");
    expectRefusal(post("/osc/commands/status", Json::object(), 400), "missingParameter");
    const std::string next = execute("camera.takePicture")["id"];
    EXPECT_EQ(std::stoi(next), std::stoi(id) + 1);
}

TEST_F(PracticeCameraHttp, AnIdAnswersDoneForEverIfAsked) {
    PracticeCameraOptions options = small();
    options.doneAnswers = 0;
    run(options);
    const std::string id = execute("camera.takePicture")["id"];
    const Json first = finished(id);
    EXPECT_EQ(first, post("/osc/commands/status", {{"id", id}}));
}

TEST_F(PracticeCameraHttp, ASecondTriggerDuringAnExposureIsRefusedAndStopIsPrompt) {
    PracticeCameraOptions options = small();
    options.timeScale = 1;
    run(options);
    const std::string id = execute("camera.takePicture")["id"];
    expectRefusal(execute("camera.takePicture", Json::object(), 403), "disabledCommand");
    EXPECT_EQ(state()["_captureStatus"], "shooting");
    EXPECT_EQ(post("/osc/commands/status", {{"id", id}})["state"], "inProgress");
    const auto begin = std::chrono::steady_clock::now();
    camera().stop();
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(500));
    EXPECT_EQ(camera().stats().exposures, 0);
    EXPECT_EQ(camera().stats().commands.at("camera.takePicture"), 2);
}

TEST_F(PracticeCameraHttp, ASelfTimerCanBeStopped) {
    PracticeCameraOptions options = small();
    options.timeScale = 1;
    run(options);
    execute("camera.setOptions", {{"options", {{"exposureDelay", 10}}}});
    expectRefusal(execute("camera._stopSelfTimer", Json::object(), 403), "disabledCommand");
    const std::string id = execute("camera.takePicture")["id"];
    EXPECT_EQ(state()["_captureStatus"], "self-timer countdown");
    execute("camera._stopSelfTimer");
    expectRefusal(finished(id, 403), "canceledShooting");
    EXPECT_EQ(state()["_captureStatus"], "idle");
}

TEST_F(PracticeCameraHttp, OptionsAreReadWithTheirSupport) {
    run();
    const Json options =
        execute("camera.getOptions",
                {{"optionNames",
                  {"captureMode", "iso", "isoSupport", "_colorTemperatureSupport", "aperture",
                   "remainingPictures", "totalSpace", "fileFormat", "dateTimeZone"}}})["results"]["options"];
    EXPECT_EQ(options["captureMode"], "image");
    EXPECT_EQ(options["iso"], 0);
    EXPECT_EQ(options["isoSupport"].size(), 19U);
    EXPECT_EQ(options["_colorTemperatureSupport"]["stepSize"], 100);
    EXPECT_EQ(options["fileFormat"]["width"], 512);
    EXPECT_GT(options["totalSpace"].get<double>(), 4e9);
    EXPECT_GT(options["remainingPictures"].get<int>(), 100);
    expectRefusal(execute("camera.getOptions", {{"optionNames", {"iso", "noSuchOption"}}}, 400),
                  "invalidParameterName");
    expectRefusal(execute("camera.getOptions", Json::object(), 400), "missingParameter");
    expectRefusal(execute("camera.getOptions", {{"optionNames", "iso"}}, 400), "invalidParameterValue");
}

TEST_F(PracticeCameraHttp, OptionsAreSetAllOrNone) {
    run();
    const auto value = [&](const std::string& name) {
        return execute("camera.getOptions", {{"optionNames", {name}}})["results"]["options"][name];
    };
    const auto set = [&](const Json& options, int status = 200) {
        return execute("camera.setOptions", {{"options", options}}, status);
    };
    set({{"exposureProgram", 1}, {"iso", 200}, {"shutterSpeed", 0.0166667}});
    EXPECT_EQ(value("iso"), 200);
    expectRefusal(set({{"exposureProgram", 2}, {"iso", 123}}, 400), "invalidParameterValue");
    EXPECT_EQ(value("exposureProgram"), 1);
    set({{"exposureProgram", 2}});
    EXPECT_EQ(value("iso"), 0) << "automatic exposure gives up what only manual has";
    expectRefusal(set({{"iso", 400}}, 400), "invalidParameterValue");
    expectRefusal(set({{"noSuchOption", 1}}, 400), "invalidParameterName");
    expectRefusal(set({{"aperture", 2.0}}, 400), "invalidParameterName");
    expectRefusal(set({{"sleepDelay", 30}}, 400), "invalidParameterValue");
    set({{"sleepDelay", 65535}, {"offDelay", 65535}});
    expectRefusal(set({{"dateTimeZone", "2026:01:02 03:04:05+01:00"}, {"iso", 0}}, 400),
                  "invalidParameterValue");
    expectRefusal(set({{"dateTimeZone", "2026-01-02"}}, 400), "invalidParameterValue");
    set({{"dateTimeZone", "2026:01:02 03:04:05-03:30"}});
    EXPECT_THAT(value("dateTimeZone").get<std::string>(), testing::MatchesRegex("2026:01:02 03:04:..-03:30"));
    set({{"captureMode", "video"}});
    expectRefusal(execute("camera.takePicture", Json::object(), 403), "disabledCommand");
    execute("camera.reset");
    EXPECT_EQ(value("captureMode"), "image");
    EXPECT_EQ(value("sleepDelay"), 180);
}

TEST_F(PracticeCameraHttp, ListsPageAndSort) {
    run();
    for (int i = 0; i < 5; ++i) {
        shoot();
    }
    const Json all = list({{"fileType", "all"}, {"entryCount", 100}, {"maxThumbSize", 0}});
    EXPECT_EQ(all["totalEntries"], 5);
    ASSERT_EQ(all["entries"].size(), 5U);
    EXPECT_EQ(all["entries"][0]["name"], "R0010005.JPG");
    const Json page = list({{"fileType", "image"},
                            {"entryCount", 2},
                            {"maxThumbSize", 0},
                            {"startPosition", 1},
                            {"_sort", "oldest"},
                            {"_detail", false}});
    ASSERT_EQ(page["entries"].size(), 2U);
    EXPECT_EQ(page["entries"][0]["name"], "R0010002.JPG");
    EXPECT_TRUE(page["entries"][0].contains("dateTime"));
    EXPECT_FALSE(page["entries"][0].contains("width"));
    EXPECT_EQ(list({{"fileType", "video"}, {"entryCount", 9}, {"maxThumbSize", 0}})["totalEntries"], 0);
    EXPECT_TRUE(
        list({{"fileType", "all"}, {"entryCount", 9}, {"maxThumbSize", 0}, {"startPosition", 5}})["entries"]
            .empty());
    EXPECT_EQ(list({{"fileType", "all"},
                    {"entryCount", 9},
                    {"maxThumbSize", 0},
                    {"_startFileUrl", all["entries"][3]["fileUrl"]}})["entries"]
                  .size(),
              2U);
    expectRefusal(execute("camera.listFiles", {{"fileType", "all"}, {"entryCount", 9}}, 400),
                  "missingParameter");
    expectRefusal(
        execute("camera.listFiles", {{"fileType", "all"}, {"entryCount", -1}, {"maxThumbSize", 0}}, 400),
        "invalidParameterValue");
    expectRefusal(
        execute("camera.listFiles",
                {{"fileType", "all"}, {"entryCount", 1}, {"maxThumbSize", 0}, {"noSuchParameter", 1}}, 400),
        "invalidParameterName");
}

TEST_F(PracticeCameraHttp, DeletesAllOrNothing) {
    run();
    const std::string first = camera().url() + shoot();
    const std::string second = camera().url() + shoot();
    shoot();
    expectRefusal(execute("camera.delete", {{"fileUrls", {first, first + "x"}}}, 400),
                  "invalidParameterValue");
    EXPECT_EQ(list(kNewest)["totalEntries"], 3);
    execute("camera.delete", {{"fileUrls", {first, second}}});
    EXPECT_EQ(list(kNewest)["totalEntries"], 1);
    get(first.substr(camera().url().size()), 404);
    execute("camera.delete", {{"fileUrls", {"all"}}});
    EXPECT_EQ(list(kNewest)["totalEntries"], 0);
    expectRefusal(execute("camera.delete", {{"fileUrls", std::vector<std::string>(129, first)}}, 403),
                  "tooManyParameters");
    EXPECT_THAT(shoot(), testing::HasSubstr("R0010004.JPG")) << "numbers are not given again";
}

TEST_F(PracticeCameraHttp, FilesComeWholeAndAsThumbnails) {
    run();
    const std::string path = shoot();
    const httplib::Headers range = {{"Range", "bytes=10-19"}};
    const auto whole = client().Get(path.c_str(), range);
    ASSERT_TRUE(whole);
    EXPECT_EQ(whole->status, 200) << "the camera knows no ranges";
    EXPECT_EQ(whole->get_header_value("Content-Length"), std::to_string(whole->body.size()));
    EXPECT_EQ(whole->get_header_value("Content-Type"), "image/jpeg");
    const jpeg::Info thumb = jpeg::readInfo(download(path + "?type=thumb"), "thumbnail");
    EXPECT_EQ(thumb.width, 64);
    get("/files/none/100RICOH/R0010001.JPG", 404);
    get("/files/../../etc/passwd", 404);
}

TEST_F(PracticeCameraHttp, UnknownThingsAreRefusedAsTheCameraDoes) {
    run();
    expectRefusal(execute("camera.startSession", Json::object(), 400), "unknownCommand");
    expectRefusal(post("/osc/commands/execute", Json::array({1}), 400), "unknownCommand");
    expectRefusal(execute("camera.setOptions", Json::object(), 400), "missingParameter");
    get("/osc/nothing", 404);
    get("/osc/state", 405);
    const auto broken = client().Post("/osc/commands/execute", "{\"name\":", "application/json");
    ASSERT_TRUE(broken);
    EXPECT_EQ(broken->status, 400);
    const auto deep = client().Post("/osc/commands/execute", std::string(500'000, '['), "application/json");
    ASSERT_TRUE(deep);
    EXPECT_EQ(deep->status, 400);
    EXPECT_EQ(get("/osc/info")["model"], "RICOH THETA V");
}

TEST_F(PracticeCameraHttp, ARequestThatNamesNoLengthHasNoBody) {
    run();
    const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(camera().port()));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    ASSERT_EQ(::connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    const timeval patience{5, 0};
    ::setsockopt(socket, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    const std::string request = "POST /osc/state HTTP/1.1\r\nHost: camera\r\n\r\n";
    ASSERT_EQ(::send(socket, request.data(), request.size(), MSG_NOSIGNAL), ssize_t(request.size()));
    std::array<char, 15> reply{};
    EXPECT_EQ(::recv(socket, reply.data(), reply.size(), MSG_WAITALL), ssize_t(reply.size()));
    EXPECT_EQ(std::string(reply.begin(), reply.end()), "HTTP/1.1 200 OK");
    ::close(socket);
}

TEST_F(PracticeCameraHttp, TheFingerprintChangesWithTheState) {
    run();
    const std::string before = post("/osc/state", Json::object())["fingerprint"];
    EXPECT_THAT(before, testing::MatchesRegex("FIG_[0-9]{4}"));
    EXPECT_EQ(post("/osc/checkForUpdates", {{"stateFingerprint", before}})["stateFingerprint"], before);
    shoot();
    EXPECT_NE(post("/osc/checkForUpdates", {{"stateFingerprint", before}})["stateFingerprint"], before);
    expectRefusal(post("/osc/checkForUpdates", Json::object(), 400), "missingParameter");
}

TEST_F(PracticeCameraHttp, FileUrlsFollowTheHostOfTheRequestOrTheRealCamera) {
    run();
    shoot();
    const httplib::Headers host = {{"Host", "theta.example:8080"}};
    const auto answer = client().Post("/osc/state", host, "", "application/json");
    ASSERT_TRUE(answer);
    EXPECT_THAT(Json::parse(answer->body)["state"]["_latestFileUrl"].get<std::string>(),
                testing::StartsWith("http://theta.example:8080/files/"));
    TearDown();
    PracticeCameraOptions options = small();
    options.urlsOfAccessPoint = true;
    run(options);
    shoot();
    EXPECT_THAT(state()["_latestFileUrl"].get<std::string>(),
                testing::StartsWith("http://192.168.1.1/files/"));
}

TEST_F(PracticeCameraHttp, AFullStorageRefusesToShoot) {
    PracticeCameraOptions options = small();
    options.storageBytes = 10'000;
    run(options);
    expectRefusal(execute("camera.takePicture", Json::object(), 403), "disabledCommand");
    EXPECT_EQ(state()["_cameraError"], Json::array({"NO_MEMORY"}));
}

TEST_F(PracticeCameraHttp, FilesSurviveARestart) {
    const test::TemporaryFolder folder;
    PracticeCameraOptions options = small();
    options.storageFolder = folder / "storage";
    options.truthFile = folder / "truth.jsonl";
    run(options);
    const std::string path = shoot();
    const Bytes bytes = download(path);
    TearDown();
    run(options);
    EXPECT_EQ(download(path), bytes);
    EXPECT_THAT(shoot(), testing::HasSubstr("R0010002.JPG"));
    EXPECT_EQ(readTruth(folder / "truth.jsonl").size(), 2U);
}

TEST_F(PracticeCameraHttp, TheSameSeedTakesTheSamePhotos) {
    run();
    const std::string path = shoot();
    const Bytes bytes = download(path);
    const Truth truth = readTruth(camera().truthFile()).at(0);
    TearDown();
    run();
    EXPECT_EQ(shoot(), path);
    const Truth again = readTruth(camera().truthFile()).at(0);
    EXPECT_EQ(again.positionM, truth.positionM);
    EXPECT_EQ(again.roomFromPhoto->coeffs(), truth.roomFromPhoto->coeffs());
    EXPECT_EQ(jpeg::decode(download(path), "photo"), jpeg::decode(bytes, "photo"));
    TearDown();
    PracticeCameraOptions other = small();
    other.errors.seed = 2;
    run(other);
    shoot();
    EXPECT_NE(readTruth(camera().truthFile()).at(0).positionM, truth.positionM);
}

TEST_F(PracticeCameraHttp, ServesTheNearestPhotoOfAFolderUnchanged) {
    const test::TemporaryFolder folder;
    const auto photo = [&](const std::string& name, std::uint8_t grey) {
        RgbImage picture(512, 256);
        std::fill(picture.values().begin(), picture.values().end(), grey);
        const Bytes bytes = jpeg::encode(picture, 90);
        writeFile(folder / name, bytes);
        return bytes;
    };
    const Bytes west = photo("west.jpg", 50);
    const Bytes east = photo("east.jpg", 200);
    PracticeCameraOptions options = small();
    options.photoFolder = folder.path();
    options.photos = {{"west.jpg", {0, 0, 1.2}, {}}, {"east.jpg", {3, 0, 1.2}, yawRotation(Radians(0.5))}};
    run(options);
    camera().setPosition({0.4, 0.3, 1.2});
    EXPECT_EQ(download(shoot()), west);
    camera().setPosition({2.4, 0.3, 1.2});
    EXPECT_EQ(download(shoot()), east);
    const auto truths = readTruth(camera().truthFile());
    EXPECT_FALSE(truths.at(0).roomFromPhoto);
    EXPECT_EQ(truths.at(1).positionM, Eigen::Vector3d(3, 0, 1.2));
    EXPECT_TRUE(truths.at(1).roomFromPhoto);
}

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

TEST_F(PracticeCameraHttp, PracticeRequestsThatMakeNoSenseGetASentence) {
    run();
    EXPECT_THAT(post("/practice/pose", {{"x", 1}}, 400)["error"].get<std::string>(),
                testing::HasSubstr("\"y\""));
    EXPECT_THAT(post("/practice/faults", {{"fault", "earthquake"}}, 400)["error"].get<std::string>(),
                testing::HasSubstr("earthquake"));
    EXPECT_EQ(get("/practice/pose")["x"], 2.0);
}

TEST(PracticeCamera, RefusesAPortThatIsTaken) {
    PracticeCamera first(small());
    first.start();
    PracticeCameraOptions options = small();
    options.port = first.port();
    PracticeCamera second(options);
    test::expectError(ErrorKind::Busy, "port", [&] { second.start(); });
}

TEST(PracticeCamera, RefusesOptionsOutOfRange) {
    const auto refuses = [](const std::string& part, auto&& change) {
        PracticeCameraOptions options = small();
        change(options);
        test::expectError(ErrorKind::InvalidInput, part, [&] { options.validate(); });
    };
    refuses("port", [](auto& o) { o.port = 70000; });
    refuses("width", [](auto& o) { o.width = 513; });
    refuses("width", [](auto& o) { o.width = 100; });
    refuses("time scale", [](auto& o) { o.timeScale = -1; });
    refuses("time scale", [](auto& o) { o.timeScale = std::numeric_limits<double>::quiet_NaN(); });
    refuses("tilt", [](auto& o) { o.errors.tiltSigma = Degrees(90); });
    refuses("position", [](auto& o) { o.errors.positionSigmaM = -1; });
    refuses("folder", [](auto& o) { o.photoFolder = "/tmp"; });
    refuses("path inside", [](auto& o) {
        o.photoFolder = "/tmp";
        o.photos = {{"../secret.jpg", {0, 0, 0}, {}}};
    });
}

TEST(PracticeCamera, StopsWithoutHavingBeenStarted) {
    PracticeCamera camera(small());
    camera.stop();
    EXPECT_EQ(camera.port(), 0);
}

} // namespace
} // namespace spherewalk::practice
