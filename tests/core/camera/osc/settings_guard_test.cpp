// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/test_camera.h"
#include "expect_error.h"
#include "temporary_folder.h"

#include "spherewalk/base/json.h"
#include "spherewalk/camera/settings_guard.h"

namespace spherewalk::camera {
namespace {

using namespace std::chrono_literals;
using test::expectError;

class SettingsGuardTest : public testing::Test {
  protected:
    test::ManualClock clock;
    test::EventLog log;
    test::TestCamera camera{clock, log};
    OscClient client{parseEndpoint(camera.address()), {}, clock};
    SettingsGuard guard{client};
};

TEST_F(SettingsGuardTest, SetsStillModeLargestJpegAndNoSleep) {
    camera.options["captureMode"] = "video";
    camera.options["fileFormat"] = {{"type", "mp4"}, {"width", 3840}, {"height", 1920}};
    EXPECT_TRUE(guard.apply({}).empty());
    EXPECT_EQ(camera.options["captureMode"], "image");
    EXPECT_EQ(camera.options["fileFormat"]["type"], "jpeg");
    EXPECT_EQ(camera.options["fileFormat"]["width"], 5376);
    EXPECT_EQ(camera.options["sleepDelay"], 65535);
    EXPECT_EQ(camera.options["offDelay"], 65535);
}

TEST_F(SettingsGuardTest, PutsBackWhatItFoundFirst) {
    guard.apply({});
    guard.apply({}); // as after a restart of the camera
    guard.restore({});
    EXPECT_EQ(camera.options["sleepDelay"], 180);
    EXPECT_EQ(camera.options["offDelay"], 64800);
}

TEST_F(SettingsGuardTest, PutsBackTheModeAndTheFormat) {
    camera.options["captureMode"] = "video";
    camera.options["fileFormat"] = {{"type", "jpeg"}, {"width", 2048}, {"height", 1024}};
    guard.apply({});
    EXPECT_EQ(camera.options["fileFormat"]["width"], 5376);
    EXPECT_TRUE(guard.restore({}).empty());
    EXPECT_EQ(camera.options["captureMode"], "video");
    EXPECT_EQ(camera.options["fileFormat"]["width"], 2048);
}

TEST_F(SettingsGuardTest, ChangesNothingIfItNeverApplied) {
    guard.restore({});
    EXPECT_EQ(camera.count("camera.setOptions"), 0);
}

TEST_F(SettingsGuardTest, GoesOnWithoutWhatTheCameraLacks) {
    for (const char* name : {"sleepDelay", "offDelay", "fileFormatSupport", "_filter"}) {
        camera.options.erase(name);
    }
    EXPECT_TRUE(guard.apply({}).empty());
    EXPECT_EQ(guard.read({"_filter", "shutterSpeed"}, {}), (Json{{"shutterSpeed", 0}}));
}

TEST_F(SettingsGuardTest, AsksForAnUnknownOptionOnlyOnce) {
    camera.options.erase("_filter");
    guard.read({"_filter", "shutterSpeed"}, {});
    const int before = camera.count("camera.getOptions");
    guard.read({"_filter", "shutterSpeed"}, {});
    EXPECT_EQ(camera.count("camera.getOptions"), before + 1);
}

TEST_F(SettingsGuardTest, SaysWhichSettingDidNotStick) {
    camera.fault("camera.setOptions", [](const auto& normal) { return normal(); });
    camera.fault("camera.setOptions", [](const auto&) { return test::answerJson(R"({"state":"done"})"); });
    const auto sentences = guard.apply({});
    ASSERT_EQ(sentences.size(), 2U);
    EXPECT_THAT(sentences[0], testing::HasSubstr("sleepDelay"));
    EXPECT_THAT(sentences[1], testing::HasSubstr("offDelay"));
}

TEST_F(SettingsGuardTest, RefusesACameraThatStaysInVideoMode) {
    camera.options["captureMode"] = "video";
    camera.fault("camera.setOptions", [](const auto&) { return test::answerJson(R"({"state":"done"})"); });
    expectError(ErrorKind::Unsupported, "\"video\"", [&] { guard.apply({}); });
}

TEST_F(SettingsGuardTest, RefusesACameraWithoutSphericalJpegs) {
    camera.options["fileFormatSupport"] = Json::array({{{"type", "raw"}, {"width", 10}, {"height", 5}}});
    camera.options["fileFormat"] = {{"type", "raw"}, {"width", 10}, {"height", 5}};
    expectError(ErrorKind::Unsupported, "spherical JPEG", [&] { guard.apply({}); });
}

class ProfileTest : public SettingsGuardTest {
  protected:
    ProfileTest() {
        camera.options.update(Json::parse(R"({
            "exposureProgram": 2, "iso": 0, "isoSupport": [0, 64, 200, 400], "shutterSpeed": 0,
            "shutterSpeedSupport": [0, 0.01, 0.01666666, 0.5], "exposureCompensation": 0.7,
            "exposureCompensationSupport": [-0.3, 0.0, 0.3], "whiteBalance": "shade",
            "whiteBalanceSupport": ["auto", "daylight"], "_colorTemperature": 5000})"));
    }

