// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "test_camera.h"

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
