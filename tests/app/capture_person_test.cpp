// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli_run.h"
#include "keyboard.h"
#include "photographed_survey.h"
#include "temporary_folder.h"

#include "spherewalk/practice/practice_camera.h"
#include "spherewalk/practice/truth.h"
#include "spherewalk/store/survey_store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <sys/resource.h>

namespace spherewalk {

using test::runCli;
using testing::HasSubstr;

namespace {

practice::PracticeCameraOptions plainCamera() {
    practice::PracticeCameraOptions options;
    options.width = 1024;
    options.isPlain = true;
    return options;
}

std::string plannedSurvey(const test::TemporaryFolder& folder) {
    std::string survey = (folder / "s.spherewalk").string();
    EXPECT_EQ(runCli({"new", survey, "--rect", "0,0,5,4", "--ceiling", "2.6", "--step", "0.6"}).status, 0);
    return survey;
}

} // namespace

TEST(CapturePerson, EnterThatIsPressedOnceTooOftenTakesNoPicture) {
    const test::TemporaryFolder folder;
    practice::PracticeCameraOptions options = plainCamera();
    options.truthFile = folder / "truth.jsonl";
    practice::PracticeCamera camera(options);
    camera.start();
    const std::string survey = plannedSurvey(folder);
    const std::vector<store::StationRecord> stations =
        store::SurveyStore::open(survey, store::Access::Read).stations();
    const test::Keyboard keyboard;
    test::Program::Options input;
    input.inputFile = keyboard.terminal();
    test::Program program({SPHEREWALK_CLI, "capture", survey, "--camera",
                           "127.0.0.1:" + std::to_string(camera.port()), "--time-scale", "0.02", "--most",
                           "3"},
                          input);
    for (std::size_t i = 0; i < 3; ++i) {
        ASSERT_NE(program.waitForError("Bring the camera to " + stations[i].name), "") << program.errors();
        camera.setPosition(stations[i].station.positionM);
        keyboard.press(i == 0 ? "\n\n\n" : "\n");
    }
    ASSERT_EQ(program.wait(), 0) << program.errors();
    EXPECT_THAT(program.output(), HasSubstr("Took 3 photos"));

    const auto store = store::SurveyStore::open(survey, store::Access::Read);
    std::map<std::string, Eigen::Vector3d> placeOf;
    for (const practice::Truth& truth : practice::readTruth(folder / "truth.jsonl")) {
        placeOf[truth.sha256] = truth.nominalPositionM;
    }
    ASSERT_EQ(store.photos().size(), 3U);
    for (const store::PhotoRecord& photo : store.photos()) {
        EXPECT_EQ(placeOf.at(photo.cameraSha256), photo.positionM) << photo.fileName;
    }
}

TEST(CapturePerson, WalksThroughARoomThatNobodyPlanned) {
    const test::TemporaryFolder folder;
    practice::PracticeCameraOptions options;
    options.width = 1024;
    practice::PracticeCamera camera(options);
    camera.start();
    const std::string survey = (folder / "h.spherewalk").string();
    ASSERT_EQ(runCli({"new", survey, "--by-hand"}).status, 0);
    const test::Keyboard keyboard;
    test::Program::Options input;
    input.inputFile = keyboard.terminal();
    test::Program program(
        {SPHEREWALK_CLI, "capture", survey, "--camera", "127.0.0.1:" + std::to_string(camera.port()),
         "--time-scale", "0.06"},
        input); // A busy machine takes its time to draw a photo, which no scale makes shorter.
    for (int photo = 1; photo <= 4; ++photo) {
        ASSERT_NE(program.waitForError("Photo " + std::to_string(photo) + ": go to its place"), "")
            << program.errors();
        camera.setPosition({1.5 + 0.4 * photo, 1.6, 1.2});
        keyboard.press(photo < 4 ? "\n" : "q\n");
    }
    ASSERT_EQ(program.wait(), 0) << program.errors();
    EXPECT_THAT(program.output(), HasSubstr("Took 3 photos"));
    EXPECT_THAT(program.output(), HasSubstr("All photos are placed."));
    EXPECT_THAT(program.output(), HasSubstr("align --positions free"));
    const auto store = store::SurveyStore::open(survey, store::Access::Read);
    EXPECT_EQ(store.photos().size(), 3U);
    EXPECT_TRUE(store.openShots().empty());
}

TEST(FollowCommand, ALineWithoutAnEndTakesNoMemory) {
    const test::TemporaryFolder folder;
    practice::PracticeCamera camera(plainCamera());
    camera.start();
    const std::string survey = plannedSurvey(folder);
    constexpr std::uintmax_t kLineBytes = 256 << 20;
    test::Program::Options input;
    input.inputFile = (folder / "line").string();
    writeFile(input.inputFile, {});
    std::filesystem::resize_file(input.inputFile, kLineBytes); // takes no room on the disk
    const auto result = runCli({"capture", survey, "--follow", "--camera",
                                "127.0.0.1:" + std::to_string(camera.port()), "--time-scale", "0.02"},
                               input);
    EXPECT_EQ(result.status, 0) << result.errors;
    rusage used{};
    ASSERT_EQ(::getrusage(RUSAGE_CHILDREN, &used), 0);
    EXPECT_LT(static_cast<std::uintmax_t>(used.ru_maxrss) << 10,
              kLineBytes / 2); // the greatest of all so far
}

TEST(ShotsCommand, ListsShotsWithoutAnEndAndTakesAPersonsDecision) {
    const test::TemporaryFolder folder;
    const std::string survey = (folder / "s.spherewalk").string();
    ASSERT_EQ(runCli({"new", survey, "--rect", "0,0,5,4", "--ceiling", "2.6", "--step", "0.6"}).status, 0);
    {
        auto store = store::SurveyStore::open(survey, store::Access::Write);
        const std::vector<store::StationRecord> stations = store.stations();
        store.markUnclear(store.beginShot(stations[0].id, "YN1", {}).id, "Is it of this station?",
                          "http://192.168.1.1/files/R0010001.JPG#17");
        store.markUnclear(store.beginShot(stations[1].id, "YN1", {}).id, "Two pictures are new.");
        store.beginShot(stations[2].id, "YN1", {});
    }
    const Json listed = runCli({"shots", survey, "--json"}).json()["shots"];
    ASSERT_EQ(listed.size(), 3U);
    EXPECT_EQ(listed[0]["picture"], "R0010001.JPG");
    EXPECT_EQ(listed[1]["sentence"], "Two pictures are new.");
    EXPECT_EQ(listed[2]["step"], "intended");
    const std::string words = runCli({"shots", survey}).output;
    EXPECT_THAT(words, HasSubstr("--confirm 1."));
    for (const char* wayOut : {"--give-up 1.", "--give-up 2.", "--give-up 3."}) {
        EXPECT_THAT(words, HasSubstr(wayOut));
    }
    EXPECT_EQ(runCli({"shots", survey, "--confirm", "2"}).status, 1); // there is no picture
    const Json decided =
        runCli({"shots", survey, "--confirm", "1", "--give-up", "rail 1, stop 2", "--json"}).json()["shots"];
    ASSERT_EQ(decided.size(), 2U);
    EXPECT_EQ(decided[0]["step"], "taken");
    EXPECT_EQ(runCli({"shots", survey, "--give-up", "all", "--json"}).json()["shots"].size(), 0U);
    EXPECT_EQ(runCli({"shots", survey, "--give-up", "all"}).status, 1);
}

TEST(ShotsCommand, IsNamedByCaptureAsLongAsAPersonHasToDecide) {
    const test::TemporaryFolder folder;
    practice::PracticeCamera camera(plainCamera());
    camera.start();
    const std::string survey = plannedSurvey(folder);
    {
        auto store = store::SurveyStore::open(survey, store::Access::Write);
        store.markUnclear(store.beginShot(store.stations()[0].id, "YN1", {}).id, "Two pictures are new.");
    }
    const std::vector<std::string> capture{
        "capture",      survey, "--practice", "--camera", "127.0.0.1:" + std::to_string(camera.port()),
        "--time-scale", "0.02", "--most",     "1"};
    EXPECT_THAT(runCli(capture).output, HasSubstr("1 shot needs a person's decision; shots lists"));
    EXPECT_EQ(runCli({"shots", survey, "--give-up", "all"}).status, 0);
    EXPECT_THAT(runCli(capture).output, testing::Not(HasSubstr("decision")));
}

TEST(StatusCommand, TellsAPictureThatNobodyWaitsForFromAnInterruptedShot) {
    const test::PhotographedSurvey survey(1);
    {
        auto store = store::SurveyStore::open(survey.path(), store::Access::Write);
        const std::vector<store::StationRecord> stations = store.stations();
        store.markTaken(store.beginShot(stations[0].id, "YN1", {}).id, "http://192.168.1.1/files/R1.JPG");
        store.beginShot(stations[1].id, "YN1", {});
    }
    const CliResult result = runCli({"status", survey.path().string()});
    EXPECT_THAT(result.output, HasSubstr("1 shot was interrupted; capture settles it first"));
    EXPECT_THAT(result.output, HasSubstr("1 picture was never fetched, and its station has another photo: "
                                         "shots lists it, and closes it with --give-up."));
    const Json json = runCli({"status", survey.path().string(), "--json"}).json();
    EXPECT_EQ(json["open_shots"], 2);
    EXPECT_EQ(json["pictures_not_needed"], 1);
}

TEST(StatusCommand, SaysHowManyPhotosAreAligned) {
    const test::PhotographedSurvey survey(2); // imported with their rotations
    std::filesystem::create_directories(survey / "more");
    RgbImage picture(512, 256);
    writeFile(survey / "more/M1.JPG", jpeg::encode(picture, 90));
    ASSERT_EQ(runCli({"import", survey.path().string(), "--photos", (survey / "more").string()}).status, 0);
    EXPECT_THAT(runCli({"status", survey.path().string()}).output, HasSubstr("2 good, 1 not aligned yet."));
    const Json json = runCli({"status", survey.path().string(), "--json"}).json();
    EXPECT_EQ(json["aligned"], (Json{{"good", 2}, {"doubtful", 0}, {"failed", 0}, {"not_aligned", 1}}));
    const CliResult plan = runCli({"plan", survey.path().string(), "--json"});
    EXPECT_TRUE(plan.json()["station_list"].back()["position_m"].is_null());
}

} // namespace spherewalk
