// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "random.h"
#include "temporary_folder.h"

#include "spherewalk/base/file.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jobs/export_dataset.h"
#include "spherewalk/jobs/import_photos.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/photo/position_tag.h"
#include "spherewalk/render/dataset.h"
#include "spherewalk/store/survey_store.h"

namespace spherewalk::jobs {

namespace fs = std::filesystem;
using test::expectError;
using test::TemporaryFolder;

namespace {

class ImportExportTest : public testing::Test {
  protected:
    ImportExportTest() {
        fs::create_directories(folder / "in");
        for (const char* name : {"a.JPG", "b.JPG", "c.JPG"}) {
            writeFile(folder / "in" / name, jpeg::encode(noise(), 90));
        }
        room.outline = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
        room.ceilingM = 2.5;
        options.stepM = 1;
    }

    RgbImage noise() {
        RgbImage picture(512, 256);
        for (std::uint8_t& value : picture.values()) {
            value = static_cast<std::uint8_t>(random.integer(0, 255));
        }
        return picture;
    }

    store::SurveyStore newSurvey() {
        return store::SurveyStore::create(folder / "s.spherewalk", "s", room, options,
                                          survey::plan(room, options));
    }

    ImportReport import(store::SurveyStore& store, const std::string& lines) {
        writeFile(folder / "p.csv", bytesOf("file,x_m,y_m,z_m,qw,qx,qy,qz\n" + lines));
        return importPhotos(store, {folder / "in", folder / "p.csv"}, noProgress(), {});
    }

