// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli_run.h"
#include "temporary_folder.h"

#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/photo/picture_file.h"
#include "spherewalk/practice/practice_options.h"
#include "spherewalk/practice/practice_room.h"

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace spherewalk {

using test::CliResult;
using test::runCli;
using testing::HasSubstr;

namespace {

constexpr int kWidth = 2048;
constexpr double kTagM = 0.16;

/// Photos of a room with tags on two days, taken by hand, and a robot's picture. They are drawn once.
class TaggedRoom {
  public:
    static const TaggedRoom& drawn() {
        static const TaggedRoom kDrawn;
        return kDrawn;
    }

    std::string path(const std::string& name) const { return (m_folder / name).string(); }

    std::map<std::string, Rigid3> truth; ///< Of photos and of pictures, by file name.
    std::vector<practice::PracticeTag> tags;

  private:
    TaggedRoom() {
        practice::PracticeRoomOptions options;
        options.sizeM = {4.2, 3.6, 2.5};
        const practice::PracticeRoom bare(options);
        options.tags = practice::tagsOnWalls(bare, 5, kTagM);
        tags = options.tags;
        const practice::PracticeRoom room(options);
        drawDay(room, "one", 11, {1.3, 1.1, 1.2});
        drawDay(room, "two", 12, {1.45, 1.35, 1.2});
        drawRobot(room);
    }

    void drawDay(const practice::PracticeRoom& room, const std::string& day, std::uint64_t seed,
                 const Eigen::Vector3d& first) {
        practice::PhotoErrors errors;
        errors.seed = seed;
        std::filesystem::create_directories(m_folder / day);
        for (int i = 0; i < 9; ++i) {
            const std::string name = text(day, i, ".jpg");
            const Eigen::Vector3d nominal = first + Eigen::Vector3d(0.6 * (i % 3), 0.55 * (i / 3), 0);
            truth[name] = errors.truePose(nominal, i + 1);
            writeFile(m_folder / day / name,
                      jpeg::encode(room.spherical(truth[name], {kWidth, kWidth / 2}), 95));
        }
    }

    void drawRobot(const practice::PracticeRoom& room) {
        writeFile(m_folder / "robot.yaml",
                  bytesOf("image_width: 640\nimage_height: 480\n"
                          "camera_matrix: {data: [520, 0, 319.5, 0, 520, 239.5, 0, 0, 1]}\n"));
        const CameraModel camera(CameraIntrinsics{640, 480, 520, 520, 319.5, 239.5, {}, {}});
        const practice::PracticeTag& tag = tags.at(2);
        const Radians out(tag.facing.value() + 0.6);
        const Eigen::Vector3d eye =
            tag.centreM + 2 * Eigen::Vector3d(std::cos(out.value()), std::sin(out.value()), -0.1);
        truth["robot.png"] = {
            (rotation({Radians(out.value() + std::numbers::pi + 0.1), Degrees(2), Degrees(-1)}) *
             bodyFromOptical())
                .normalized(),
            eye};
        photo::writePng(m_folder / "robot.png", room.view(camera, truth["robot.png"]));
        writeFile(m_folder / "robot.csv", bytesOf("file\nrobot.png\n"));
    }

    test::TemporaryFolder m_folder;
};

/// Imports and aligns a day's photos.
Json aligned(const std::string& day, const std::vector<std::string>& more) {
    const TaggedRoom& room = TaggedRoom::drawn();
    const std::string survey = room.path(day + ".spherewalk");
    if (!std::filesystem::exists(survey)) {
        EXPECT_EQ(runCli({"new", survey, "--rect", "0,0,4.2,3.6", "--ceiling", "2.5"}).status, 0);
        EXPECT_EQ(runCli({"import", survey, "--photos", room.path(day)}).status, 0);
    }
    std::vector<std::string> arguments{"align",  survey,       "--positions", "free",
                                       "--json", "--tag-size", text(kTagM)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const CliResult result = runCli(arguments);
    EXPECT_EQ(result.status, 0) << result.errors;
    return result.json();
}

const Json& dayOne() {
    static const Json kAligned = aligned("one", {});
    return kAligned;
}

Eigen::Vector3d vectorOf(const Json& json) {
    return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()};
}

Eigen::Quaterniond quaternionOf(const Json& q) {
    return {q["w"].get<double>(), q["x"].get<double>(), q["y"].get<double>(), q["z"].get<double>()};
}

std::string cameraNameOf(const Json& photo) {
    const std::string file = photo["file"];
    return file.substr(0, file.find_first_of("-_.")) + ".jpg";
}

/// The solved places of a report's photos, beside the true ones.
std::pair<Eigen::Matrix3Xd, Eigen::Matrix3Xd> placesOf(const Json& report) {
    const Json& photos = report["photos"];
    Eigen::Matrix3Xd solved(3, photos.size());
    Eigen::Matrix3Xd truth(3, photos.size());
    for (std::size_t i = 0; i < photos.size(); ++i) {
        const auto column = static_cast<Eigen::Index>(i);
        solved.col(column) = vectorOf(photos[i]["position_m"]);
        truth.col(column) = TaggedRoom::drawn().truth.at(cameraNameOf(photos[i])).translation;
    }
    return {solved, truth};
}

/// The frame of day one from the true room: rigid, by day one's photos.
Rigid3 frameOfDayOne() {
    const auto [solved, truth] = placesOf(dayOne());
    const Eigen::Matrix4d motion = Eigen::umeyama(truth, solved, false);
    return {Eigen::Quaterniond(Eigen::Matrix3d(motion.topLeftCorner<3, 3>())), motion.topRightCorner<3, 1>()};
}

void expectTrueScaleAndTags() {
    const Json& report = dayOne();
    EXPECT_EQ(report["places"]["scale_by"], "tags");
    EXPECT_LT(report["places"]["scale_sigma"], 0.003);
    const auto [solved, truth] = placesOf(report);
    const Eigen::Matrix4d motion = Eigen::umeyama(truth, solved, true);
    const double scale = std::cbrt(motion.topLeftCorner<3, 3>().determinant());
    EXPECT_NEAR(scale, 1, 0.003);
    EXPECT_GE(report["april_tags"].size(), 3U);
    const Rigid3 frame = frameOfDayOne();
    for (const Json& tag : report["april_tags"]) {
        const auto corners = TaggedRoom::drawn().tags.at(tag["number"]).cornersM();
        for (std::size_t i = 0; i < corners.size(); ++i) {
            EXPECT_LT((vectorOf(tag["corners_m"][i]) - frame * corners[i]).norm(), 0.005) << tag["number"];
        }
    }
}

void expectJoinedDays() {
    const Json two = aligned("two", {"--tags-of", TaggedRoom::drawn().path("one.spherewalk")});
    EXPECT_THAT(std::string(two["reason"]), HasSubstr("AprilTags of the other survey give frame and scale"));
    const Rigid3 frame = frameOfDayOne();
    const auto [solved, truth] = placesOf(two);
    double squares = 0;
    for (Eigen::Index i = 0; i < solved.cols(); ++i) {
        squares += (solved.col(i) - frame * Eigen::Vector3d(truth.col(i))).squaredNorm();
    }
    EXPECT_LT(std::sqrt(squares / static_cast<double>(solved.cols())), 0.005);
}

void expectRegisteredPicture() {
    const TaggedRoom& room = TaggedRoom::drawn();
    ASSERT_EQ(runCli({"export", room.path("one.spherewalk"), room.path("d"), "--scene", "sphere"}).status, 0);
    const Json dataset = parseJson(readTextFile(room.path("d/dataset.json"), 1 << 20), "the dataset");
    EXPECT_EQ(dataset["april_tags"].size(), dayOne()["april_tags"].size());
    const CliResult result = runCli({"compare", room.path("d"), "--camera", room.path("robot.yaml"),
                                     "--pictures", room.path("robot.csv"), "--json"});
    ASSERT_EQ(result.status, 0) << result.errors;
    const Json registered = result.json()["registered"][0];
    ASSERT_TRUE(registered["why"].is_null()) << registered["why"];
    const Rigid3 truth = frameOfDayOne() * room.truth.at("robot.png");
    const Json& pose = registered["pose"];
    EXPECT_LT((vectorOf(pose["position_m"]) - truth.translation).norm(), 0.01);
    EXPECT_LT(Degrees(angleBetween(quaternionOf(pose["room_from_camera"]), truth.rotation)).value(), 0.3);
}

/// A picture without a tag cannot be registered.
void expectRefusedPicture() {
    const TaggedRoom& room = TaggedRoom::drawn();
    const std::string wall = room.path("wall.png");
    photo::writePng(wall, RgbImage(640, 480));
    writeFile(room.path("wall.csv"), bytesOf("file\nwall.png\n"));
    const CliResult result = runCli({"compare", room.path("d"), "--camera", room.path("robot.yaml"),
                                     "--pictures", room.path("wall.csv")});
    EXPECT_EQ(result.status, 1);
    EXPECT_THAT(result.errors, HasSubstr("shows no AprilTag"));
}

} // namespace

// One test, since each would have to draw and align the photos anew.
TEST(AprilTags, GiveScaleJoinDaysAndRegisterTheRobotsPicture) {
    expectTrueScaleAndTags();
    expectJoinedDays();
    expectRegisteredPicture();
    expectRefusedPicture();
}

TEST(AprilTags, ArePrintedByPlan) {
    const test::TemporaryFolder folder;
    const std::string survey = (folder / "s.spherewalk").string();
    ASSERT_EQ(runCli({"new", survey, "--rect", "0,0,4,3", "--ceiling", "2.5"}).status, 0);
    const CliResult result = runCli({"plan", survey, "--tags", "3", "--first-tag", "10"});
    EXPECT_EQ(result.status, 0) << result.errors;
    EXPECT_THAT(result.output, HasSubstr("AprilTags 10 to 12"));
    EXPECT_GT(std::filesystem::file_size(folder / "s.spherewalk" / "tags.pdf"), 1000U);
    const CliResult tooMany = runCli({"plan", survey, "--tags", "3", "--first-tag", "585"});
    EXPECT_EQ(tooMany.status, 1);
    EXPECT_THAT(tooMany.errors, HasSubstr("0 to 586"));
}

TEST(AprilTags, OfASurveyThatSawNoneJoinNothing) {
    const test::TemporaryFolder folder;
    const std::string survey = (folder / "s.spherewalk").string();
    ASSERT_EQ(runCli({"new", survey, "--rect", "0,0,4,3", "--ceiling", "2.5"}).status, 0);
    const CliResult result =
        runCli({"align", survey, "--positions", "free", "--tag-size", "0.16", "--tags-of", survey});
    EXPECT_EQ(result.status, 1);
    EXPECT_THAT(result.errors, HasSubstr("knows no AprilTags"));
    EXPECT_EQ(runCli({"align", survey, "--tags-of", survey}).status, 2);
}

} // namespace spherewalk
