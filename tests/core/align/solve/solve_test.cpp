// SPDX-License-Identifier: GPL-3.0-or-later
#include "made/survey_truth.h"
#include "made/synthetic_survey.h"

#include "spherewalk/align/solve.h"
#include "spherewalk/base/error.h"
#include "spherewalk/geometry/rotation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace spherewalk::align {

namespace {

constexpr double kDegree = std::numbers::pi / 180;

SyntheticSurveyOptions seeded(int seed) {
    SyntheticSurveyOptions options;
    options.seed = static_cast<std::uint64_t>(seed);
    options.mostMatches = 300;
    return options;
}

SyntheticSurveyOptions small(int seed) {
    SyntheticSurveyOptions options = seeded(seed);
    options.columns = 3;
    options.rows = 3;
    return options;
}

SolveOptions with(Model model) {
    SolveOptions options;
    options.model = model;
    options.threads = 2;
    return options;
}

std::string sentenceOf(const SyntheticSurvey& survey, const SolveOptions& options = {}) {
    try {
        solveSurvey(survey, options);
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::InvalidInput);
        return error.sentence();
    }
    return {};
}

} // namespace

TEST(Solve, FindsEveryRotationToAHundredthOfADegree) {
    for (int seed = 1; seed <= 3; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        const SyntheticSurvey survey = syntheticSurvey(seeded(seed));
        const Alignment alignment = solveSurvey(survey, with(Model::Position));
        const SurveyErrors errors = errorsOf(alignment, survey.roomFromPhoto);
        EXPECT_EQ(errors.solved, 25);
        EXPECT_LT(errors.yawRms, 0.012 * kDegree);
        EXPECT_LT(errors.yawWorst, 0.035 * kDegree);
        EXPECT_LT(errors.tiltApartRms, 0.01 * kDegree);
        EXPECT_LT(errors.tiltRms, 0.1 * kDegree); // all together they lean as heights and priors leave it
        EXPECT_LT(std::abs(errors.commonYaw), 4 * alignment.sigmaCommonYaw.value());
        EXPECT_LT(std::abs(errors.commonYaw), 0.6 * kDegree);
    }
}

TEST(Solve, SaysHowFarItErrs) {
    double yawSquares = 0;
    double tiltSquares = 0;
    double within = 0;
    constexpr int kSeeds = 6;
    for (int seed = 1; seed <= kSeeds; ++seed) {
        const SyntheticSurvey survey = syntheticSurvey(small(seed));
        const SurveyErrors errors =
            errorsOf(solveSurvey(survey, with(Model::Position)), survey.roomFromPhoto);
        yawSquares += errors.ratioYaw * errors.ratioYaw / kSeeds;
        tiltSquares += errors.ratioTilt * errors.ratioTilt / kSeeds;
        within += errors.within3 / kSeeds;
    }
    EXPECT_GT(std::sqrt(yawSquares), 0.5);
    EXPECT_LT(std::sqrt(yawSquares), 2);
    EXPECT_GT(std::sqrt(tiltSquares), 0.5);
    EXPECT_LT(std::sqrt(tiltSquares), 2);
    EXPECT_GE(within, 0.95);
}

namespace {

/// How far the photos' places err among each other, over what the solution says: the root mean square. What
/// all are moved, turned and scaled by together is fitted and taken off.
double ownPlaceRatio(const Alignment& alignment, const std::vector<Rigid3>& truth) {
    const auto count = static_cast<Eigen::Index>(truth.size());
    Eigen::Vector3d middleM = Eigen::Vector3d::Zero();
    for (const Rigid3& pose : truth) {
        middleM += pose.translation / static_cast<double>(count);
    }
    Eigen::MatrixXd together = Eigen::MatrixXd::Zero(3 * count, 7);
    Eigen::VectorXd moves(3 * count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const Eigen::Vector3d placeM = truth[at].translation - middleM;
        moves.segment<3>(3 * i) = alignment.photos[at].roomFromPhoto.translation - truth[at].translation;
        together.block<3, 3>(3 * i, 0).setIdentity();
        for (int axis = 0; axis < 3; ++axis) {
            together.block<3, 1>(3 * i, 3 + axis) = Eigen::Vector3d::Unit(axis).cross(placeM);
        }
        together.block<3, 1>(3 * i, 6) = placeM;
    }
    moves -= together * together.colPivHouseholderQr().solve(moves);
    double squares = 0;
    for (Eigen::Index i = 0; i < count; ++i) {
        const double sigmaM = alignment.photos[static_cast<std::size_t>(i)].sigmaOwnPositionM;
        squares += (moves.segment<3>(3 * i) / sigmaM).squaredNorm() / (3.0 * static_cast<double>(count));
    }
    return std::sqrt(squares);
}

} // namespace

