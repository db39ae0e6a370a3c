// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "temporary_folder.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/jobs/walk.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/photo/picture_file.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace spherewalk::jobs {

using test::expectError;

namespace {

/// A dataset of two photos, one red and one blue, a metre apart.
void writeDataset(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder / "photos");
    render::DatasetInfo info;
    for (int i = 0; i < 2; ++i) {
        RgbImage picture(64, 32);
        for (int p = 0; p < 64 * 32; ++p) {
            picture.values()[static_cast<std::size_t>(3 * p + 2 * i)] = 200;
        }
        const Bytes jpeg = jpeg::encode(picture, 95);
        render::DatasetPhoto photo;
        photo.file = "photos/" + std::to_string(i) + ".jpg";
        photo.sha256 = sha256Hex(jpeg);
        photo.sizeBytes = jpeg.size();
        photo.width = 64;
        photo.height = 32;
        photo.roomFromPhoto.translation.x() = i;
        info.photos.push_back(photo);
        writeFile(folder / photo.file, jpeg);
    }
    writeFile(folder / render::kDatasetFile, bytesOf(render::toJson(info).dump()));
}

class WalkTest : public testing::Test {
  protected:
    WalkTest() {
        writeDataset(folder / "d");
        for (int i = 0; i < 5; ++i) {
            path.push_back({0.1 * i, {Eigen::Quaterniond::Identity(), {0.25 * i, 0, 0}}});
        }
    }

    WalkReport run(const std::stop_token& stop = {}) { return run("out/walk", {}, stop); }

    WalkReport run(const std::string& out, const WalkOptions& options, const std::stop_token& stop = {},
                   ProgressSink& progress = noProgress()) {
        const render::Renderer renderer(
            std::make_shared<const render::Dataset>(render::Dataset::open(folder / "d")));
        return walk(renderer, CameraModel(CameraIntrinsics::pinhole(32, 24, 1)), path, options, folder / out,
                    progress, stop);
    }

    WalkReport runPart(const std::string& out, const std::string& shard,
                       ProgressSink& progress = noProgress()) {
        WalkOptions options;
        options.shard = Shard::parse(shard);
        return run(out, options, {}, progress);
    }

    /// All files by name, but for those that tell how long it took.
    std::map<std::string, std::string> filesOf(const std::string& out) {
        std::map<std::string, std::string> files;
        for (const auto& entry : std::filesystem::directory_iterator(folder / out)) {
            if (entry.is_regular_file() && entry.path().filename() != "times.csv") {
                files[entry.path().filename()] = readTextFile(entry.path());
            }
        }
        return files;
    }

    test::TemporaryFolder folder;
    std::vector<TimedPose> path;
};

} // namespace

TEST_F(WalkTest, WritesAFrameAPoseWithItsIndexAndASheet) {
    const WalkReport report = run();
    EXPECT_EQ(report.frames, 5U);
    EXPECT_EQ(report.photosUsed, 2U);
    EXPECT_DOUBLE_EQ(report.worstOffsetM, 0.5);
    const RgbImage first = photo::readPicture(folder / "out/walk/000000.png");
    const RgbImage last = photo::readPicture(folder / "out/walk/000004.png");
    EXPECT_GT(first.at(16, 12)[0], 150);
    EXPECT_GT(last.at(16, 12)[2], 150);
    EXPECT_EQ(first.width(), 32);
    EXPECT_FALSE(photo::readPicture(folder / "out/walk/contact-sheet.png").empty());
    const std::string csv = readTextFile(folder / "out/walk/index.csv");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 6);
    EXPECT_NE(csv.find("\n000003.png,0.30000000000000004,0.75,0,0,0,0,0,1,photos/1.jpg,0.25,none,bicubic,"),
              std::string::npos)
        << csv;
}

TEST_F(WalkTest, IsTheSameInOnePieceAndInParts) {
    EXPECT_TRUE(run("whole", {}).isComplete);
    EXPECT_FALSE(runPart("parts", "3/3").isComplete);
    EXPECT_FALSE(runPart("parts", "1/3").isComplete);
    EXPECT_FALSE(std::filesystem::exists(folder / "parts/index.csv"));
    EXPECT_TRUE(runPart("parts", "2/3").isComplete);
    EXPECT_EQ(filesOf("parts"), filesOf("whole"));
    EXPECT_EQ(filesOf("whole").size(), 7U); // five frames, index, sheet
}

