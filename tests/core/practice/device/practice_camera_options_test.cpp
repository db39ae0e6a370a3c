// SPDX-License-Identifier: GPL-3.0-or-later
#include "server/practice_camera_fixture.h"

#include "spherewalk/base/json.h"

namespace spherewalk::practice {
namespace {

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

} // namespace
} // namespace spherewalk::practice
