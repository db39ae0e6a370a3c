// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli_run.h"
#include "hand_held_photos.h"
#include "temporary_folder.h"

#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/photo/picture_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <string>
#include <vector>

namespace spherewalk {

using test::CliResult;
using test::runCli;
using testing::HasSubstr;

namespace {

/// The address that a practice camera says it listens at.
std::string addressOf(const test::Program& practiceCamera) {
    const std::string said = practiceCamera.waitForError("Ctrl-C");
    const std::size_t begin = said.find("http://") + 7;
    return said.substr(begin, said.find(';', begin) - begin);
}

} // namespace

TEST(CommandLine, GoesFromAPlanToARobotsViewWithEveryStepAsJson) {
    const test::TemporaryFolder folder;
    const auto path = [&](const std::string& name) { return (folder / name).string(); };
    test::Program camera({SPHEREWALK_CLI, "practice-camera", "--port", "0", "--time-scale", "0", "--width",
                          "1024", "--truth", path("truth.jsonl")});
    const std::string address = addressOf(camera);
    ASSERT_NE(address, "");

    const CliResult made = runCli(
        {"new", path("s.spherewalk"), "--rect", "0,0,5,4", "--ceiling", "2.6", "--step", "1.4", "--json"});
    ASSERT_EQ(made.status, 0) << made.errors;
    const int stations = made.json()["stations"];
    ASSERT_GE(stations, 2);
    EXPECT_EQ(runCli({"plan", path("s.spherewalk"), "--json"}).json()["station_list"].size(),
              static_cast<std::size_t>(stations));

    EXPECT_EQ(runCli({"camera", "info", "--camera", address, "--json"}).json()["model"], "RICOH THETA V");
    EXPECT_EQ(runCli({"camera", "state", "--camera", address, "--json"}).json()["capture_status"], "idle");
    const CliResult shot = runCli(
        {"camera", "shoot", "--camera", address, "--out", path("one.jpg"), "--time-scale", "0.2", "--json"});
    ASSERT_EQ(shot.status, 0) << shot.errors;
    EXPECT_EQ(photo::readPicture(path("one.jpg")).width(), 1024);
    EXPECT_EQ(runCli({"camera", "list", "--camera", address, "--json"}).json()["total"], 1);

    const CliResult captured = runCli({"capture", path("s.spherewalk"), "--camera", address, "--practice",
                                       "--time-scale", "0.2", "--json"});
    ASSERT_EQ(captured.status, 0) << captured.errors;
    EXPECT_EQ(captured.json()["taken"], stations);
    EXPECT_EQ(runCli({"status", path("s.spherewalk"), "--json"}).json()["stations_with_photo"], stations);
    EXPECT_EQ(runCli({"check", path("s.spherewalk"), "--json"}).json()["sound"], true);
    const CliResult exported = runCli({"export", path("s.spherewalk"), path("d"), "--json"});
    ASSERT_EQ(exported.status, 0) << exported.errors;
    EXPECT_EQ(exported.json()["photos"], stations);
    EXPECT_EQ(exported.json()["photos_without_rotation"], stations); // nothing has solved them
    EXPECT_THAT(exported.errors, HasSubstr("heading"));

    writeFile(folder / "c.yaml", bytesOf("image_width: 64\nimage_height: 48\n"
                                         "camera_matrix: {data: [50, 0, 31.5, 0, 50, 23.5, 0, 0, 1]}\n"));
    writeFile(folder / "p.tum",
              bytesOf("0 2 2 1.3 0 0 0 1\n1 2.5 2 1.3 0 0 0.7071067811865476 0.7071067811865476\n"));
    const CliResult walked = runCli({"walk", path("d"), "--camera", path("c.yaml"), "--path", path("p.tum"),
                                     "--frame", "body", "--out", path("w"), "--json"});
    ASSERT_EQ(walked.status, 0) << walked.errors;
    EXPECT_EQ(walked.json()["frames"], 2);
    const CliResult drawn = runCli({"practice-pictures", path("drawn"), "--camera", path("c.yaml"), "--path",
                                    path("p.tum"), "--frame", "body", "--json"});
    ASSERT_EQ(drawn.status, 0) << drawn.errors;
    EXPECT_EQ(drawn.json()["pictures"], 2);
    EXPECT_EQ(photo::readPicture(path("drawn/000001.png")).width(), 64);
    // The body looks along x with z up; the same view as an optical pose.
    const CliResult viewed = runCli({"view", path("d"), "--camera", path("c.yaml"), "--pose",
                                     "2 2 1.3 -0.5 0.5 -0.5 0.5", "--out", path("v.png"), "--json"});
    ASSERT_EQ(viewed.status, 0) << viewed.errors;
    EXPECT_EQ(photo::readPicture(path("v.png")), photo::readPicture(path("w/000000.png")));

    camera.signal(SIGINT);
    EXPECT_EQ(camera.wait(), 0);
    EXPECT_THAT(camera.output(), HasSubstr(std::to_string(stations + 1) + " pictures"));
}

TEST(CommandLine, PlansAFlatRoomByRoom) {
    const test::TemporaryFolder folder;
    const std::string outline = folder / "flat.json";
    const std::string survey = folder / "flat.spherewalk";
    writeFile(outline, bytesOf(R"({"outline":[[0,0],[4,0],[4,1.5],[4.1,1.5],[4.1,0],[8.1,0],[8.1,4],[4.1,4],
        [4.1,2.4],[4,2.4],[4,4],[0,4]],"ceiling_m":2.6,
        "rooms":[{"name":"kitchen","at":[2,2]},{"name":"bedroom","at":[6.1,2]}]})"));
    ASSERT_EQ(runCli({"new", survey, "--outline", outline, "--step", "0.5"}).status, 0);
    const Json plan = runCli({"plan", survey, "--json"}).json();
    std::vector<std::string> rooms;
    for (const Json& rail : plan.at("rails")) {
        if (const std::string room = rail.at("room"); rooms.empty() || rooms.back() != room) {
            rooms.push_back(room);
        }
    }
    EXPECT_EQ(rooms.size(), 2U);
    EXPECT_NE(runCli({"plan", survey, "--list"}).output.find(", bedroom"), std::string::npos);
}

