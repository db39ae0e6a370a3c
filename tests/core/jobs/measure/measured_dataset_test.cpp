// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "photographed_survey.h"

#include "spherewalk/base/json.h"
#include "spherewalk/jobs/measured_dataset.h"
#include "spherewalk/render/dataset.h"

#include <set>

namespace spherewalk::jobs {

using test::expectError;

namespace {

const std::string kDescription(render::kDatasetFile);

/// A dataset of three photos, and its description.
class StoredResults : public testing::Test {
  protected:
    StoredResults() { exportDataset(m_survey.open(), m_dataset, {}, noProgress(), {}); }

    Json description() const { return parseJson(readTextFile(m_dataset / kDescription), "dataset.json"); }

    void write(const Json& json) { writeFile(m_dataset / kDescription, bytesOf(json.dump())); }

    render::DatasetInfo info() const { return render::Dataset::open(m_dataset).info(); }

    /// A report that chooses the sphere, and a cheaper scene model for the second photo.
    MeasureReport report() const {
        MeasureReport report;
        report.photos = 3;
        report.focalPx = 500;
        SceneLikeness sphere;
        sphere.scene = render::SceneKind::Sphere;
        sphere.p95Px = 1.5;
        report.scenes.push_back(sphere);
        report.rungs.push_back({render::SceneKind::Sphere, render::Sampling::Footprint, 1.5, 3, 1000});
        report.choice.tolerancePx = 2;
        report.choice.rung = 0;
        report.choice.isWithin = true;
        report.choice.reason = "It is enough.";
        report.choice.photoScenes = {std::nullopt, render::SceneKind::None, std::nullopt};
        return report;
    }

    test::PhotographedSurvey m_survey{3};
    std::filesystem::path m_dataset = m_survey / "d";
};

render::ColourCorrection brighter() {
    render::ColourCorrection correction;
    correction.matrix.diagonal() << 1.1, 1.2, 1.3;
    return correction;
}

} // namespace

TEST_F(StoredResults, AreThereWhenTheDatasetIsOpenedAgain) {
    storeChoice(m_dataset, report());
    storeColour(m_dataset, brighter());
    const render::DatasetInfo now = info();
    ASSERT_TRUE(now.choice);
    EXPECT_EQ(now.choice->scene, render::SceneKind::Sphere);
    EXPECT_EQ(now.choice->tolerancePx, 2);
    EXPECT_EQ(now.choice->reason, "It is enough.");
    EXPECT_EQ(now.measuredErrorPx.at(render::SceneKind::Sphere), 1.5);
    EXPECT_EQ(now.photos.at(1).scene, render::SceneKind::None);
    EXPECT_FALSE(now.photos.at(0).scene);
    ASSERT_TRUE(now.colour);
    EXPECT_EQ(*now.colour, brighter());
}

TEST_F(StoredResults, KeepWhatTheyDoNotUnderstand) {
    Json json = description();
    json["of_a_later_version"] = {{"a", 1}, {"b", {1, 2, 3}}};
    json["photos"][0]["of_a_later_version"] = "kept";
    write(json);
    storeColour(m_dataset, brighter());
    storeChoice(m_dataset, report());
    const Json now = description();
    EXPECT_EQ(now.at("of_a_later_version"), json.at("of_a_later_version"));
    EXPECT_EQ(now.at("photos").at(0).at("of_a_later_version"), "kept");
}

TEST_F(StoredResults, ChangeNothingElse) {
    Json before = description();
    storeColour(m_dataset, brighter());
    Json now = description();
    EXPECT_FALSE(now.at("colour_correction").is_null());
    before.erase("colour_correction");
    now.erase("colour_correction");
    EXPECT_EQ(now, before);
}

TEST_F(StoredResults, TakeThePlaceOfEarlierOnes) {
    storeColour(m_dataset, brighter());
    const std::string once = readTextFile(m_dataset / kDescription);
    storeColour(m_dataset, brighter());
    EXPECT_EQ(readTextFile(m_dataset / kDescription), once);
    storeChoice(m_dataset, report());
    MeasureReport later = report();
    later.choice.reason = "Later.";
    later.choice.photoScenes.clear();
    storeChoice(m_dataset, later);
    EXPECT_EQ(info().choice->reason, "Later.");
    EXPECT_FALSE(info().photos.at(1).scene) << "of the earlier choice";
    EXPECT_TRUE(info().colour) << "stays beside the choice";
}

TEST_F(StoredResults, AreRefusedWithoutAChoice) {
    const std::string before = readTextFile(m_dataset / kDescription);
    MeasureReport none = report();
    none.choice.rung.reset();
    none.choice.reason = "Nothing could be compared.";
    expectError(ErrorKind::InvalidInput, "Nothing could be compared.", [&] { storeChoice(m_dataset, none); });
    EXPECT_EQ(readTextFile(m_dataset / kDescription), before);
}

TEST_F(StoredResults, AreRefusedForAColourThatIsNone) {
    const std::string before = readTextFile(m_dataset / kDescription);
    render::ColourCorrection wrong;
    wrong.matrix(0, 0) = 100;
    EXPECT_THROW(storeColour(m_dataset, wrong), Error);
    EXPECT_EQ(readTextFile(m_dataset / kDescription), before);
}

TEST_F(StoredResults, LeaveADamagedDescriptionAsItIs) {
    for (const std::string& damaged : {std::string("{"), std::string("{\"photos\": 3}"), std::string("[]")}) {
        SCOPED_TRACE(damaged);
        writeFile(m_dataset / kDescription, bytesOf(damaged));
        EXPECT_THROW(storeColour(m_dataset, brighter()), Error);
        EXPECT_EQ(readTextFile(m_dataset / kDescription), damaged);
    }
}

TEST_F(StoredResults, NeedADataset) {
    expectError(ErrorKind::NotFound, "dataset.json", [&] { storeColour(m_survey / "none", brighter()); });
    EXPECT_FALSE(std::filesystem::exists(m_survey / "none"));
}

TEST(MeasureCacheFolder, LiesInASurveyAndBesideADataset) {
    const test::PhotographedSurvey survey{2};
    EXPECT_TRUE(isSurvey(survey.path()));
    EXPECT_FALSE(isSurvey(survey / "in"));
    EXPECT_FALSE(isSurvey(survey / "none"));
    EXPECT_EQ(measureCacheFolder(survey.path()), survey.path() / "measure-cache");
    EXPECT_EQ(measureCacheFolder("/a/room.dataset"), "/a/room.dataset.measure-cache");
    EXPECT_EQ(measureCacheFolder("/a/room.dataset/"), "/a/room.dataset.measure-cache");
    EXPECT_EQ(measureCacheFolder("room.dataset"), "room.dataset.measure-cache");
}

namespace {

/// Datasets in the cache of a survey.
class SurveyDataset : public testing::Test {
  protected:
    std::filesystem::path make(render::SceneKind scene = render::SceneKind::Sphere) {
        return surveyDataset(m_survey.open(), scene, m_cache, noProgress(), {});
    }