TEST_F(WalkTest, IsFinishedByTheLastOfPartsThatRunAtATime) {
    struct : ProgressSink {
        void progress(double /*fraction*/, std::string_view /*activity*/) override {
            std::exchange(meanwhile, [] {})();
        }

        void warning(std::string_view /*sentence*/) override {}

        std::function<void()> meanwhile;
    } duringTheFirst;

    duringTheFirst.meanwhile = [&] { EXPECT_FALSE(runPart("parts", "2/2").isComplete); };
    EXPECT_TRUE(runPart("parts", "1/2", duringTheFirst).isComplete);
    run("whole", {});
    EXPECT_EQ(filesOf("parts"), filesOf("whole"));
}

TEST_F(WalkTest, GoesOnWithFramesThatAreMissing) {
    run();
    std::filesystem::remove(folder / "out/walk/000002.png");
    const WalkReport again = run();
    EXPECT_EQ(again.reused, 4U);
    EXPECT_EQ(again.frames, 5U);
    EXPECT_TRUE(std::filesystem::exists(folder / "out/walk/000002.png"));
}

TEST_F(WalkTest, TakesNoFramesOfAnotherWalk) {
    run();
    path[1].roomFromCamera.translation.x() = 0.3;
    EXPECT_EQ(run().reused, 0U);
    WalkOptions nearest;
    nearest.view.sampling = render::Sampling::Nearest;
    EXPECT_EQ(run("out/walk", nearest).reused, 0U);
}

TEST_F(WalkTest, RendersAgainWhatItsJournalTellsOnlyHalf) {
    run();
    for (const auto& part : std::filesystem::directory_iterator(folder / "out/walk/parts")) {
        const std::string lines = readTextFile(part.path());
        writeFile(part.path(), bytesOf(lines.substr(0, lines.size() - 3)));
    }
    EXPECT_EQ(run().reused, 4U);
    EXPECT_EQ(run().reused, 5U);
}

TEST_F(WalkTest, ReadsItsJournalWhateverElseStandsInIt) {
    run();
    for (const auto& part : std::filesystem::directory_iterator(folder / "out/walk/parts")) {
        using namespace std::string_view_literals;
        const std::string lines = readTextFile(part.path());
        const std::string noise(
            "\n\n7\n-1\ta\tb\tend\nx\ta\tb\tend\n1e99\ta\tb\tend\n\0\xff\t\n\t\t\tend\n9\ta\tend\n"sv);
        writeFile(part.path(), bytesOf(noise + lines + noise));
    }
    const WalkReport again = run();
    EXPECT_EQ(again.reused, 5U);
    EXPECT_TRUE(again.isComplete);
    const std::string index = readTextFile(folder / "out/walk/index.csv");
    EXPECT_EQ(std::count(index.begin(), index.end(), '\n'), 6) << index;
}

TEST_F(WalkTest, GoesOnWithoutItsJournal) {
    run();
    const auto first = filesOf("out/walk");
    std::filesystem::remove_all(folder / "out/walk/parts");
    EXPECT_EQ(run().reused, 0U) << "a picture alone does not tell what it shows";
    EXPECT_EQ(filesOf("out/walk"), first);
}

TEST_F(WalkTest, LeavesTheJournalOfAnotherWalkAlone) {
    run();
    std::map<std::string, std::string> journals;
    for (const auto& part : std::filesystem::directory_iterator(folder / "out/walk/parts")) {
        journals[part.path()] = readTextFile(part.path());
    }
    path.pop_back();
    run();
    for (const auto& [file, lines] : journals) {
        EXPECT_EQ(readTextFile(file), lines);
    }
}

TEST_F(WalkTest, MayHaveMorePartsThanFrames) {
    for (int part = 1; part <= 8; ++part) {
        EXPECT_EQ(runPart("parts", std::to_string(part) + "/8").isComplete, part == 8) << part;
    }
    run("whole", {});
    EXPECT_EQ(filesOf("parts"), filesOf("whole"));
}