    TemporaryFolder folder;
    test::Random random{51};
    survey::Room room;
    survey::PlanOptions options;
};

} // namespace

TEST_F(ImportExportTest, PhotosComeOutWithTheirPlacesRotationsAndEveryPixel) {
    auto store = newSurvey();
    const ImportReport report = import(store, "a.JPG,1,1,1.2,0.5,0.5,-0.5,0.5\nb.JPG,2,1.5,1.3,1,0,0,0\n");
    EXPECT_EQ(report.imported, 2);
    EXPECT_EQ(report.withRotation, 2);
    const ExportReport exported = exportDataset(store, folder / "d", {}, noProgress(), {});
    EXPECT_EQ(exported.withoutRotation, 0);
    const auto dataset = render::Dataset::open(folder / "d", render::Verify::Hashes);
    ASSERT_EQ(dataset.info().photos.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
        const render::DatasetPhoto& photo = dataset.info().photos[i];
        const bool isA = photo.file == "photos/a.jpg";
        const Eigen::Quaterniond q =
            isA ? Eigen::Quaterniond(0.5, 0.5, -0.5, 0.5) : Eigen::Quaterniond::Identity();
        EXPECT_LT(angleBetween(photo.roomFromPhoto.rotation, q).value(), 1e-12);
        EXPECT_EQ(photo.roomFromPhoto.translation,
                  isA ? Eigen::Vector3d(1, 1, 1.2) : Eigen::Vector3d(2, 1.5, 1.3));
        EXPECT_EQ(photo.rotationSource, "imported");
        const fs::path source = folder / "in" / (isA ? "a.JPG" : "b.JPG");
        const Bytes written = dataset.readPhoto(i);
        EXPECT_EQ(jpeg::decode(written, "x"), jpeg::decode(readFile(source), "x"));
        const auto tag = photo::readPositionTag(written, "x");
        ASSERT_TRUE(tag);
        EXPECT_EQ(tag->surveyId, store.info().uuid);
        EXPECT_EQ(tag->positionM, photo.roomFromPhoto.translation);
    }
    EXPECT_GT(dataset.info().sphereRadiusM.value_or(0), 0.8);
    EXPECT_LT(dataset.info().sphereRadiusM.value_or(9), 2.5);
}

TEST_F(ImportExportTest, PhotosNearAPlannedStationBelongToIt) {
    auto store = newSurvey();
    const Eigen::Vector3d planned = store.stations().front().station.positionM;
    const std::string near = std::to_string(planned.x() + 0.03) + "," + std::to_string(planned.y()) + "," +
                             std::to_string(planned.z());
    const ImportReport report = import(store, "a.JPG," + near + ",,,,\nb.JPG,0.01,0.01,1,,,,\n");
    EXPECT_EQ(report.newStations, 1);
    EXPECT_EQ(store.chosenPhoto(store.stations().front().id)->cameraFileName, "a.JPG");
    EXPECT_EQ(store.stations().back().station.placement, -1);
}

TEST_F(ImportExportTest, ASecondImportAddsNothingTwiceAndMayBringRotations) {
    auto store = newSurvey();
    import(store, "a.JPG,1,1,1.2,,,,\n");
    EXPECT_FALSE(store.activeSolution());
    const ImportReport again = import(store, "a.JPG,1,1,1.2,0,0,0,1\nc.JPG,3,1,1.2,1,0,0,0\n");
    EXPECT_EQ(again.alreadyThere, 1);
    EXPECT_EQ(again.imported, 1);
    EXPECT_EQ(store.photos().size(), 2U);
    EXPECT_EQ(store.solvedPhotos(store.activeSolution()->id).size(), 2U);
}

TEST_F(ImportExportTest, ExportSaysWhatHasNoRotation) {
    auto store = newSurvey();
    import(store, "a.JPG,1,1,1.2,,,,\n");
    const ExportReport report = exportDataset(store, folder / "d", {}, noProgress(), {});
    EXPECT_EQ(report.withoutRotation, 1);
    EXPECT_NE(render::Dataset::open(folder / "d").info().photos[0].rotationSource, "imported");
}

TEST_F(ImportExportTest, NamesTheLineWhosePhotoCannotBeUsedAndKeepsTheOnesBefore) {
    auto store = newSurvey();
    expectError(ErrorKind::NotFound, "line 3 of",
                [&] { import(store, "a.JPG,1,1,1,,,,\nabsent.JPG,1,1,1,,,,\n"); });
    EXPECT_EQ(store.photos().size(), 1U);
    const Bytes whole = readFile(folder / "in/b.JPG");
    writeFile(folder / "in/b.JPG", ByteView(whole).first(whole.size() / 2));
    expectError(ErrorKind::Corrupt, "b.JPG", [&] { import(store, "b.JPG,1,1,1,,,,\n"); });
    EXPECT_EQ(store.photos().size(), 1U);
    EXPECT_TRUE(store.check(noProgress(), {}).isSound());
}

TEST_F(ImportExportTest, AnEmptySurveyHasNothingToExport) {
    const auto store = newSurvey();
    expectError(ErrorKind::InvalidInput, "no station has a photo",
                [&] { exportDataset(store, folder / "d", {}, noProgress(), {}); });
}

TEST_F(ImportExportTest, ExportsTheDrawnRoomWherePhotosShowNone) {
    store::SurveyStore store = newSurvey();
    import(store, "a.JPG,1,1,1.2,1,0,0,0\nb.JPG,2,1,1.2,1,0,0,0\nc.JPG,1,2,1.2,1,0,0,0\n");
    ExportOptions wanted;
    wanted.scene = render::SceneKind::Room;
    wanted.depth.sweep.width = 64;
    wanted.depth.sweep.coarseWidth = 64;
    const ExportReport report = exportDataset(store, folder / "d", wanted, noProgress(), {});
    ASSERT_TRUE(report.roomShape);
    EXPECT_EQ(report.roomShape->outline, room.outline);
    EXPECT_EQ(report.roomShape->floorM, 0);
    EXPECT_EQ(report.roomShape->ceilingM, 2.5);
    EXPECT_EQ(render::Dataset::open(folder / "d").info().roomShape, report.roomShape);
}

} // namespace spherewalk::jobs