TEST(Solve, SaysHowFarAPhotoErrsAmongTheOthers) {
    double squares = 0;
    constexpr int kSeeds = 6;
    for (int seed = 1; seed <= kSeeds; ++seed) {
        const SyntheticSurvey survey = syntheticSurvey(small(seed));
        const Alignment alignment = solveSurvey(survey, with(Model::Position));
        const double ratio = ownPlaceRatio(alignment, survey.roomFromPhoto);
        squares += ratio * ratio / kSeeds;
        for (const SolvedPose& pose : alignment.photos) {
            EXPECT_GT(pose.sigmaOwnPositionM, 0);
            EXPECT_LT(pose.sigmaOwnPositionM, 0.5 * pose.sigmaPositionM);
        }
    }
    EXPECT_GT(std::sqrt(squares), 0.5);
    EXPECT_LT(std::sqrt(squares), 2);
}

TEST(Solve, ChoosesTheModelThatTheMatchesSupport) {
    SyntheticSurveyOptions exact = small(2);
    exact.positionSigmaM = 0;
    exact.heightSigmaM = 0;
    const SyntheticSurvey still = syntheticSurvey(exact);
    const Alignment tilted = solveSurvey(still, with(Model::Auto));
    EXPECT_EQ(tilted.model, Model::Tilt) << tilted.reason;
    EXPECT_EQ(tilted.trials.size(), 4U);
    EXPECT_THAT(tilted.reason, testing::HasSubstr("degrees"));

    const SyntheticSurvey moved = syntheticSurvey(small(2));
    EXPECT_EQ(solveSurvey(moved, with(Model::Auto)).model, Model::Position);
}

TEST(Solve, SolvesEveryModelOfItsLadder) {
    SyntheticSurveyOptions options = small(5);
    options.tiltSigma = Degrees(0.02);
    options.positionSigmaM = 0.0003;
    options.heightSigmaM = 0.0003;
    const SyntheticSurvey survey = syntheticSurvey(options);
    for (const Model model : {Model::Yaw, Model::Tilt, Model::Placement, Model::Position}) {
        SCOPED_TRACE(name(model));
        const Alignment alignment = solveSurvey(survey, with(model));
        EXPECT_EQ(alignment.model, model);
        const SurveyErrors errors = errorsOf(alignment, survey.roomFromPhoto);
        EXPECT_LT(errors.yawRms, 0.03 * kDegree);
        EXPECT_GE(errors.within3, 0.9);
    }
}

TEST(Solve, FollowsRailsThatLayAskew) {
    SyntheticSurveyOptions options = seeded(4);
    options.rows = 3;
    options.placementSigmaM = 0.01;
    options.placementSigma = Degrees(1);
    options.positionSigmaM = 0.0005;
    options.heightSigmaM = 0.0005;
    const SyntheticSurvey survey = syntheticSurvey(options);
    const SurveyErrors errors = errorsOf(solveSurvey(survey, with(Model::Placement)), survey.roomFromPhoto);
    EXPECT_LT(errors.yawRms, 0.05 * kDegree);
}

TEST(Solve, SurvivesFourWrongMatchesOutOfFive) {
    SyntheticSurveyOptions options = small(6);
    options.wrongShare = 0.8;
    options.mostMatches = 1000;
    const SyntheticSurvey survey = syntheticSurvey(options);
    const SurveyErrors errors = errorsOf(solveSurvey(survey, with(Model::Position)), survey.roomFromPhoto);
    EXPECT_EQ(errors.solved, 9);
    EXPECT_LT(errors.yawRms, 0.03 * kDegree);
}

