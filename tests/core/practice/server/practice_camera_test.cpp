// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "server/practice_camera_fixture.h"

#include "spherewalk/base/json.h"

#include <array>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace spherewalk::practice {
namespace {

TEST_F(PracticeCameraHttp, TellsThatItIsAThetaVOfLevelTwo) {
    run();
    const Json info = get("/osc/info");
    EXPECT_EQ(info["model"], "RICOH THETA V");
    EXPECT_EQ(info["apiLevel"], Json::array({2}));
    EXPECT_EQ(info["endpoints"]["httpPort"], camera().port());
    EXPECT_EQ(info["serialNumber"].get<std::string>().size(), 8U);
    EXPECT_GE(info["uptime"].get<int>(), 0);
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
