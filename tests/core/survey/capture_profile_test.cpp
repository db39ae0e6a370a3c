// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"

#include "spherewalk/survey/capture_profile.h"

namespace spherewalk::survey {
namespace {

using test::expectError;

TEST(CaptureProfile, LeavesEverythingToTheCameraUnlessFixed) {
    EXPECT_EQ(parseProfile("auto"), CaptureProfile{});
    EXPECT_EQ(parseProfile(""), CaptureProfile{});
    EXPECT_EQ(profileText(CaptureProfile{}), "auto");
}

TEST(CaptureProfile, IsNoneWhereTheCameraIsToStayAsItIs) {
    EXPECT_EQ(parseProfile("camera"), std::nullopt);
    EXPECT_EQ(profileText(std::nullopt), "camera");
}

TEST(CaptureProfile, ReadsItsValues) {
    const auto profile = parseProfile("iso=200,shutter=1/50,white-balance=5200K,width=2688");
    ASSERT_TRUE(profile);
    EXPECT_EQ(profile->iso, 200);
    EXPECT_DOUBLE_EQ(*profile->shutterS, 0.02);
    EXPECT_EQ(profile->colourTemperatureK, 5200);
    EXPECT_EQ(profile->photoWidth, 2688);
    EXPECT_EQ(parseProfile("white-balance=shade,ev=-0.3")->whiteBalance, WhiteBalance::Shade);
    EXPECT_EQ(parseProfile("shutter=2.5")->shutterS, 2.5);
}

TEST(CaptureProfile, IsReadAsItWasWritten) {
    for (const char* spelled : {"auto", "camera", "iso=64", "shutter=1/60,ev=0.7", "iso=100,shutter=2.5",
                                "white-balance=bulb-fluorescent", "ev=-2,white-balance=3000K,width=5376"}) {
        EXPECT_EQ(profileText(parseProfile(spelled)), spelled);
    }
}

TEST(CaptureProfile, WritesShutterTimesAsPhotographersDo) {
    EXPECT_EQ(shutterText(0.01666666), "1/60");
    EXPECT_EQ(shutterText(0.00004), "1/25000");
    EXPECT_EQ(shutterText(0.76923076), "0.76923076");
    EXPECT_EQ(shutterText(0.4), "0.4");
    EXPECT_EQ(shutterText(8), "8");
}

TEST(CaptureProfile, SaysWhatCannotBe) {
    for (const auto& [spelled, part] : {std::pair{"iso=fast", "iso is no number"},
                                        {"iso=100.5", "whole number"},
                                        {"iso=1", "between 10"},
                                        {"shutter=0", "shutter time must lie"},
                                        {"shutter=1/0", "no number"},
                                        {"shutter=nan", "no number"},
                                        {"ev=9", "between -5"},
                                        {"iso=100,shutter=1/60,ev=1", "nothing left"},
                                        {"white-balance=blue", "daylight"},
                                        {"white-balance=shade,white-balance=4000K", "not both"},
                                        {"width=3", "512"},
                                        {"speed=1", "no \"speed\""},
                                        {"iso", "no number"}}) {
        SCOPED_TRACE(spelled);
        expectError(ErrorKind::InvalidInput, part, [&, value = spelled] { parseProfile(value); });
    }
}

} // namespace
} // namespace spherewalk::survey
