// SPDX-License-Identifier: GPL-3.0-or-later
// Sessions of API level 1, and passwords.
#include "server/practice_camera_fixture.h"

#include "spherewalk/base/json.h"

namespace spherewalk::practice {
namespace {

class PracticeCameraAccess : public PracticeCameraHttp {
  protected:
    void runModel(CameraModel model) {
        PracticeCameraOptions options = small();
        options.model = model;
        options.isPlain = true;
        run(options);
    }

    void runWithPassword(int nonceRequests = 0) {
        PracticeCameraOptions options = small();
        options.digestUser = "THETAYL00123456";
        options.digestPassword = "00123456";
        options.nonceRequests = nonceRequests;
        run(options);
    }
};

TEST_F(PracticeCameraAccess, LevelOneNeedsASession) {
    runModel(CameraModel::LevelOne);
    EXPECT_FALSE(get("/osc/info").contains("apiLevel"));
    expectRefusal(execute("camera.takePicture", Json::object(), 400), "missingParameter");
    const Json first = execute("camera.startSession")["results"]["sessionId"];
    EXPECT_EQ(state()["sessionId"], first);
    expectRefusal(execute("camera.startSession", Json::object(), 400), "cameraInExclusiveUse");
    execute("camera.closeSession", {{"sessionId", first}});
    const Json session = execute("camera.startSession")["results"]["sessionId"];
    expectRefusal(execute("camera.takePicture", {{"sessionId", first}}, 403), "invalidSessionId");
    const Json done = finished(execute("camera.takePicture", {{"sessionId", session}})["id"]);
    EXPECT_EQ(done["results"]["fileUri"], "100RICOH/R0010001.JPG");
    EXPECT_EQ(state()["_latestFileUri"], "100RICOH/R0010001.JPG");
    finished(execute("camera.takePicture", {{"sessionId", session}})["id"]);
    const Json page = execute("camera.listImages", {{"entryCount", 1}})["results"];
    EXPECT_EQ(page["entries"][0]["uri"], "100RICOH/R0010002.JPG");
    EXPECT_EQ(page["totalEntries"], 2);
    const Json rest =
        execute("camera.listImages", {{"entryCount", 5}, {"continuationToken", page["continuationToken"]}});
    EXPECT_EQ(rest["results"]["entries"].size(), 1U);
    const Json body = {{"name", "camera.getImage"}, {"parameters", {{"fileUri", "100RICOH/R0010001.JPG"}}}};
    const auto image = client().Post("/osc/commands/execute", body.dump(), "application/json");
    ASSERT_TRUE(image);
    EXPECT_EQ(image->get_header_value("Content-Type"), "image/jpeg");
    EXPECT_EQ(page["entries"][0]["size"].get<std::size_t>() > 0, !image->body.empty());
    expectRefusal(
        execute("camera.setOptions", {{"sessionId", session}, {"options", {{"clientVersion", 2}}}}, 400),
        "invalidParameterName");
    execute("camera.closeSession", {{"sessionId", session}});
    expectRefusal(execute("camera.getOptions", {{"sessionId", session}, {"optionNames", {"iso"}}}, 403),
                  "invalidSessionId");
}

TEST_F(PracticeCameraAccess, LevelOneRefusesWhatItDoesNotHave) {
    runModel(CameraModel::LevelOne);
    const Json session = execute("camera.startSession")["results"]["sessionId"];
    expectRefusal(execute("camera.listFiles", {{"entryCount", 1}}, 400), "unknownCommand");
    expectRefusal(execute("camera.listImages", {{"entryCount", 1}, {"sessionId", session}}, 400),
                  "invalidParameterName");
    expectRefusal(execute("camera.getOptions", {{"optionNames", {"iso"}}}, 400), "missingParameter");
    const Json body = {{"name", "camera.getImage"},
                       {"parameters", {{"fileUri", "100RICOH/R0010001.JPG"}, {"sessionId", session}}}};
    const auto image = client().Post("/osc/commands/execute", body.dump(), "application/json");
    ASSERT_TRUE(image);
    EXPECT_EQ(image->status, 400);
}

TEST_F(PracticeCameraAccess, AThetaSIsSwitchedToLevelTwoAndFallsBack) {
    runModel(CameraModel::ThetaS);
    EXPECT_EQ(state()["_apiVersion"], 1);
    const Json session = execute("camera.startSession")["results"]["sessionId"];
    execute("camera.setOptions", {{"sessionId", session}, {"options", {{"clientVersion", 2}}}});
    EXPECT_EQ(state()["_apiVersion"], 2);
    expectRefusal(execute("camera.startSession", Json::object(), 400), "unknownCommand");
    EXPECT_THAT(shoot(), testing::HasSubstr("R0010001.JPG"));
    camera().arm({FaultKind::LevelOne, "/osc/state"});
    EXPECT_EQ(state()["_apiVersion"], 1);
}

TEST_F(PracticeCameraAccess, EveryRequestNeedsThePassword) {
    runWithPassword();
    const auto refused = client().Get("/osc/info");
    ASSERT_TRUE(refused);
    EXPECT_EQ(refused->status, 401);
    EXPECT_THAT(
        refused->get_header_value("WWW-Authenticate"),
        testing::MatchesRegex("Digest realm=\"RICOH THETA V\", nonce=\"[0-9a-f]{32}\", qop=\"auth\".*"));
    EXPECT_EQ(client().Post("/osc/commands/execute", "{}", "application/json")->status, 401);
    EXPECT_EQ(client().Get("/files/x")->status, 401);
    EXPECT_EQ(camera().stats().commands.size(), 0U);
}

} // namespace
} // namespace spherewalk::practice
