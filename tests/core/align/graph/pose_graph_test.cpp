// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "graph/pose_graph.h"
#include "made/simulated_survey.h"

#include "spherewalk/geometry/rotation.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace spherewalk::align {

namespace {

using test::Random;

/// A survey of rails and stops, of whose pairs this share is wrong.
SimulatedSurvey surveyOf(int rails, int stops, double wrongShare, Random& random) {
    SimulationOptions options;
    options.rails = rails;
    options.stops = stops;
    options.wrongShare = wrongShare;
    SimulatedSurvey survey(options, random);
    survey.expose(random);
    return survey;
}

PoseGraph confirmedGraph(const SimulatedSurvey& survey) {
    return poseGraph(static_cast<int>(survey.photos.size()), survey.estimates, 1);
}

} // namespace

TEST(PoseGraph, IsGoodToAFractionOfADegreeThoughManyPairsAreWrong) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
        Random random(seed);
        const SimulatedSurvey survey = surveyOf(8, 8, 0.5, random); // a quarter with wrong rotations
        const PoseGraph graph = confirmedGraph(survey);
        ASSERT_EQ(graph.components.size(), 1U);
        const Component& all = graph.components[0];
        ASSERT_EQ(all.photos.size(), 64U);
        const Eigen::Quaterniond roomFromComponent =
            survey.roomFromPhoto[0].rotation * all.componentFromPhoto[0].conjugate();
        for (std::size_t i = 0; i < 64; ++i) {
            const Radians off =
                angleBetween(roomFromComponent * all.componentFromPhoto[i], survey.roomFromPhoto[i].rotation);
            EXPECT_LT(Degrees(off).value(), 0.4) << "seed " << seed << ", photo " << i;
        }
    }
}

TEST(PoseGraph, LeavesOutWhatNoTriangleConfirms) {
    Random random(9);
    SimulatedSurvey survey = surveyOf(1, 4, 0, random);
    std::erase_if(survey.estimates, [](const PairEstimate& pair) { return pair.b != pair.a + 1; });
    EXPECT_TRUE(confirmedGraph(survey).components.empty());
    EXPECT_EQ(poseGraph(4, survey.estimates).components.size(), 1U);
}

TEST(PoseGraph, HasAComponentForEachPartOfTheSurveyThatNothingConnects) {
    Random random(10);
    SimulatedSurvey survey = surveyOf(6, 5, 0.1, random);
    std::erase_if(survey.estimates, [](const PairEstimate& pair) { return (pair.a < 10) != (pair.b < 10); });
    const PoseGraph graph = confirmedGraph(survey);
    ASSERT_EQ(graph.components.size(), 2U);
    EXPECT_EQ(graph.components[0].photos.size(), 20U);
    EXPECT_EQ(graph.components[0].photos.front(), 10);
    EXPECT_EQ(graph.components[1].photos.back(), 9);
}

TEST(PoseGraph, ResidualsOfItsEdgesAreSmall) {
    Random random(11);
    const SimulatedSurvey survey = surveyOf(6, 6, 0.2, random);
    for (const GraphEdge& edge : confirmedGraph(survey).components.at(0).edges) {
        EXPECT_LT(edge.residualRad, 0.02);
    }
}

TEST(PoseGraph, RefusesPairsOfPhotosThatDoNotExist) {
    Random random(12);
    SimulatedSurvey survey = surveyOf(2, 2, 0, random);
    survey.estimates[0].b = 4;
    test::expectError(ErrorKind::InvalidInput, "there are 4 photos", [&] { confirmedGraph(survey); });
}

TEST(RoomOrientation, IsTheTruthWithinAFractionOfADegree) {
    for (unsigned seed = 20; seed < 26; ++seed) {
        Random random(seed);
        const SimulatedSurvey survey = surveyOf(6, 6, 0.3, random);
        const Component component = confirmedGraph(survey).components.at(0);
        const RoomOrientation best = orientations(component, survey.photos, survey.estimates).at(0);
        EXPECT_TRUE(best.hasHeading);
        EXPECT_GT(best.agreeingShare, 0.7);
        for (std::size_t i = 0; i < component.photos.size(); ++i) {
            const Radians off =
                angleBetween(best.roomFromComponent * component.componentFromPhoto[i],
                             survey.roomFromPhoto[static_cast<std::size_t>(component.photos[i])].rotation);
            EXPECT_LT(Degrees(off).value(), 0.8) << "seed " << seed << ", photo " << i;
        }
    }
}

