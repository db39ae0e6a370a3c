// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "hand_held_photos.h"
#include "temporary_folder.h"

#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/polygon.h"
#include "spherewalk/jobs/align_survey.h"
#include "spherewalk/jobs/check_places.h"
#include "spherewalk/jobs/export_dataset.h"
#include "spherewalk/jobs/import_photos.h"
#include "spherewalk/jobs/solution_findings.h"
#include "spherewalk/photo/position_tag.h"
#include "spherewalk/render/dataset.h"
#include "spherewalk/store/survey_store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace spherewalk::jobs {

using test::expectError;
using testing::HasSubstr;
using testing::StartsWith;

namespace {

/// Photos of the practice room, taken by hand. Nobody wrote down where.
class FreeSurvey : public testing::Test {
  protected:
    store::SurveyStore imported() {
        survey::Room outline;
        outline.outline = {{0, 0}, {5, 0}, {5, 4}, {0, 4}};
        outline.ceilingM = 2.6;
        auto store = store::SurveyStore::create(m_folder / "s.spherewalk", "s", outline, {}, {});
        report = importPhotos(store, {m_folder / "in", {}}, noProgress(), {});
        return store;
    }

    test::TemporaryFolder m_folder;
    std::vector<Rigid3> truth = test::writeHandHeldPhotos(m_folder / "in");
    ImportReport report;
};

} // namespace

TEST_F(FreeSurvey, PhotosWithoutPositionsGetStationsWhosePlaceIsNotKnown) {
    const store::SurveyStore store = imported();
    EXPECT_EQ(report.imported, 6);
    EXPECT_EQ(report.unknownPlaces, 6);
    for (const store::PhotoRecord& photo : store.photos()) {
        const store::StationRecord station = store.station(photo.station);
        EXPECT_THAT(station.name, StartsWith("unknown place of H"));
        EXPECT_EQ(priorOf(store, photo, station, 0.01, noProgress()).name, photo.fileName); // Not twice.
        EXPECT_FALSE(store.station(photo.station).isPlaceKnown);
        EXPECT_FALSE(photo::readPositionTag(readFile(store.photoFolder() / photo.fileName), photo.fileName));
    }
    EXPECT_TRUE(photosToExport(store).photos.empty());
    EXPECT_TRUE(checkPlaces(store, noProgress(), {}).empty());
}

TEST_F(FreeSurvey, ASecondImportAddsNothing) {
    store::SurveyStore store = imported();
    const ImportReport again = importPhotos(store, {m_folder / "in", {}}, noProgress(), {});
    EXPECT_EQ(again.imported, 0);
    EXPECT_EQ(again.alreadyThere, 6);
    EXPECT_EQ(store.stations().size(), 6U);
}

TEST_F(FreeSurvey, APlainAlignmentRefusesUnknownPlaces) {
    store::SurveyStore store = imported();
    expectError(ErrorKind::InvalidInput, "--positions free",
                [&] { alignSurvey(store, {}, noProgress(), {}); });
}

TEST_F(FreeSurvey, AnEmptyFolderIsRefused) {
    store::SurveyStore store = imported();
    std::filesystem::create_directories(m_folder / "nothing");
    expectError(ErrorKind::NotFound, "There is no JPEG", [&] {
        importPhotos(store, {m_folder / "nothing", {}}, noProgress(), {});
    });
}

TEST_F(FreeSurvey, PlacesAreSolvedAndTheStationsMoveThere) {
    store::SurveyStore store = imported();
    AlignOptions options;
    options.isFree = true;
    options.distance = {"H0.jpg", "H5.jpg", (truth[0].translation - truth[5].translation).norm()};
    const AlignReport aligned = alignSurvey(store, options, noProgress(), {});
    EXPECT_EQ(aligned.effort, align::Effort::Fine);
    for (const AlignedPhoto& photo : aligned.photos) {
        ASSERT_TRUE(photo.pose.isSolved) << photo.pose.why;
        const store::StationRecord station = store.station(store.photo(photo.photo).station);
        EXPECT_EQ(station.station.positionM, photo.pose.roomFromPhoto.translation);
        EXPECT_THAT(station.name, StartsWith("place of H"));
        EXPECT_TRUE(station.isPlaceKnown);
        const std::filesystem::path file = store.photoFolder() / photo.file;
        const auto tag = photo::readPositionTag(readFile(file), photo.file);
        ASSERT_TRUE(tag) << photo.file;
        EXPECT_EQ(tag->stationName, station.name);
    }
    for (std::size_t i = 1; i < truth.size(); ++i) {
        const double solvedM = (aligned.photos[i].pose.roomFromPhoto.translation -
                                aligned.photos[0].pose.roomFromPhoto.translation)
                                   .norm();
        EXPECT_NEAR(solvedM, (truth[i].translation - truth[0].translation).norm(), 0.01);
    }
    const survey::Room room = store.room(); // the one that the photos show
    EXPECT_NEAR(room.ceilingM, 2.6, 0.05);  // no lower than it was given
    for (const store::StationRecord& station : store.stations()) {
        EXPECT_TRUE(contains(room.outline, station.station.positionM.head<2>())) << station.name;
    }
    EXPECT_NE(room.outline, (Polygon{{0, 0}, {5, 0}, {5, 4}, {0, 4}}));
    EXPECT_EQ(store.stations().size(), 6U);
    EXPECT_EQ(store.solvedPhotos(aligned.solution).size(), 6U);
    EXPECT_EQ(photosToExport(store).photos.size(), 6U);
    EXPECT_TRUE(checkPlaces(store, noProgress(), {}).empty());
    refuseUnknownPlaces(store); // throws nothing: it is a survey like any other now
}