    std::set<std::filesystem::path> datasets() const {
        std::set<std::filesystem::path> result;
        for (const auto& entry : std::filesystem::directory_iterator(m_cache)) {
            result.insert(entry.path());
        }
        return result;
    }

    test::PhotographedSurvey m_survey{3};
    std::filesystem::path m_cache = m_survey / "cache";
};

} // namespace

TEST_F(SurveyDataset, IsMadeOnceAsLongAsTheSurveyStaysAsItIs) {
    const std::filesystem::path first = make();
    EXPECT_EQ(render::Dataset::open(first).info().photos.size(), 3U);
    const auto written = std::filesystem::last_write_time(first / kDescription);
    EXPECT_EQ(make(), first);
    EXPECT_EQ(std::filesystem::last_write_time(first / kDescription), written);
    EXPECT_EQ(datasets(), (std::set<std::filesystem::path>{first}));
}

TEST_F(SurveyDataset, IsAnotherOnceAPhotoIsRejectedAndTheOldOneIsGone) {
    const std::filesystem::path first = make();
    auto store = m_survey.open(store::Access::Write);
    store.setReview({store.photos().at(0).id, store::Decision::Rejected, ""});
    const std::filesystem::path second = make();
    EXPECT_NE(second, first);
    EXPECT_EQ(render::Dataset::open(second).info().photos.size(), 2U);
    EXPECT_EQ(datasets(), (std::set<std::filesystem::path>{second}));
}

TEST_F(SurveyDataset, IsAnotherOnceASolutionTurnsItsPhotos) {
    const std::filesystem::path first = make();
    auto store = m_survey.open(store::Access::Write);
    store::NewSolution solution;
    solution.source = "align";
    solution.model = "yaw";
    store::SolvedPhoto solved;
    solved.photo = store.photos().at(0).id;
    solved.roomFromPhoto = Eigen::Quaterniond(0, 0, 0, 1);
    solved.positionM = store.photos().at(0).positionM;
    solution.photos.push_back(solved);
    store.addSolution(solution, true);
    EXPECT_NE(make(), first);
}

TEST_F(SurveyDataset, IsMadeAnewWhereOneWasNotFinished) {
    const std::filesystem::path first = make();
    std::filesystem::remove(first / kDescription);
    EXPECT_EQ(make(), first);
    EXPECT_EQ(render::Dataset::open(first).info().photos.size(), 3U);
}

TEST_F(SurveyDataset, LeavesNothingThatLooksFinishedWhenItIsStopped) {
    std::stop_source stop;
    stop.request_stop();
    expectError(ErrorKind::Stopped, "Stopped", [&] {
        surveyDataset(m_survey.open(), render::SceneKind::Sphere, m_cache, noProgress(), stop.get_token());
    });
    for (const std::filesystem::path& left : datasets()) {
        EXPECT_FALSE(std::filesystem::exists(left / kDescription)) << left;
    }
    EXPECT_EQ(render::Dataset::open(make()).info().photos.size(), 3U);
}

TEST_F(SurveyDataset, SaysWhichFolderItCannotUse) {
    writeFile(m_cache, bytesOf("a file"));
    expectError(ErrorKind::Io, "name another folder", [&] { make(); });
}

} // namespace spherewalk::jobs
