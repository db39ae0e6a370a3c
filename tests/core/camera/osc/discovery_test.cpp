// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/event_log.h"
#include "capture/test_camera.h"
#include "expect_error.h"
#include "manual_clock.h"

#include "spherewalk/camera/discovery.h"

#include <chrono>
#include <thread>

namespace spherewalk::camera {
namespace {

using namespace std::chrono_literals;
using test::expectError;

class Discovery : public testing::Test {
  protected:
    FindReport find(const std::vector<std::string>& addresses, const std::stop_token& stop = {}) {
        FindOptions options;
        options.browseTime = 0ms; // the network around the test is none of its business
        options.places.clear();
        for (const std::string& address : addresses) {
            options.places.push_back({parseEndpoint(address), "given"});
        }
        return findCameras(options, stop);
    }

    test::ManualClock clock;
    test::EventLog log;
    test::TestCamera camera{clock, log};
};

TEST_F(Discovery, FindsWhoAnswersAndWhoDoesNot) {
    const FindReport report = find({"127.0.0.1:1", camera.address()});
    ASSERT_EQ(report.cameras.size(), 1U);
    EXPECT_EQ(report.cameras[0].info.model, "RICOH THETA V");
    EXPECT_EQ(report.cameras[0].place.endpoint, parseEndpoint(camera.address()));
    ASSERT_EQ(report.silent.size(), 1U);
    EXPECT_EQ(report.silent[0].endpoint.port, 1);
}

TEST_F(Discovery, NamesACameraOnceHoweverManyAddressesItHas) {
    EXPECT_EQ(find({camera.address(), camera.address()}).cameras.size(), 1U);
}

TEST_F(Discovery, LeavesOutWhatIsNoCamera) {
    camera.fault("/osc/info", [](const auto&) { return test::answerPage(); });
    const FindReport report = find({camera.address()});
    EXPECT_TRUE(report.cameras.empty());
    EXPECT_EQ(report.silent.size(), 1U);
}

TEST_F(Discovery, OnlyAsksWhoItIs) {
    find({camera.address()});
    EXPECT_EQ(log.events(), std::vector<std::string>{"/osc/info"});
}

TEST_F(Discovery, StopsAtOnce) {
    camera.fault("/osc/info", [](const auto&) { return test::neverAnswer(); });
    std::stop_source source;
    std::chrono::steady_clock::time_point asked;
    const std::jthread stopper([&] {
        camera.server().waitForCount("/osc/info", 1);
        asked = std::chrono::steady_clock::now();
        source.request_stop();
    });
    expectError(ErrorKind::Stopped, "", [&] { find({camera.address()}, source.get_token()); });
    EXPECT_LT(std::chrono::steady_clock::now() - asked, 200ms);
}

TEST_F(Discovery, SaysWhyItCouldNotListen) {
    // With a daemon there is nothing to say, without one a sentence; either way it comes back.
    FindOptions options;
    options.places.clear();
    options.browseTime = 1ms;
    const FindReport report = findCameras(options, {});
    EXPECT_TRUE(report.note.empty() || report.note.ends_with(".")) << report.note;
}

TEST(UsualPlaces, AreTheWiFiOfCamerasAndThePracticeCamera) {
    const auto places = usualPlaces();
    ASSERT_EQ(places.size(), 3U);
    EXPECT_EQ(places[0].endpoint.name(), "192.168.1.1:80");
    EXPECT_EQ(places[1].endpoint.name(), "192.168.42.1:80");
    EXPECT_EQ(places[2].endpoint.name(), "127.0.0.1:8080");
}

} // namespace
} // namespace spherewalk::camera
