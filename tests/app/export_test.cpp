// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli_run.h"
#include "photographed_survey.h"
#include "ply_reader.h"

#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/photo/picture_file.h"
#include "spherewalk/practice/practice_room.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <iterator>
#include <set>
#include <sstream>
#include <vector>

namespace spherewalk {

using test::CliResult;
using test::runCli;
using test::writeSmallCamera;
using testing::HasSubstr;

namespace {

std::vector<std::vector<std::string>> wordsOf(const std::filesystem::path& file) {
    std::vector<std::vector<std::string>> lines;
    std::istringstream all(readTextFile(file));
    for (std::string line; std::getline(all, line);) {
        if (!line.empty() && line.front() != '#') {
            std::istringstream words(line);
            lines.emplace_back(std::istream_iterator<std::string>(words),
                               std::istream_iterator<std::string>());
        }
    }
    return lines;
}

/// A survey of six photos of the practice room, whose poses are known, and exports of it for learners.
class Learners : public testing::Test {
  protected:
    Learners() {
        const practice::RoomPlan drawn = m_room.plan();
        const survey::Room room{drawn.outline, drawn.obstacles, drawn.ceilingM};
        survey::PlanOptions plan;
        plan.stepM = 2;
        auto store =
            store::SurveyStore::create(m_folder / "s.spherewalk", "s", room, plan, survey::plan(room, plan));
        std::filesystem::create_directories(m_folder / "in");
        std::string csv = "file,x_m,y_m,z_m,yaw_deg\n";
        for (int i = 0; i < 6; ++i) {
            const std::string name = text("R", 1001 + i, ".JPG");
            const Eigen::Vector3d at(2 + 0.5 * (i % 3), 1.6 + 0.5 * (i / 3), 1.2);
            const RgbImage photo = m_room.spherical({Eigen::Quaterniond::Identity(), at}, {512, 256});
            writeFile(m_folder / "in" / name, jpeg::encode(photo, 90));
            csv += text(name, ",", at.x(), ",", at.y(), ",", at.z(), ",0\n");
        }
        writeFile(m_folder / "p.csv", bytesOf(csv));
        jobs::importPhotos(store, {m_folder / "in", m_folder / "p.csv"}, noProgress(), {});
    }

    Json exported(const std::string& name, std::vector<std::string> more) const {
        more.insert(more.begin(),
                    {"export", path("s.spherewalk"), path(name), "--test-every", "3", "--json"});
        const CliResult made = runCli(more);
        EXPECT_EQ(made.status, 0) << made.errors;
        return made.json();
    }

    CliResult compare(const std::string& dataset, const std::string& against) const {
        return runCli({"compare", path(dataset), "--camera", path("colmap/camera.yaml"), "--pictures",
                       path("colmap/test.csv"), "--against", path(against), "--json"});
    }

    std::string path(const std::string& name) const { return (m_folder / name).string(); }