TEST(Solve, SurvivesARepeatedPattern) {
    SyntheticSurveyOptions options = small(20);
    options.repeatedShare = 0.4;
    const SyntheticSurvey survey = syntheticSurvey(options);
    const SurveyErrors errors = errorsOf(solveSurvey(survey, with(Model::Position)), survey.roomFromPhoto);
    EXPECT_EQ(errors.solved, 9);
    EXPECT_LT(errors.yawRms, 0.03 * kDegree);
}

TEST(Solve, LeavesOutAMirrorImage) {
    SyntheticSurvey survey = syntheticSurvey(small(21));
    for (PhotoPair& pair : survey.pairs) {
        for (Correspondence& match : pair.matches) {
            if (pair.a == 4) {
                match.inA.y() = -match.inA.y();
            } else if (pair.b == 4) {
                match.inB.y() = -match.inB.y();
            }
        }
    }
    const Alignment alignment = solveSurvey(survey, with(Model::Position));
    EXPECT_FALSE(alignment.photos[4].isSolved);
    EXPECT_FALSE(alignment.photos[4].why.empty());
    EXPECT_LT(errorsOf(alignment, survey.roomFromPhoto).yawWorst, 0.06 * kDegree);
}

TEST(Solve, SurvivesPairsThatAreWrong) {
    const SyntheticSurvey survey = syntheticSurvey(seeded(7));
    std::vector<PairEstimate> estimates = estimatePairs(survey.pairs);
    for (std::size_t i = 0; i < estimates.size(); i += 7) { // every seventh turned by half
        estimates[i].aFromB = estimates[i].aFromB * yawRotation(Degrees(180));
    }
    const Alignment alignment =
        solve(survey.photos, survey.pairs, estimates, with(Model::Position), noProgress(), {});
    EXPECT_LT(errorsOf(alignment, survey.roomFromPhoto).yawWorst, 0.04 * kDegree);
}

TEST(Solve, NeedsNoLargeCoordinates) {
    SyntheticSurveyOptions options = small(8);
    const Alignment near = solveSurvey(syntheticSurvey(options), with(Model::Position));
    options.originM = {1e6, -1e6, 100};
    const SyntheticSurvey survey = syntheticSurvey(options);
    const Alignment far = solveSurvey(survey, with(Model::Position));
    for (std::size_t i = 0; i < near.photos.size(); ++i) {
        const double apart =
            angleBetween(near.photos[i].roomFromPhoto.rotation, far.photos[i].roomFromPhoto.rotation).value();
        EXPECT_LT(apart, 1e-4 * kDegree);
        const Eigen::Vector3d moved =
            far.photos[i].roomFromPhoto.translation - near.photos[i].roomFromPhoto.translation;
        EXPECT_LT((moved - options.originM).norm(), 1e-6);
    }
}

TEST(Solve, FixesTheHeadingOfPhotosOnOneLine) {
    for (int seed = 1; seed <= 3; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        SyntheticSurveyOptions options = seeded(seed);
        options.rows = 1;
        options.columns = 6;
        const SyntheticSurvey survey = syntheticSurvey(options);
        const SurveyErrors errors =
            errorsOf(solveSurvey(survey, with(Model::Position)), survey.roomFromPhoto);
        EXPECT_EQ(errors.solved, 6);
        EXPECT_LT(errors.yawRms, 0.03 * kDegree);
        EXPECT_LT(std::abs(errors.commonYaw), 1.5 * kDegree);
        EXPECT_LT(errors.tiltRms, 0.6 * kDegree); // the roll about the line is as good as the priors
        EXPECT_GE(errors.within3, 0.9);
    }
}

TEST(Solve, SolvesTwoPhotosAtOnePlaceButNotTheirHeading) {
    SyntheticSurveyOptions options = seeded(9);
    options.columns = 2;
    options.rows = 1;
    options.stepM = 0;
    options.positionSigmaM = 0;
    options.heightSigmaM = 0;
    const SyntheticSurvey survey = syntheticSurvey(options);
    const Alignment alignment = solveSurvey(survey);
    ASSERT_TRUE(alignment.photos[0].isSolved);
    ASSERT_TRUE(alignment.photos[1].isSolved);
    EXPECT_LT(errorsOf(alignment, survey.roomFromPhoto).yawRms, 0.02 * kDegree);
    EXPECT_GT(alignment.sigmaCommonYaw.value(), 1);
    EXPECT_THAT(alignment.warnings, testing::Contains(testing::HasSubstr("common heading")));
}

