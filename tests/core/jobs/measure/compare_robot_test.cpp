// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "flat_room.h"
#include "random.h"
#include "temporary_folder.h"

#include "spherewalk/base/bytes.h"
#include "spherewalk/base/json.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jobs/compare_robot.h"
#include "spherewalk/jobs/measured_dataset.h"
#include "spherewalk/photo/picture_file.h"
#include "spherewalk/render/renderer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace spherewalk::jobs {

namespace {

using test::FlatRoom;

/// The robot's picture, its true pose, and a dataset to compare it with.
class CompareRobot : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        s_folder = std::make_unique<test::TemporaryFolder>();
        FlatRoom::write(*s_folder / "d");
    }

    static void TearDownTestSuite() { s_folder.reset(); }

    static render::Renderer renderer() {
        return render::Renderer(
            std::make_shared<const render::Dataset>(render::Dataset::open(*s_folder / "d")));
    }

    static CompareReport compare(const CompareOptions& options) {
        return compareRobot(renderer(), FlatRoom::camera(), options, noProgress(), {});
    }

    static RobotPicture truePicture() { return {FlatRoom::data() / "view_03.png", {}, FlatRoom::view3()}; }

    /// The picture with its colours changed.
    template <class Change>
    static RobotPicture changedPicture(const std::string& name, const Change& change) {
        RgbImage picture = photo::readPicture(truePicture().file);
        for (std::size_t i = 0; i < picture.values().size(); i += 3) {
            change(picture.values().data() + i);
        }
        photo::writePng(*s_folder / name, picture);
        return {*s_folder / name, {}, FlatRoom::view3()};
    }

    static CompareReport fitColour(const RobotPicture& picture) {
        CompareOptions options;
        options.pictures = {picture};
        options.fitsColour = true;
        return compare(options);
    }

    static std::unique_ptr<test::TemporaryFolder> s_folder;
};

std::unique_ptr<test::TemporaryFolder> CompareRobot::s_folder;

/// What a camera with another white balance, other filters and a gamma of its own makes of a pixel.
void cast(std::uint8_t* rgb, test::Random& random) {
    const Eigen::Vector3d light = Eigen::Vector3d(rgb[0], rgb[1], rgb[2]) / 255;
    Eigen::Matrix3d mix;
    mix << 0.72, 0.1, 0, 0.04, 0.85, 0.05, 0, 0.08, 0.98;
    const Eigen::Vector3d mixed = mix * light;
    for (int c = 0; c < 3; ++c) {
        const double level = 255 * std::pow(std::clamp(mixed[c], 0.0, 1.0), 1.25) + random.uniform(-0.5, 0.5);
        rgb[c] = static_cast<std::uint8_t>(std::lround(std::clamp(level, 0.0, 255.0)));
    }
}

} // namespace

TEST_F(CompareRobot, FindsThePoseThatAPictureWasTakenFrom) {
    test::Random random(31);
    CompareOptions options;
    for (int i = 0; i < 2; ++i) {
        options.pictures.push_back(truePicture());
        options.pictures.back().roomFromCamera =
            FlatRoom::view3() *
            Rigid3{Eigen::Quaterniond(Eigen::AngleAxisd(Radians(Degrees(3)).value(), random.direction())),
                   0.06 * random.direction()};
    }
    options.refinesPoses = true;
    const CompareReport report = compare(options);
    EXPECT_EQ(report.refined, 2U);
    for (const ComparedPicture& picture : report.pictures) {
        ASSERT_TRUE(picture.refined->isFitted) << picture.refined->why;
        EXPECT_LT((picture.used().translation - FlatRoom::view3().translation).norm(), 0.004);
        EXPECT_LT(angleBetween(picture.used().rotation, FlatRoom::view3().rotation), Radians(Degrees(0.12)));
        EXPECT_LT(picture.after.medianPx.value(), 0.5);
        EXPECT_GT(picture.before.medianPx.value(), 5);
        EXPECT_GT(picture.after.looks.psnrDb, picture.before.looks.psnrDb + 5);
    }
}