TEST(CommandLine, GoesFromPhotosByHandToADatasetWithoutAPlan) {
    const test::TemporaryFolder folder;
    const auto path = [&](const std::string& name) { return (folder / name).string(); };
    test::writeHandHeldPhotos(folder / "in");
    const CliResult made = runCli({"new", path("s.spherewalk"), "--by-hand"});
    ASSERT_EQ(made.status, 0) << made.errors;
    EXPECT_THAT(made.output, HasSubstr("align --positions free"));
    ASSERT_EQ(runCli({"import", path("s.spherewalk"), "--photos", path("in")}).status, 0);
    EXPECT_EQ(runCli({"status", path("s.spherewalk")}).status, 0);
    EXPECT_TRUE(runCli({"plan", path("s.spherewalk"), "--json"}).json()["floor_m2"].is_null());
    const CliResult sheet = runCli({"plan", path("s.spherewalk"), "--sheet", path("sheet.pdf")});
    EXPECT_NE(sheet.status, 0);
    EXPECT_THAT(sheet.errors, HasSubstr("nobody has drawn it"));
    const CliResult aligned = runCli({"align", path("s.spherewalk"), "--positions", "free", "--json"});
    ASSERT_EQ(aligned.status, 0) << aligned.errors;
    EXPECT_EQ(aligned.json()["effort"], "fine");
    EXPECT_EQ(aligned.json()["places"]["scale_by"], "guess");
    EXPECT_EQ(aligned.json()["scale_sigma"], 0.25);
    // Of the practice room's 20 m2, what the photos show of its walls.
    const CliResult plan = runCli({"plan", path("s.spherewalk"), "--json"});
    EXPECT_NEAR(plan.json()["floor_m2"].get<double>(), 20, 5);
    ASSERT_EQ(runCli({"export", path("s.spherewalk"), path("d"), "--scene", "sphere"}).status, 0);
    EXPECT_EQ(parseJson(readTextFile(path("d/dataset.json")), "dataset.json")["photos"].size(), 6U);
}

TEST(CommandLine, AnswersThatWereGivenBeforeTheQuestionTakeNoPicture) {
    const test::TemporaryFolder folder;
    const std::string survey = (folder / "s.spherewalk").string();
    test::Program camera(
        {SPHEREWALK_CLI, "practice-camera", "--port", "0", "--time-scale", "0", "--width", "1024"});
    const std::string address = addressOf(camera);
    ASSERT_EQ(runCli({"new", survey, "--rect", "0,0,4,3", "--ceiling", "2.5", "--step", "1"}).status, 0);
    const CliResult ended =
        runCli({"capture", survey, "--camera", address, "--time-scale", "0.2"}, {"\n\n", {}});
    EXPECT_EQ(ended.status, 3);
    EXPECT_THAT(ended.errors, HasSubstr("Bring the camera to rail 1, stop 1"));
    EXPECT_THAT(ended.errors, HasSubstr("Standard input ended"));
    EXPECT_EQ(runCli({"status", survey, "--json"}).json()["stations_with_photo"], 0);
}

TEST(CommandLine, CtrlCStopsCleanlyWithStatusThree) {
    const test::TemporaryFolder folder;
    test::Program demo({SPHEREWALK_CLI, "demo", (folder / "demo").string(), "--width", "1024"});
    ASSERT_NE(demo.waitForError("Photo "), "");
    demo.signal(SIGINT);
    EXPECT_EQ(demo.wait(), 3);
    EXPECT_THAT(demo.errors(), HasSubstr("Stopped"));
    EXPECT_EQ(runCli({"check", (folder / "demo/practice-room.spherewalk").string()}).status, 0);
}

} // namespace spherewalk
