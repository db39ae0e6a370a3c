// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "photographed_survey.h"

#include "spherewalk/base/json.h"
#include "spherewalk/jobs/solution_findings.h"
#include "spherewalk/store/survey_store.h"

#include <gtest/gtest.h>

namespace spherewalk::jobs {

namespace {

class SolutionFindingsTest : public testing::Test {
  protected:
    /// Says that the first photo belongs to the second station, and that the third failed.
    void addSolution() {
        AlignReport report;
        report.alignment.reason = "Because.";
        report.alignment.warnings = {"Something about all."};
        store::NewSolution solution;
        solution.source = "align";
        solution.model = "yaw";
        for (std::size_t i = 0; i < 3; ++i) {
            const store::PhotoRecord photo = store.chosenPhoto(stations[i].id).value();
            AlignedPhoto aligned;
            aligned.photo = photo.id;
            aligned.file = photo.fileName;
            aligned.quality = i == 2 ? survey::Quality::Failed : survey::Quality::Good;
            aligned.pose.isSolved = i != 2;
            aligned.pose.residualRad = 0.01;
            aligned.pose.constraints = 5;
            report.photos.push_back(aligned);
            if (i != 2) {
                store::SolvedPhoto solved;
                solved.photo = photo.id;
                solved.positionM = photo.positionM;
                solved.sigmaYawRad = 0.002;
                solution.photos.push_back(solved);
            }
        }
        report.photos[0].fits = stations[1].name;
        report.photos[0].cure = Cure::Retag;
        report.photos[0].flags = {"It fits elsewhere."};
        report.photos[2].cure = Cure::Retake;
        solution.report = toJson(report).dump();
        store.addSolution(solution, true);
    }

    test::PhotographedSurvey survey{3};
    store::SurveyStore store = survey.open(store::Access::Write);
    std::vector<store::StationRecord> stations = store.stations();
};

} // namespace

TEST_F(SolutionFindingsTest, SayWhatTheSolutionSaysOfEachPhoto) {
    addSolution();
    const SolutionFindings findings = activeFindings(store).value();
    EXPECT_EQ(findings.reason, "Because.");
    EXPECT_EQ(findings.warnings, std::vector<std::string>{"Something about all."});
    ASSERT_EQ(findings.photos.size(), 3U);
    const PhotoFinding& first = findings.photos[0];
    EXPECT_EQ(first.stationName, stations[0].name);
    EXPECT_EQ(first.sigmaYaw, Radians(0.002));
    EXPECT_NEAR(first.residual.value().value(), 0.01, 1e-12);
    EXPECT_EQ(first.neighbours, 5);
    EXPECT_EQ(first.fits, stations[1].id);
    EXPECT_EQ(first.cure, Cure::Retag);
    EXPECT_EQ(first.flags, std::vector<std::string>{"It fits elsewhere."});
    EXPECT_EQ(findings.photos[2].quality, survey::Quality::Failed);
    EXPECT_FALSE(findings.photos[2].roomFromPhoto.has_value());
    EXPECT_EQ(findings.photos[2].cure, Cure::Retake);
}

TEST_F(SolutionFindingsTest, ProposeTheMovesAndNotAgainOnceTheyAreMade) {
    addSolution();
    const std::vector<PhotoPlace> moves = activeFindings(store)->retags();
    ASSERT_EQ(moves.size(), 1U);
    EXPECT_EQ(moves[0].station, stations[1].id);
    retagPhotos(store, moves, noProgress(), {});
    const SolutionFindings after = activeFindings(store).value();
    EXPECT_TRUE(after.retags().empty());
    EXPECT_EQ(after.photos[0].cure, Cure::None);
}

TEST_F(SolutionFindingsTest, GiveTheAprilTagsAsTheyWereFoundAndRefuseForgedOnes) {
    EXPECT_TRUE(aprilTagsOf(store).empty());
    align::RoomTags found;
    found.tags.push_back(
        {7, {Eigen::Vector3d(1, 0, 2), {1.2, 0, 2}, {1.2, 0, 1.8}, {1, 0, 1.8}}, 0.2, 0.001, 0.002, 4});
    const auto record = [&](const Json& tags) {
        store::NewSolution solution;
        solution.source = "align";
        solution.model = "yaw";
        solution.report = Json{{"april_tags", tags}}.dump();
        store.addSolution(solution, true);
    };
    const Json tags = aprilTagsJson(found);
    record(tags);
    const std::vector<align::RoomTag> read = aprilTagsOf(store);
    ASSERT_EQ(read.size(), 1U);
    EXPECT_EQ(read[0].number, 7);
    EXPECT_EQ(read[0].corners, found.tags[0].corners);
    EXPECT_EQ(read[0].size, 0.2);
    EXPECT_EQ(read[0].sigma, 0.002);
    const auto expectRefused = [&](const std::string& part, const auto& forge) {
        Json forged = tags;
        forge(forged);
        record(forged);
        test::expectError(ErrorKind::Corrupt, part, [&] { aprilTagsOf(store); });
    };
    expectRefused("from 0 to 586", [](Json& forged) { forged[0]["number"] = 587; });
    expectRefused("april_tags/0/size_m", [](Json& forged) { forged[0]["size_m"] = 0; });
    expectRefused("april_tags/0/sigma_m", [](Json& forged) { forged[0]["sigma_m"] = nullptr; });
    expectRefused("corners_m/2", [](Json& forged) { forged[0]["corners_m"][2][1] = 1e300; });
    expectRefused("four corners", [](Json& forged) { forged[0]["corners_m"].erase(0); });
    expectRefused("listed twice", [](Json& forged) { forged.push_back(forged[0]); });
}

TEST_F(SolutionFindingsTest, KnowAnImportedSolutionToo) {
    const SolutionFindings findings = activeFindings(store).value();
    EXPECT_EQ(findings.solution.source, "imported");
    EXPECT_TRUE(findings.photos.at(0).roomFromPhoto.has_value());
    EXPECT_TRUE(findings.retags().empty());
}

} // namespace spherewalk::jobs
