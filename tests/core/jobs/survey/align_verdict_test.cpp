// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/align_survey.h"
#include "spherewalk/store/survey_store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace spherewalk::jobs {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

namespace {

/// A grid of nine photos that are solved where they are tagged.
class AlignVerdicts : public testing::Test {
  protected:
    AlignVerdicts() {
        for (int i = 0; i < 9; ++i) {
            align::PhotoPrior prior;
            prior.positionM = Eigen::Vector3d(0.2 * (i % 3), 0.2 * (i / 3), 1.2);
            align::SolvedPose pose;
            pose.isSolved = true;
            pose.roomFromPhoto.translation = prior.positionM;
            pose.sigmaPositionM = 0.002;
            pose.sigmaOwnPositionM = 0.001;
            tagged.push_back(prior);
            report.alignment.photos.push_back(pose);
            report.photos.emplace_back().photo = i + 1;
        }
    }

    /// Gives the verdicts, of which that on the fifth photo is in question.
    const AlignedPhoto& verdict() {
        giveVerdicts(tagged, report);
        for (const AlignedPhoto& photo : report.photos) {
            if (photo.photo != 5) {
                EXPECT_EQ(photo.quality, survey::Quality::Good) << photo.photo;
            }
        }
        return report.photos[4];
    }

    /// Whether the store gets a pose of the fifth photo.
    bool isRecorded() const {
        const store::NewSolution solution = recordOf(report);
        EXPECT_GE(solution.photos.size(), 8U);
        return std::ranges::any_of(solution.photos,
                                   [](const store::SolvedPhoto& photo) { return photo.photo == 5; });
    }

    std::vector<align::PhotoPrior> tagged;
    AlignReport report;
};

} // namespace

TEST_F(AlignVerdicts, AreGoodWhereNothingIsWrong) {
    EXPECT_EQ(verdict().quality, survey::Quality::Good);
    EXPECT_TRUE(isRecorded());
}

// A wrong tag whose photo's neighbours tell its place no better than it was sought with.
TEST_F(AlignVerdicts, FailAPhotoWhosePlaceStaysUnknown) {
    report.photos[4].freeSigmaM = 0.05;
    report.alignment.photos[4].sigmaPositionM = 0.03;
    EXPECT_EQ(verdict().quality, survey::Quality::Failed);
    EXPECT_THAT(report.photos[4].flags, Contains(HasSubstr("Where it was taken is known to 3 cm only")));
    EXPECT_EQ(report.photos[4].cure, Cure::Retake);
    EXPECT_FALSE(isRecorded());
}

TEST_F(AlignVerdicts, KeepAPhotoWhosePlaceWasFound) {
    report.photos[4].freeSigmaM = 0.05;
    report.alignment.photos[4].sigmaPositionM = 0.02;
    EXPECT_NE(verdict().quality, survey::Quality::Failed);
    EXPECT_TRUE(isRecorded());
}

TEST_F(AlignVerdicts, FailAPhotoWhoseNeighboursContradictAlmostAllOfIt) {
    report.alignment.photos[4].outlierShare = 0.95;
    EXPECT_EQ(verdict().quality, survey::Quality::Failed);
    EXPECT_THAT(report.photos[4].flags, Contains(HasSubstr("contradict 95 % of what it shows")));
    EXPECT_FALSE(isRecorded());
}

TEST_F(AlignVerdicts, DoubtAPhotoWhoseNeighboursContradictMuchOfIt) {
    report.alignment.photos[4].outlierShare = 0.6;
    EXPECT_EQ(verdict().quality, survey::Quality::Doubtful);
    EXPECT_EQ(report.photos[4].cure, Cure::Mask);
    EXPECT_TRUE(isRecorded());
}

TEST_F(AlignVerdicts, BlameNoPhotoWhoseTiltWasNotSolved) {
    report.alignment.photos[4].sigmaOwn = Degrees(0.7);
    report.alignment.model = align::Model::Yaw;
    EXPECT_EQ(verdict().quality, survey::Quality::Doubtful);
    EXPECT_THAT(report.photos[4].flags, ElementsAre(AllOf(HasSubstr("does not solve its tilt"),
                                                          HasSubstr("is known to 0.700 deg only"))));
    EXPECT_EQ(report.photos[4].cure, Cure::None);
}

TEST_F(AlignVerdicts, BlameAPhotoThatSharesTooLittleOfWhatWasSolved) {
    report.alignment.photos[4].sigmaOwn = Degrees(0.7);
    report.alignment.model = align::Model::Position;
    EXPECT_EQ(verdict().quality, survey::Quality::Doubtful);
    EXPECT_THAT(report.photos[4].flags,
                ElementsAre(AllOf(HasSubstr("shares too little"), HasSubstr("is known to 0.700 deg only"))));
    EXPECT_EQ(report.photos[4].cure, Cure::Retake);
}

TEST_F(AlignVerdicts, AreSaidOnceOfAllPhotosTogether) {
    for (AlignedPhoto& photo : report.photos) {
        photo.file = "R" + std::to_string(photo.photo) + ".JPG";
        photo.station = "place of " + photo.file;
    }
    report.photos[1].flags = {"It is alone.", "It is dark."};
    report.photos[2].flags = {"It is dark."};
    report.photos[6].flags = {"It is alone."};
    report.photos[6].station = "rail 2, stop 1";
    EXPECT_THAT(
        alignText(report),
        testing::EndsWith(
            "\nR2.JPG, R7.JPG (rail 2, stop 1), each: It is alone.\nR2.JPG, R3.JPG, each: It is dark."));
}

} // namespace spherewalk::jobs
