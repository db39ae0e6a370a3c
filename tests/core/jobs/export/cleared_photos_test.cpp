// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "temporary_folder.h"
#include "warnings.h"

#include "spherewalk/base/file.h"
#include "spherewalk/jobs/export_dataset.h"
#include "spherewalk/jobs/export_foreign.h"
#include "spherewalk/jobs/import_photos.h"
#include "spherewalk/jobs/measured_dataset.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/practice/practice_room.h"
#include "spherewalk/render/dataset.h"
#include "spherewalk/store/survey_store.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace spherewalk::jobs {

namespace fs = std::filesystem;

namespace {

constexpr int kColumns = 3;
constexpr int kRows = 3;

/// A robot below the lens, with four wheels.
void drawRobotBelow(RgbImage& picture) {
    for (int y = picture.height() * 155 / 180; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const bool isWheel = std::cos(8 * std::acos(-1.0) * x / picture.width()) > 0.7;
            std::fill_n(picture.at(x, y), RgbImage::kChannels, std::uint8_t(isWheel ? 20 : 120));
        }
    }
}

/// A survey of the practice room whose photos all show a robot.
class RobotSurvey : public testing::Test {
  protected:
    RobotSurvey() {
        const practice::PracticeRoom pictured;
        fs::create_directories(m_folder / "in");
        std::string lines = "file,x_m,y_m,z_m,yaw_deg\n";
        for (int i = 0; i < kColumns * kRows; ++i) {
            const Eigen::Vector3d position(1.5 + 0.5 * (i % kColumns), 1.2 + 0.5 * (i / kColumns), 1.2);
            RgbImage picture = pictured.spherical({Eigen::Quaterniond::Identity(), position}, {512, 256});
            drawRobotBelow(picture);
            const std::string name = "R" + std::to_string(i) + ".JPG";
            writeFile(m_folder / "in" / name, jpeg::encode(picture, 95));
            lines +=
                name + "," + std::to_string(position.x()) + "," + std::to_string(position.y()) + ",1.2,0\n";
        }
        writeFile(m_folder / "p.csv", bytesOf(lines));
        m_store.emplace(newSurvey("s.spherewalk", {{0, 0}, {5, 0}, {5, 4}, {0, 4}}));
        m_options.scene = render::SceneKind::Depth;
        m_options.depth.sweep.width = 64;
        m_options.depth.sweep.coarseWidth = 64;
    }

    store::SurveyStore newSurvey(const std::string& name, const Polygon& outline) const {
        survey::Room room;
        room.outline = outline;
        room.ceilingM = 2.5;
        survey::PlanOptions plan;
        plan.stepM = 0.5;
        auto store = store::SurveyStore::create(m_folder / name, "s", room, plan, survey::plan(room, plan));
        importPhotos(store, {m_folder / "in", m_folder / "p.csv", 0.05, false}, noProgress(), {});
        return store;
    }

    ExportReport exported(const std::string& name) {
        return exportDataset(*m_store, m_folder / name, m_options, noProgress(), {});
    }

    RgbImage photoIn(const std::string& dataset) const {
        return jpeg::decode(readFile(m_folder / dataset / "photos/R4.jpg"), "R4.jpg");
    }

    /// The mean brightness of the rows that show the robot.
    static double robotsShade(const RgbImage& picture) {
        double sum = 0;
        double count = 0;
        for (int y = picture.height() * 160 / 180; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                sum += std::abs(picture.at(x, y)[0] - picture.at(x, y)[2]);
                ++count;
            }
        }
        return sum / count;
    }

    test::TemporaryFolder m_folder;
    std::optional<store::SurveyStore> m_store;
    ExportOptions m_options;
};

} // namespace

TEST_F(RobotSurvey, TheDatasetShowsTheFloorInPlaceOfTheRobot) {
    const ExportReport report = exported("d");
    EXPECT_GT(report.carriedShare, 0.04);
    EXPECT_LT(report.carriedShare, 0.09);
    const RgbImage before = jpeg::decode(readFile(m_folder / "in" / "R4.JPG"), "R4.JPG");
    const RgbImage after = photoIn("d");
    EXPECT_LT(robotsShade(before), 5) << "a robot is grey";
    EXPECT_GT(robotsShade(after), 25) << "the floor is of wood";
    for (int y = 0; y < before.height() / 2; ++y) {
        ASSERT_TRUE(std::equal(before.at(0, y), before.at(0, y) + 3 * before.width(), after.at(0, y))) << y;
    }
    // The dataset is whole, and the survey keeps the photo.
    const auto dataset = render::Dataset::open(m_folder / "d", render::Verify::Hashes);
    EXPECT_EQ(dataset.info().photos.size(), 9U);
    EXPECT_EQ(jpeg::decode(readFile(m_store->photoFolder() / "R4.JPG"), "R4.JPG"), before);
}

TEST_F(RobotSurvey, ASecondExportFindsAllThatTheFirstHasMade) {
    exported("d");
    EXPECT_EQ(knownScene(*m_store, m_options.depth), render::SceneKind::Depth);
    const ExportReport second = exported("d2");
    EXPECT_EQ(second.depth.reused, second.depth.photos);
    EXPECT_EQ(photoIn("d2"), photoIn("d"));
}

