// SPDX-License-Identifier: GPL-3.0-or-later
#include "photographed_survey.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/base/json.h"
#include "spherewalk/jobs/check_places.h"
#include "spherewalk/jobs/export_dataset.h"
#include "spherewalk/jobs/solution_findings.h"
#include "spherewalk/photo/position_tag.h"
#include "spherewalk/render/dataset.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace spherewalk::jobs {

namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class CheckPlaces : public testing::Test {
  protected:
    std::vector<std::string> check() const { return checkPlaces(store, noProgress(), {}); }

    std::vector<std::string> checkDataset() const {
        return checkPlaces(render::Dataset::open(survey / "d"), noProgress(), {});
    }

    test::PhotographedSurvey survey{3};
    store::SurveyStore store = survey.open(store::Access::Write);
    std::vector<store::StationRecord> stations = store.stations();
    store::PhotoRecord first = store.chosenPhoto(stations[0].id).value();
};

} // namespace

TEST_F(CheckPlaces, FindNothingAfterImportRetagAndExport) {
    EXPECT_THAT(check(), IsEmpty());
    retagPhotos(store, {{first.id, stations[1].id}}, noProgress(), {});
    EXPECT_THAT(check(), IsEmpty());
    exportDataset(store, survey / "d", {}, noProgress(), {});
    EXPECT_THAT(checkDataset(), IsEmpty());
}

TEST_F(CheckPlaces, NameAPhotoWhoseTagSaysAnotherPlaceThanTheSurvey) {
    store::MovedPhoto moved{first.id,
                            stations[1].id,
                            stations[1].station.positionM,
                            first.fileName,
                            first.fileSha256,
                            first.sizeBytes,
                            true};
    survey.leaveUnchecked();
    store.movePhotos({moved}); // without a new tag
    EXPECT_THAT(check(), ElementsAre(AllOf(HasSubstr(first.fileName), HasSubstr(stations[0].name),
                                           HasSubstr(stations[1].name))));
}

TEST_F(CheckPlaces, NameAPhotoThatTheSolutionPutsAtAnotherStation) {
    survey.leaveUnchecked();
    store::NewSolution solution;
    solution.source = "align";
    solution.model = "position";
    solution.photos.resize(1);
    solution.photos[0].photo = first.id;
    solution.photos[0].positionM = stations[1].station.positionM;
    store.addSolution(solution, true);
    EXPECT_THAT(check(),
                ElementsAre(AllOf(HasSubstr("nearer to another station"), HasSubstr(first.fileName))));
    const double offM = (stations[1].station.positionM - first.positionM).norm();
    solution.report = Json{{"position_sigma_m", offM / 3}}.dump(); // The tags may be as wrong as that.
    store.addSolution(solution, true);
    EXPECT_THAT(check(), IsEmpty());
    solution.report = Json{{"position_sigma_m", offM / 5}}.dump();
    store.addSolution(solution, true);
    EXPECT_THAT(check(), ElementsAre(HasSubstr("nearer to another station")));
}

TEST_F(CheckPlaces, NameAPhotoOfADatasetThatWasMovedByHand) {
    survey.leaveUnchecked();
    exportDataset(store, survey / "d", {}, noProgress(), {});
    const fs::path description = survey / "d" / std::string(render::kDatasetFile);
    Json json = parseJson(readTextFile(description), "dataset");
    std::swap(json["photos"][0]["station"], json["photos"][1]["station"]);
    writeFile(description, bytesOf(json.dump(1)));
    EXPECT_EQ(checkDataset().size(), 2U);
}

} // namespace spherewalk::jobs
