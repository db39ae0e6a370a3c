// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "temporary_folder.h"

#include "spherewalk/base/file.h"
#include "spherewalk/jobs/measure_page.h"
#include "spherewalk/jobs/measure_report.h"
#include "spherewalk/render/dataset_format.h"

#include <gtest/gtest.h>

namespace spherewalk::jobs {

using render::SceneKind;

namespace {

class MeasuredPhotosTest : public testing::Test {
  protected:
    MeasuredPhotosTest() {
        info.surveyId = "of the survey";
        info.name = "room";
        for (const char* file : {"photos/a.jpg", "photos/b.jpg", "photos/c.jpg"}) {
            info.photos.emplace_back().file = file;
            info.photos.back().roomFromPhoto.translation.x() = static_cast<double>(info.photos.size());
        }
        report.photos = 3;
        report.focalPx = 500;
        report.directions = 4;
        report.scenes.resize(2);
        report.scenes[1].scene = SceneKind::Sphere;
        report.scenes[0].photos = {{0, 30, 9}, {2, 20, 9}};
        report.scenes[1].photos = {{0, 3, 9}, {1, {}, 0}, {2, 2.5, 9}};
        report.rungs = {{SceneKind::None, {}, 25, 1, 1}, {SceneKind::Sphere, {}, 3, 2, 1}};
        report.choice.tolerancePx = 4;
        report.choice.rung = 1;
    }

    MeasuredPhotos readBack() {
        writeReport({&info, &report, nullptr}, folder.path());
        return readMeasuredPhotos(folder / "report.json");
    }

    test::TemporaryFolder folder;
    render::DatasetInfo info;
    MeasureReport report;
};

} // namespace

TEST_F(MeasuredPhotosTest, AreThoseOfTheChosenSceneModel) {
    const MeasuredPhotos found = readBack();
    EXPECT_EQ(found.surveyId, "of the survey");
    EXPECT_EQ(found.scene, SceneKind::Sphere);
    EXPECT_EQ(found.tolerancePx, 4);
    EXPECT_EQ(found.focalPx, 500);
    ASSERT_EQ(found.photos.size(), 3U);
    EXPECT_EQ(found.photos[0].file, "photos/a.jpg");
    EXPECT_EQ(found.photos[0].p95Px, 3);
    EXPECT_EQ(found.photos[1].p95Px, std::nullopt);
    EXPECT_EQ(found.photos[2].p95Px, 2.5);
}

TEST_F(MeasuredPhotosTest, AreThoseThatWereLeftOutBesidePicturesOfARobot) {
    MeasureReport robots = report;
    robots.isLeaveOneOut = false;
    robots.scenes[1].photos.clear();
    robots.leaveOneOut = std::make_shared<MeasureReport>(report);
    report = robots;
    EXPECT_EQ(readBack().photos[0].p95Px, 3);
}

TEST_F(MeasuredPhotosTest, AreRefusedWhereNothingWasMeasured) {
    writeReport({&info, nullptr, nullptr}, folder.path());
    test::expectError(ErrorKind::InvalidInput, "single photos",
                      [&] { readMeasuredPhotos(folder / "report.json"); });
    report.choice.rung.reset();
    test::expectError(ErrorKind::InvalidInput, "single photos", [&] { readBack(); });
}

TEST_F(MeasuredPhotosTest, OfAnotherNumberOfPhotosAreCorrupt) {
    report.scenes[1].photos.push_back({3, 1, 9});
    test::expectError(ErrorKind::Corrupt, "photo", [&] { readBack(); });
    writeFile(folder / "report.json", bytesOf(std::string("{}")));
    test::expectError(ErrorKind::Corrupt, "measured", [&] { readMeasuredPhotos(folder / "report.json"); });
}

} // namespace spherewalk::jobs
