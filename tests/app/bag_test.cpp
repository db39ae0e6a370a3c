// SPDX-License-Identifier: GPL-3.0-or-later
// Bags of walks, read by others: ROS's own library, a reader by the specification, and the format's own
// library.
#include "cli_run.h"
#include "photographed_survey.h"

#include "spherewalk/base/json.h"
#include "spherewalk/geometry/trajectory.h"
#include "spherewalk/photo/picture_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <sstream>

namespace spherewalk {

namespace fs = std::filesystem;

using test::CliResult;
using test::runCli;
using testing::HasSubstr;

namespace {

/// Of the walk's poses; the first is at 0, which is no time in ROS.
constexpr std::array<std::int64_t, 4> kStampsNs{1, 100'000'000, 250'000'000, 1'699'999'999'125'000'000};
constexpr double kFx = 120;
constexpr double kCx = 79.5;
constexpr double kCy = 59.5;
const std::vector<std::string> kPython{"/usr/bin/env", SPHEREWALK_PYTHON};

/// Runs a command to its end and returns what it printed.
std::string printed(std::vector<std::string> command, const std::vector<std::string>& more) {
    command.insert(command.end(), more.begin(), more.end());
    test::Program program(command);
    EXPECT_EQ(program.wait(), 0) << command.back() << ": " << program.errors();
    return program.output();
}

std::string script(const std::string& name) {
    return std::string(SPHEREWALK_BAG_READERS) + "/" + name;
}

std::vector<Json> lines(const std::string& output) {
    std::vector<Json> all;
    std::istringstream in(output);
    for (std::string line; std::getline(in, line);) {
        all.push_back(parseJson(line, "what a reader printed"));
    }
    return all;
}

/// Whether ROS's own check works here for a bag whose definitions have no comments, tried on one that ROS
/// wrote. That of Debian 13 fails, because Python 3.13 ended what it relies on.
bool rosCanCheck(const std::string& folder) {
    const std::string bag = folder + "/own.bag";
    std::vector<std::string> command = kPython;
    command.insert(command.end(), {script("write_rosbag.py"), bag});
    return test::Program(command).wait() == 0 &&
           test::Program({"/usr/bin/env", "rosbag", "check", bag}).wait() == 0;
}

bool hasPythonModule(const std::string& module) {
    std::vector<std::string> command = kPython;
    command.insert(command.end(), {"-c", "import " + module});
    return test::Program(command).wait() == 0;
}

Bytes decoded(const std::string& base64) {
    const auto sixBits = [](char c) {
        constexpr std::string_view kDigits =
            "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        return static_cast<std::uint32_t>(kDigits.find(c));
    };
    Bytes bytes;
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : base64) {
        if (c == '=') {
            break;
        }
        bits = bits << 6U | sixBits(c);
        count += 6;
        if (count >= 8) {
            count -= 8;
            bytes.push_back(static_cast<std::uint8_t>(bits >> static_cast<unsigned>(count)));
        }
    }
    return bytes;
}

/// A walk through a small room, turned in every direction, and its bags.
class BagTest : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        s_survey = new test::PhotographedSurvey{2};
        ASSERT_EQ(runCli({"export", s_survey->path(), *s_survey / "d"}).status, 0);
        writeFile(*s_survey / "p.tum", bytesOf("0 2 1.5 1.2 0 0 0 1\n"
                                               "0.1 2.1 1.5 1.2 0.5 -0.5 0.5 -0.5\n"
                                               "0.25 2.2 1.4 1.1 0.1 0.7 -0.1 0.7\n"
                                               "1699999999.125 2.2 1.4 1.1 -0.6 0.48 0.64 0\n"));
        ASSERT_TRUE(walked("w", {}));
        ASSERT_TRUE(walked("png", {"--bag-pictures", "png"}));
    }

    static void TearDownTestSuite() {
        delete s_survey;
        s_survey = nullptr;
    }

    static testing::AssertionResult walked(const std::string& folder, const std::vector<std::string>& more) {
        std::vector<std::string> command{"walk",     *s_survey / "d",
                                         "--camera", test::writeSmallCamera(*s_survey / "c.yaml"),
                                         "--path",   *s_survey / "p.tum",
                                         "--out",    *s_survey / folder,
                                         "--scene",  "none",
                                         "--format", "rosbag",
                                         "--format", "mcap"};
        command.insert(command.end(), more.begin(), more.end());
        const CliResult result = runCli(command);
        return result.status == 0 ? testing::AssertionSuccess()
                                  : testing::AssertionFailure() << result.errors;
    }

    static fs::path frame(std::size_t number) { return *s_survey / "w" / text("00000", number, ".png"); }

    static void expectTheWalk(const std::vector<Json>& messages, bool isRos1);

    static test::PhotographedSurvey* s_survey;
};

