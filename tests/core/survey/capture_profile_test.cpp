// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "random.h"

#include "spherewalk/survey/capture_profile.h"
#include "spherewalk/survey/shot.h"

namespace spherewalk::survey {
namespace {

using spherewalk::test::expectError;

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

TEST(CaptureProfile, OfAnyValuesIsReadAsItWasWritten) {
    spherewalk::test::Random random(66);
    SCOPED_TRACE(random.seed());
    for (int i = 0; i < 300; ++i) {
        CaptureProfile profile;
        if (random.integer(0, 1) == 1) {
            profile.iso = random.integer(10, 102'400);
        } else {
            profile.compensationEv = random.integer(-15, 15) / 3.0;
        }
        if (random.integer(0, 1) == 1) {
            profile.colourTemperatureK = random.integer(1000, 20'000);
        } else {
            profile.whiteBalance = static_cast<WhiteBalance>(random.integer(0, 9));
        }
        if (random.integer(0, 1) == 1) {
            profile.photoWidth = random.integer(512, 32'768);
        }
        EXPECT_EQ(parseProfile(profileText(profile)), profile) << profileText(profile);
    }
    for (const double shutterS : usualShutterTimes()) {
        const auto again = parseProfile("shutter=" + shutterText(shutterS));
        EXPECT_NEAR(again->shutterS.value(), shutterS, 1e-3 * shutterS);
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

TEST(ShotWords, OfStepsAndGradesAreReadAsTheyAreWritten) {
    for (const auto& [step, word] : kShotStepNames) {
        EXPECT_EQ(name(step), word);
        EXPECT_EQ(shotStepNamed(word), step);
    }
    for (const auto& [quality, word] : kQualityNames) {
        EXPECT_EQ(qualityNamed(name(quality)), quality);
    }
    EXPECT_LT(Quality::Good, Quality::Failed);
    expectError(ErrorKind::InvalidInput, "not_taken and unclear", [] { shotStepNamed("Taken"); });
    expectError(ErrorKind::InvalidInput, "doubtful and failed", [] { qualityNamed(""); });
}

} // namespace
} // namespace spherewalk::survey
