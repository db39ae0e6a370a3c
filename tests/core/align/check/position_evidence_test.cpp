// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/position_evidence.h"
#include "check/position_hypotheses.h"
#include "made/simulated_survey.h"

#include "spherewalk/geometry/rotation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace spherewalk::align {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using test::Random;

namespace {

SimulatedSurvey gridSurvey(Random& random) {
    SimulationOptions options;
    options.rails = 5;
    options.stops = 6;
    return SimulatedSurvey(options, random);
}

Places taggedPlaces(const SimulatedSurvey& survey) {
    Places places;
    for (int i = 0; i < static_cast<int>(survey.photos.size()); ++i) {
        places.push_back(i);
    }
    return places;
}

/// The evidence of an exposed survey with the tags' positions. Its frame is the room's.
PositionEvidence evidenceOf(const SimulatedSurvey& survey, const Vector3d& movedM = Vector3d::Zero()) {
    Component component;
    for (int i = 0; const Rigid3& pose : survey.roomFromPhoto) {
        component.photos.push_back(i++);
        component.componentFromPhoto.push_back(pose.rotation);
    }
    for (int i = 0; const PairEstimate& estimate : survey.estimates) {
        component.edges.push_back({i++, estimate.a, estimate.b, estimate.aFromB});
    }
    std::vector<Vector3d> positionsM;
    for (const PhotoPrior& photo : survey.photos) {
        positionsM.push_back(photo.positionM + movedM);
    }
    return {baselines(survey.estimates, component), positionsM,
            std::vector<double>(positionsM.size(), 0.003)};
}

std::vector<Move> anyMoves(const SimulatedSurvey& survey, Random& random) {
    std::vector<Move> moves;
    const int count = static_cast<int>(survey.photos.size());
    const int first = random.integer(0, count - 4);
    for (int photo = first; photo < first + random.integer(1, 4); ++photo) {
        const int planned = random.integer(0, count - 1);
        moves.push_back(
            {photo, planned, survey.plannedPositions[static_cast<std::size_t>(planned)].positionM});
    }
    return moves;
}

/// Checks a survey whose photos were taken as told, and says which photos have this reason.
std::vector<std::string> reasonsOf(SimulatedSurvey& survey, Random& random) {
    survey.expose(random);
    std::vector<std::string> reasons;
    for (const WrongPosition& wrong :
         wrongPositions(survey.photos, survey.estimates, survey.plannedPositions)) {
        reasons.push_back(wrong.reason);
    }
    return reasons;
}

} // namespace

TEST(PositionEvidence, GainIsWhatTheScoreGainsAndLeavesItAsItWas) {
    for (unsigned seed = 900; seed < 910; ++seed) {
        Random random(seed);
        SimulatedSurvey survey = gridSurvey(random);
        survey.expose(random);
        PositionEvidence evidence = evidenceOf(survey);
        for (int round = 0; round < 10; ++round) {
            const double before = evidence.score();
            const std::vector<Move> moves = anyMoves(survey, random);
            const double gain = evidence.gain(moves);
            EXPECT_EQ(evidence.score(), before);
            evidence.apply(moves);
            EXPECT_NEAR(evidence.score() - before, gain, 1e-7) << "seed " << seed;
        }
    }
}

TEST(PositionEvidence, IsBestWhereThePhotosWereTaken) {
    Random random(910);
    SCOPED_TRACE(random.seed());
    SimulatedSurvey survey = gridSurvey(random);
    survey.expose(random);
    PositionEvidence evidence = evidenceOf(survey);
    for (int photo = 0; photo < 30; ++photo) {
        const Move away{photo, -1,
                        survey.photos[static_cast<std::size_t>(photo)].positionM + Vector3d(0.15, 0.1, 0)};
        EXPECT_LT(evidence.gain({&away, 1}), 0) << "photo " << photo;
    }
}