TEST_F(WalkTest, RendersNothingForABagThatCannotHoldItsTimes) {
    path.front().timeS = -1;
    WalkOptions options;
    options.bags = {dataset::BagFormat::Rosbag};
    expectError(ErrorKind::InvalidInput, "", [&] { run("out", options); });
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

TEST_F(WalkTest, NamesTheKindsOfABagsPictures) {
    EXPECT_EQ(bagPictures("raw"), BagPictures::Raw);
    EXPECT_EQ(bagPictures("png"), BagPictures::Png);
    expectError(ErrorKind::InvalidInput, "raw", [] { bagPictures("jpeg"); });
}

TEST_F(WalkTest, WithASensorIsTheSameInOnePieceAndInParts) {
    for (const bool isAutomatic : {false, true}) {
        WalkOptions options;
        options.sensor.emplace();
        options.sensor->noise = {2000, 5};
        options.sensor->exposure.timeS = 0.02;
        options.sensor->shutter.lineDelayS = 1e-4;
        if (isAutomatic) {
            options.sensor->exposure.automatic.emplace();
            options.sensor->whiteBalance.isAutomatic = true;
        }
        const std::string name = isAutomatic ? "automatic" : "fixed";
        EXPECT_TRUE(run(name, options).isComplete);
        options.shard = Shard::parse("2/2");
        run(name + "-parts", options);
        options.shard = Shard::parse("1/2");
        EXPECT_TRUE(run(name + "-parts", options).isComplete);
        EXPECT_EQ(filesOf(name + "-parts"), filesOf(name));
    }
    EXPECT_NE(filesOf("fixed").at("000001.png"), filesOf("automatic").at("000001.png"));
    EXPECT_THAT(filesOf("fixed").at("index.csv"), testing::HasSubstr("trust,exposure_time_s,gain_db\n"));
    EXPECT_THAT(filesOf("fixed").at("index.csv"), testing::HasSubstr(",0.02,0.000\n"));
}

TEST_F(WalkTest, WithAnotherSensorIsAnotherWalk) {
    WalkOptions options;
    options.sensor.emplace().noise.fullWellE = 500;
    run("w", options);
    options.sensor->seed = 2;
    EXPECT_EQ(run("w", options).reused, 0U);
    EXPECT_EQ(run("w", options).reused, 5U);
    options.sensor.reset();
    EXPECT_EQ(run("w", options).reused, 0U);
}

TEST_F(WalkTest, WithASensorNeedsTimesThatAscend) {
    path[3].timeS = path[2].timeS;
    WalkOptions options;
    options.sensor.emplace();
    expectError(ErrorKind::InvalidInput, "pose 4 is not later", [&] { run("w", options); });
}

TEST_F(WalkTest, WritesDepthInMillimetresWithWhatIsLaidIn) {
    WalkOptions options;
    options.writesDepth = true;
    expectError(ErrorKind::InvalidInput, "knows no depth", [&] { run("none", options); });
    render::DatasetInfo info = render::Dataset::open(folder / "d").info();
    info.sphereRadiusM = 2;
    writeFile(folder / "d" / render::kDatasetFile, bytesOf(render::toJson(info).dump()));
    options.view.scene = render::SceneKind::Sphere;
    options.balls = {Ball{{1, 0, 0.8}, 0.2}}; // in the last pose's axis
    EXPECT_TRUE(run("w", options).isComplete);
    const DepthImage last = photo::readDepthPng(folder / "w/depth/000004.png");
    EXPECT_NEAR(*last.at(16, 12), 0.6, 0.003);
    EXPECT_NEAR(*last.at(1, 12), 2 * std::cos(std::atan(14.5 / 29.29)), 0.01) << "of the sphere";
    std::filesystem::remove(folder / "w/depth/000002.png");
    EXPECT_EQ(run("w", options).reused, 4U);
    EXPECT_TRUE(std::filesystem::exists(folder / "w/depth/000002.png"));
}

TEST_F(WalkTest, LabelsWhatIsLaidInTheSameInParts) {
    WalkOptions options;
    options.writesLabels = true;
    expectError(ErrorKind::InvalidInput, "--ball", [&] { run("none", options); });
    options.balls = {Ball{{1, 0, 0.8}, 0.2}, Ball{{1.82, 0, 2.255}, 0.6}, Ball{{0.25, 0, 2.5}, 0.3}};
    expectError(ErrorKind::InvalidInput, "knows no depth", [&] { run("none", options); });
    render::DatasetInfo info = render::Dataset::open(folder / "d").info();
    info.sphereRadiusM = 2;
    writeFile(folder / "d" / render::kDatasetFile, bytesOf(render::toJson(info).dump()));
    options.view.scene = render::SceneKind::Sphere;
    options.view.threads = 1;
    options.bags = {dataset::BagFormat::Mcap};
    EXPECT_TRUE(run("whole", options).isComplete);
    options.view.threads = 3;
    for (const char* part : {"2/2", "1/2"}) {
        options.shard = Shard::parse(part);
        run("parts", options);
    }
    EXPECT_EQ(filesOf("parts"), filesOf("whole"));

    const Json json = parseJson(readTextFile(folder / "whole/annotations.json"), "annotations.json");
    ASSERT_EQ(json["images"].size(), 5U);
    const Json& last = json["images"][4];
    EXPECT_EQ(last["file_name"], "000004.png");
    const Image<std::uint16_t, 1> labels = photo::readPng16(folder / "whole" / last["labels_file"]);
    EXPECT_EQ(*labels.at(16, 12), 1);
    EXPECT_EQ(*labels.at(1, 12), 0) << "the room";
    EXPECT_EQ(last["hidden_instances"], Json::array({3})) << "behind the sphere";
    std::map<int, Json> seen;
    for (const Json& annotation : json["annotations"]) {
        if (annotation["image_id"] == 4) {
            seen[annotation["instance"].get<int>()] = annotation;
        }
    }
    ASSERT_EQ(seen.size(), 2U);
    EXPECT_EQ(seen[1]["visible_share"], 1);
    EXPECT_EQ(seen[1]["box_in_camera"]["center_m"], Json({0, 0, 0.8}));
    EXPECT_EQ(seen[1]["box_in_room"]["center_m"], Json({1, 0, 0.8}));
    EXPECT_EQ(seen[1]["box_in_room"]["size_m"], Json({0.4, 0.4, 0.4}));
    // The second ball comes through the sphere, behind the first one.
    EXPECT_GT(seen[2]["hidden_by_objects_share"], 0.1);
    EXPECT_GT(seen[2]["hidden_by_room_share"], 0.1);
    EXPECT_NEAR(seen[2]["visible_share"].get<double>() + seen[2]["hidden_by_objects_share"].get<double>() +
                    seen[2]["hidden_by_room_share"].get<double>(),
                1, 1e-12);
    EXPECT_LT(seen[2]["area"], seen[2]["whole_area"]);
    EXPECT_TRUE(std::filesystem::exists(folder / "whole/walk.mcap"));
}

TEST_F(WalkTest, LabelsObjectsWithBoxesThatAreTurnedAsTheyAre) {
    render::DatasetInfo info = render::Dataset::open(folder / "d").info();
    info.sphereRadiusM = 2;
    writeFile(folder / "d" / render::kDatasetFile, bytesOf(render::toJson(info).dump()));
    writeFile(folder / "slab.obj", bytesOf("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nf 1 2 3 4\n"));
    WalkOptions options;
    options.view.scene = render::SceneKind::Sphere;
    options.writesLabels = true;
    options.meshes = {parseObject("cube 1 0 0.6 0.4 45"),
                      parseObject((folder / "slab.obj").string() + " 1 0 1.2 1.6")};
    run("labelled", options);
    const Json json = parseJson(readTextFile(folder / "labelled/annotations.json"), "annotations.json");
    ASSERT_EQ(json["categories"].size(), 4U);
    EXPECT_EQ(json["categories"][2]["name"], "cube");
    EXPECT_EQ(json["categories"][3]["name"], "slab");
    const Image<std::uint16_t, 1> labels = photo::readPng16(folder / "labelled/labels/000004.png");
    EXPECT_EQ(*labels.at(16, 12), 1);
    std::map<int, Json> seen;
    for (const Json& annotation : json["annotations"]) {
        if (annotation["image_id"] == 4) {
            seen[annotation["instance"].get<int>()] = annotation;
        }
    }
    ASSERT_EQ(seen.size(), 2U);
    EXPECT_EQ(seen[1]["category_id"], 2);
    EXPECT_EQ(seen[1]["visible_share"], 1);
    const auto expectNumbers = [](const Json& numbers, const std::vector<double>& expected) {
        ASSERT_EQ(numbers.size(), expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i) {
            EXPECT_NEAR(numbers[i].get<double>(), expected[i], 1e-6) << i;
        }
    };
    expectNumbers(seen[1]["box_in_room"]["center_m"], {1, 0, 0.8});
    expectNumbers(seen[1]["box_in_room"]["size_m"], {0.4, 0.4, 0.4});
    EXPECT_NEAR(seen[1]["box_in_room"]["rotation"]["w"].get<double>(), std::cos(std::acos(-1.) / 8), 1e-12);
    EXPECT_EQ(seen[2]["category_id"], 3);
    expectNumbers(seen[2]["box_in_room"]["size_m"], {1.6, 0.8, 0});
    expectNumbers(seen[2]["box_in_camera"]["center_m"], {0, 0, 1.2});
    EXPECT_GT(seen[2]["hidden_by_objects_share"], 0.05) << "by the cube before it";
    // Another mesh of the same name and bounds is another walk's.
    writeFile(folder / "slab.obj", bytesOf("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nf 1 2 3\nf 1 2 4\n"));
    options.meshes[1] = parseObject((folder / "slab.obj").string() + " 1 0 1.2 1.6");
    EXPECT_EQ(run("labelled", options).reused, 0U);
}

TEST_F(WalkTest, OfARigHasTheFramesOfEachCameraAndOneBagWithEqualStamps) {
    render::DatasetInfo info = render::Dataset::open(folder / "d").info();
    info.sphereRadiusM = 2;
    writeFile(folder / "d" / render::kDatasetFile, bytesOf(render::toJson(info).dump()));
    const CameraIntrinsics lens = CameraIntrinsics::pinhole(32, 24, 1);
    const Rigid3 rightOfLeft{Eigen::Quaterniond::Identity(), {0.1, 0, 0}};
    const std::vector<render::RigCamera> rig{{"left", "left_optical", lens, Rigid3()},
                                             {"right", "right_optical", lens, rightOfLeft}};
    const std::vector<WalkCamera> cameras = walkCameras(rig, path, "rig.yaml");
    WalkOptions options;
    options.writesDepth = true;
    options.bags = {dataset::BagFormat::Rosbag};
    const render::Renderer renderer(
        std::make_shared<const render::Dataset>(render::Dataset::open(folder / "d")));
    const auto walkRig = [&](const std::string& out) {
        return walk(renderer, cameras, options, folder / out, noProgress(), {});
    };
    const WalkReport report = walkRig("rig");
    EXPECT_EQ(report.frames, 10U);
    EXPECT_EQ(report.photosUsed, 2U);
    EXPECT_TRUE(std::filesystem::exists(folder / "rig/walk.bag"));
    EXPECT_FALSE(std::filesystem::exists(folder / "rig/index.csv"));
    options.shard = Shard::parse("2/2");
    EXPECT_FALSE(walkRig("parts").isComplete);
    EXPECT_FALSE(std::filesystem::exists(folder / "parts/walk.bag"));
    options.shard = Shard::parse("1/2");
    EXPECT_TRUE(walkRig("parts").isComplete);
    EXPECT_EQ(filesOf("parts"), filesOf("rig"));

    // Each camera's frames are those of a camera that walks alone.
    options = {};
    options.writesDepth = true;
    run("left", options);
    EXPECT_EQ(filesOf("rig/left"), filesOf("left"));
    EXPECT_EQ(filesOf("rig/left/depth"), filesOf("left/depth"));
    for (TimedPose& pose : path) {
        pose.roomFromCamera = pose.roomFromCamera * rightOfLeft;
    }
    run("right", options);
    EXPECT_EQ(filesOf("rig/right"), filesOf("right"));
    EXPECT_EQ(filesOf("parts/right"), filesOf("right"));
    EXPECT_NE(filesOf("left"), filesOf("right"));
}

TEST_F(WalkTest, OfARigHasNoiseOfItsOwnInEachCamera) {
    const CameraIntrinsics lens = CameraIntrinsics::pinhole(32, 24, 1);
    const std::vector<WalkCamera> cameras =
        walkCameras({{"a", "a", lens, Rigid3()}, {"b", "b", lens, Rigid3()}}, path, "rig.yaml");
    WalkOptions options;
    const render::Renderer renderer(
        std::make_shared<const render::Dataset>(render::Dataset::open(folder / "d")));
    walk(renderer, cameras, options, folder / "plain", noProgress(), {});
    EXPECT_EQ(filesOf("plain/a"), filesOf("plain/b"));
    options.sensor.emplace();
    options.sensor->noise = {2000, 5};
    walk(renderer, cameras, options, folder / "noisy", noProgress(), {});
    EXPECT_NE(filesOf("noisy/a").at("000000.png"), filesOf("noisy/b").at("000000.png"));
}

TEST_F(WalkTest, KeepsTheFramesSoFarWhenStopped) {
    std::stop_source stop;
    stop.request_stop();
    expectError(ErrorKind::Stopped, "Stopped", [&] { run(stop.get_token()); });
}

TEST_F(WalkTest, SaysWhichFolderItCannotMake) {
    writeFile(folder / "out", bytesOf("a file"));
    expectError(ErrorKind::Io, "out/walk", [&] { run(); });
}

} // namespace spherewalk::jobs