    std::vector<std::string> apply(const std::string& profile) {
        return m_guard.emplace(client, survey::parseProfile(profile)).apply({});
    }

    Json held() {
        const auto names = m_guard->heldNames();
        return m_guard->read({names.begin(), names.end()}, {});
    }

    std::vector<std::string> hold() { return m_guard->hold(held(), {}); }

    std::vector<std::string> differences() { return m_guard->exposureDifferences({}); }

  private:
    std::optional<SettingsGuard> m_guard;
};

TEST_F(ProfileTest, TheAutomaticOneLeavesNothingAsItHappensToBe) {
    camera.options["exposureProgram"] = 1;
    camera.options["iso"] = 400;
    EXPECT_TRUE(apply("auto").empty());
    EXPECT_EQ(camera.options["exposureProgram"], 2);
    EXPECT_EQ(camera.options["exposureCompensation"], 0.0);
    EXPECT_EQ(camera.options["whiteBalance"], "auto");
}

TEST_F(ProfileTest, WithoutOneTheExposureStaysAsItIs) {
    EXPECT_TRUE(apply("camera").empty());
    EXPECT_EQ(camera.options["whiteBalance"], "shade");
    EXPECT_EQ(camera.options["exposureCompensation"], 0.7);
}

TEST_F(ProfileTest, FixedValuesAreSetAsTheCameraSpellsThem) {
    camera.options["_filter"] = "hdr";
    EXPECT_TRUE(apply("iso=200,shutter=1/60,white-balance=4200K").empty());
    EXPECT_EQ(camera.options["exposureProgram"], 1);
    EXPECT_EQ(camera.options["iso"], 200);
    EXPECT_EQ(camera.options["shutterSpeed"], 0.01666666);
    EXPECT_EQ(camera.options["whiteBalance"], "_colorTemperature");
    EXPECT_EQ(camera.options["_colorTemperature"], 4200);
    EXPECT_EQ(camera.options["_filter"], "off");
}

TEST_F(ProfileTest, PutsBackTheExposureAlsoForAProgramThatWasKilled) {
    const test::TemporaryFolder folder;
    camera.options["_filter"] = "hdr";
    const Json before = camera.options;
    const auto profile = survey::parseProfile("iso=200,shutter=1/60,white-balance=4200K");
    SettingsGuard killed(client, profile);
    killed.rememberIn(folder.path(), "00123456");
    killed.apply({});
    EXPECT_NE(camera.options, before);
    SettingsGuard next(client, profile);
    next.rememberIn(folder.path(), "00123456");
    next.apply({});
    EXPECT_TRUE(next.restore({}).empty());
    EXPECT_EQ(camera.options, before);
}

TEST_F(ProfileTest, NamesWhatTheCameraDoesNotTakeBack) {
    SettingsGuard own(client, survey::parseProfile("iso=200"));
    own.apply({});
    const auto refuseIso = [&](const auto& normal) {
        return camera.lastOptions().contains("iso") ? test::answerOsc("invalidParameterValue", 400)
                                                    : normal();
    };
    camera.fault("camera.setOptions", refuseIso, 20);
    EXPECT_THAT(own.restore({}),
                testing::ElementsAre(testing::HasSubstr("did not take its setting iso back")));
    EXPECT_EQ(camera.options["whiteBalance"], "shade");
}

TEST_F(ProfileTest, OneFixedValueLeavesTheOtherToTheCamera) {
    apply("iso=64,ev=-0.33");
    EXPECT_EQ(camera.options["exposureProgram"], 9);
    EXPECT_EQ(camera.options["exposureCompensation"], -0.3);
    apply("shutter=0.5");
    EXPECT_EQ(camera.options["exposureProgram"], 4);
}

TEST_F(ProfileTest, SaysWhatTheCameraOffersInstead) {
    expectError(ErrorKind::InvalidInput, "ISO 100; the nearest are 64 and 200", [&] { apply("iso=100"); });
    expectError(ErrorKind::InvalidInput, "shutter time 1/80 s; the nearest are 1/100 s and 1/60 s",
                [&] { apply("shutter=1/80"); });
    expectError(ErrorKind::InvalidInput, "white balance cloudy", [&] { apply("white-balance=cloudy"); });
    expectError(ErrorKind::InvalidInput, "no photos 1000 pixels wide, but 5376",
                [&] { apply("width=1000"); });
}

TEST_F(ProfileTest, SaysWhatTheCameraCannotBeTold) {
    for (const char* name : {"iso", "isoSupport", "exposureProgram", "whiteBalance"}) {
        camera.options.erase(name);
    }
    EXPECT_THAT(apply("iso=200"), testing::ElementsAre(testing::HasSubstr("does not let its ISO be set")));
    EXPECT_TRUE(apply("auto").empty());
}

TEST_F(ProfileTest, WhatTheCameraForgotIsSetAgain) {
    apply("iso=200,shutter=1/60");
    EXPECT_TRUE(hold().empty());
    camera.options["iso"] = 0;
    camera.options["sleepDelay"] = 180;
    EXPECT_THAT(hold(), testing::ElementsAre(
                            "The camera did not keep the setting sleepDelay; it was set again before "
                            "the photo.",
                            "The camera's ISO is 0 instead of 200; it was set again before the photo."));
    EXPECT_EQ(camera.options["iso"], 200);
    EXPECT_EQ(camera.options["sleepDelay"], 65535);
}

TEST_F(ProfileTest, WhatTheCameraDoesNotKeepIsSaid) {
    apply("iso=200");
    camera.options["iso"] = 64;
    camera.fault(
        "camera.setOptions", [](const auto&) { return test::answerJson(R"({"state":"done"})"); }, 2);
    EXPECT_THAT(hold(), testing::ElementsAre(
                            testing::HasSubstr("ISO is 64 instead of 200; the camera does not keep")));
}

TEST_F(ProfileTest, AnExposureThatTheCameraNeverKeepsStopsAtTheSecondPhoto) {
    apply("iso=200");
    const auto lose = [&] {
        camera.options["iso"] = 64;
        camera.fault(
            "camera.setOptions", [](const auto&) { return test::answerJson(R"({"state":"done"})"); }, 2);
    };
    lose();
    EXPECT_EQ(hold().size(), 1U); // before the first photo
    EXPECT_EQ(differences().size(), 1U);
    lose();
    expectError(ErrorKind::Unsupported, "--profile camera", [&] { hold(); });
}

TEST_F(ProfileTest, AnExposureThatTheCameraLosesInEachPhotoStopsAtTheThird) {
    apply("iso=200");
    for (int photo = 0; photo < 2; ++photo) {
        EXPECT_LE(hold().size(), 1U); // set again
        EXPECT_EQ(camera.options["iso"], 200);
        camera.options["iso"] = 64;
        EXPECT_EQ(differences().size(), 1U);
    }
    expectError(ErrorKind::Unsupported, "--profile camera", [&] { hold(); });
}

TEST_F(ProfileTest, AnExposureThatWasLostOnceIsForgiven) {
    apply("iso=200");
    for (int photo = 0; photo < 4; ++photo) {
        EXPECT_LE(hold().size(), 1U);
        camera.options["iso"] = photo % 2 == 0 ? 64 : 200;
        EXPECT_EQ(differences().empty(), photo % 2 == 1);
    }
    hold();
}

TEST(ShotAllowance, GrowsWithTimerExposureAndFilter) {
    const ShotAllowance allowance;
    EXPECT_EQ(allowance.of(Json::object()), 30s);
    EXPECT_EQ(allowance.of({{"exposureDelay", 5}, {"shutterSpeed", 2.5}, {"_filter", "off"}}), 40s);
    EXPECT_EQ(allowance.of({{"_filter", "hdr"}}), 50s);
    EXPECT_EQ(allowance.of({{"_filter", "Noise Reduction"}}), 50s);
}

TEST(ShotAllowance, SurvivesNonsense) {
    const ShotAllowance allowance;
    EXPECT_EQ(allowance.of({{"exposureDelay", -5}, {"shutterSpeed", "fast"}, {"_filter", 7}}), 30s);
    EXPECT_LE(allowance.of({{"exposureDelay", 1e300}}), 2h);
}

} // namespace
} // namespace spherewalk::camera
