// SPDX-License-Identifier: GPL-3.0-or-later
#include "made/survey_truth.h"
#include "made/synthetic_survey.h"
#include "solve/match_selection.h"

#include "spherewalk/align/solve.h"
#include "spherewalk/base/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace spherewalk::align {

namespace {

/// Every fifth photo is blurred: its bearings err four times as far as they state.
SyntheticSurvey withBlur(int seed, double lensAheadM = 0) {
    SyntheticSurveyOptions options;
    options.seed = static_cast<std::uint64_t>(seed);
    options.lensAheadM = lensAheadM;
    options.columns = 4;
    options.rows = 4;
    options.mostMatches = 300;
    options.blurredEvery = 5;
    return syntheticSurvey(options);
}

bool isBlurred(std::size_t photo) {
    return photo % 5 == 2;
}

std::vector<double> noiseOf(const SyntheticSurvey& survey, const std::vector<PairEstimate>& estimates) {
    return photoNoise(survey.photos.size(), survey.pairs, estimates);
}

double rootMeanSquare(const std::vector<double>& values) {
    double squares = 0;
    for (const double value : values) {
        squares += value * value;
    }
    return std::sqrt(squares / static_cast<double>(values.size()));
}

} // namespace

TEST(PhotoNoise, IsWhatBlurredPhotosErrBy) {
    const SyntheticSurvey survey = withBlur(1);
    const std::vector<double> noise = noiseOf(survey, estimatePairs(survey.pairs));
    for (std::size_t i = 0; i < noise.size(); ++i) {
        SCOPED_TRACE(testing::Message() << "photo " << i);
        EXPECT_GE(noise[i], isBlurred(i) ? 2.8 : 1);
        EXPECT_LE(noise[i], isBlurred(i) ? 5 : 1.35);
    }
}

/// The pairs' fits know nothing of the two lenses, and miss by what stands ahead in each photo alike.
TEST(PhotoNoise, FindsBlurAmongPhotosOfTwoLenses) {
    const SyntheticSurvey survey = withBlur(4, 0.01);
    const std::vector<double> noise = noiseOf(survey, estimatePairs(survey.pairs));
    for (std::size_t i = 0; i < noise.size(); ++i) {
        SCOPED_TRACE(testing::Message() << "photo " << i);
        EXPECT_GE(noise[i], isBlurred(i) ? 1.5 : 1);
        EXPECT_LE(noise[i], isBlurred(i) ? 5 : 1.35);
    }
}

TEST(PhotoNoise, BlamesNoPhotoForOnePairThatIsWrong) {
    const SyntheticSurvey survey = withBlur(2);
    std::vector<PairEstimate> estimates = estimatePairs(survey.pairs);
    const std::vector<double> before = noiseOf(survey, estimates);
    ASSERT_EQ(estimates[0].a, 0);
    ASSERT_TRUE(estimates[0].baselineInA);
    estimates[0].baselineInA = estimates[0].baselineInA->unitOrthogonal();
    const std::vector<double> after = noiseOf(survey, estimates);
    for (std::size_t i = 0; i < before.size(); ++i) {
        EXPECT_LT(after[i], 1.25 * before[i]) << "photo " << i;
    }
}

TEST(PhotoNoise, IsOneWhereNothingTellsIt) {
    const SyntheticSurvey survey = withBlur(3);
    std::vector<PairEstimate> estimates = estimatePairs(survey.pairs);
    for (PairEstimate& estimate : estimates) {
        estimate.verdict = PairVerdict::TooFew;
    }
    EXPECT_EQ(noiseOf(survey, estimates), std::vector<double>(survey.photos.size(), 1));
    EXPECT_TRUE(photoNoise(0, {}, {}).empty());
}

TEST(PhotoNoise, MakesSigmasOfBlurredAndOfSharpPhotosRight) {
    std::vector<double> blurred;
    std::vector<double> sharp;
    for (int seed = 1; seed <= 6; ++seed) {
        const SyntheticSurvey survey = withBlur(seed);
        SolveOptions options;
        options.model = Model::Position;
        const Alignment alignment = solveSurvey(survey, options);
        const SurveyErrors errors = errorsOf(alignment, survey.roomFromPhoto);
        ASSERT_EQ(errors.solved, 16);
        const double common = median(errors.yaw); // The mean would follow the blurred ones.
        for (std::size_t i = 0; i < errors.yaw.size(); ++i) {
            const double off = (errors.yaw[i] - common) / alignment.photos[i].sigmaYaw.value();
            (isBlurred(i) ? blurred : sharp).push_back(off);
        }
    }
    EXPECT_GT(rootMeanSquare(blurred), 0.6);
    EXPECT_LT(rootMeanSquare(blurred), 1.5);
    EXPECT_GT(rootMeanSquare(sharp), 0.6);
    EXPECT_LT(rootMeanSquare(sharp), 1.5);
    RecordProperty("blurred", std::to_string(rootMeanSquare(blurred)));
    RecordProperty("sharp", std::to_string(rootMeanSquare(sharp)));
}

} // namespace spherewalk::align