test::PhotographedSurvey* BagTest::s_survey = nullptr;

std::vector<Json> ofTopic(const std::vector<Json>& messages, const std::string& topic,
                          const std::string& type) {
    std::vector<Json> found;
    for (const Json& one : messages) {
        if (one["topic"] == topic) {
            EXPECT_EQ(one["type"], type);
            found.push_back(one);
        }
    }
    return found;
}

std::int64_t stampNs(const Json& header) {
    const Json& stamp = header["stamp"];
    const Json& nanoseconds = stamp.contains("nsec") ? stamp["nsec"] : stamp["nanosec"];
    return stamp["sec"].get<std::int64_t>() * 1'000'000'000 + nanoseconds.get<std::int64_t>();
}

Rigid3 poseOf(const Json& place, const Json& turn) {
    return {Eigen::Quaterniond(turn["w"], turn["x"], turn["y"], turn["z"]),
            Eigen::Vector3d(place["x"], place["y"], place["z"])};
}

void expectSame(const Rigid3& a, const Rigid3& b) {
    EXPECT_EQ(a.translation, b.translation);
    EXPECT_EQ(a.rotation.coeffs(), b.rotation.coeffs());
}

/// By how much the picture's colours are not those of the directions that it sees by the message's own camera
/// and pose: the root of the mean square, of 255. Colours are compared with each other, so that grey patches
/// do not count.
double colourError(const Bytes& rgb, const Json& k, const Rigid3& roomFromCamera) {
    double sum = 0;
    for (int v = 0; v < 120; ++v) {
        for (int u = 0; u < 160; ++u) {
            const Eigen::Vector3d inCamera((u - k[2].get<double>()) / k[0].get<double>(),
                                           (v - k[5].get<double>()) / k[4].get<double>(), 1);
            const Eigen::Vector3d expected = 60 * (roomFromCamera.rotation * inCamera.normalized());
            const std::size_t at = 3 * static_cast<std::size_t>(160 * v + u);
            const Eigen::Vector3d seen(rgb[at], rgb[at + 1], rgb[at + 2]);
            sum += ((seen.array() - seen.mean()) - (expected.array() - expected.mean())).square().mean();
        }
    }
    return std::sqrt(sum / (160.0 * 120));
}