TEST(RoomOrientation, TurnsWithTheRoom) {
    Random random(30);
    SimulatedSurvey survey = surveyOf(5, 5, 0.1, random);
    const Component component = confirmedGraph(survey).components.at(0);
    const RoomOrientation before = orientations(component, survey.photos, survey.estimates).at(0);
    const Eigen::Quaterniond turned = yawRotation(Degrees(40));
    for (PhotoPrior& photo : survey.photos) {
        photo.positionM = turned * photo.positionM + Eigen::Vector3d(100, -20, 3);
    }
    const RoomOrientation after = orientations(component, survey.photos, survey.estimates).at(0);
    EXPECT_LT(angleBetween(after.roomFromComponent, turned * before.roomFromComponent).value(), 1e-4);
}

TEST(RoomOrientation, HasNoHeadingWhereAllPhotosShareAPlace) {
    Random random(31);
    SimulatedSurvey survey = surveyOf(4, 4, 0, random);
    const Component component = confirmedGraph(survey).components.at(0);
    for (PhotoPrior& photo : survey.photos) {
        photo.positionM.setZero();
    }
    const std::vector<RoomOrientation> found = orientations(component, survey.photos, survey.estimates);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_FALSE(found[0].hasHeading);
    const Eigen::Vector3d up =
        found[0].roomFromComponent * component.componentFromPhoto[0] * Eigen::Vector3d::UnitZ();
    EXPECT_GT(up.z(), 0.999); // upright all the same
}

namespace {

/// The last photo has one neighbour that shows the same, in 30 matches of 37.
SimulatedSurvey behindAWall(Random& random) {
    SimulatedSurvey survey = surveyOf(4, 5, 0, random);
    const int last = static_cast<int>(survey.photos.size()) - 1;
    for (PairEstimate& pair : survey.estimates) {
        if (pair.b != last) {
            continue;
        }
        if (pair.a == last - 1) {
            pair.inliers = 30;
            pair.inlierShare = 0.8;
        } else {
            pair.verdict = PairVerdict::TooFew;
        }
    }
    return survey;
}

bool isLastConfirmed(const SimulatedSurvey& survey) {
    const int count = static_cast<int>(survey.photos.size());
    const PoseGraph graph = poseGraph(count, survey.estimates);
    EXPECT_EQ(static_cast<int>(graph.components.front().photos.size()), count - 1);
    const std::vector<bool> confirmed = confirmedByTags(graph, survey.photos, survey.estimates);
    EXPECT_LE(std::ranges::count(confirmed, true), 1);
    const PoseGraph again = poseGraph(count, survey.estimates, 0, confirmed);
    EXPECT_EQ(static_cast<int>(again.components.front().photos.size()), confirmed.back() ? count : count - 1);
    return confirmed.back();
}

} // namespace

TEST(ConfirmedByTags, IsAPhotoThatStandsFromItsNeighbourWhereItsTagSays) {
    Random random(31);
    EXPECT_TRUE(isLastConfirmed(behindAWall(random)));
}

TEST(ConfirmedByTags, IsNoPhotoThatItsTagPutsElsewhereOrThatFewMatchesHold) {
    Random random(32);
    SimulatedSurvey elsewhere = behindAWall(random);
    elsewhere.photos.back().positionM.y() += 0.2;
    EXPECT_FALSE(isLastConfirmed(elsewhere));
    SimulatedSurvey few = behindAWall(random);
    for (PairEstimate& pair : few.estimates) {
        pair.inliers = pair.inliers == 30 ? 15 : pair.inliers;
    }
    EXPECT_FALSE(isLastConfirmed(few));
}

} // namespace spherewalk::align