TEST(Solve, SolvesTwoPhotosApart) {
    SyntheticSurveyOptions options = seeded(10);
    options.columns = 2;
    options.rows = 1;
    const SyntheticSurvey survey = syntheticSurvey(options);
    const Alignment alignment = solveSurvey(survey);
    const SurveyErrors errors = errorsOf(alignment, survey.roomFromPhoto);
    EXPECT_EQ(errors.solved, 2);
    EXPECT_LT(errors.yawRms, 0.05 * kDegree);
}

TEST(Solve, LeavesOnePhotoUnsolved) {
    SyntheticSurveyOptions options = seeded(11);
    options.columns = 1;
    options.rows = 1;
    const Alignment alignment = solveSurvey(syntheticSurvey(options));
    EXPECT_FALSE(alignment.photos[0].isSolved);
    EXPECT_EQ(alignment.photos[0].why, "There is no other photo to compare it with.");
}

TEST(Solve, SolvesNothingFromNothing) {
    EXPECT_TRUE(solve({}, {}, {}, {}, noProgress(), {}).photos.empty());
}

TEST(Solve, SolvesEachPartOfASurveyInTwoParts) {
    SyntheticSurveyOptions options = seeded(12);
    const SyntheticSurvey whole = syntheticSurvey(options);
    const auto part = [](int photo) { return photo % 5 < 3; };
    const SyntheticSurvey survey =
        withPairs(whole, [&](const PhotoPair& pair) { return part(pair.a) == part(pair.b); });
    const Alignment alignment = solveSurvey(survey, with(Model::Position));
    EXPECT_EQ(alignment.components, 2);
    EXPECT_EQ(alignment.photos[0].component, 0);
    EXPECT_EQ(alignment.photos[4].component, 1);
    for (const int component : {0, 1}) {
        const SurveyErrors errors = errorsOf(alignment, survey.roomFromPhoto, component);
        EXPECT_EQ(errors.solved, component == 0 ? 15 : 10);
        EXPECT_LT(errors.yawRms, 0.03 * kDegree);
    }
    EXPECT_THAT(alignment.warnings, testing::Contains(testing::HasSubstr("2 parts")));
}

TEST(Solve, NamesAPhotoThatNothingHolds) {
    const SyntheticSurvey whole = syntheticSurvey(small(13));
    const SyntheticSurvey survey =
        withPairs(whole, [](const PhotoPair& pair) { return pair.a != 4 && pair.b != 4; });
    const Alignment alignment = solveSurvey(survey, with(Model::Position));
    EXPECT_FALSE(alignment.photos[4].isSolved);
    EXPECT_EQ(alignment.photos[4].why, "It was compared with no other photo.");
    EXPECT_EQ(errorsOf(alignment, survey.roomFromPhoto).solved, 8);
}

TEST(Solve, IsNotBentByTwoPhotosThatWereSwapped) {
    SyntheticSurvey survey = syntheticSurvey(seeded(14));
    std::swap(survey.photos[7].positionM, survey.photos[8].positionM);
    const Alignment alignment = solveSurvey(survey, with(Model::Position));
    SurveyErrors errors = errorsOf(alignment, survey.roomFromPhoto);
    int good = 0;
    for (const double yaw : errors.yaw) {
        good += std::abs(yaw) < 0.1 * kDegree ? 1 : 0;
    }
    EXPECT_GE(good, 20);
}

TEST(Solve, RefusesNumbersThatAreNone) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const SyntheticSurvey good = syntheticSurvey(small(15));
    SyntheticSurvey survey = good;
    survey.photos[3].positionM.y() = nan;
    EXPECT_THAT(sentenceOf(survey), testing::HasSubstr("photo 4"));
    survey = good;
    survey.photos[2].levelFromPhoto->x() = nan;
    EXPECT_THAT(sentenceOf(survey), testing::HasSubstr("photo 3"));
    survey = good;
    survey.photos[1].positionSigmaM = -1;
    EXPECT_THAT(sentenceOf(survey), testing::HasSubstr("photo 2"));
    survey = good;
    survey.pairs[0].b = 99;
    EXPECT_THAT(sentenceOf(survey), testing::HasSubstr("99"));
    SolveOptions options;
    options.heldOutShare = nan;
    EXPECT_THAT(sentenceOf(good, options), testing::HasSubstr("held-out"));
}

