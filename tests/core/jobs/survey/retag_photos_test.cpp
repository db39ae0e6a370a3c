// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "photographed_survey.h"
#include "warnings.h"

#include "spherewalk/jobs/export_dataset.h"
#include "spherewalk/jobs/solution_findings.h"
#include "spherewalk/photo/position_tag.h"
#include "spherewalk/render/dataset.h"
#include "spherewalk/store/survey_store.h"

#include <algorithm>

namespace spherewalk::jobs {

namespace fs = std::filesystem;
using test::expectError;

namespace {

class RetagPhotos : public testing::Test {
  protected:
    photo::PositionTag tagOf(std::int64_t photo) const {
        const fs::path file = store.photoFolder() / store.photo(photo).fileName;
        return photo::readPositionTag(readFile(file), file.string()).value();
    }

    std::vector<PhotoPlace> retag(const std::vector<PhotoPlace>& places) {
        return retagPhotos(store, places, noProgress(), {});
    }

    test::PhotographedSurvey survey{3};
    store::SurveyStore store = survey.open(store::Access::Write);
    std::vector<store::StationRecord> stations = store.stations();
    std::int64_t a = store.chosenPhoto(stations[0].id)->id;
    std::int64_t b = store.chosenPhoto(stations[1].id)->id;
};

} // namespace

TEST_F(RetagPhotos, SwapPlacesInTheSurveyAndInTheFiles) {
    retag({{a, stations[1].id}, {b, stations[0].id}});
    EXPECT_EQ(store.chosenPhoto(stations[0].id)->id, b);
    EXPECT_EQ(store.chosenPhoto(stations[1].id)->id, a);
    EXPECT_EQ(store.photo(a).positionM, stations[1].station.positionM);
    EXPECT_EQ(tagOf(a).stationName, stations[1].name);
    EXPECT_EQ(tagOf(a).positionM, stations[1].station.positionM);
    EXPECT_TRUE(tagOf(a).roomFromPhoto.has_value());
    EXPECT_TRUE(store.check(noProgress(), {}).isSound());
    EXPECT_TRUE(store.check(noProgress(), {}).filesWithoutPhoto.empty());
}

TEST_F(RetagPhotos, TakesMovedPhotosOutOfTheAlignmentAndSaysSo) {
    test::Warnings warnings;
    retagPhotos(store, {{a, stations[1].id}, {b, stations[0].id}}, warnings, {});
    ASSERT_EQ(warnings.sentences.size(), 1U);
    EXPECT_EQ(warnings.sentences[0].find("2 photos have left the alignment"), 0U) << warnings.sentences[0];
    const auto solved = store.solvedPhotos(store.activeSolution()->id);
    ASSERT_EQ(solved.size(), 1U); // the third photo was not moved
    const auto exported = exportDataset(store, survey / "d", {}, noProgress(), {});
    EXPECT_EQ(exported.withoutRotation, 2);
    const render::Dataset dataset = render::Dataset::open(survey / "d");
    for (const render::DatasetPhoto& photo : dataset.info().photos) {
        const auto station = std::ranges::find(stations, photo.station, &store::StationRecord::name);
        ASSERT_NE(station, stations.end());
        EXPECT_LT((photo.roomFromPhoto.translation - station->station.positionM).norm(), 1e-3);
    }
    retagPhotos(store, {{a, stations[1].id}}, warnings, {}); // where it is already
    EXPECT_EQ(warnings.sentences.size(), 1U);
}

TEST_F(RetagPhotos, KeepTheAlignmentOfAPhotoThatItFoundAtItsNewPlace) {
    store::NewSolution solution{"align", "position", "{}", {}};
    for (const std::int64_t photo : {a, b}) {
        solution.photos.emplace_back().photo = photo;
        solution.photos.back().positionM = stations[1].station.positionM + Eigen::Vector3d(0.008, 0, 0);
    }
    store.addSolution(solution, true);
    retag({{a, stations[1].id}, {b, stations[0].id}});
    const auto solved = store.solvedPhotos(store.activeSolution()->id);
    ASSERT_EQ(solved.size(), 1U);
    EXPECT_EQ(solved[0].photo, a);
}

TEST_F(RetagPhotos, IsUndoneByWhatItReturns) {
    const store::PhotoRecord before = store.photo(a);
    const store::PhotoRecord there = store.photo(b);
    const std::vector<PhotoPlace> undo = retag({{a, stations[1].id}});
    EXPECT_FALSE(store.chosenPhoto(stations[0].id).has_value());
    EXPECT_EQ(store.chosenPhoto(stations[1].id)->id, a);
    retag(undo);
    EXPECT_EQ(store.photo(a).station, before.station);
    EXPECT_EQ(store.photo(a).positionM, before.positionM);
    EXPECT_EQ(store.photo(a).fileSha256, before.fileSha256);
    EXPECT_EQ(store.photo(a).fileName, before.fileName);
    EXPECT_TRUE(store.photo(b).choose);
    EXPECT_EQ(store.photo(b).fileSha256, there.fileSha256);
}

TEST_F(RetagPhotos, ChangesNothingIfItCannotDoAll) {
    survey.leaveUnchecked();
    const std::string name = store.photo(a).fileName;
    fs::resize_file(store.photoFolder() / store.photo(b).fileName, 10);
    expectError(ErrorKind::Corrupt, store.photo(b).fileName, [&] {
        retag({{a, stations[1].id}, {b, stations[0].id}});
    });
    EXPECT_EQ(store.photo(a).station, stations[0].id);
    EXPECT_EQ(store.photo(a).fileName, name);
    EXPECT_TRUE(store.check(noProgress(), {}).filesWithoutPhoto.empty());
}

TEST_F(RetagPhotos, RefuseAPhotoThatIsNamedTwice) {
    expectError(ErrorKind::InvalidInput, "cannot be at two stations", [&] {
        retag({{a, stations[1].id}, {a, stations[2].id}});
    });
}

TEST_F(RetagPhotos, StopWithNothingChanged) {
    std::stop_source stop;
    stop.request_stop();
    expectError(ErrorKind::Stopped, "", [&] {
        retagPhotos(store, {{a, stations[1].id}}, noProgress(), stop.get_token());
    });
    EXPECT_EQ(store.photo(a).station, stations[0].id);
}

} // namespace spherewalk::jobs
