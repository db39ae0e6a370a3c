// SPDX-License-Identifier: GPL-3.0-or-later
#include "made/survey_truth.h"
#include "made/synthetic_survey.h"

#include "spherewalk/align/solve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace spherewalk::align {

namespace {

constexpr int kPhotosARow = 5;
constexpr int kPhotosOfARoom = 3 * kPhotosARow;

/// Two rooms with three rails each. One photo of each sees the other room, through a door. The tags are far
/// better than they promise.
SyntheticSurvey twoRooms(int seed) {
    SyntheticSurveyOptions options;
    options.seed = static_cast<std::uint64_t>(seed);
    options.columns = kPhotosARow;
    options.rows = 6;
    options.mostMatches = 200;
    options.positionSigmaM = 0.0005;
    const SyntheticSurvey survey = syntheticSurvey(options);
    SyntheticSurvey kept = withPairs(survey, [](const PhotoPair& pair) {
        return (pair.a < kPhotosOfARoom) == (pair.b < kPhotosOfARoom) ||
               (pair.a == kPhotosOfARoom - 3 && pair.b == kPhotosOfARoom + 2);
    });
    for (PhotoPair& pair : kept.pairs) {
        if ((pair.a < kPhotosOfARoom) != (pair.b < kPhotosOfARoom)) {
            const Eigen::Quaterniond& roomFromA =
                kept.roomFromPhoto[static_cast<std::size_t>(pair.a)].rotation;
            std::erase_if(pair.matches, [&](const Correspondence& match) {
                return (roomFromA * match.inA).y() < 0.8; // beside the door
            });
        }
    }
    for (PhotoPrior& photo : kept.photos) {
        photo.positionSigmaM = 0.005;
    }
    return kept;
}

SolveOptions positions(bool narrows) {
    SolveOptions options;
    options.model = Model::Position;
    options.threads = 2;
    options.areTagged = narrows;
    return options;
}

} // namespace

TEST(TwoRooms, AreHeldByTagsThatAreBetterThanTheyPromise) {
    double stated = 0;
    double narrowed = 0;
    for (int seed = 1; seed <= 4; ++seed) {
        const SyntheticSurvey survey = twoRooms(seed);
        stated += errorsOf(solveSurvey(survey, positions(false)), survey.roomFromPhoto).yawRms;
        narrowed += errorsOf(solveSurvey(survey, positions(true)), survey.roomFromPhoto).yawRms;
    }
    EXPECT_LT(narrowed, 0.7 * stated);
}

TEST(TwoRooms, AreNotTurnedByOneWrongMatchThroughTheDoor) {
    double squares = 0;
    const std::vector<int> seeds = {2, 3, 4, 16};
    for (const int seed : seeds) {
        const SyntheticSurvey survey = twoRooms(seed);
        const SurveyErrors errors = errorsOf(solveSurvey(survey, positions(false)), survey.roomFromPhoto);
        // With seeds 2 and 16 one wrong match fits to a standard deviation, and all others nearly as well.
        EXPECT_LT(errors.ratioYaw, 3) << "seed " << seed;
        squares += errors.ratioYaw * errors.ratioYaw / static_cast<double>(seeds.size());
    }
    EXPECT_LT(std::sqrt(squares), 1.7);
}

} // namespace spherewalk::align
