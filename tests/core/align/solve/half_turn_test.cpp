// SPDX-License-Identifier: GPL-3.0-or-later
#include "made/survey_truth.h"
#include "made/synthetic_survey.h"
#include "pairs/pair_geometry.h"
#include "solve/component_solver.h"

#include "spherewalk/geometry/rotation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <numeric>
#include <set>

namespace spherewalk::align {

namespace {

/// Six photos on one line along x, at their true poses but for some that are turned by half about the line.
class HalfTurns {
  public:
    explicit HalfTurns(std::uint64_t seed, const std::set<int>& turned = {}, bool isReversed = false) {
        SyntheticSurveyOptions options;
        options.seed = seed;
        options.columns = 6;
        options.rows = 1;
        options.stepM = 0.6;
        options.reachM = 1.3;
        options.positionSigmaM = 0.002;
        m_survey = syntheticSurvey(options);
        m_estimates = estimatePairs(m_survey.pairs);
        std::vector<int> photos(m_survey.photos.size());
        std::iota(photos.begin(), photos.end(), 0);
        std::vector<Eigen::Quaterniond> rotations;
        for (const int photo : photos) {
            Eigen::Quaterniond rotation = m_survey.roomFromPhoto[static_cast<std::size_t>(photo)].rotation;
            if (turned.contains(photo)) {
                rotation = turn({std::numbers::pi, 0, 0}) * rotation;
            }
            rotations.push_back(isReversed ? yawRotation(Degrees(180)) * rotation : rotation);
        }
        state.unknowns = unknowns(photos, m_survey.photos, rotations);
        std::vector<std::vector<bool>> isUsed;
        for (const PairEstimate& estimate : m_estimates) {
            isUsed.push_back(estimate.isInlier);
        }
        m_tracks = tracks(m_survey.pairs, isUsed);
        input.priors = m_survey.photos;
        input.options = &m_options;
        m_noise.assign(photos.size(), 1);
        input.candidates = {m_survey.pairs, m_estimates, m_tracks, {}, photos, m_noise};
        for (std::size_t i = 0; i < m_estimates.size(); ++i) {
            if (m_estimates[i].verdict == PairVerdict::Constraint) {
                input.candidates.chosen.push_back(static_cast<int>(i));
            }
        }
    }

    HalfTurns(const HalfTurns&) = delete;
    HalfTurns& operator=(const HalfTurns&) = delete;

    double worstErrorRad() const {
        double worst = 0;
        for (std::size_t i = 0; i < m_survey.roomFromPhoto.size(); ++i) {
            worst = std::max(
                worst, angleBetween(state.unknowns.state(i).roomFromPhoto, m_survey.roomFromPhoto[i].rotation)
                           .value());
        }
        return worst;
    }

    ComponentState state;
    ComponentInput input;

  private:
    SyntheticSurvey m_survey;
    std::vector<PairEstimate> m_estimates;
    std::vector<std::vector<int>> m_tracks;
    std::vector<double> m_noise;
    SolveOptions m_options;
};

constexpr double kNearRad = 0.03; // An estimate's own error, added up over the line.

} // namespace

TEST(HalfTurn, OfOnePhotoOrOfAPartIsTurnedBack) {
    for (const std::set<int>& turned : {std::set{5}, std::set{2}, std::set{4, 5}, std::set{0, 1, 5}}) {
        HalfTurns line(31, turned);
        SCOPED_TRACE(testing::Message() << "seed 31, turned " << testing::PrintToString(turned));
        EXPECT_GT(line.worstErrorRad(), 3);
        EXPECT_EQ(turnHalves(line.input, line.state), static_cast<int>(turned.size()));
        EXPECT_LT(line.worstErrorRad(), kNearRad);
    }
}

TEST(HalfTurn, LeavesRightPhotosAlone) {
    HalfTurns line(32);
    EXPECT_EQ(turnHalves(line.input, line.state), 0);
    EXPECT_LT(line.worstErrorRad(), 1e-12);
    EXPECT_THAT(unclearSides(line.state, pairSides(line.input, line.state)), testing::Each(false));
}

TEST(HalfTurn, OfAllPhotosAboutTheVerticalReversesTheTravel) {
    EXPECT_EQ(travelSign(pairSides(HalfTurns(33).input, HalfTurns(33).state)), TravelSign::Right);
    const HalfTurns reversed(33, {}, true);
    EXPECT_EQ(travelSign(pairSides(reversed.input, reversed.state)), TravelSign::Reversed);
}

TEST(BentPhotos, AreThoseThatThePairsDoNotJoinToMostOthers) {
    HalfTurns line(34);
    EXPECT_THAT(bentPhotos(line.input, line.state), testing::Each(false));
    for (const std::size_t photo : {4U, 5U}) {
        Eigen::Quaterniond& rotation = line.state.unknowns.reference[photo];
        rotation = yawRotation(Degrees(3)) * rotation;
    }
    EXPECT_THAT(bentPhotos(line.input, line.state),
                testing::ElementsAre(false, false, false, false, true, true));
    for (std::size_t photo = 0; photo < 6; ++photo) {
        Eigen::Quaterniond& rotation = line.state.unknowns.reference[photo];
        rotation = yawRotation(Degrees(3.0 * static_cast<double>(photo))) * rotation;
    }
    EXPECT_THAT(bentPhotos(line.input, line.state), testing::Each(true)); // none that the others could join
}

TEST(HalfTurn, OfTheTravelIsUnclearWithoutParallax) {
    PairSides pair;
    pair.same = 200;
    pair.front = 6;
    pair.behind = 3;
    EXPECT_EQ(travelSign(std::vector{pair}), TravelSign::Unclear);
    pair.front = 30;
    pair.behind = 20;
    EXPECT_EQ(travelSign(std::vector{pair}), TravelSign::Unclear);
    pair.behind = 2;
    EXPECT_EQ(travelSign(std::vector{pair}), TravelSign::Right);
}

} // namespace spherewalk::align
