// SPDX-License-Identifier: GPL-3.0-or-later
// The options of a Theta V, each checked against what the camera says that it supports.
#include "device/camera_options.h"

#include "spherewalk/base/json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace spherewalk::practice {
namespace {

const std::vector<std::string> kListed = {"captureMode",
                                          "fileFormat",
                                          "exposureProgram",
                                          "iso",
                                          "shutterSpeed",
                                          "isoAutoHighLimit",
                                          "exposureCompensation",
                                          "whiteBalance",
                                          "_filter",
                                          "exposureDelay",
                                          "offDelay",
                                          "clientVersion",
                                          "_topBottomCorrection",
                                          "_imageStitching",
                                          "previewFormat",
                                          "_wlanFrequency",
                                          "_language"};

class PracticeOptions : public testing::Test {
  protected:
    Json value(const std::string& name) const { return m_options.get(Json::array({name}), {})[name]; }

    Json support(const std::string& name) const { return value(name + "Support"); }

    /// The code that a change is refused with; nothing if it is done.
    std::optional<OscCode> set(const Json& values) {
        try {
            m_options.set(values);
            return std::nullopt;
        } catch (const OscError& error) {
            return error.code();
        }
    }

    std::optional<OscCode> refusalOfGet(const Json& names) const {
        try {
            m_options.get(names, {});
            return std::nullopt;
        } catch (const OscError& error) {
            return error.code();
        }
    }

