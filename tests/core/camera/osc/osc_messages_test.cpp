// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"

#include "spherewalk/base/json.h"
#include "spherewalk/camera/osc_messages.h"

#include <set>

namespace spherewalk::camera {
namespace {

using test::expectError;

Json json(std::string_view text) {
    return parseJson(text, "the test");
}

TEST(CameraInfo, ReadsATheta) {
    const CameraInfo info =
        parseCameraInfo(json(R"({"manufacturer":"RICOH","model":"RICOH THETA V","serialNumber":"00123456",
                 "firmwareVersion":"3.21.1","uptime":261,"gps":false,"somethingNew":{"a":[1]},
                 "endpoints":{"httpPort":80,"httpUpdatesPort":80},"apiLevel":[2]})"));
    EXPECT_EQ(info.model, "RICOH THETA V");
    EXPECT_EQ(info.serialNumber, "00123456");
    EXPECT_EQ(info.uptimeS, 261);
    EXPECT_EQ(info.httpPort, 80);
    EXPECT_TRUE(info.hasApiLevel(2));
    EXPECT_FALSE(info.hasApiLevel(1));
}

TEST(CameraInfo, WithoutLevelsSpeaksLevelOne) {
    for (const char* levels :
         {"", R"(,"apiLevel":null)", R"(,"apiLevel":[])", R"(,"apiLevel":["2",-1,1e300])"}) {
        const auto info =
            parseCameraInfo(json(std::string(R"({"model":"M","serialNumber":7)") + levels + "}"));
        EXPECT_EQ(info.apiLevels, std::vector{1}) << levels;
        EXPECT_EQ(info.serialNumber, "7");
    }
}

TEST(CameraInfo, NeedsModelAndSerialNumber) {
    expectError(ErrorKind::Corrupt, "model", [] { parseCameraInfo(json(R"({"serialNumber":"1"})")); });
    expectError(ErrorKind::Corrupt, "serial", [] { parseCameraInfo(json(R"({"model":"M"})")); });
    expectError(ErrorKind::Corrupt, "model", [] { parseCameraInfo(json("[]")); });
}

TEST(CameraState, ReadsATheta) {
    const CameraState state = parseCameraState(
        json(R"({"fingerprint":"FIG_0012","state":{"batteryLevel":0.67,"_batteryState":"disconnect",
                 "storageUri":"http://h/files/","_captureStatus":"idle","_latestFileUrl":"http://h/f/R1.JPG",
                 "_apiVersion":2,"_pluginRunning":true,"_cameraError":["NO_MEMORY","NEW_ERROR"]}})"));
    EXPECT_EQ(state.fingerprint, "FIG_0012");
    EXPECT_EQ(state.batteryFraction, 0.67);
    EXPECT_TRUE(state.isIdle());
    EXPECT_TRUE(state.isPluginRunning);
    EXPECT_EQ(state.apiVersion, 2);
    EXPECT_EQ(state.errors.size(), 2U);
}

TEST(CameraState, TakesPercentAndFractionAlike) {
    const auto battery = [](const char* level) {
        return parseCameraState(json(std::string(R"({"state":{"batteryLevel":)") + level + "}}"))
            .batteryFraction;
    };
    EXPECT_EQ(battery("57"), 0.57);
    EXPECT_EQ(battery("1"), 1.0);
    EXPECT_EQ(battery("1.0"), 1.0);
    EXPECT_EQ(battery("0"), 0.0);
    EXPECT_EQ(battery("-1"), std::nullopt);
    EXPECT_EQ(battery("1e300"), std::nullopt);
    EXPECT_EQ(battery(R"("full")"), std::nullopt);
}

TEST(CameraState, IgnoresUnusableOptionalMembers) {
    const CameraState state = parseCameraState(
        json(R"({"state":{"_captureStatus":7,"_latestFileUrl":null,"_apiVersion":1e9,"_pluginRunning":"no",
                 "_cameraError":"none"}})"));
    EXPECT_TRUE(state.isIdle());
    EXPECT_EQ(state.latestFileUrl, "");
    EXPECT_EQ(state.apiVersion, std::nullopt);
    EXPECT_FALSE(state.isPluginRunning);
    EXPECT_TRUE(state.errors.empty());
}

TEST(CameraState, NeedsAState) {
    expectError(ErrorKind::Corrupt, "state", [] { parseCameraState(json(R"({"fingerprint":"F"})")); });
}