TEST_F(CompareRobot, SaysWhatPeopleSeeBesideDisplacement) {
    CompareOptions options;
    options.pictures = {truePicture(), truePicture()};
    options.pictures[1].roomFromCamera.translation.x() += 0.03; // so the view is wrong there
    const CompareReport report = compare(options);
    const Looks& right = report.pictures[0].before.looks;
    const Looks& wrong = report.pictures[1].before.looks;
    EXPECT_GT(right.ssim, wrong.ssim + 0.05);
    EXPECT_LT(right.falseEdges, wrong.falseEdges);
    EXPECT_LT(right.missedEdges, wrong.missedEdges);
    EXPECT_DOUBLE_EQ(report.before.looks.mean.ssim, (right.ssim + wrong.ssim) / 2);
    EXPECT_FALSE(report.pictures[0].steadiness);
    ASSERT_TRUE(report.pictures[1].steadiness);
    EXPECT_NEAR(report.pictures[1].steadiness->medianPx.value(), report.pictures[1].before.medianPx.value(),
                2)
        << "the second view jumps by its whole displacement";
    EXPECT_GT(report.steadyMedianPx.value(), 2);
    const Json json = toJson(report);
    EXPECT_EQ(json["pictures"][0]["before"]["ssim"], right.ssim);
    EXPECT_EQ(json["before"]["false_edges"], report.before.looks.mean.falseEdges);
    EXPECT_THAT(compareText(report), testing::HasSubstr("displacements change by"));
}

TEST_F(CompareRobot, SeesNoChangeWhereNothingMoves) {
    CompareOptions options;
    options.pictures = {truePicture(), truePicture()};
    EXPECT_EQ(compare(options).steadyMedianPx, 0);
}

TEST_F(CompareRobot, SaysWhyAPoseCannotBeRefined) {
    CompareOptions options;
    options.pictures = {
        changedPicture("blank.png", [](std::uint8_t* rgb) { std::fill_n(rgb, 3, std::uint8_t{90}); })};
    options.refinesPoses = true;
    const CompareReport report = compare(options);
    EXPECT_EQ(report.refined, 0U);
    EXPECT_EQ(report.pictures[0].used().translation, FlatRoom::view3().translation);
    EXPECT_THAT(compareText(report),
                testing::HasSubstr("blank.png keeps the pose that was given: Only 0 of 0"));
}

TEST_F(CompareRobot, NeedsASceneModelWithDepthToRefineAPose) {
    CompareOptions options;
    options.pictures = {truePicture()};
    options.refinesPoses = true;
    options.view.scene = render::SceneKind::None;
    EXPECT_THAT(compare(options).pictures[0].refined->why, testing::HasSubstr("--scene depth"));
}

TEST_F(CompareRobot, CorrectsACastAndAGammaToHalfMoreThanWithoutThem) {
    CompareOptions plain;
    plain.pictures = {truePicture()};
    const double uncast = compare(plain).pictures[0].before.colourError.value();
    test::Random random(32);
    const CompareReport report =
        fitColour(changedPicture("cast.png", [&](std::uint8_t* rgb) { cast(rgb, random); }));
    ASSERT_TRUE(report.fit && report.fit->correction) << (report.fit ? report.fit->why : "");
    EXPECT_GT(report.before.colourError.value(), 10 * uncast);
    EXPECT_LT(report.after.colourError.value(), 1.5 * uncast);
    RecordProperty("uncast", std::to_string(uncast));
    RecordProperty("after", std::to_string(report.after.colourError.value()));
}