TEST_F(RobotSurvey, ThePhotosStayWhereTheyShall) {
    const RgbImage before = jpeg::decode(readFile(m_folder / "in" / "R4.JPG"), "R4.JPG");
    m_options.clearsCarried = false;
    EXPECT_EQ(exported("kept").carriedShare, 0);
    EXPECT_EQ(photoIn("kept"), before);
    MeasureOptions measure;
    measure.mostViews = 2;
    measure.samplingViews = 1;
    measure.scene = render::SceneKind::Depth;
    const CameraModel camera(CameraIntrinsics::pinhole(64, 48, 1));
    exportChosen(*m_store, m_folder / "chosen", camera, measure, m_options, noProgress(), {});
    EXPECT_EQ(photoIn("chosen"), before) << "so do those of a scene model that was measured";
    m_options.clearsCarried = true;
    m_options.scene = render::SceneKind::Sphere;
    EXPECT_EQ(exported("sphere").carriedShare, 0);
    EXPECT_EQ(photoIn("sphere"), before);
}

TEST_F(RobotSurvey, AnOutlineThatThePhotosContradictIsNotTheDatasetsRoom) {
    m_options.depth.sweep.width = 256;
    const Polygon block{{1.3, 1.0}, {2.7, 1.0}, {2.7, 2.4}, {1.3, 2.4}}; // about the photos alone
    const store::SurveyStore small = newSurvey("small.spherewalk", block);
    const auto datasetOf = [&](const store::SurveyStore& store, const std::string& name) {
        test::Warnings warnings;
        exportDataset(store, m_folder / name, m_options, warnings, {});
        const bool isSaid = std::any_of(
            warnings.sentences.begin(), warnings.sentences.end(), [](const std::string& sentence) {
                return sentence.find("beyond the drawn outline") != std::string::npos;
            });
        return std::pair(render::Dataset::open(m_folder / name), isSaid);
    };
    const auto [right, isSaidOfRight] = datasetOf(*m_store, "right");
    EXPECT_FALSE(isSaidOfRight);
    EXPECT_EQ(right.info().outline, m_store->room().outline);
    const auto [corrected, isSaid] = datasetOf(small, "corrected");
    EXPECT_TRUE(isSaid);
    EXPECT_FALSE(corrected.isOutside({3.5, 3, 1.2})) << "the photos see this place";
    EXPECT_TRUE(corrected.isOutside({8, 3, 1.2}));
    EXPECT_EQ(corrected.info().outline, corrected.info().roomShape.value().outline);
}

// The room of a survey by hand stands for none: 6 x 6 m about the origin.
TEST_F(RobotSurvey, ARoomThatNobodyDrewIsFoundInThePhotosAndNothingIsSaidOfIt) {
    m_options.depth.sweep.width = 256;
    auto store =
        store::SurveyStore::create(m_folder / "hand.spherewalk", "hand", survey::unknownRoom(), {}, {});
    test::Warnings warnings;
    importPhotos(store, {m_folder / "in", m_folder / "p.csv", 0.05, false}, warnings, {});
    exportDataset(store, m_folder / "hand", m_options, warnings, {});
    for (const std::string& sentence : warnings.sentences) {
        EXPECT_EQ(sentence.find("outline"), std::string::npos) << sentence;
        EXPECT_EQ(sentence.find("drawn"), std::string::npos) << sentence;
    }
    const auto dataset = render::Dataset::open(m_folder / "hand");
    std::vector<double> xs;
    for (const Eigen::Vector2d& corner : dataset.info().outline) {
        xs.push_back(corner.x());
    }
    ASSERT_EQ(xs.size(), 4U);
    EXPECT_NEAR(*std::ranges::min_element(xs), 0, 0.3);
    EXPECT_NEAR(*std::ranges::max_element(xs), 5, 0.3);
    EXPECT_FALSE(dataset.isOutside({4.5, 3.5, 1.2}));
}

TEST_F(RobotSurvey, ASphereNeedsNoRoomAndAWorldOne) {
    writeFile(m_folder / "far.csv", bytesOf("file,x_m,y_m,z_m,yaw_deg\nR0.JPG,11.5,11.2,1.2,0\n"));
    auto store =
        store::SurveyStore::create(m_folder / "hand.spherewalk", "hand", survey::unknownRoom(), {}, {});
    importPhotos(store, {m_folder / "in", m_folder / "far.csv", 0.05, false}, noProgress(), {});
    m_options.scene = render::SceneKind::Sphere;
    exportDataset(store, m_folder / "hand", m_options, noProgress(), {});
    EXPECT_NEAR(render::Dataset::open(m_folder / "hand").info().sphereRadiusM.value_or(0), 2, 0.5);
    test::expectError(ErrorKind::NotFound, "nobody has drawn its room",
                      [&] { worldRoomOf(m_folder / "hand.spherewalk"); });
}

} // namespace spherewalk::jobs