TEST(Solve, IsTheSameForAnyNumberOfThreads) {
    const SyntheticSurvey survey = syntheticSurvey(small(16));
    SolveOptions options = with(Model::Position);
    options.threads = 1;
    const Alignment first = solveSurvey(survey, options);
    options.threads = 2;
    const Alignment second = solveSurvey(survey, options);
    for (std::size_t i = 0; i < first.photos.size(); ++i) {
        EXPECT_EQ(first.photos[i].roomFromPhoto.rotation.coeffs(),
                  second.photos[i].roomFromPhoto.rotation.coeffs());
        EXPECT_EQ(first.photos[i].sigmaYaw, second.photos[i].sigmaYaw);
    }
}

TEST(Solve, StopsWhenAsked) {
    // Asked at the first sign of progress: the stop comes while it solves.
    class StopAtOnce : public ProgressSink {
      public:
        explicit StopAtOnce(std::stop_source& source) : m_source(source) {}

        void progress(double fraction, std::string_view) override {
            if (fraction > 0.1) {
                m_source.request_stop();
            }
        }

        void warning(std::string_view) override {}

      private:
        std::stop_source& m_source;
    };

    const SyntheticSurvey survey = syntheticSurvey(small(17));
    const std::vector<PairEstimate> estimates = estimatePairs(survey.pairs);
    std::stop_source source;
    StopAtOnce sink(source);
    try {
        solve(survey.photos, survey.pairs, estimates, {}, sink, source.get_token());
        FAIL() << "it went on";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::Stopped);
    }
}

TEST(Solve, TurnsUprightWhatIsTilted) {
    SyntheticSurvey survey = syntheticSurvey(small(18));
    // Cameras that hung askew and say so: the same pictures, turned.
    const Eigen::Quaterniond askew = rotation({Degrees(10), Degrees(25), Degrees(-40)});
    for (PhotoPrior& photo : survey.photos) {
        photo.levelFromPhoto = askew;
    }
    for (Rigid3& truth : survey.roomFromPhoto) {
        truth.rotation = truth.rotation * askew;
    }
    for (PhotoPair& pair : survey.pairs) {
        for (Correspondence& match : pair.matches) {
            match.inA = askew.conjugate() * match.inA;
            match.inB = askew.conjugate() * match.inB;
        }
    }
    const SurveyErrors errors = errorsOf(solveSurvey(survey, with(Model::Position)), survey.roomFromPhoto);
    EXPECT_LT(errors.yawRms, 0.1 * kDegree);
    EXPECT_LT(errors.tiltRms, 0.2 * kDegree);
    EXPECT_GE(errors.within3, 0.9);
}

TEST(Solve, FindsHowFarTheLensesStandApart) {
    for (const double aheadM : {0.01, -0.02, 0.0}) {
        SCOPED_TRACE(aheadM);
        SyntheticSurveyOptions options = small(19);
        options.stepM = 0.6;
        options.reachM = 1.3;
        options.lensAheadM = aheadM;
        const SyntheticSurvey survey = syntheticSurvey(options);
        const Alignment alignment = solveSurvey(survey);
        const SurveyErrors errors = errorsOf(alignment, survey.roomFromPhoto);
        EXPECT_LT(errors.yawRms, 0.03 * kDegree);
        EXPECT_LT(errors.ratioYaw, 2);
        for (const SolvedPose& photo : alignment.photos) {
            EXPECT_NEAR(photo.lenses.aheadM, aheadM, 5e-4);
            EXPECT_LT(photo.lensSigmaM, 1e-3); // known, also where the lenses are one
            EXPECT_LT(std::abs(photo.lenses.aheadM - aheadM), 4 * photo.lensSigmaM);
        }
    }
}

} // namespace spherewalk::align