    practice::PracticeRoom m_room;
    test::TemporaryFolder m_folder;
};

} // namespace

TEST_F(Learners, GetPointsThatAreThereAndPicturesToTestWith) {
    const Json made = exported("colmap", {"--format", "colmap", "--points", "--voxel", "0.05"});
    EXPECT_EQ(made["test_photos"], 2);
    const auto points = wordsOf(path("colmap/sparse/0/points3D.txt"));
    EXPECT_EQ(made["points"], points.size());
    ASSERT_GT(points.size(), 1000U);
    std::size_t near = 0;
    for (const auto& point : points) {
        ASSERT_EQ(point.size(), 8U);
        const Eigen::Vector3d at(*parseNumber(point[1]), *parseNumber(point[2]), *parseNumber(point[3]));
        near += m_room.surfaceDistanceM(at) < 0.15 ? 1 : 0; // what fusion takes for one surface
    }
    EXPECT_GT(static_cast<double>(near), 0.8 * static_cast<double>(points.size()));
    test::Program colmap({"/usr/bin/env", "colmap", "model_analyzer", "--path", path("colmap/sparse/0")});
    ASSERT_EQ(colmap.wait(), 0) << colmap.errors();
    EXPECT_THAT(colmap.output() + colmap.errors(), HasSubstr(text("Points: ", points.size())));
    std::set<std::string> split;
    for (const auto& [file, pictures] : {std::pair{"train", 24U}, std::pair{"test", 12U}}) {
        const auto names = wordsOf(path(text("colmap/sparse/0/", file, ".txt")));
        EXPECT_EQ(names.size(), pictures);
        for (const auto& name : names) {
            EXPECT_TRUE(std::filesystem::exists(path("colmap/images/" + name.at(0))));
            EXPECT_EQ(file == std::string("test"), name[0].find("R1002") == 0 || name[0].find("R1005") == 0);
            split.insert(name[0]);
        }
    }
    EXPECT_EQ(split.size(), 36U);

    exported("nerf", {"--format", "nerfstudio", "--faces", "--points", "--voxel", "0.05"});
    const Json nerf = parseJson(readTextFile(path("nerf/transforms.json")), "transforms.json");
    EXPECT_EQ(nerf["train_filenames"].size(), 24U);
    EXPECT_EQ(nerf["test_filenames"].size(), 12U);
    EXPECT_EQ(nerf["val_filenames"], nerf["test_filenames"]);
    EXPECT_EQ(test::readPly(path("nerf/" + nerf["ply_file_path"].get<std::string>())).vertices.size(),
              points.size());
}

TEST_F(Learners, AreMeasuredBesideViewsOfADatasetWithoutTheTests) {
    exported("colmap", {"--format", "colmap"});
    EXPECT_EQ(exported("ours", {})["photos"], 4);
    ASSERT_EQ(runCli({"export", path("s.spherewalk"), path("all"), "--scene", "sphere"}).status, 0);
    std::filesystem::create_directories(path("perfect"));
    const auto names = wordsOf(path("colmap/sparse/0/test.txt"));
    for (const auto& name : names) {
        std::filesystem::copy_file(path("colmap/images/" + name[0]), path("perfect/" + name[0]));
    }
    writeFile(path("perfect/notes.png"), bytesOf("of somebody"));
    const CliResult compared = compare("ours", "perfect");
    ASSERT_EQ(compared.status, 0) << compared.errors;
    const Json json = compared.json();
    ASSERT_EQ(json["pictures"].size(), 12U);
    EXPECT_NEAR(json["theirs"]["ssim"].get<double>(), 1, 1e-6);
    EXPECT_EQ(json["theirs"]["false_edges"], 0);
    EXPECT_LT(json["ours"]["ssim"], 0.99);
    EXPECT_GT(json["ours"]["psnr_db"], 10);
    EXPECT_LT(json["theirs_beside_ours"]["ssim_lower_by"]["mean"], 0);
    EXPECT_EQ(json["unused"], Json::array({"notes.png"}));

    const CliResult whole = compare("all", "perfect");
    EXPECT_EQ(whole.status, 1);
    EXPECT_THAT(whole.errors, HasSubstr("--test-every"));
    photo::writePng(path("perfect/R1002_up.png"), RgbImage(64, 64));
    EXPECT_THAT(compare("ours", "perfect").errors, HasSubstr("have one name"));
    std::filesystem::remove(path("perfect/R1002_up.jpg"));
    EXPECT_THAT(compare("ours", "perfect").errors, HasSubstr("64 x 64"));
    std::filesystem::remove(path("perfect/R1002_up.png"));
    EXPECT_THAT(compare("ours", "perfect").errors, HasSubstr("no rendering called R1002_up;"));
    EXPECT_THAT(compare("ours", "nowhere").errors, HasSubstr("nowhere"));
}

TEST_F(Learners, AreRefusedWhatTheirFormatDoesNotKnow) {
    const auto refused = [&](const std::vector<std::string>& more, int status, const std::string& words) {
        std::vector<std::string> command{"export", path("s.spherewalk"), path("out")};
        command.insert(command.end(), more.begin(), more.end());
        const CliResult made = runCli(command);
        EXPECT_EQ(made.status, status) << more.back();
        EXPECT_THAT(made.errors, HasSubstr(words));
        EXPECT_FALSE(std::filesystem::exists(path("out")));
    };
    refused({"--format", "kitti", "--points"}, 1, "--format colmap and nerfstudio");
    refused({"--format", "ply", "--test-every", "3"}, 1, "colmap, nerfstudio and spherewalk");
    refused({"--format", "colmap", "--test-every", "13"}, 1, "smaller --test-every");
    refused({"--test-every", "1"}, 2, "--test-every");
}

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
    const CliResult usual = runCli({"export", survey.path(), survey / "usual", "--scene", "auto"});
    ASSERT_EQ(usual.status, 0) << usual.errors;
    EXPECT_THAT(usual.output, HasSubstr("640 x 480")) << "it says which camera it took";
    const CliResult made = runCli({"export", survey.path(), dataset, "--scene", "auto", "--camera", camera,
                                   "--tolerance", "900", "--json"});
    ASSERT_EQ(made.status, 0) << made.errors;
    const Json description = parseJson(readTextFile(survey / "d/dataset.json"), "dataset.json");
    EXPECT_EQ(made.json()["measured"]["scenes"].size(), 5U) << "the room as it was drawn, too";
    EXPECT_NE(description["choice"]["scene"], "depth") << "an endlessly far world needs no depth";
    EXPECT_EQ(made.json()["scene"], "sphere");
    EXPECT_EQ(description["scene_models"].size(), 1U);
}

