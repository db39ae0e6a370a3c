// SPDX-License-Identifier: GPL-3.0-or-later
// The camera as a state machine, without a network and on a clock that the test moves.
#include "device/fault_plan.h"
#include "device/osc_device.h"
#include "manual_clock.h"

#include "spherewalk/base/json.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/practice/truth.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <optional>
#include <set>
#include <thread>
#include <tuple>

namespace spherewalk::practice {
namespace {

using Minutes = std::chrono::minutes;

PracticeCameraOptions plainOptions() {
    PracticeCameraOptions options;
    options.width = 512;
    options.isPlain = true;
    return options;
}

class PracticeDevice : public testing::Test {
  protected:
    void run(PracticeCameraOptions options = plainOptions()) {
        m_device.reset();
        m_options = std::move(options);
        m_device.emplace(m_options, m_faults, m_clock);
    }

    OscReply execute(const std::string& command, const Json& parameters = Json::object()) {
        return m_device->execute({{"name", command}, {"parameters", parameters}}, "http://h");
    }

    OscReply status(const std::string& id) { return m_device->status(Json{{"id", id}}.dump(), "http://h"); }

    Json state() const { return m_device->state("http://h")["state"]; }

    Json option(const std::string& name) {
        return execute("camera.getOptions", {{"optionNames", {name}}}).body["results"]["options"][name];
    }

    void set(const Json& values) {
        EXPECT_EQ(execute("camera.setOptions", {{"options", values}}).status, 200) << values;
    }

    /// The answer that is not "in progress".
    OscReply finished(const std::string& id) {
        for (;;) {
            OscReply reply = status(id);
            if (reply.body["state"] != "inProgress") {
                return reply;
            }
            std::this_thread::yield();
        }
    }

    Json shoot() { return finished(execute("camera.takePicture").body["id"]).body["results"]; }

    static std::string codeOf(const OscReply& reply) {
        return reply.body.contains("error") ? reply.body["error"]["code"].get<std::string>() : "";
    }