TEST(PositionEvidence, ContradictsAPhotoThatWasTakenElsewhere) {
    Random random(911);
    SCOPED_TRACE(random.seed());
    SimulatedSurvey survey = gridSurvey(random);
    survey.takeAt(14, 17);
    survey.expose(random);
    const PositionEvidence evidence = evidenceOf(survey);
    const PositionEvidence::Count wrong = evidence.count(14);
    EXPECT_GT(2 * wrong.contradicted, wrong.directions);
    EXPECT_LE(wrong.directions, static_cast<int>(evidence.of(14).size()));
    EXPECT_LT(4 * evidence.count(0).contradicted, evidence.count(0).directions);
}

TEST(PositionEvidence, IsTheSameWhereverTheRoomLiesAndHoweverItIsTurned) {
    Random random(912);
    SCOPED_TRACE(random.seed());
    SimulatedSurvey survey = gridSurvey(random);
    survey.expose(random);
    const double score = evidenceOf(survey).score();
    EXPECT_NEAR(evidenceOf(survey, Vector3d(1e6, -2e6, 0)).score(), score, 1e-3);
    const Quaterniond turned = yawRotation(Degrees(77));
    for (PhotoPrior& photo : survey.photos) {
        photo.positionM = turned * photo.positionM;
    }
    PositionEvidence evidence = evidenceOf(survey);
    EXPECT_LT(evidence.score(), score - 100);
    evidence.turn(turned);
    EXPECT_NEAR(evidence.score(), score, 1e-6);
}

TEST(PositionEvidence, OfNothingSaysNothing) {
    PositionEvidence evidence({}, {Vector3d::Zero(), Vector3d::UnitX()}, {0.003, 0.003});
    const Move move{1, -1, Vector3d(5, 5, 5)};
    EXPECT_EQ(evidence.gain({&move, 1}), 0);
    EXPECT_EQ(evidence.score(), 0);
    EXPECT_EQ(evidence.count(0).directions, 0);
}

TEST(PlannedLines, AreSortedByStopAndSplitByRailAndHeight) {
    std::vector<PlannedPosition> planned;
    for (const int stop : {2, 0, 1}) {
        for (const double heightM : {1.2, 1.6}) {
            planned.push_back({"", Vector3d(0.2 * stop, 0, heightM), 4, stop});
            planned.push_back({"", Vector3d(0.2 * stop, 1, heightM), 3, stop});
        }
    }
    planned.push_back({"", Vector3d(9, 9, 1), -1, 0});
    planned.push_back({"", Vector3d(std::numeric_limits<double>::quiet_NaN(), 0, 1), 3, 3});
    const PlannedLines lines(planned);
    ASSERT_EQ(lines.lines().size(), 4U);
    for (int line = 0; line < 4; ++line) {
        const std::vector<int>& positions = lines.lines()[static_cast<std::size_t>(line)];
        ASSERT_EQ(positions.size(), 3U);
        for (int index = 0; index < 3; ++index) {
            const int at = positions[static_cast<std::size_t>(index)];
            EXPECT_EQ(lines[at].stop, index);
            EXPECT_EQ(lines.place(at).line, line);
            EXPECT_EQ(lines.place(at).index, index);
        }
    }
    EXPECT_EQ(lines.place(12).line, -1);
    EXPECT_EQ(lines.place(13).line, -1);
    EXPECT_EQ(lines.place(-1).line, -1);
}

TEST(PlannedLines, GoOnStraightBeyondTheirEnds) {
    const PlannedLines lines(std::vector<PlannedPosition>{{"", {0, 0, 1}, 0, 0}, {"", {0.2, 0.1, 1}, 0, 1}});
    EXPECT_LT((lines.positionM(0, -1) - Vector3d(-0.2, -0.1, 1)).norm(), 1e-12);
    EXPECT_LT((lines.positionM(0, 2) - Vector3d(0.4, 0.2, 1)).norm(), 1e-12);
    EXPECT_EQ(lines.positionM(0, 1), Vector3d(0.2, 0.1, 1));
}

