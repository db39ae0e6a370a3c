// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "random.h"
#include "temporary_folder.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jobs/export_dataset.h"
#include "spherewalk/jobs/import_photos.h"
#include "spherewalk/jobs/solution_findings.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/photo/position_tag.h"
#include "spherewalk/render/dataset.h"
#include "spherewalk/store/survey_store.h"

#include <cmath>

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

    ImportReport import(store::SurveyStore& store, const std::string& lines, bool move = false) {
        writeFile(folder / "p.csv", bytesOf("file,x_m,y_m,z_m,qw,qx,qy,qz\n" + lines));
        return importPhotos(store, {folder / "in", folder / "p.csv", 0.05, move}, noProgress(), {});
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

/// Whether the alignment knows how the lenses of a camera stand that has them in one place.
class WithLenses : public ImportExportTest, public testing::WithParamInterface<bool> {};

// What all photos may be turned and moved by together is no photo's own, and lowers no view's trust.
TEST_P(WithLenses, ADatasetHasWhatEachPhotoErrsAmongTheOthers) {
    const bool isKnown = GetParam();
    auto store = newSurvey();
    import(store, "a.JPG,1,1,1.2,1,0,0,0\nb.JPG,2,1.5,1.3,1,0,0,0\n");
    store::NewSolution solution;
    solution.source = "align";
    solution.model = "position";
    Json photos = Json::array();
    for (const store::PhotoRecord& photo : store.photos()) {
        store::SolvedPhoto solved;
        solved.photo = photo.id;
        solved.positionM = photo.positionM;
        solved.sigmaYawRad = solved.sigmaPitchRad = solved.sigmaRollRad = 0.01;
        solved.sigmaPositionM = 0.003;
        solution.photos.push_back(solved);
        const bool isFirst = photos.empty();
        photos.push_back({{"photo", photo.id},
                          {"status", "good"},
                          {"flags", Json::array()},
                          {"lens_ahead_m", isFirst ? 0.0 : 0.011},
                          {"lens_ahead_sigma_m", isKnown ? Json(0.0001) : Json()},
                          {"sigma_own", isFirst ? Json{{"turn_deg", 0.1}, {"position_m", 0.0002}} : Json()}});
    }
    solution.report = Json{{"cycle_error_deg", 0.267}, {"photos", photos}}.dump();
    store.addSolution(solution, true);
    exportDataset(store, folder / "d", {}, noProgress(), {});
    const render::DatasetInfo info = render::Dataset::open(folder / "d").info();
    ASSERT_EQ(info.photos.size(), 2U);
    for (const render::DatasetPhoto& photo : info.photos) {
        const bool isFirst = photo.roomFromPhoto.translation.x() < 1.5;
        EXPECT_NEAR(photo.positionSigmaM.value().x(), isFirst ? 0.0002 : 0.003, 1e-9);
        EXPECT_EQ(photo.lenses.aheadM, isFirst ? 0 : 0.011);
        // Pairs that disagree by 0.1 degrees about each axis count, too, unless it is known that the photos
        // have one centre.
        const double turnRad = isFirst ? Radians(Degrees(std::hypot(0.1, isKnown ? 0 : 0.1))).value() : 0.01;
        for (const Radians sigma : {photo.rotationSigma.value().yaw, photo.rotationSigma.value().pitch,
                                    photo.rotationSigma.value().roll}) {
            EXPECT_NEAR(sigma.value(), turnRad, 1e-9);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(ImportExportTest, WithLenses, testing::Bool());

TEST_F(ImportExportTest, NamesPhotosWhoseTurnTheAlignmentDoesNotKnow) {
    auto store = newSurvey();
    import(store, "a.JPG,1,1,1.2,1,0,0,0\nb.JPG,2,1.5,1.3,1,0,0,0\n");
    store::NewSolution solution;
    solution.source = "align";
    for (const store::PhotoRecord& photo : store.photos()) {
        store::SolvedPhoto solved;
        solved.photo = photo.id;
        solved.positionM = photo.positionM;
        if (photo.fileName == "a.JPG") {
            solved.sigmaYawRad = solved.sigmaPitchRad = solved.sigmaRollRad = 0.01;
        }
        solution.photos.push_back(solved);
    }
    solution.report = Json{{"photos", Json::array()}}.dump();
    store.addSolution(solution, true);
    const std::vector<std::string> doubts = photosToExport(store).doubts;
    ASSERT_EQ(doubts.size(), 1U);
    EXPECT_TRUE(doubts[0].starts_with("How 1 photo is turned is not known: b.JPG. Look")) << doubts[0];
}

TEST_F(ImportExportTest, NamesTheLineWhosePhotoCannotBeUsedAndTakesTheOthers) {
    auto store = newSurvey();
    const ImportReport report = import(store, "absent.JPG,1,2,1,,,,\na.JPG,1,1,1,,,,\n");
    EXPECT_EQ(report.imported, 1);
    ASSERT_EQ(report.refused.size(), 1U);
    EXPECT_EQ(report.refused[0].file, "absent.JPG");
    EXPECT_NE(report.refused[0].sentence.find("line 2 of"), std::string::npos) << report.refused[0].sentence;
    EXPECT_EQ(store.photos().size(), 1U);
    const std::size_t stations = store.stations().size();
    const Bytes whole = readFile(folder / "in/b.JPG");
    writeFile(folder / "in/b.JPG", ByteView(whole).first(whole.size() / 2));
    expectError(ErrorKind::Corrupt, "b.JPG", [&] { import(store, "b.JPG,0.9,0.9,1,,,,\n"); });
    EXPECT_EQ(store.photos().size(), 1U);
    EXPECT_EQ(store.stations().size(), stations); // none is left for a photo that was refused
    EXPECT_TRUE(store.check(noProgress(), {}).isSound());
}

TEST_F(ImportExportTest, ARotationThatIsImportedLeavesTheOthersKnown) {
    auto store = newSurvey();
    import(store, "a.JPG,1,1,1.2,0,0,0,1\nb.JPG,2,1,1.2,0,0,0,1\n");
    import(store, "c.JPG,3,1,1.2,1,0,0,0\nb.JPG,2,1,1.2,0,1,0,0\n");
    const auto solved = store.solvedPhotos(store.activeSolution()->id);
    ASSERT_EQ(solved.size(), 3U);
    EXPECT_EQ(solved[0].roomFromPhoto.z(), 1); // a: taken over
    EXPECT_EQ(solved[1].roomFromPhoto.x(), 1); // b: given anew
    EXPECT_EQ(exportDataset(store, folder / "d", {}, noProgress(), {}).withoutRotation, 0);
}

TEST_F(ImportExportTest, ARotationThatIsImportedKeepsWhatTheAlignmentSaid) {
    auto store = newSurvey();
    writeFile(folder / "in/d.JPG", jpeg::encode(noise(), 90));
    import(store, "a.JPG,1,1,1.2,,,,\nb.JPG,2,1,1.2,,,,\nc.JPG,1,2,1.2,,,,\n");
    store::NewSolution solution;
    solution.source = "align";
    solution.model = "position";
    Json photos = Json::array();
    for (const store::PhotoRecord& photo : store.photos()) {
        const bool isFailed = photo.fileName == "b.JPG";
        photos.push_back({{"photo", photo.id},
                          {"status", isFailed ? "failed" : "good"},
                          {"flags", Json::array()},
                          {"lens_ahead_m", 0.011}});
        store::SolvedPhoto solved;
        solved.photo = photo.id;
        solved.positionM = photo.positionM;
        if (photo.fileName == "a.JPG") {
            solved.sigmaYawRad = solved.sigmaPitchRad = solved.sigmaRollRad = 0.01;
        }
        if (!isFailed) {
            solution.photos.push_back(solved);
        }
    }
    solution.report = Json{{"photos", photos}, {"tag_warnings", {"The scale is wrong."}}}.dump();
    store.addSolution(solution, true);
    for (const bool isGivenToo : {false, true}) { // b, in a second import
        import(store, isGivenToo ? "b.JPG,2,1,1.2,0,0,0,1\n" : "d.JPG,2,2,1.2,0,0,0,1\n");
        const PhotosToExport made = photosToExport(store);
        EXPECT_EQ(made.failed.size(), isGivenToo ? 0U : 1U);
        ASSERT_EQ(made.doubts.size(), isGivenToo ? 2U : 3U);
        EXPECT_EQ(made.doubts[0], "The scale is wrong.");
        EXPECT_TRUE(made.doubts[1].starts_with("How 1 photo is turned is not known: c.JPG"))
            << made.doubts[1];
    }
    exportDataset(store, folder / "d", {}, noProgress(), {});
    const render::DatasetInfo info = render::Dataset::open(folder / "d").info();
    ASSERT_EQ(info.photos.size(), 4U);
    for (const render::DatasetPhoto& photo : info.photos) {
        const bool isGiven = photo.file == "photos/b.jpg" || photo.file == "photos/d.jpg";
        EXPECT_EQ(photo.rotationSource, isGiven ? "imported" : "aligned") << photo.file;
        EXPECT_EQ(photo.lenses.aheadM, isGiven ? 0 : 0.011) << photo.file;
        EXPECT_EQ(std::abs(photo.roomFromPhoto.rotation.z()), isGiven ? 1 : 0) << photo.file;
        EXPECT_EQ(photo.rotationSigma.has_value(), photo.file == "photos/a.jpg");
    }
}

TEST_F(ImportExportTest, ACorrectedPlaceIsRefusedUnlessItIsAMove) {
    auto store = newSurvey();
    import(store, "a.JPG,1,1,1.2,1,0,0,0\nb.JPG,2,1,1.2,1,0,0,0\n");
    const ImportReport refused = import(store, "a.JPG,1.2,1,1.2,1,0,0,0\nb.JPG,2,1,1.2,1,0,0,0\n");
    ASSERT_EQ(refused.refused.size(), 1U);
    EXPECT_NE(refused.refused[0].sentence.find("0.200 m from the place in the file. Give --move"),
              std::string::npos)
        << refused.refused[0].sentence;
    EXPECT_EQ(refused.alreadyThere, 1);
    const store::PhotoRecord before = store.findPhoto(sha256Hex(readFile(folder / "in/a.JPG"))).value();
    EXPECT_EQ(before.positionM.x(), 1);

    EXPECT_EQ(import(store, "a.JPG,1.2,1,1.2,0,0,0,1\nb.JPG,2,1,1.2,,,,\n", true).moved, 1);
    const store::PhotoRecord after = store.photo(before.id);
    const Eigen::Vector3d place(1.2, 1, 1.2);
    EXPECT_EQ(after.positionM, place);
    const fs::path file = store.photoFolder() / after.fileName;
    const photo::PositionTag tag = photo::readPositionTag(readFile(file), file.string()).value();
    EXPECT_EQ(tag.positionM, place);
    EXPECT_EQ(tag.stationName, store.station(after.station).name);
    const auto solved = store.solvedPhotos(store.activeSolution()->id);
    ASSERT_EQ(solved.size(), 2U);
    EXPECT_EQ(solved[0].positionM, place);
    EXPECT_TRUE(store.check(noProgress(), {}).isSound());
}

TEST_F(ImportExportTest, PhotosThatShareAPlaceOrTheirBytesAreBothNamed) {
    auto store = newSurvey();
    fs::copy_file(folder / "in/a.JPG", folder / "in/twin.JPG");
    const ImportReport report = import(store, "a.JPG,1,1,1.2,,,,\nb.JPG,1,1,1.2,,,,\ntwin.JPG,1,1,1.2,,,,\n");
    EXPECT_EQ(report.imported, 2);
    ASSERT_EQ(report.notes.size(), 2U);
    EXPECT_EQ(report.notes[0].find("b.JPG (line 3) and a.JPG are both at"), 0U) << report.notes[0];
    EXPECT_EQ(report.notes[1], "twin.JPG has the same bytes as a.JPG in line 2: they are one photo.");
    for (const bool move : {false, true}) {
        const ImportReport apart = import(store, "a.JPG,1,1,1.2,,,,\ntwin.JPG,2,1,1.2,,,,\n", move);
        ASSERT_EQ(apart.refused.size(), 1U);
        EXPECT_NE(apart.refused[0].sentence.find("cannot be at two places"), std::string::npos);
    }
    EXPECT_EQ(store.photos().size(), 2U);
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