TEST_F(FreeSurvey, AHeightOfTheLensThatNobodySaidIsAGuess) {
    survey::PlanOptions plan;
    plan.areHeightsGuessed = true;
    auto store = store::SurveyStore::create(m_folder / "g.spherewalk", "g", survey::unknownRoom(), plan, {});
    importPhotos(store, {m_folder / "in", {}}, noProgress(), {});
    AlignOptions options;
    options.isFree = true;
    const AlignReport guessed = alignSurvey(store, options, noProgress(), {});
    EXPECT_EQ(guessed.scaleSigma, 0.25);
    EXPECT_THAT(alignText(guessed), HasSubstr("A guessed height of the lens over the solved floor, 1.20 m"));
    EXPECT_THAT(photosToExport(store).doubts, testing::Contains(StartsWith("Nobody said how high the lens")));
    exportDataset(store, m_folder / "d", {}, noProgress(), {});
    EXPECT_EQ(render::Dataset::open(m_folder / "d").info().scaleSigma, 0.25);
    EXPECT_TRUE(store.planOptions().areHeightsGuessed);

    options.lensHeightM = 1.5;
    const AlignReport known = alignSurvey(store, options, noProgress(), {});
    EXPECT_LT(known.scaleSigma, 0.02);
    EXPECT_THAT(photosToExport(store).doubts, testing::IsEmpty());
    options.lensHeightM = 0; // The survey has kept it.
    const AlignReport again = alignSurvey(store, options, noProgress(), {});
    EXPECT_EQ(again.scaleSigma, known.scaleSigma);
    EXPECT_THAT(alignText(again), HasSubstr("1.50 m"));
    EXPECT_EQ(activeFindings(store)->scaleSigma, known.scaleSigma);
}

TEST(FreePlacesOfNoPhoto, HaveNoScaleToSpeakOf) {
    align::FreePlaces places;
    places.photos.resize(2);
    places.photos[0].roomFromPhoto = places.photos[1].roomFromPhoto = Rigid3{};
    places.warnings = {"The scale is not known."};
    AlignReport report;
    report.photos.resize(2);
    report.alignment.photos.resize(2);
    const std::vector<align::PhotoPrior> priors(2);
    takePlaces(places, priors, report);
    EXPECT_THAT(report.alignment.warnings, testing::IsEmpty());
    report.alignment.photos[1].isSolved = true;
    takePlaces(places, priors, report);
    EXPECT_THAT(report.alignment.warnings, testing::ElementsAre("The scale is not known."));
}

TEST_F(FreeSurvey, AHeightThatPhotosWereImportedWithIsNoGuess) {
    survey::PlanOptions plan;
    plan.areHeightsGuessed = true;
    auto store = store::SurveyStore::create(m_folder / "h.spherewalk", "h", survey::unknownRoom(), plan, {});
    EXPECT_TRUE(freeOptions(store, {}, {}).isLensHeightGuessed);
    writeFile(m_folder / "positions.csv",
              bytesOf(std::string("file,x_m,y_m,z_m\nH0.jpg,1,1,1.4\nH1.jpg,2,1,1.4\n")));
    importPhotos(store, {m_folder / "in", m_folder / "positions.csv"}, noProgress(), {});
    const align::FreeOptions options = freeOptions(store, {}, {});
    EXPECT_EQ(options.lensHeightM, 1.4);
    EXPECT_FALSE(options.isLensHeightGuessed);
}

TEST_F(FreeSurvey, ASecondAlignmentKeepsTheFrameAndTheRoomThatSomebodyDrew) {
    store::SurveyStore store = imported();
    AlignOptions options;
    options.isFree = true;
    options.effort = align::Effort::Normal;
    alignSurvey(store, options, noProgress(), {});
    // As if the room had been measured in a frame of its own.
    const Eigen::Isometry2d drawn = Eigen::Translation2d(7, -3) * Eigen::Rotation2Dd(0.6);
    std::vector<PhotoPlace> moved;
    std::vector<store::PlacedStation> places;
    for (const store::PhotoRecord& photo : store.photos()) {
        Eigen::Vector3d positionM = photo.positionM;
        positionM.head<2>() = drawn * positionM.head<2>();
        moved.push_back({photo.id, photo.station, positionM, true});
        places.push_back({photo.station, positionM, {}, true});
    }
    moved.front().positionM->x() += 2; // one is wrong
    store.placeStations(places);
    retagPhotos(store, moved, noProgress(), {});
    survey::Room room = store.room();
    room.outline = {{0, -10}, {14, -10}, {14, 4}, {0, 4}};
    store.replaceRoom(room, store::RoomOrigin::Drawn);
    const AlignReport again = alignSurvey(store, options, noProgress(), {});
    EXPECT_EQ(again.fromCache, 6) << "other tags make no other pictures";
    EXPECT_EQ(store.room().outline, room.outline);
    for (std::size_t i = 0; i < places.size(); ++i) {
        EXPECT_LT((store.station(places[i].station).station.positionM - places[i].positionM).norm(), 0.005)
            << i;
    }
    EXPECT_EQ(store.stations().size(), 6U);
}

} // namespace spherewalk::jobs