    PracticeCameraOptions m_options;
    FaultPlan m_faults;
    test::ManualClock m_clock;
    std::optional<OscDevice> m_device;
};

TEST_F(PracticeDevice, IsIdleBeforeAndAfterAPicture) {
    run();
    EXPECT_EQ(state()["_captureStatus"], "idle");
    const Json results = shoot();
    EXPECT_EQ(results["fileUrl"], state()["_latestFileUrl"]);
    EXPECT_EQ(state()["_captureStatus"], "idle");
    EXPECT_EQ(m_device->exposures(), 1);
}

TEST_F(PracticeDevice, TakesAsLongAsTheTimeScaleSays) {
    PracticeCameraOptions options = plainOptions();
    options.timeScale = 1;
    run(options);
    const Clock::Duration before = m_clock.passed();
    shoot();
    const std::chrono::duration<double> plain = m_clock.passed() - before;
    EXPECT_GE(plain.count(), 3.0);
    EXPECT_LE(plain.count(), 4.0);
    set({{"_filter", "hdr"}});
    const Clock::Duration begin = m_clock.passed();
    shoot();
    const std::chrono::duration<double> hdr = m_clock.passed() - begin;
    EXPECT_GE(hdr.count(), 8.5);
    EXPECT_LE(hdr.count(), 9.5);
}

TEST_F(PracticeDevice, ALongShutterMakesALongerPicture) {
    PracticeCameraOptions options = plainOptions();
    options.timeScale = 1;
    run(options);
    double last = 0;
    for (const double shutter : {1.0, 4.0, 15.0}) {
        set({{"exposureProgram", 4}, {"shutterSpeed", shutter}});
        const Clock::Duration begin = m_clock.passed();
        shoot();
        const std::chrono::duration<double> took = m_clock.passed() - begin;
        EXPECT_GT(took.count(), last + shutter / 2) << shutter;
        last = took.count();
    }
}

TEST_F(PracticeDevice, AnIdAnswersAsOftenAsItIsMeantTo) {
    PracticeCameraOptions options = plainOptions();
    for (const int answers : {1, 2, 5}) {
        options.doneAnswers = answers;
        run(options);
        const std::string id = execute("camera.takePicture").body["id"];
        for (int i = 0; i < answers; ++i) {
            EXPECT_EQ(finished(id).status, 200) << i;
        }
        EXPECT_EQ(codeOf(status(id)), "invalidParameterValue") << answers;
    }
}

TEST_F(PracticeDevice, AStatusNeedsAnId) {
    run();
    EXPECT_EQ(codeOf(m_device->status("{}", "")), "missingParameter");
    EXPECT_EQ(codeOf(m_device->status("[1]", "")), "missingParameter");
    EXPECT_EQ(codeOf(m_device->status("{", "")), "invalidParameterValue");
    EXPECT_EQ(codeOf(status("no such id")), "invalidParameterValue");
}

TEST_F(PracticeDevice, CommandsAreReadWithSuspicion) {
    run();
    EXPECT_EQ(codeOf(m_device->execute(Json::array(), "")), "unknownCommand");
    EXPECT_EQ(codeOf(m_device->execute({{"name", 3}}, "")), "unknownCommand");
    EXPECT_EQ(codeOf(m_device->execute({{"name", "camera.setOptions"}, {"parameters", 3}}, "")),
              "invalidParameterValue");
    EXPECT_EQ(codeOf(execute("camera.setOptions")), "missingParameter");
    EXPECT_EQ(codeOf(execute("camera.setOptions", {{"options", Json::object()}})), "invalidParameterValue");
    EXPECT_EQ(codeOf(execute("camera.getOptions", {{"optionNames", "iso"}})), "invalidParameterValue");
    EXPECT_EQ(codeOf(execute("camera.flyAway")), "unknownCommand");
    EXPECT_EQ(m_device->execute(Json::array(), "").body["name"], "unknown");
}

TEST_F(PracticeDevice, FilmsTakeNoPictures) {
    run();
    set({{"captureMode", "video"}});
    EXPECT_EQ(codeOf(execute("camera.takePicture")), "disabledCommand");
    set({{"captureMode", "image"}});
    EXPECT_EQ(execute("camera.takePicture").status, 200);
}

/// A camera whose picture lasts until the test lets it end: its clock sleeps for as long.
class HeldClock : public test::ManualClock {
  public:
    bool sleep(Duration duration, const std::stop_token& stop) override {
        while (m_isHeld && !stop.stop_requested()) {
            std::this_thread::yield();
        }
        return test::ManualClock::sleep(duration, stop);
    }

    void release() { m_isHeld = false; }