void BagTest::expectTheWalk(const std::vector<Json>& messages, bool isRos1) {
    const std::string msg = isRos1 ? "/" : "/msg/";
    const auto images = ofTopic(messages, "/camera/image_raw", "sensor_msgs" + msg + "Image");
    const auto cameras = ofTopic(messages, "/camera/camera_info", "sensor_msgs" + msg + "CameraInfo");
    const auto poses = ofTopic(messages, "/camera/pose", "geometry_msgs" + msg + "PoseStamped");
    const auto transforms = ofTopic(messages, "/tf", "tf2_msgs" + msg + "TFMessage");
    const std::vector<TimedPose> path = readTum(*s_survey / "p.tum");
    ASSERT_EQ(images.size(), path.size());
    ASSERT_EQ(cameras.size(), path.size());
    ASSERT_EQ(poses.size(), path.size());
    ASSERT_EQ(transforms.size(), path.size());
    ASSERT_EQ(messages.size(), 4 * path.size());
    for (std::size_t i = 0; i < path.size(); ++i) {
        SCOPED_TRACE(i);
        const std::int64_t timeNs = kStampsNs[i];
        const Json image = images[i]["message"];
        const Json camera = cameras[i]["message"];
        const Json pose = poses[i]["message"];
        const Json transform = transforms[i]["message"]["transforms"][0];
        for (const Json* header :
             {&image["header"], &camera["header"], &pose["header"], &transform["header"]}) {
            EXPECT_EQ(stampNs(*header), timeNs);
        }
        for (const auto* all : {&images, &cameras, &poses, &transforms}) {
            EXPECT_EQ((*all)[i]["time_ns"], timeNs);
        }
        EXPECT_EQ(image["header"]["frame_id"], "camera_optical");
        EXPECT_EQ(camera["header"]["frame_id"], "camera_optical");
        EXPECT_EQ(pose["header"]["frame_id"], "map");
        EXPECT_EQ(transform["header"]["frame_id"], "map");
        EXPECT_EQ(transform["child_frame_id"], "camera_optical");
        const Json k = camera[isRos1 ? "K" : "k"];
        EXPECT_EQ(k, Json({kFx, 0.0, kCx, 0.0, kFx, kCy, 0.0, 0.0, 1.0}));
        EXPECT_EQ(camera[isRos1 ? "P" : "p"],
                  Json({kFx, 0.0, kCx, 0.0, 0.0, kFx, kCy, 0.0, 0.0, 0.0, 1.0, 0.0}));
        EXPECT_EQ(camera[isRos1 ? "R" : "r"], Json({1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}));
        EXPECT_EQ(camera[isRos1 ? "D" : "d"], Json({0.0, 0.0, 0.0, 0.0, 0.0}));
        EXPECT_EQ(camera["distortion_model"], "plumb_bob");
        EXPECT_EQ(camera["width"], 160);
        EXPECT_EQ(camera["height"], 120);
        EXPECT_EQ(image["encoding"], "rgb8");
        EXPECT_EQ(image["step"], 480);
        const RgbImage expected = photo::readPicture(frame(i));
        const Bytes pixels = decoded(image["data"]);
        EXPECT_TRUE(
            std::equal(pixels.begin(), pixels.end(), expected.values().begin(), expected.values().end()));
        const Rigid3 told = poseOf(pose["pose"]["position"], pose["pose"]["orientation"]);
        expectSame(told, path[i].roomFromCamera);
        expectSame(poseOf(transform["transform"]["translation"], transform["transform"]["rotation"]), told);
        EXPECT_LT(colourError(pixels, k, told), 3) << "frames or axes are not what the pixels show";
    }
}

} // namespace

TEST_F(BagTest, RosReadsTheBagByItself) {
    if (!hasPythonModule("rosbag")) {
        GTEST_SKIP() << "python3-rosbag is not installed";
    }
    const std::string bag = *s_survey / "w/walk.bag";
    expectTheWalk(lines(printed(kPython, {script("read_rosbag.py"), bag})), true);
    EXPECT_THAT(printed({"/usr/bin/env", "rosbag", "info"}, {bag}), HasSubstr("messages:    16"));
    if (!rosCanCheck(s_survey->path())) {
        GTEST_SKIP() << "rosbag cannot check a bag that it wrote itself; all else was read";
    }
    printed({"/usr/bin/env", "rosbag", "check"}, {bag});
}

TEST_F(BagTest, McapIsAsItsSpecificationSays) {
    expectTheWalk(lines(printed(kPython, {script("read_mcap.py"), *s_survey / "w/walk.mcap"})), false);
}

TEST_F(BagTest, McapsOwnLibraryReadsIt) {
#ifndef SPHEREWALK_NPM
    GTEST_SKIP() << "there is no npm";
#else
    const test::TemporaryFolder modules;
    fs::copy(script("npm"), modules.path(), fs::copy_options::recursive);
    test::Program install({SPHEREWALK_NPM, "ci", "--prefix", modules.path(), "--no-audit", "--no-fund"});
    if (install.wait() != 0) {
        GTEST_SKIP() << "npm could not fetch the library: " << install.errors();
    }
    expectTheWalk(
        lines(printed({SPHEREWALK_NODE, modules.path() / "read_mcap.mjs"}, {*s_survey / "w/walk.mcap"})),
        false);
#endif
}