TEST(ExportCommand, MeasuresUnlessASceneModelIsNamedFromThreePhotosOn) {
    const test::PhotographedSurvey survey{3};
    const std::string camera = writeSmallCamera(survey / "c.yaml");
    const std::vector<std::string> command{"export",   survey.path(), survey / "d",
                                           "--camera", camera,        "--json"};
    const CliResult made = runCli(command);
    ASSERT_EQ(made.status, 0) << made.errors;
    EXPECT_TRUE(made.json().contains("measured"));
    const test::PhotographedSurvey small{2};
    const CliResult few = runCli({"export", small.path(), small / "d", "--json"});
    ASSERT_EQ(few.status, 0) << few.errors;
    EXPECT_FALSE(few.json().contains("measured"));
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
    ASSERT_EQ(runCli({"export", survey.path(), dataset, "--scene", "sphere"}).status, 0);
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
    ASSERT_EQ(runCli({"export", dataset, survey / "in/world", "--format", "sdf", "--plugin"}).status, 0);
    EXPECT_THAT(readTextFile(survey / "in/world/world.sdf"), HasSubstr("<dataset>../../d</dataset>"));
    const CliResult noDataset =
        runCli({"export", survey.path(), survey / "other", "--format", "sdf", "--plugin"});
    EXPECT_EQ(noDataset.status, 1);
    EXPECT_THAT(noDataset.errors, HasSubstr("export the survey first"));
    EXPECT_EQ(runCli({"export", dataset, survey / "other", "--format", "mjcf", "--plugin"}).status, 1);
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

TEST(WalkCommand, WalksWithARigAndSaysWhatIsWrongWithOne) {
    const test::PhotographedSurvey survey{2};
    ASSERT_EQ(runCli({"export", survey.path(), survey / "d"}).status, 0);
    writeFile(survey / "p.tum", bytesOf("0 2 1.5 1.2 0 0 0 1\n0.1 2.1 1.5 1.2 0 0 0.1 0.995\n"));
    writeSmallCamera(survey / "c.yaml");
    const std::string left =
        "axes: body\ncameras:\n  - {name: left, camera_info: c.yaml, rig_from_camera: [0, "
        "0.06, 0, 0, 0, 0, 1]}\n";
    const std::string right = "  - {name: right, camera_info: c.yaml";
    writeFile(survey / "rig.yaml", bytesOf(left + right + ", rig_from_camera: [0, -0.06, 0, 0, 0, 0, 1]}\n"));
    writeFile(survey / "tf.yaml", bytesOf(left + right + "}\n"));
    const auto walk = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words{"walk",  survey / "d", "--path",   survey / "p.tum",
                                       "--out", survey / "w", "--format", "rosbag"};
        words.insert(words.end(), more.begin(), more.end());
        return runCli(words);
    };
    EXPECT_THAT(walk({"--rig", survey / "tf.yaml"}).errors, HasSubstr("right of the rig"));
    EXPECT_THAT(walk({"--rig", survey / "rig.yaml", "--frame", "body"}).errors,
                HasSubstr("leave --frame out"));
    EXPECT_THAT(walk({"--rig", survey / "rig.yaml", "--camera", survey / "c.yaml"}).errors,
                HasSubstr("--rig"));
    EXPECT_THAT(walk({"--rig", survey / "none.yaml"}).errors, HasSubstr("none.yaml"));
    EXPECT_FALSE(std::filesystem::exists(survey / "w"));
    const CliResult walked = walk({"--rig", survey / "rig.yaml", "--depth"});
    ASSERT_EQ(walked.status, 0) << walked.errors;
    EXPECT_THAT(walked.output, HasSubstr("4 frames of 2 cameras"));
    for (const char* file : {"left/000001.png", "right/depth/000001.png", "right/index.csv", "walk.bag"}) {
        EXPECT_TRUE(std::filesystem::exists(survey / "w" / file)) << file;
    }
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
    EXPECT_THAT(runCli(walk).errors, HasSubstr("--ball or --object")) << "there is nothing to label";
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

TEST(ProbeCommand, WritesTheLightAtAPlace) {
    const test::PhotographedSurvey survey{2};
    ASSERT_EQ(runCli({"export", survey.path(), survey / "d"}).status, 0);
    const Json at =
        parseJson(readTextFile(survey / "d/dataset.json"), "dataset.json")["photos"][0]["position_m"];
    const std::string place =
        text(at[0].get<double>() + 0.1, " ", at[1].get<double>(), " ", at[2].get<double>());
    const CliResult probed = runCli(
        {"probe", survey / "d", "--at", place, "--out", survey / "light.hdr", "--width", "64", "--json"});
    ASSERT_EQ(probed.status, 0) << probed.errors;
    const Json json = probed.json();
    EXPECT_EQ(json["harmonics"].size(), 9U);
    EXPECT_GE(json["recovered_share"].get<double>(), 0);
    EXPECT_GE(json["clipped_share"].get<double>(), 0);
    EXPECT_LT(json["clipped_share"].get<double>(), 0.5);
    EXPECT_NEAR(std::hypot(json["towards"][0].get<double>(), json["towards"][1].get<double>(),
                           json["towards"][2].get<double>()),
                1, 1e-9);
    const std::string file = readTextFile(survey / "light.hdr");
    const std::string head = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 32 +X 64\n";
    EXPECT_EQ(file.substr(0, head.size()), head);
    EXPECT_EQ(file.size(), head.size() + std::size_t{4} * 64 * 32);
    const CliResult said =
        runCli({"probe", survey / "d", "--at", place, "--out", survey / "light.hdr", "--width", "64"});
    EXPECT_THAT(said.output, HasSubstr("% of all directions are too bright for the photos"));
    const auto refused = [&](const std::string& where, const std::string& width, const std::string& part) {
        const CliResult result =
            runCli({"probe", survey / "d", "--at", where, "--out", survey / "no.hdr", "--width", width});
        EXPECT_EQ(result.status, 1);
        EXPECT_THAT(result.errors, HasSubstr(part));
        EXPECT_FALSE(std::filesystem::exists(survey / "no.hdr"));
    };
    refused("1 2", "64", "--at wants a place in the room as \"x y z\"");
    refused("1 2 up", "64", "--at wants a place");
    refused("1 2 nan", "64", "--at wants a place");
    refused(place, "63", "give an even number from 16 to 8192");
}

TEST(ViewCommand, LightsABallAndLetsItCastAShadow) {
    const test::PhotographedSurvey survey{2};
    ASSERT_EQ(runCli({"export", survey.path(), survey / "d"}).status, 0);
    const Json at =
        parseJson(readTextFile(survey / "d/dataset.json"), "dataset.json")["photos"][0]["position_m"];
    const auto place = [&](double ahead, const std::string& rest) {
        return text(at[0].get<double>() + ahead, " ", at[1].get<double>(), " ", at[2].get<double>(), rest);
    };
    const auto view = [&](const std::string& out, std::vector<std::string> more) {
        std::vector<std::string> arguments{
            "view",    survey / "d", "--camera", writeSmallCamera(survey / "c.yaml"),
            "--frame", "body",       "--pose",   place(0, " 0 0 0 1"),
            "--out",   survey / out};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runCli(arguments).status;
    };
    ASSERT_EQ(view("flat.png", {"--ball", place(0.6, " 0.1")}), 0);
    ASSERT_EQ(view("lit.png", {"--ball", place(0.6, " 0.1"), "--light"}), 0);
    EXPECT_NE(photo::readPicture(survey / "flat.png"), photo::readPicture(survey / "lit.png"));
    EXPECT_EQ(view("none.png", {"--light"}), 2) << "there is nothing to light";
}

} // namespace spherewalk