  private:
    std::atomic<bool> m_isHeld = true;
};

TEST(PracticeDeviceAtWork, RefusesAnotherPictureInTheWayThatWasChosen) {
    using WhenBusy = PracticeCameraOptions::WhenBusy;
    for (const auto& [when, code] : {std::pair{WhenBusy::DisabledCommand, "disabledCommand"},
                                     std::pair{WhenBusy::ServiceUnavailable, "serviceUnavailable"},
                                     std::pair{WhenBusy::DeviceBusy, "deviceBusy"}}) {
        PracticeCameraOptions options = plainOptions();
        options.timeScale = 1;
        options.whenBusy = when;
        FaultPlan faults;
        HeldClock clock;
        OscDevice device(options, faults, clock);
        const Json trigger = {{"name", "camera.takePicture"}};
        const std::string id = device.execute(trigger, "").body["id"];
        EXPECT_EQ(device.state("")["state"]["_captureStatus"], "shooting");
        EXPECT_FALSE(device.beginPreview()) << "nothing is previewed meanwhile";
        EXPECT_EQ(device.execute(trigger, "").body["error"]["code"], code);
        EXPECT_EQ(device.status(Json{{"id", id}}.dump(), "").body["state"], "inProgress");
        clock.release();
    }
}

TEST(PracticeDeviceAtWork, ASelfTimerCountsDownAndCanBeStopped) {
    PracticeCameraOptions options = plainOptions();
    options.timeScale = 1;
    options.doneAnswers = 0;
    FaultPlan faults;
    HeldClock clock;
    OscDevice device(options, faults, clock);
    const auto execute = [&](const Json& request) { return device.execute(request, ""); };
    EXPECT_EQ(execute({{"name", "camera._stopSelfTimer"}}).body["error"]["code"], "disabledCommand");
    execute({{"name", "camera.setOptions"}, {"parameters", {{"options", {{"exposureDelay", 5}}}}}});
    const std::string id = execute({{"name", "camera.takePicture"}}).body["id"];
    EXPECT_EQ(device.state("")["state"]["_captureStatus"], "self-timer countdown");
    EXPECT_EQ(execute({{"name", "camera._stopSelfTimer"}}).status, 200);
    OscReply reply;
    do {
        reply = device.status(Json{{"id", id}}.dump(), "");
    } while (reply.body["state"] == "inProgress");
    EXPECT_EQ(reply.body["error"]["code"], "canceledShooting");
    EXPECT_EQ(device.exposures(), 0);
}

TEST(PracticeDeviceAtWork, SwitchingOffLosesThePicture) {
    PracticeCameraOptions options = plainOptions();
    options.timeScale = 1;
    FaultPlan faults;
    HeldClock clock;
    OscDevice device(options, faults, clock);
    const std::string id = device.execute({{"name", "camera.takePicture"}}, "").body["id"];
    device.restart();
    EXPECT_EQ(device.state("")["state"]["_captureStatus"], "idle");
    EXPECT_EQ(device.exposures(), 0);
    EXPECT_EQ(device.status(Json{{"id", id}}.dump(), "").status, 400) << "its id is forgotten";
}

TEST_F(PracticeDevice, StorageFillsUpPictureByPicture) {
    PracticeCameraOptions options = plainOptions();
    options.storageBytes = 100'000;
    run(options);
    std::uint64_t left = option("remainingPictures");
    EXPECT_EQ(option("totalSpace"), 100'000);
    EXPECT_EQ(option("remainingSpace"), 100'000);
    ASSERT_GT(left, 0U);
    std::uint64_t space = option("remainingSpace");
    while (left > 0) {
        shoot();
        const std::uint64_t pictures = option("remainingPictures");
        const std::uint64_t bytes = option("remainingSpace");
        EXPECT_LE(pictures, left) << "a picture may be smaller than the camera reckons";
        ASSERT_LT(bytes, space);
        left = pictures;
        space = bytes;
    }
    EXPECT_EQ(state()["_cameraError"], Json::array()) << "nobody has asked for one more yet";
    EXPECT_EQ(codeOf(execute("camera.takePicture")), "disabledCommand");
    EXPECT_EQ(state()["_cameraError"], Json::array({"NO_MEMORY"}));
    EXPECT_EQ(execute("camera.delete", {{"fileUrls", {"all"}}}).status, 200);
    EXPECT_EQ(state()["_cameraError"], Json::array());
    EXPECT_TRUE(shoot().contains("fileUrl"));
}

TEST_F(PracticeDevice, TheClockRunsOnFromWhereItIsSet) {
    run();
    set({{"dateTimeZone", "2030:05:06 07:08:09+02:00"}});
    EXPECT_EQ(option("dateTimeZone"), "2030:05:06 07:08:09+02:00");
    m_clock.advance(Minutes(55));
    EXPECT_EQ(option("dateTimeZone"), "2030:05:06 08:03:09+02:00");
    shoot();
    const Json entry =
        execute("camera.listFiles", {{"fileType", "image"}, {"entryCount", 1}, {"maxThumbSize", 0}})
            .body["results"]["entries"][0];
    EXPECT_EQ(entry["dateTimeZone"], "2030:05:06 08:03:09+02:00");
    m_device->meet({FaultKind::ClockUnset, ""});
    EXPECT_THAT(option("dateTimeZone").get<std::string>(), testing::StartsWith("1970:01:01"));
    EXPECT_EQ(state()["_cameraError"], Json::array({"NO_DATE_SETTING"}));
}

TEST_F(PracticeDevice, UptimeCountsFromTheLastStart) {
    run();
    m_clock.advance(Minutes(10));
    EXPECT_EQ(m_device->info(80)["uptime"], 600);
    m_device->fallAsleep();
    EXPECT_EQ(m_device->info(80)["uptime"], 600) << "a sleep is no start";
    m_device->restart();
    EXPECT_EQ(m_device->info(80)["uptime"], 0);
}

TEST_F(PracticeDevice, TheFingerprintFollowsTheState) {
    run();
    const auto fingerprint = [&] { return m_device->state("")["fingerprint"]; };
    const auto changes = [&](const auto& act) {
        const Json before = fingerprint();
        act();
        return fingerprint() != before;
    };
    EXPECT_FALSE(changes([&] { execute("camera.getOptions", {{"optionNames", {"iso"}}}); }));
    EXPECT_FALSE(changes([&] { m_device->setPosition({1, 1, 1}); }));
    EXPECT_TRUE(changes([&] { set({{"_shutterVolume", 7}}); }));
    EXPECT_TRUE(changes([&] { shoot(); }));
    EXPECT_TRUE(changes([&] { m_device->meet({FaultKind::Hot, ""}); }));
    EXPECT_TRUE(changes([&] { execute("camera.reset"); }));
    EXPECT_EQ(m_device->checkForUpdates(R"({"stateFingerprint": ""})").body["stateFingerprint"],
              fingerprint());
}

TEST_F(PracticeDevice, BatteryFallsOnlyAndEndsInARestart) {
    run();
    std::vector<Fault> outages;
    m_device->onOutage([&](const Fault& fault) { outages.push_back(fault); });
    double last = state()["batteryLevel"];
    EXPECT_EQ(last, 1);
    for (int i = 0; i < 3; ++i) {
        m_device->meet({FaultKind::Battery, "", 0, 1, 0, 0.3});
        EXPECT_LT(state()["batteryLevel"].get<double>(), last);
        last = state()["batteryLevel"];
    }
    EXPECT_TRUE(outages.empty());
    m_device->meet({FaultKind::Battery, "", 0, 1, 0, 0.3});
    ASSERT_EQ(outages.size(), 1U);
    EXPECT_EQ(outages[0].kind, FaultKind::Reboot);
    EXPECT_EQ(state()["batteryLevel"], 1) << "somebody changed it";
}

TEST_F(PracticeDevice, WhatClosesThePortIsPassedOn) {
    run();
    std::vector<FaultKind> outages;
    m_device->onOutage([&](const Fault& fault) { outages.push_back(fault.kind); });
    for (const FaultKind kind : {FaultKind::RefuseConnections, FaultKind::Sleep, FaultKind::Reboot,
                                 FaultKind::Plugin, FaultKind::Slow, FaultKind::NoMoreTrouble}) {
        m_device->meet({kind, "", 0, 1, 0, 1});
    }
    EXPECT_THAT(outages,
                testing::ElementsAre(FaultKind::RefuseConnections, FaultKind::Sleep, FaultKind::Reboot));
}

TEST_F(PracticeDevice, ASlowCameraTakesSoMuchLonger) {
    PracticeCameraOptions options = plainOptions();
    options.timeScale = 0.5;
    run(options);
    const auto waited = [&] {
        const Clock::Duration before = m_clock.passed();
        m_device->pause(2);
        return std::chrono::duration<double>(m_clock.passed() - before).count();
    };
    EXPECT_NEAR(waited(), 1, 1e-6);
    m_device->meet({FaultKind::Slow, "", 0, 1, 0, 7});
    EXPECT_NEAR(waited(), 7, 1e-6);
    m_device->meet({FaultKind::NoMoreTrouble, ""});
    EXPECT_NEAR(waited(), 1, 1e-6);
}

TEST_F(PracticeDevice, APreviewEndsWithAPictureAnotherPreviewAndASetting) {
    run();
    const auto begun = [&] { return m_device->beginPreview().value(); };
    const std::uint64_t first = begun();
    EXPECT_TRUE(m_device->isPreviewing(first));
    const std::uint64_t second = begun();
    EXPECT_FALSE(m_device->isPreviewing(first));
    set({{"_shutterVolume", 3}});
    EXPECT_TRUE(m_device->isPreviewing(second));
    set({{"captureMode", "image"}});
    EXPECT_FALSE(m_device->isPreviewing(second));
    EXPECT_EQ(m_device->nextPreviewPicture(second), nullptr);
    const std::uint64_t third = begun();
    shoot();
    EXPECT_FALSE(m_device->isPreviewing(third));
}

TEST_F(PracticeDevice, APreviewIsDrawnAnewOnlyWhereItWouldDiffer) {
    run();
    set({{"previewFormat", {{"width", 640}, {"height", 320}, {"framerate", 30}}}});
    const std::uint64_t preview = m_device->beginPreview().value();
    const auto first = m_device->nextPreviewPicture(preview);
    ASSERT_TRUE(first);
    EXPECT_EQ(jpeg::readInfo(*first, "preview").width, 640);
    EXPECT_EQ(m_device->nextPreviewPicture(preview), first);
    m_device->setPosition({2.2, 1.5, 1.1});
    const auto moved = m_device->nextPreviewPicture(preview);
    EXPECT_NE(moved, first);
    EXPECT_NE(*moved, *first);
}

TEST_F(PracticeDevice, TheTruthIsThereBeforeThePictureIsAnnounced) {
    run();
    m_device->setPosition({1.5, 2, 1});
    set({{"exposureProgram", 9}, {"iso", 400}});
    const Json results = shoot();
    const std::vector<Truth> truths = readTruth(m_device->truthFile());
    ASSERT_EQ(truths.size(), 1U);
    EXPECT_EQ(results["fileUrl"], "http://h" + truths[0].urlPath);
    EXPECT_EQ(truths[0].nominalPositionM, Eigen::Vector3d(1.5, 2, 1));
    EXPECT_EQ(truths[0].options["iso"], 400);
    EXPECT_FALSE(truths[0].byButton);
    EXPECT_TRUE(m_device->fileOf(truths[0].urlPath));
    EXPECT_FALSE(m_device->fileOf("/files/none"));
}

TEST_F(PracticeDevice, ModelsBeginWithTheirLevel) {
    for (const auto& [model, level, levels] : {std::tuple{CameraModel::ThetaV, 2, Json::array({2})},
                                               std::tuple{CameraModel::ThetaS, 1, Json::array({1, 2})},
                                               std::tuple{CameraModel::LevelOne, 1, Json()}}) {
        PracticeCameraOptions options = plainOptions();
        options.model = model;
        run(options);
        EXPECT_EQ(state()["_apiVersion"], level);
        const Json info = m_device->info(8080);
        EXPECT_EQ(info.value("apiLevel", Json()), levels);
        EXPECT_EQ(info["endpoints"]["httpPort"], 8080);
        EXPECT_EQ(info["gyro"], model == CameraModel::ThetaV);
    }
}

TEST_F(PracticeDevice, AThetaSFallsBackWhenItSleeps) {
    PracticeCameraOptions options = plainOptions();
    options.model = CameraModel::ThetaS;
    run(options);
    const Json session = execute("camera.startSession").body["results"]["sessionId"];
    execute("camera.setOptions", {{"sessionId", session}, {"options", {{"clientVersion", 2}}}});
    EXPECT_EQ(state()["_apiVersion"], 2);
    EXPECT_EQ(codeOf(execute("camera.startSession")), "unknownCommand");
    m_device->fallAsleep();
    EXPECT_EQ(state()["_apiVersion"], 1);
    EXPECT_EQ(codeOf(execute("camera.getOptions", {{"sessionId", session}, {"optionNames", {"iso"}}})),
              "invalidSessionId");
}

TEST_F(PracticeDevice, ASerialNumberBelongsToASeed) {
    std::set<std::string> serials;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        PracticeCameraOptions options = plainOptions();
        options.seed = seed;
        run(options);
        const std::string serial = m_device->info(80)["serialNumber"];
        EXPECT_THAT(serial, testing::MatchesRegex("00[0-9]{6}"));
        run(options);
        EXPECT_EQ(m_device->info(80)["serialNumber"], serial);
        serials.insert(serial);
    }
    EXPECT_GT(serials.size(), 18U);
}

} // namespace
} // namespace spherewalk::practice