TEST(PlannedLines, FindTheTagByItsPlaceAndOfSeveralTheOneOfThePhotosStop) {
    const PlannedLines lines(std::vector<PlannedPosition>{
        {"", {1, 1, 1}, 0, 4}, {"", {1.001, 1, 1}, 2, 3}, {"", {5, 5, 1}, 2, 4}});
    PhotoPrior photo;
    photo.positionM = Vector3d(1, 1, 1);
    photo.placement = 2;
    photo.stop = 3;
    EXPECT_EQ(lines.tag(photo), 1);
    photo.placement = 7;
    EXPECT_EQ(lines.tag(photo), 0);
    photo.positionM.x() = 1.03;
    EXPECT_EQ(lines.tag(photo), -1);
    photo.positionM.x() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(lines.tag(photo), -1);
}

TEST(Hypotheses, BeginWithTheBlunderThatWasMadeAndLeaveTheEvidenceAsItWas) {
    Random random(913);
    SCOPED_TRACE(random.seed());
    SimulatedSurvey survey = gridSurvey(random);
    survey.takeAt(8, 20);
    survey.takeAt(20, 8);
    survey.expose(random);
    PositionEvidence evidence = evidenceOf(survey);
    const double before = evidence.score();
    const std::vector<Hypothesis> found =
        hypotheses(evidence, PlannedLines(survey.plannedPositions), taggedPlaces(survey));
    EXPECT_EQ(evidence.score(), before);
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found[0].blunder, Blunder::Swapped);
    ASSERT_EQ(found[0].moves.size(), 2U);
    EXPECT_EQ(found[0].moves[0].photo + found[0].moves[1].photo, 28);
    EXPECT_TRUE(std::ranges::is_sorted(found, std::greater(), &Hypothesis::gain));
    EXPECT_GT(found.back().gain, 0);
    EXPECT_LE(found.size(), 100U);
}

TEST(Hypotheses, OfACleanSurveyAreNone) {
    for (unsigned seed = 914; seed < 918; ++seed) {
        Random random(seed);
        SimulatedSurvey survey = gridSurvey(random);
        survey.expose(random);
        PositionEvidence evidence = evidenceOf(survey);
        EXPECT_TRUE(hypotheses(evidence, PlannedLines(survey.plannedPositions), taggedPlaces(survey)).empty())
            << "seed " << seed;
    }
}

TEST(PositionSentences, SayThatARailWasWalkedFromTheOtherEnd) {
    Random random(918);
    SCOPED_TRACE(random.seed());
    SimulatedSurvey survey = gridSurvey(random);
    for (int stop = 0; stop < 6; ++stop) {
        survey.takeAt(survey.planned(2, stop), survey.planned(2, 5 - stop));
    }
    std::vector<std::string> expected;
    for (int stop = 5; stop >= 0; --stop) {
        expected.push_back(
            "Its rail was walked from the other end: it shows what is seen from rail 2, stop " +
            std::to_string(stop) + ".");
    }
    EXPECT_EQ(reasonsOf(survey, random), expected);
}

TEST(PositionSentences, SayHowManyPhotosAreOneStopOff) {
    Random random(919);
    SCOPED_TRACE(random.seed());
    SimulatedSurvey survey = gridSurvey(random);
    for (int stop = 0; stop < 6; ++stop) {
        survey.takeAt(survey.planned(1, stop), stop < 5 ? survey.planned(1, stop + 1) : -1);
    }
    const std::vector<std::string> reasons = reasonsOf(survey, random);
    ASSERT_EQ(reasons.size(), 6U);
    EXPECT_EQ(reasons[0], "It is one of 6 photos taken one stop farther along its rail than its tag says: it "
                          "shows what is seen from rail 1, stop 1.");
    EXPECT_EQ(reasons[5], "It was taken about 0.20 m from where its tag says, where no photo is planned: one "
                          "stop off the end of its rail.");
}

TEST(PositionSentences, NameTheStationOfASinglePhotoTakenElsewhere) {
    Random random(920);
    SCOPED_TRACE(random.seed());
    SimulatedSurvey survey = gridSurvey(random);
    survey.takeAt(survey.planned(1, 1), survey.planned(3, 4));
    EXPECT_THAT(reasonsOf(survey, random),
                testing::ElementsAre("It shows what is seen from rail 3, stop 4."));
}

} // namespace spherewalk::align