TEST(CommandReply, TellsItsThreeStates) {
    const CommandReply done =
        parseCommandReply(json(R"({"state":"done","results":{"fileUrl":"http://h/R.JPG"}})"));
    EXPECT_EQ(done.state, CommandReply::State::Done);
    EXPECT_EQ(done.fileUrl(), "http://h/R.JPG");
    const CommandReply running =
        parseCommandReply(json(R"({"state":"inProgress","id":306,"progress":{"completion":0}})"));
    EXPECT_EQ(running.state, CommandReply::State::InProgress);
    EXPECT_EQ(running.id, "306");
    EXPECT_EQ(running.completion, 0.0);
    const CommandReply refused = parseCommandReply(
        json(R"({"state":"error","error":{"code":"disabledCommand","message":"is disabled"}})"));
    EXPECT_EQ(refused.error, OscErrorCode::DisabledCommand);
    EXPECT_EQ(refused.errorMessage, "is disabled");
}

TEST(CommandReply, NeedsAStateAndWhileRunningAnId) {
    expectError(ErrorKind::Corrupt, "state", [] { parseCommandReply(json("{}")); });
    expectError(ErrorKind::Corrupt, "unknown state", [] { parseCommandReply(json(R"({"state":"maybe"})")); });
    expectError(ErrorKind::Corrupt, "id", [] { parseCommandReply(json(R"({"state":"inProgress"})")); });
    expectError(ErrorKind::Corrupt, "id",
                [] { parseCommandReply(json(R"({"state":"inProgress","id":{"a":1}})")); });
}

TEST(CommandReply, ErrorWithoutACodeIsAnotherError) {
    for (const char* text :
         {R"({"state":"error"})", R"({"state":"error","error":{}})", R"({"error":{"code":"brandNew"}})"}) {
        const CommandReply reply = parseCommandReply(json(text));
        EXPECT_EQ(reply.state, CommandReply::State::Error) << text;
        EXPECT_EQ(reply.error, OscErrorCode::Other) << text;
    }
}

TEST(FileList, KeepsSizesBeyond32Bits) {
    const FileList list =
        parseFileList(json(R"({"totalEntries":3,"entries":[{"fileUrl":"http://h/a.JPG","size":19211927552},
                 {"fileUrl":"http://h/b.JPG","size":4.0},{"fileUrl":"http://h/c.JPG","size":-1,"width":1e9}]})"));
    EXPECT_EQ(list.entries[0].sizeBytes, 19211927552U);
    EXPECT_EQ(list.entries[1].sizeBytes, 4U);
    EXPECT_EQ(list.entries[2].sizeBytes, std::nullopt);
    EXPECT_EQ(list.entries[2].width, 0);
}

TEST(FileList, NeedsItsCountAndUrls) {
    expectError(ErrorKind::Corrupt, "totalEntries", [] { parseFileList(json(R"({"entries":[]})")); });
    expectError(ErrorKind::Corrupt, "totalEntries",
                [] { parseFileList(json(R"({"entries":[],"totalEntries":-1})")); });
    expectError(ErrorKind::Corrupt, "entries", [] { parseFileList(json(R"({"totalEntries":0})")); });
    expectError(ErrorKind::Corrupt, "fileUrl",
                [] { parseFileList(json(R"({"totalEntries":1,"entries":[{"name":"a"}]})")); });
    expectError(ErrorKind::Corrupt, "fileUrl",
                [] { parseFileList(json(R"({"totalEntries":1,"entries":[7]})")); });
}

TEST(WholeNumber, RefusesWhatIsNone) {
    for (const char* value : {"1.5", "1e300", "-1e300", "18446744073709551615", R"("5")", "null", "[]"}) {
        EXPECT_EQ(wholeNumber(json(std::string(R"({"a":)") + value + "}"), "a"), std::nullopt) << value;
    }
    EXPECT_EQ(wholeNumber(json(R"({"a":-5.0})"), "a"), -5);
}

TEST(OscError, EveryCodeOfTheTableHasAMeaningAndAdvice) {
    std::set<OscErrorCode> seen;
    for (const char* code :
         {"unknownCommand", "disabledCommand", "missingParameter", "invalidParameterName",
          "invalidParameterValue", "tooManyParameters", "corruptedFile", "powerOffSequenceRunning",
          "invalidFileFormat", "serviceUnavailable", "canceledShooting", "unexpected", "notFound",
          "invalidSessionId", "cameraInExclusiveUse", "deviceBusy", "noFreeSpace"}) {
        const OscErrorCode meaning = oscErrorCode(code);
        EXPECT_NE(meaning, OscErrorCode::Other) << code;
        EXPECT_TRUE(seen.insert(meaning).second) << code;
        EXPECT_FALSE(advice(meaning).empty()) << code;
    }
    EXPECT_EQ(oscErrorCode("somethingNew"), OscErrorCode::Other);
    EXPECT_EQ(oscErrorCode(""), OscErrorCode::Other);
}

TEST(OscError, OnlyClearRefusalsProveThatNothingWasDone) {
    EXPECT_TRUE(provesNothingDone(OscErrorCode::DisabledCommand));
    EXPECT_TRUE(provesNothingDone(OscErrorCode::ServiceUnavailable));
    EXPECT_FALSE(provesNothingDone(OscErrorCode::Unexpected));
    EXPECT_FALSE(provesNothingDone(OscErrorCode::Other));
    EXPECT_FALSE(provesNothingDone(OscErrorCode::None));
}

} // namespace
} // namespace spherewalk::camera