TEST_F(CompareRobot, RefusesTheGreyPicturesOfAGreyCamera) {
    const CompareReport report = fitColour(changedPicture("grey.png", [](std::uint8_t* rgb) {
        std::fill_n(rgb, 3, static_cast<std::uint8_t>((rgb[0] + 2 * rgb[1] + rgb[2]) / 4));
    }));
    EXPECT_FALSE(report.colour);
    EXPECT_THAT(report.fit->why, testing::HasSubstr("only grey"));
}

TEST_F(CompareRobot, RefusesPicturesOfASingleColour) {
    const CompareReport report = fitColour(changedPicture("single.png", [](std::uint8_t* rgb) {
        rgb[0] = 180;
        rgb[1] = 90;
        rgb[2] = 60;
    }));
    EXPECT_FALSE(report.colour);
    EXPECT_THAT(report.fit->why, testing::HasSubstr("only one colour"));
}

TEST_F(CompareRobot, ViewsAreCorrectedOnceTheCorrectionIsStored) {
    const test::TemporaryFolder folder;
    FlatRoom::write(folder / "d");
    Json json = parseJson(readTextFile(folder / "d/dataset.json"), "x");
    json["of_a_later_version"] = 7;
    writeFile(folder / "d/dataset.json", bytesOf(json.dump()));
    render::ColourCorrection darker;
    darker.matrix *= 0.5;
    storeColour(folder / "d", darker);
    EXPECT_EQ(parseJson(readTextFile(folder / "d/dataset.json"), "x")["of_a_later_version"], 7);
    const auto dataset = std::make_shared<const render::Dataset>(render::Dataset::open(folder / "d"));
    EXPECT_EQ(dataset->info().colour, darker);
    CompareOptions options;
    options.pictures = {truePicture()};
    const CompareReport report =
        compareRobot(render::Renderer(dataset), FlatRoom::camera(), options, noProgress(), {});
    EXPECT_GT(report.after.colourError.value(), report.before.colourError.value() + 10);
}

TEST_F(CompareRobot, WritesAPageWithPicturesAndPosesThatCanBeReadAgain) {
    const test::TemporaryFolder folder;
    std::filesystem::copy_file(FlatRoom::data() / "view_03.png", folder / "a, \"b\".png");
    CompareOptions options;
    options.pictures = {{folder / "a, \"b\".png", {}, FlatRoom::view3()}};
    options.shown = 1;
    const CompareReport report = compare(options);
    writeComparison(report, folder / "report");
    writePoses(report, folder / "poses.csv");
    EXPECT_THAT(readTextFile(folder / "report/report.html"), testing::HasSubstr("<img src=\"report-1.jpg\""));
    EXPECT_TRUE(std::filesystem::exists(folder / "report/report-1.jpg"));
    EXPECT_EQ(parseJson(readTextFile(folder / "report/report.json"), "x")["pictures"].size(), 1U);
    const std::vector<RobotPicture> read = readRobotPictures(folder / "poses.csv");
    ASSERT_EQ(read.size(), 1U);
    EXPECT_TRUE(std::filesystem::equivalent(read[0].file, options.pictures[0].file));
    EXPECT_EQ(read[0].roomFromCamera.translation, FlatRoom::view3().translation);
}

TEST_F(CompareRobot, RefusesPicturesOfAnotherSizeAndNone) {
    CompareOptions options;
    test::expectError(ErrorKind::InvalidInput, "no robot's pictures", [&] { compare(options); });
    photo::writePng(*s_folder / "small.png", RgbImage(64, 48));
    options.pictures = {{*s_folder / "small.png", {}, FlatRoom::view3()}};
    test::expectError(ErrorKind::InvalidInput, "64 x 48", [&] { compare(options); });
}

TEST_F(CompareRobot, StopsWhenAsked) {
    CompareOptions options;
    options.pictures = {truePicture()};
    std::stop_source source;
    source.request_stop();
    test::expectError(ErrorKind::Stopped, "", [&] {
        compareRobot(renderer(), FlatRoom::camera(), options, noProgress(), source.get_token());
    });
}

} // namespace spherewalk::jobs
