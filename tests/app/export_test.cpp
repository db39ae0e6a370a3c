// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli_run.h"
#include "photographed_survey.h"

#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/photo/picture_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cctype>
#include <vector>

namespace spherewalk {

using test::CliResult;
using test::runCli;
using test::writeSmallCamera;
using testing::HasSubstr;

TEST(ExportCommand, OnlyLooksWhenAsked) {
    const test::PhotographedSurvey survey(2);
    const CliResult checked =
        runCli({"export", survey.path().string(), (survey / "d").string(), "--check", "--json"});
    EXPECT_EQ(checked.status, 0) << checked.errors;
    EXPECT_EQ(checked.json()["photos"], 2);
    EXPECT_FALSE(std::filesystem::exists(survey / "d"));
}

TEST(ExportCommand, FindsDepthsOfASurveyThatMayOnlyBeRead) {
    namespace fs = std::filesystem;
    const test::PhotographedSurvey survey(3);
    fs::permissions(survey.path(), fs::perms::owner_read | fs::perms::owner_exec);
    const CliResult made =
        runCli({"export", survey.path().string(), survey / "d", "--scene", "depth", "--json"},
               {.obeysPermissions = true});
    fs::permissions(survey.path(), fs::perms::owner_all);
    ASSERT_EQ(made.status, 0) << made.errors;
    EXPECT_EQ(made.json()["photos_with_depth"], 3);
    EXPECT_FALSE(fs::exists(survey.path() / "depth-cache"));
}

TEST(ExportCommand, ExportsTheSceneModelThatEarnsItsPlace) {
    const test::PhotographedSurvey survey{2};
    const std::string camera = writeSmallCamera(survey / "c.yaml");
    const std::string dataset = survey / "d";
    const CliResult refused = runCli({"export", survey.path(), dataset, "--scene", "auto"});
    EXPECT_EQ(refused.status, 1);
    EXPECT_THAT(refused.errors, HasSubstr("--camera"));
    const CliResult made = runCli({"export", survey.path(), dataset, "--scene", "auto", "--camera", camera,
                                   "--tolerance", "900", "--json"});
    ASSERT_EQ(made.status, 0) << made.errors;
    const Json description = parseJson(readTextFile(survey / "d/dataset.json"), "dataset.json");
    EXPECT_EQ(made.json()["measured"]["scenes"].size(), 5U) << "the room as it was drawn, too";
    EXPECT_NE(description["choice"]["scene"], "depth") << "an endlessly far world needs no depth";
    EXPECT_EQ(made.json()["scene"], "sphere");
    EXPECT_EQ(description["scene_models"].size(), 1U);
}

TEST(ExportCommand, CutsPhotosIntoFacesThatColmapReads) {
    const test::PhotographedSurvey survey{2};
    const std::string folder = survey / "faces";
    const CliResult made = runCli({"export", survey.path(), folder, "--format", "colmap", "--json"});
    ASSERT_EQ(made.status, 0) << made.errors;
    EXPECT_EQ(made.json()["pictures"], 12);
    EXPECT_TRUE(std::filesystem::exists(survey / "faces/images/R1001_front.jpg"));
    test::Program colmap({"/usr/bin/env", "colmap", "model_analyzer", "--path", folder + "/sparse/0"});
    ASSERT_EQ(colmap.wait(), 0) << colmap.errors();
    EXPECT_THAT(colmap.output() + colmap.errors(), HasSubstr("Registered images: 12"));
    const CliResult again = runCli({"export", survey.path(), folder, "--format", "colmap"});
    EXPECT_EQ(again.status, 1);
    EXPECT_THAT(again.errors, HasSubstr("exists already"));
}

TEST(ExportCommand, WritesPosesIntoPhotosThatExiftoolReads) {
    const test::PhotographedSurvey survey{2};
    ASSERT_EQ(runCli({"export", survey.path(), survey / "d"}).status, 0);
    const Json description = parseJson(readTextFile(survey / "d/dataset.json"), "dataset.json");
    for (const Json& photo : description["photos"]) {
        const std::string file = survey / "d" / photo["file"].get<std::string>();
        test::Program exiftool({"/usr/bin/env", "exiftool", "-json", "-n", "-XMP-spherewalk:all", file});
        ASSERT_EQ(exiftool.wait(), 0) << exiftool.errors();
        const Json found = parseJson(exiftool.output(), "what exiftool says").at(0);
        const auto number = [&](const std::string& tag) { // long ones come as texts
            const Json& value = found.at(tag);
            return value.is_string() ? parseNumber(value.get<std::string>()).value() : value.get<double>();
        };
        int i = 0;
        for (const char* axis : {"X", "Y", "Z"}) {
            EXPECT_NEAR(number(text("Position", axis)), photo["position_m"][i++].get<double>(), 1e-9);
        }
        for (const auto& [component, value] : photo["room_from_photo"].items()) {
            const auto capital = static_cast<char>(std::toupper(component.front()));
            EXPECT_NEAR(number(std::string("RoomFromPhoto") + capital), value.get<double>(), 1e-9);
        }
    }
}

TEST(ExportCommand, MakesTheSameWorldOfASurveyAndOfItsDataset) {
    const test::PhotographedSurvey survey{4};
    const std::string camera = writeSmallCamera(survey / "c.yaml");
    const std::string dataset = survey / "d";
    ASSERT_EQ(runCli({"export", survey.path(), dataset}).status, 0);
    for (const std::string& from : {survey.path().string(), dataset}) {
        const CliResult made =
            runCli({"export", from, from + ".world", "--format", "sdf", "--camera", camera});
        ASSERT_EQ(made.status, 0) << made.errors;
        EXPECT_THAT(made.output, HasSubstr("4 walls"));
    }
    const std::string world = readTextFile(dataset + ".world/world.sdf");
    EXPECT_EQ(world, readTextFile(survey.path().string() + ".world/world.sdf"));
    EXPECT_THAT(world, HasSubstr("<fx>120</fx><fy>120</fy><cx>80</cx><cy>60</cy>"));
    EXPECT_THAT(readTextFile(dataset + ".world/camera.yaml"),
                HasSubstr("data: [120, 0, 79.5, 0, 120, 59.5,"));
    EXPECT_EQ(runCli({"export", dataset, dataset + ".world", "--format", "sdf"}).status, 1);
}

TEST(ExportCommand, GivesNerfstudioThePhotosAsTheyAre) {
    const test::PhotographedSurvey survey{2};
    ASSERT_EQ(runCli({"export", survey.path(), survey / "n", "--format", "nerfstudio"}).status, 0);
    const Json json = parseJson(readTextFile(survey / "n/transforms.json"), "transforms.json");
    EXPECT_EQ(json["camera_model"], "EQUIRECTANGULAR");
    ASSERT_EQ(json["frames"].size(), 2U);
    for (const Json& frame : json["frames"]) {
        EXPECT_TRUE(std::filesystem::exists(survey / "n" / frame["file_path"].get<std::string>()));
    }
}

TEST(WalkCommand, WritesItsPosesAsOtherProgramsReadThem) {
    const test::PhotographedSurvey survey{2};
    ASSERT_EQ(runCli({"export", survey.path(), survey / "d"}).status, 0);
    writeFile(survey / "p.tum", bytesOf("0 2 1.5 1.2 0 0 0 1\n0.1 2.1 1.5 1.2 0 0 0.1 0.995\n"));
    const CliResult walked = runCli({"walk", survey / "d", "--camera", writeSmallCamera(survey / "c.yaml"),
                                     "--frame", "body", "--path", survey / "p.tum", "--out", survey / "w",
                                     "--format", "colmap", "--format", "kitti", "--format", "tum"});
    ASSERT_EQ(walked.status, 0) << walked.errors;
    for (const char* file : {"sparse/0/images.txt", "poses.txt", "times.txt", "groundtruth.txt"}) {
        EXPECT_TRUE(std::filesystem::exists(survey / "w" / file)) << file;
    }
    EXPECT_THAT(readTextFile(survey / "w/sparse/0/images.txt"), HasSubstr(" 1 000001.png\n"));
}

TEST(WalkCommand, LabelsWhatItLaysIn) {
    const test::PhotographedSurvey survey{2};
    ASSERT_EQ(runCli({"export", survey.path(), survey / "d"}).status, 0);
    const Json at =
        parseJson(readTextFile(survey / "d/dataset.json"), "dataset.json")["photos"][0]["position_m"];
    const auto besideIt = [&](double x, double y) { // of the photo, in whose sphere all of it lies
        return text(at[0].get<double>() + x, " ", at[1].get<double>() + y, " ", at[2].get<double>(), " ");
    };
    writeFile(survey / "p.tum",
              bytesOf("0 " + besideIt(0, 0) + "0 0 0 1\n0.1 " + besideIt(0, 0.02) + "0 0 0 1\n"));
    const std::vector<std::string> walk{
        "walk",    survey / "d", "--camera", writeSmallCamera(survey / "c.yaml"),
        "--frame", "body",       "--path",   survey / "p.tum",
        "--out",   survey / "w", "--labels"};
    EXPECT_EQ(runCli(walk).status, 2) << "there is nothing to label";
    EXPECT_FALSE(std::filesystem::exists(survey / "w"));
    std::vector<std::string> withBalls = walk;
    withBalls.insert(withBalls.end(),
                     {"--ball", besideIt(0.6, 0) + "0.1", "--ball", besideIt(0.9, 0.1) + "0.1", "--json"});
    const CliResult walked = runCli(withBalls);
    ASSERT_EQ(walked.status, 0) << walked.errors;
    const Json json = parseJson(readTextFile(survey / "w/annotations.json"), "annotations.json");
    EXPECT_EQ(json["annotations"].size(), 4U);
    const auto labels = photo::readPng16(survey / "w/labels/000000.png");
    EXPECT_EQ(*labels.at(79, 59), 1);
    EXPECT_EQ(*labels.at(5, 5), 0);
    for (const Json& annotation : json["annotations"]) {
        if (annotation["image_id"] == 0) {
            EXPECT_EQ(annotation["area"], std::count(labels.values().begin(), labels.values().end(),
                                                     annotation["instance"].get<int>()));
            const bool isFirst = annotation["instance"] == 1;
            EXPECT_EQ(annotation["visible_share"] == 1, isFirst) << "the second stands behind the first";
        }
    }
}

} // namespace spherewalk