TEST_F(BagTest, HoldsThePicturesAsPngWhereAsked) {
    const auto messages = lines(printed(kPython, {script("read_mcap.py"), *s_survey / "png/walk.mcap"}));
    const auto images = ofTopic(messages, "/camera/image_raw/compressed", "sensor_msgs/msg/CompressedImage");
    ASSERT_EQ(images.size(), 4U);
    for (std::size_t i = 0; i < images.size(); ++i) {
        EXPECT_EQ(decoded(images[i]["message"]["data"]), readFile(frame(i)));
        EXPECT_EQ(images[i]["message"]["format"], "rgb8; png compressed bgr8");
    }
    if (hasPythonModule("rosbag") && rosCanCheck(s_survey->path())) {
        printed({"/usr/bin/env", "rosbag", "check"}, {*s_survey / "png/walk.bag"});
    }
}

TEST_F(BagTest, IsReadInChunksOfAboutAMegabyte) {
    writeFile(*s_survey / "vga.yaml",
              bytesOf("image_width: 640\nimage_height: 480\n"
                      "camera_matrix: {data: [480, 0, 319.5, 0, 480, 239.5, 0, 0, 1]}\n"));
    ASSERT_EQ(
        runCli({"walk", *s_survey / "d", "--camera", *s_survey / "vga.yaml", "--path", *s_survey / "p.tum",
                "--out", *s_survey / "vga", "--format", "rosbag", "--format", "mcap"})
            .status,
        0);
    const auto messages = lines(printed(kPython, {script("read_mcap.py"), *s_survey / "vga/walk.mcap"}));
    const auto images = ofTopic(messages, "/camera/image_raw", "sensor_msgs/msg/Image");
    ASSERT_EQ(images.size(), 4U);
    for (std::size_t i = 0; i < images.size(); ++i) {
        const RgbImage expected = photo::readPicture(*s_survey / "vga" / text("00000", i, ".png"));
        const Bytes pixels = decoded(images[i]["message"]["data"]);
        ASSERT_EQ(pixels.size(), expected.values().size());
        EXPECT_TRUE(std::equal(pixels.begin(), pixels.end(), expected.values().begin()));
    }
    if (hasPythonModule("rosbag")) {
        const std::string info = printed({"/usr/bin/env", "rosbag", "info"}, {*s_survey / "vga/walk.bag"});
        EXPECT_THAT(info, HasSubstr("messages:    16"));
        EXPECT_THAT(info, HasSubstr("[2/2 chunks]"));
        EXPECT_EQ(lines(printed(kPython, {script("read_rosbag.py"), *s_survey / "vga/walk.bag"})).size(),
                  16U);
    }
}

TEST_F(BagTest, IsTheSameInEveryRun) {
    ASSERT_TRUE(walked("again", {}));
    EXPECT_EQ(readFile(*s_survey / "w/walk.bag"), readFile(*s_survey / "again/walk.bag"));
    EXPECT_EQ(readFile(*s_survey / "w/walk.mcap"), readFile(*s_survey / "again/walk.mcap"));
}

TEST_F(BagTest, RefusesTimesThatRosDoesNotHaveBeforeItRenders) {
    writeFile(*s_survey / "early.tum", bytesOf("-1 2 1.5 1.2 0 0 0 1\n"));
    const CliResult refused =
        runCli({"walk", *s_survey / "d", "--camera", *s_survey / "c.yaml", "--path", *s_survey / "early.tum",
                "--out", *s_survey / "early", "--format", "mcap"});
    EXPECT_EQ(refused.status, 1);
    EXPECT_THAT(refused.errors, HasSubstr("ROS cannot tell the time -1 s"));
    EXPECT_FALSE(fs::exists(*s_survey / "early"));
}

} // namespace spherewalk
