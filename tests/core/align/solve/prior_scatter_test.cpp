// SPDX-License-Identifier: GPL-3.0-or-later
#include "made/survey_truth.h"
#include "made/synthetic_survey.h"

#include "spherewalk/align/solve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

namespace spherewalk::align {

namespace {

SyntheticSurveyOptions grid(int seed, int columns, int rows) {
    SyntheticSurveyOptions options;
    options.seed = static_cast<std::uint64_t>(seed);
    options.columns = columns;
    options.rows = rows;
    options.mostMatches = 200;
    return options;
}

/// Exact tags that are stated as usual ones are.
SyntheticSurvey exactTags(SyntheticSurveyOptions options) {
    options.positionSigmaM = 0;
    options.heightSigmaM = 0;
    SyntheticSurvey survey = syntheticSurvey(options);
    for (PhotoPrior& photo : survey.photos) {
        photo.positionSigmaM = PhotoPrior().positionSigmaM;
        photo.heightSigmaM = PhotoPrior().heightSigmaM;
    }
    return survey;
}

Alignment solved(const SyntheticSurvey& survey, Model model, bool narrows) {
    SolveOptions options;
    options.model = model;
    options.threads = 2;
    options.areTagged = narrows;
    return solveSurvey(survey, options);
}

void expectTheSame(const SyntheticSurvey& survey) {
    const Alignment stated = solved(survey, Model::Position, false);
    const Alignment narrowed = solved(survey, Model::Position, true);
    for (std::size_t i = 0; i < stated.photos.size(); ++i) {
        EXPECT_EQ(stated.photos[i].roomFromPhoto.translation, narrowed.photos[i].roomFromPhoto.translation);
        EXPECT_EQ(stated.photos[i].sigmaYaw.value(), narrowed.photos[i].sigmaYaw.value());
    }
}

} // namespace

TEST(PriorScatter, LeavesPriorsThatAreRight) {
    SyntheticSurveyOptions options = grid(3, 5, 6);
    options.positionSigmaM = 0.005;
    options.placementSigmaM = 0.01;
    options.placementSigma = Degrees(1);
    expectTheSame(syntheticSurvey(options));
}

TEST(PriorScatter, LearnsNothingFromFewPhotos) {
    expectTheSame(exactTags(grid(5, 3, 1)));
}

TEST(PriorScatter, MakesTurnsKnownWhereExactTagsAreStatedAsUsual) {
    const SyntheticSurvey survey = exactTags(grid(2, 5, 5));
    const Alignment stated = solved(survey, Model::Tilt, false);
    const Alignment narrowed = solved(survey, Model::Tilt, true);
    for (std::size_t i = 0; i < stated.photos.size(); ++i) {
        EXPECT_LT(narrowed.photos[i].sigmaOwn.value(), 0.6 * stated.photos[i].sigmaOwn.value());
        EXPECT_EQ(stated.photos[i].roomFromPhoto.translation, narrowed.photos[i].roomFromPhoto.translation);
    }
    const SurveyErrors errors = errorsOf(narrowed, survey.roomFromPhoto);
    EXPECT_GE(errors.within3, 0.95);
    EXPECT_LT(std::max(errors.ratioYaw, errors.ratioTilt), 2);
}

TEST(PriorScatter, LetsATagThatIsFarOffKeepItsPhoto) {
    SyntheticSurvey survey = exactTags(grid(7, 5, 5));
    survey.photos[12].positionM.x() += 0.04;
    const Alignment alignment = solved(survey, Model::Position, true);
    const double offM =
        (alignment.photos[12].roomFromPhoto.translation - survey.roomFromPhoto[12].translation).norm();
    EXPECT_LT(offM, 0.012);
}

} // namespace spherewalk::align