    CameraOptions m_options{5376, false};
};

TEST_F(PracticeOptions, BeginWithValuesThatAreSupported) {
    for (const std::string& name : kListed) {
        EXPECT_THAT(support(name), testing::Contains(value(name))) << name;
    }
}

TEST_F(PracticeOptions, TakeEveryValueThatIsSupported) {
    for (const std::string& name : kListed) {
        for (const Json& one : support(name)) {
            CameraOptions fresh(5376, false);
            Json change = {{name, one}};
            if (name == "iso" && one != 0) {
                change["exposureProgram"] = 9;
            } else if (name == "shutterSpeed" && one != 0) {
                change["exposureProgram"] = 4;
            }
            fresh.set(change);
            EXPECT_EQ(fresh.value(name), one) << name;
        }
    }
}

TEST_F(PracticeOptions, RefuseEveryValueThatIsNot) {
    for (const std::string& name : kListed) {
        for (const Json& wrong : {Json("no such value"), Json(-17), Json(), Json::array(), Json::object()}) {
            EXPECT_EQ(set({{name, wrong}}), OscCode::InvalidParameterValue) << name << " " << wrong;
        }
    }
}

TEST_F(PracticeOptions, RangesIncludeTheirEndsAndKeepTheirStep) {
    EXPECT_EQ(support("_colorTemperature"),
              (Json{{"minTemperature", 2500.0}, {"maxTemperature", 10000.0}, {"stepSize", 100.0}}));
    EXPECT_EQ(set({{"_colorTemperature", 2500}}), std::nullopt);
    EXPECT_EQ(set({{"_colorTemperature", 10000}}), std::nullopt);
    EXPECT_EQ(set({{"_colorTemperature", 5250}}), OscCode::InvalidParameterValue);
    EXPECT_EQ(set({{"_colorTemperature", 2400}}), OscCode::InvalidParameterValue);
    EXPECT_EQ(set({{"_colorTemperature", 10100}}), OscCode::InvalidParameterValue);
    EXPECT_EQ(set({{"_shutterVolume", 100}}), std::nullopt);
    EXPECT_EQ(set({{"_shutterVolume", 101}}), OscCode::InvalidParameterValue);
    EXPECT_EQ(set({{"sleepDelay", 60}}), std::nullopt);
    EXPECT_EQ(set({{"sleepDelay", 59}}), OscCode::InvalidParameterValue);
}

TEST_F(PracticeOptions, NumbersAreTheSameWithAndWithoutAFraction) {
    EXPECT_EQ(set({{"exposureProgram", 2.0}}), std::nullopt);
    EXPECT_EQ(set({{"exposureCompensation", 1}}), std::nullopt);
    EXPECT_EQ(set({{"exposureProgram", 4}, {"shutterSpeed", 0.0166667}}), std::nullopt)
        << "a shutter speed may be rounded";
    EXPECT_EQ(set({{"shutterSpeed", 0.0170}}), OscCode::InvalidParameterValue);
}

TEST_F(PracticeOptions, AreChangedAllOrNone) {
    const Json before = m_options.exposure();
    EXPECT_EQ(set({{"exposureProgram", 9}, {"iso", 200}, {"whiteBalance", "moonlight"}}),
              OscCode::InvalidParameterValue);
    EXPECT_EQ(m_options.exposure(), before);
    EXPECT_EQ(set({{"exposureProgram", 9}, {"noSuchOption", 1}}), OscCode::InvalidParameterName);
    EXPECT_EQ(m_options.exposure(), before);
}

TEST_F(PracticeOptions, SensitivityAndShutterNeedAProgramThatHasThem) {
    struct Case {
        int program;
        bool hasIso;
        bool hasShutter;
        bool hasBias;
    };

    for (const Case& one : {Case{1, true, true, false}, Case{2, false, false, true},
                            Case{4, false, true, true}, Case{9, true, false, true}}) {
        const auto expected = [](bool isGood) {
            return isGood ? std::nullopt : std::optional(OscCode::InvalidParameterValue);
        };
        m_options.reset();
        ASSERT_EQ(set({{"exposureProgram", one.program}}), std::nullopt);
        EXPECT_EQ(set({{"iso", 400}}), expected(one.hasIso)) << one.program;
        EXPECT_EQ(set({{"shutterSpeed", 0.01}}), expected(one.hasShutter)) << one.program;
        EXPECT_EQ(set({{"exposureCompensation", -0.7}}), expected(one.hasBias)) << one.program;
    }
}

TEST_F(PracticeOptions, AProgramThatLacksAValueForgetsIt) {
    ASSERT_EQ(set({{"exposureProgram", 1}, {"iso", 400}, {"shutterSpeed", 0.01}}), std::nullopt);
    ASSERT_EQ(set({{"exposureProgram", 4}}), std::nullopt);
    EXPECT_EQ(value("iso"), 0);
    EXPECT_EQ(value("shutterSpeed"), 0.01);
    ASSERT_EQ(set({{"exposureProgram", 2}}), std::nullopt);
    EXPECT_EQ(value("shutterSpeed"), 0);
}

TEST_F(PracticeOptions, AFilterMakesTheExposureAutomatic) {
    ASSERT_EQ(set({{"exposureProgram", 9}, {"iso", 400}}), std::nullopt);
    ASSERT_EQ(set({{"_filter", "hdr"}}), std::nullopt);
    EXPECT_EQ(value("exposureProgram"), 2);
    EXPECT_EQ(value("iso"), 0);
    ASSERT_EQ(set({{"_filter", "off"}, {"captureMode", "video"}}), std::nullopt);
    EXPECT_EQ(set({{"_filter", "hdr"}}), OscCode::InvalidParameterValue) << "films have no filters";
}

TEST_F(PracticeOptions, TheClockIsSetAlone) {
    EXPECT_EQ(set({{"dateTimeZone", "2026:01:02 03:04:05+01:00"}}), std::nullopt);
    EXPECT_EQ(set({{"dateTimeZone", "2026:01:02 03:04:05+01:00"}, {"iso", 0}}),
              OscCode::InvalidParameterValue);
    EXPECT_EQ(set({{"dateTimeZone", "yesterday"}}), OscCode::InvalidParameterValue);
    EXPECT_EQ(set({{"dateTimeZone", 1}}), OscCode::InvalidParameterValue);
}

TEST_F(PracticeOptions, DelaysBeforeSwitchingOffAreWholeMinutes) {
    for (const int good : {600, 660, 604800, 0, 65535}) {
        EXPECT_EQ(set({{"offDelay", good}}), std::nullopt) << good;
    }
    for (const int wrong : {599, 601, 604860, 60}) {
        EXPECT_EQ(set({{"offDelay", wrong}}), OscCode::InvalidParameterValue) << wrong;
    }
}

TEST_F(PracticeOptions, APlaceNeedsLatitudeAndLongitude) {
    EXPECT_EQ(set({{"gpsInfo", {{"lat", 47.4}, {"lng", 8.5}}}}), std::nullopt);
    EXPECT_EQ(set({{"gpsInfo", {{"lat", 47.4}}}}), OscCode::InvalidParameterValue);
    EXPECT_EQ(set({{"gpsInfo", {{"lat", "47"}, {"lng", 8.5}}}}), OscCode::InvalidParameterValue);
    EXPECT_EQ(refusalOfGet({"gpsInfoSupport"}), OscCode::InvalidParameterName) << "any place is supported";
}

TEST_F(PracticeOptions, AreAskedForByNamesThatTheCameraKnows) {
    EXPECT_EQ(refusalOfGet({"iso", "noSuchOption"}), OscCode::InvalidParameterName);
    EXPECT_EQ(refusalOfGet({"noSuchOptionSupport"}), OscCode::InvalidParameterName);
    EXPECT_EQ(refusalOfGet(Json::array({1})), OscCode::InvalidParameterValue);
    const Json given = m_options.get({"remainingPictures", "iso"}, {{"remainingPictures", 12}});
    EXPECT_EQ(given, (Json{{"remainingPictures", 12}, {"iso", 0}})) << "in the order of asking";
}

TEST_F(PracticeOptions, ASleepForgetsTheExposureAndKeepsTheRest) {
    ASSERT_EQ(set({{"exposureProgram", 9}, {"iso", 400}, {"sleepDelay", 90}, {"_language", "de"}}),
              std::nullopt);
    m_options.forgetExposure();
    EXPECT_EQ(value("exposureProgram"), 2);
    EXPECT_EQ(value("iso"), 0);
    EXPECT_EQ(value("sleepDelay"), 90);
    EXPECT_EQ(value("_language"), "de");
}

TEST_F(PracticeOptions, AResetForgetsAllButTheClock) {
    ASSERT_EQ(set({{"dateTimeZone", "2026:01:02 03:04:05+01:00"}}), std::nullopt);
    ASSERT_EQ(set({{"sleepDelay", 90}, {"_shutterVolume", 0}}), std::nullopt);
    m_options.reset();
    EXPECT_EQ(value("sleepDelay"), 180);
    EXPECT_EQ(value("_shutterVolume"), 50);
    EXPECT_EQ(m_options.value("dateTimeZone"), "2026:01:02 03:04:05+01:00");
}

TEST(PracticeOptionsAtFirst, FollowTheCameraThatIsMade) {
    EXPECT_EQ(CameraOptions(5376, true).value("_topBottomCorrection"), "Apply");
    EXPECT_EQ(CameraOptions(5376, false).value("_topBottomCorrection"), "Disapply");
    EXPECT_EQ(CameraOptions(1024, false).value("fileFormat")["height"], 512);
}

} // namespace
} // namespace spherewalk::practice
