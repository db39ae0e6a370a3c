// SPDX-License-Identifier: GPL-3.0-or-later
#include "made/synthetic_survey.h"
#include "random.h"

#include "spherewalk/align/photo_pair.h"
#include "spherewalk/base/fixed_random.h"
#include "spherewalk/geometry/rotation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <string_view>

namespace spherewalk::align {

namespace {

constexpr double kPairDegree = std::numbers::pi / 180;

Eigen::Quaterniond attitude(double yawDegrees, double pitchDegrees = 0.4, double rollDegrees = -0.6) {
    return rotation({Degrees(yawDegrees), Degrees(pitchDegrees), Degrees(rollDegrees)});
}

double errorOf(const PairEstimate& estimate, const SyntheticPair& made) {
    return angleBetween(estimate.aFromB, made.aFromB).value();
}

SyntheticSurveyOptions seededPairs(int seed) {
    SyntheticSurveyOptions options;
    options.seed = static_cast<std::uint64_t>(seed);
    return options;
}

} // namespace

TEST(PairEstimate, FindsRotationAndBaselineForAnyYaw) {
    for (int seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        const double heading = seed * 2.399;
        const Eigen::Vector3d offset(0.2 * std::cos(heading), 0.2 * std::sin(heading), 0);
        const SyntheticPair made = syntheticPair(seededPairs(seed), offset, attitude(seed * 97.0));
        const PairEstimate estimate = estimatePair(made.pair);
        ASSERT_EQ(estimate.verdict, PairVerdict::Constraint);
        EXPECT_LT(errorOf(estimate, made), 0.1 * kPairDegree);
        ASSERT_TRUE(estimate.baselineInA);
        EXPECT_LT(angleBetween(*estimate.baselineInA, made.baselineInA).value(), 3 * kPairDegree);
        EXPECT_GT(estimate.forwardShare, 0.9);
    }
}

TEST(PairEstimate, SurvivesFourWrongMatchesOutOfFive) {
    for (int seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        SyntheticSurveyOptions options = seededPairs(seed);
        options.wrongShare = 0.8;
        options.repeatedShare = 0.02;
        const SyntheticPair made = syntheticPair(options, {0.3, 0.4, 0}, attitude(seed * 61.0));
        const PairEstimate estimate = estimatePair(made.pair);
        ASSERT_EQ(estimate.verdict, PairVerdict::Constraint);
        EXPECT_LT(errorOf(estimate, made), 0.4 * kPairDegree);
    }
}

TEST(PairEstimate, FindsHalfATurn) {
    for (int seed = 1; seed <= 10; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        SyntheticSurveyOptions options = seededPairs(seed);
        options.hasAnyYaw = false;
        const SyntheticPair made = syntheticPair(options, {0.2, 0, 0}, attitude(180, 0, 0));
        const PairEstimate estimate = estimatePair(made.pair);
        ASSERT_EQ(estimate.verdict, PairVerdict::Constraint);
        EXPECT_LT(errorOf(estimate, made), 0.1 * kPairDegree);
    }
}

TEST(PairEstimate, GivesATurnAndNoBaselineForTwoPhotosAtOnePlace) {
    for (int seed = 1; seed <= 10; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        const SyntheticPair made =
            syntheticPair(seededPairs(seed), Eigen::Vector3d::Zero(), attitude(seed * 40.0, 20, -30));
        const PairEstimate estimate = estimatePair(made.pair);
        ASSERT_EQ(estimate.verdict, PairVerdict::Constraint);
        EXPECT_FALSE(estimate.baselineInA);
        EXPECT_LT(errorOf(estimate, made), 0.03 * kPairDegree);
    }
}

TEST(PairEstimate, SaysHowFarItErrs) {
    double rotationSquares = 0;
    double baselineSquares = 0;
    int count = 0;
    for (int seed = 1; seed <= 40; ++seed) {
        const SyntheticPair made = syntheticPair(seededPairs(seed), {0.2, 0.2, 0}, attitude(seed * 77.0));
        const PairEstimate estimate = estimatePair(made.pair);
        ASSERT_EQ(estimate.verdict, PairVerdict::Constraint) << "seed " << seed;
        const Eigen::AngleAxisd error(estimate.aFromB * made.aFromB.conjugate());
        const Eigen::Vector3d turned = error.angle() * error.axis();
        rotationSquares += turned.dot(estimate.rotationCovariance.inverse() * turned) / 3;
        const double angle = angleBetween(*estimate.baselineInA, made.baselineInA).value();
        baselineSquares += angle * angle / (2 * estimate.baselineSigmaRad * estimate.baselineSigmaRad);
        ++count;
    }
    EXPECT_GT(std::sqrt(rotationSquares / count), 0.7);
    EXPECT_LT(std::sqrt(rotationSquares / count), 1.5);
    EXPECT_GT(std::sqrt(baselineSquares / count), 0.6);
    EXPECT_LT(std::sqrt(baselineSquares / count), 1.6);
}

// All of these lie in planes with the baseline and in front, as matches do that fit by chance.
TEST(PairEstimate, BelievesNoMatchesWhoseNeighboursChangePlaces) {
    for (const double mostM : {1.5, 15.0}) {
        test::Random random(7);
        PhotoPair pair;
        pair.b = 1;
        const Eigen::Quaterniond aFromB = attitude(50);
        for (int i = 0; i < 300; ++i) {
            const Eigen::Vector3d inA = random.direction();
            const double distanceM = 1 / random.uniform(1 / mostM, 1 / 1.3);
            const Eigen::Vector3d fromB = distanceM * inA - Eigen::Vector3d(1, 0.4, 0);
            pair.matches.push_back({inA, aFromB.conjugate() * fromB.normalized(), 1e-3});
        }
        PairOptions options;
        options.reach = Radians(1.5);
        const PairEstimate estimate = estimatePair(pair, options);
        EXPECT_GT(estimate.inlierShare, 0.8);
        EXPECT_LT(angleBetween(estimate.aFromB, aFromB).value(), kPairDegree);
        EXPECT_EQ(estimate.verdict, mostM < 2 ? PairVerdict::Constraint : PairVerdict::NoAgreement) << mostM;
    }
}

TEST(PairEstimate, TakesOfTwoRotationsTheOneThatKeepsWhatIsUp) {
    const SyntheticPair upright = syntheticPair(seededPairs(1), {0.3, 0.2, 0}, attitude(40));
    SyntheticPair both = syntheticPair(seededPairs(2), {0.3, -0.2, 0}, attitude(70, 20, 10));
    const auto half = static_cast<std::ptrdiff_t>(both.pair.matches.size() / 2);
    both.pair.matches.insert(both.pair.matches.end(), upright.pair.matches.begin(),
                             upright.pair.matches.begin() + half * 9 / 5);
    EXPECT_EQ(estimatePair(both.pair).verdict, PairVerdict::NoAgreement);
    PairOptions stated;
    const Eigen::Vector3d upInB = attitude(40).conjugate() * Eigen::Vector3d::UnitZ();
    stated.ups = {{upright.aFromB * upInB, 0.5 * kPairDegree}, {upInB, 0.5 * kPairDegree}};
    const PairEstimate estimate = estimatePair(both.pair, stated);
    EXPECT_EQ(estimate.verdict, PairVerdict::Constraint);
    EXPECT_LT(errorOf(estimate, upright), 0.3 * kPairDegree);
}

// Real photos two metres apart: near things move by 20 degrees and more, and most matches are wrong.
TEST(PairEstimate, FindsRotationsOfLongStepsFromAFewRightMatches) {
    int right = 0;
    for (int seed = 1; seed <= 40; ++seed) {
        SyntheticSurveyOptions options = seededPairs(seed);
        options.wrongShare = 0.65;
        options.mostMatches = 100;
        const Eigen::Vector3d offset(1.5 * std::cos(seed), 1.5 * std::sin(seed), 0);
        const Eigen::Quaterniond roomFromB = attitude(seed * 97.0, seed % 9, -7);
        const SyntheticPair made = syntheticPair(options, offset, roomFromB);
        PairOptions stated;
        // What a photo says of its tilt, a degree off.
        for (const Eigen::Quaterniond& level : {attitude(0, 0.7, 0.7) * roomFromB * made.aFromB.conjugate(),
                                                attitude(0, -0.7, 0.7) * roomFromB}) {
            stated.ups.push_back({level.conjugate() * Eigen::Vector3d::UnitZ(), 1 * kPairDegree});
        }
        const PairEstimate estimate = estimatePair(made.pair, stated);
        right += estimate.verdict == PairVerdict::Constraint && errorOf(estimate, made) < 0.5 * kPairDegree;
    }
    EXPECT_GE(right, 35);
}

TEST(PairEstimate, FollowsSigmasThatAreWrong) {
    for (const double factor : {0.4, 2.5}) {
        double squares = 0;
        for (int seed = 1; seed <= 20; ++seed) {
            SyntheticPair made = syntheticPair(seededPairs(seed), {0.2, 0.2, 0}, attitude(seed * 77.0));
            for (Correspondence& match : made.pair.matches) {
                match.sigmaRad *= factor;
            }
            const PairEstimate estimate = estimatePair(made.pair);
            ASSERT_EQ(estimate.verdict, PairVerdict::Constraint) << "seed " << seed;
            const Eigen::AngleAxisd error(estimate.aFromB * made.aFromB.conjugate());
            const Eigen::Vector3d turned = error.angle() * error.axis();
            squares += turned.dot(estimate.rotationCovariance.inverse() * turned) / 3 / 20;
        }
        EXPECT_GT(std::sqrt(squares), 0.6) << factor;
        EXPECT_LT(std::sqrt(squares), 1.6) << factor;
    }
}

TEST(PairEstimate, RefusesAMirrorImage) {
    for (int seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        SyntheticPair made =
            syntheticPair(seededPairs(seed), {seed % 2 * 0.2, 0.2, 0}, attitude(seed * 50.0));
        for (Correspondence& match : made.pair.matches) {
            match.inB.y() = -match.inB.y();
        }
        const PairEstimate estimate = estimatePair(made.pair);
        EXPECT_NE(estimate.verdict, PairVerdict::Constraint)
            << estimate.inliers << " of " << made.pair.matches.size() << ", in front "
            << estimate.forwardShare << ", spread " << estimate.spread;
    }
}

TEST(PairEstimate, RefusesMatchesByChance) {
    for (int seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        SyntheticSurveyOptions options = seededPairs(seed);
        options.wrongShare = 1;
        options.points = 6000;
        options.mostMatches = 40 * seed;
        const SyntheticPair made = syntheticPair(options, {0.2, 0, 0}, attitude(seed * 50.0));
        const PairVerdict verdict = estimatePair(made.pair).verdict;
        EXPECT_TRUE(verdict == PairVerdict::TooFew || verdict == PairVerdict::NoAgreement) << name(verdict);
    }
}

TEST(PairEstimate, RefusesWhatLiesInOneDirection) {
    for (int seed = 1; seed <= 10; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        SyntheticSurveyOptions options = seededPairs(seed);
        options.points = 60000;
        options.mostMatches = 30000;
        options.wrongShare = 0.05;
        SyntheticPair made = syntheticPair(options, {0.2, 0, 0}, attitude(seed * 50.0));
        const Eigen::Vector3d axis = made.pair.matches.front().inA;
        std::erase_if(made.pair.matches,
                      [&](const Correspondence& match) { return match.inA.dot(axis) < std::cos(0.12); });
        ASSERT_GT(made.pair.matches.size(), 20U);
        const PairEstimate estimate = estimatePair(made.pair);
        EXPECT_EQ(estimate.verdict, PairVerdict::TooNarrow) << name(estimate.verdict);
    }
}

TEST(PairEstimate, RefusesARoomThatLooksTheSameTurnedAround) {
    // Every second match belongs to the point on the opposite side.
    SyntheticPair made = syntheticPair(seededPairs(3), {0.05, 0, 0}, attitude(0, 0, 0));
    const Eigen::Quaterniond around = yawRotation(Degrees(180));
    for (std::size_t i = 0; i < made.pair.matches.size(); i += 2) {
        made.pair.matches[i].inB = around * made.pair.matches[i].inB;
    }
    EXPECT_EQ(estimatePair(made.pair).verdict, PairVerdict::NoAgreement);
}

TEST(PairEstimate, LeavesOutMatchesThatAreNoDirections) {
    SyntheticPair made = syntheticPair(seededPairs(4), {0.2, 0, 0}, attitude(130));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    made.pair.matches[0].inA.x() = nan;
    made.pair.matches[1].inB = Eigen::Vector3d::Zero();
    made.pair.matches[2].sigmaRad = nan;
    made.pair.matches[3].sigmaRad = 0;
    made.pair.matches[4].inB *= std::numeric_limits<double>::infinity();
    const PairEstimate estimate = estimatePair(made.pair);
    ASSERT_EQ(estimate.verdict, PairVerdict::Constraint);
    EXPECT_LT(errorOf(estimate, made), 0.1 * kPairDegree);
    EXPECT_FALSE(estimate.isInlier[0]);
    EXPECT_FALSE(estimate.isInlier[1]);
}

TEST(PairEstimate, SaysTooFewForNothing) {
    EXPECT_EQ(estimatePair({}).verdict, PairVerdict::TooFew);
}

TEST(PairEstimate, IsTheSameForAnyNumberOfThreads) {
    std::vector<PhotoPair> pairs;
    for (int seed = 1; seed <= 9; ++seed) {
        pairs.push_back(syntheticPair(seededPairs(seed), {0.2, 0.1, 0}, attitude(seed * 10.0)).pair);
    }
    PairOptions one;
    one.threads = 1;
    PairOptions two;
    two.threads = 2;
    const std::vector<PairEstimate> first = estimatePairs(pairs, one);
    const std::vector<PairEstimate> second = estimatePairs(pairs, two);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        EXPECT_EQ(first[i].aFromB.coeffs(), second[i].aFromB.coeffs());
        EXPECT_EQ(first[i].inliers, second[i].inliers);
    }
}

TEST(PairVerdict, NamesDiffer) {
    const std::set<std::string_view> names = {name(PairVerdict::Constraint), name(PairVerdict::TooFew),
                                              name(PairVerdict::TooNarrow), name(PairVerdict::NoAgreement)};
    EXPECT_EQ(names.size(), 4U);
}

} // namespace spherewalk::align
