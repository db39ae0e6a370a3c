// SPDX-License-Identifier: GPL-3.0-or-later
#include "pairs/disjoint_sets.h"
#include "pairs/pair_fit.h"
#include "pairs/pair_geometry.h"
#include "random.h"

#include "spherewalk/geometry/rotation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

namespace spherewalk::align {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace {

constexpr double kHalfTurnRad = std::numbers::pi;

double offRad(const Matrix3d& found, const Quaterniond& planted) {
    return angleBetween(Quaterniond(found), planted).value();
}

/// Matches of far things between photos that are turned by the planted rotation. This share is wrong.
Bearings plantedBearings(const Quaterniond& aFromB, int count, double wrongShare, test::Random& random) {
    Bearings bearings;
    for (int i = 0; i < count; ++i) {
        const Vector3d inB = random.direction();
        const bool isWrong = random.uniform(0, 1) < wrongShare;
        bearings.inB.push_back(inB);
        bearings.inA.push_back(isWrong ? random.direction()
                                       : (aFromB * inB + random.vector(0.001)).normalized());
        bearings.sigmaRad.push_back(0.001);
        bearings.match.push_back(i);
    }
    return bearings;
}

/// Normal residuals of this standard deviation, of which a share is replaced by large ones.
std::vector<double> contaminated(double sigma, double wrongShare, test::Random& random) {
    std::vector<double> residuals;
    for (int i = 0; i < 4000; ++i) {
        const bool isWrong = random.uniform(0, 1) < wrongShare;
        residuals.push_back(isWrong ? random.uniform(-100, 100) * sigma : random.normal(sigma));
    }
    return residuals;
}

} // namespace

TEST(Turn, ComesBackFromItsVectorUpToHalfATurn) {
    test::Random random(401);
    SCOPED_TRACE(random.seed());
    for (int i = 0; i < 500; ++i) {
        const double angle = i % 5 == 0 ? kHalfTurnRad - 1e-7 : random.uniform(0, kHalfTurnRad - 1e-6);
        const Vector3d vector = angle * random.direction();
        EXPECT_LT((turnVector(turn(vector)) - vector).norm(), 1e-8) << vector.transpose();
    }
}

TEST(Turn, KeepsTheDigitsOfTinyAngles) {
    test::Random random(402);
    SCOPED_TRACE(random.seed());
    for (double angle = 1e-15; angle < 1e-3; angle *= 7) {
        const Vector3d vector = angle * random.direction();
        EXPECT_LT((turnVector(turn(vector)) - vector).norm(), 1e-9 * angle) << angle;
        EXPECT_NEAR(turn(vector).norm(), 1, 1e-15);
    }
}

TEST(Turn, VectorIsNeverLongerThanHalfATurnWhicheverSignTheQuaternionHas) {
    test::Random random(403);
    SCOPED_TRACE(random.seed());
    for (int i = 0; i < 500; ++i) {
        const Quaterniond rotation = random.rotation();
        const Quaterniond negative(-rotation.coeffs());
        EXPECT_LE(turnVector(rotation).norm(), kHalfTurnRad + 1e-12);
        EXPECT_LT((turnVector(rotation) - turnVector(negative)).norm(), 1e-12);
    }
}

TEST(Turn, FollowsSmallChangesAsItsJacobianSays) {
    test::Random random(404);
    SCOPED_TRACE(random.seed());
    for (const double length : {0.0, 1e-7, 1e-4, 0.3, 2.0, 3.1}) {
        for (int i = 0; i < 20; ++i) {
            const Vector3d vector = length * random.direction();
            const Vector3d change = 1e-5 * random.direction();
            const Vector3d followed = turnVector(turn(vector + change) * turn(vector).conjugate());
            EXPECT_LT((followed - leftJacobian(vector) * change).norm(), 1e-9) << length;
        }
    }
}

TEST(TangentBasis, IsARightHandedFrameWithTheDirection) {
    test::Random random(405);
    SCOPED_TRACE(random.seed());
    for (int i = 0; i < 200; ++i) {
        Matrix3d frame;
        frame.col(2) = random.direction();
        frame.leftCols<2>() = tangentBasis(frame.col(2));
        EXPECT_LT((frame.transpose() * frame - Matrix3d::Identity()).norm(), 1e-12);
        EXPECT_GT(frame.determinant(), 0);
    }
}

TEST(BestRotation, IsThePlantedOneUpToHalfATurn) {
    test::Random random(406);
    SCOPED_TRACE(random.seed());
    for (int i = 0; i < 100; ++i) {
        const Quaterniond planted =
            i % 2 == 0 ? random.rotation() : turn((kHalfTurnRad - 1e-9 * i) * random.direction());
        Matrix3d moment = Matrix3d::Zero();
        for (int k = 0; k < 6; ++k) {
            const Vector3d inB = random.direction();
            moment += (planted * inB) * inB.transpose();
        }
        EXPECT_LT(offRad(bestRotation(moment), planted), 1e-7) << "round " << i;
    }
}

TEST(BestRotation, NeedsNoMoreThanTwoDirections) {
    test::Random random(407);
    SCOPED_TRACE(random.seed());
    for (int i = 0; i < 50; ++i) {
        const Quaterniond planted = random.rotation();
        const Vector3d one = random.direction();
        const Vector3d other = one.unitOrthogonal();
        const Matrix3d moment =
            (planted * one) * one.transpose() + 0.5 * (planted * other) * other.transpose();
        EXPECT_LT(offRad(bestRotation(moment), planted), 1e-7);
    }
}

TEST(BestRotation, IsARotationEvenForTheMomentOfAMirrorImage) {
    test::Random random(408);
    SCOPED_TRACE(random.seed());
    for (int i = 0; i < 100; ++i) {
        Matrix3d moment;
        moment << random.vector(), random.vector(), random.vector();
        const Matrix3d rotation = bestRotation(i == 0 ? Matrix3d(Matrix3d::Zero()) : moment);
        EXPECT_NEAR(rotation.determinant(), 1, 1e-9);
        EXPECT_LT((rotation * rotation.transpose() - Matrix3d::Identity()).norm(), 1e-9);
    }
}

TEST(RotationHypotheses, BeginWithThePlantedRotationThoughHalfOfTheMatchesAreWrong) {
    for (unsigned seed = 410; seed < 420; ++seed) {
        test::Random random(seed);
        const Quaterniond planted =
            seed % 2 == 0 ? random.rotation() : turn((kHalfTurnRad - 1e-4) * random.direction());
        const auto found = rotationHypotheses(plantedBearings(planted, 200, 0.5, random));
        ASSERT_FALSE(found.empty()) << "seed " << seed;
        EXPECT_LT(offRad(found[0].aFromB, planted), 0.03) << "seed " << seed;
    }
}

TEST(RotationHypotheses, DifferByTwelveDegreesAndComeBestFirst) {
    test::Random random(421);
    SCOPED_TRACE(random.seed());
    const auto found = rotationHypotheses(plantedBearings(random.rotation(), 150, 0.8, random));
    for (std::size_t i = 1; i < found.size(); ++i) {
        EXPECT_LE(found[i].score, found[i - 1].score);
        for (std::size_t k = 0; k < i; ++k) {
            EXPECT_GT(offRad(found[i].aFromB, Quaterniond(found[k].aFromB)), 0.2);
        }
    }
}

TEST(RotationHypotheses, OfFewerThanTwoMatchesAreNone) {
    test::Random random(422);
    EXPECT_TRUE(rotationHypotheses({}).empty());
    EXPECT_TRUE(rotationHypotheses(plantedBearings(random.rotation(), 1, 0, random)).empty());
}

TEST(UprightFrom, TakesTheDirectionUpByTheSmallestTurn) {
    test::Random random(423);
    SCOPED_TRACE(random.seed());
    for (int i = 0; i < 300; ++i) {
        const Vector3d up = random.uniform(0.01, 100) * random.direction();
        const Quaterniond upright = uprightFrom(up);
        EXPECT_LT((upright * up.normalized() - Vector3d::UnitZ()).norm(), 1e-7);
        EXPECT_NEAR(turnVector(upright).norm(), angleBetween(up, Vector3d(Vector3d::UnitZ())).value(), 1e-7);
        EXPECT_NEAR(upright.norm(), 1, 1e-9);
    }
}

TEST(UprightFrom, TurnsOverWhatIsUpsideDown) {
    for (const Vector3d& up : {Vector3d(0, 0, -1), Vector3d(1e-9, 0, -1), Vector3d(0, -1e-5, -1)}) {
        EXPECT_LT((uprightFrom(up) * up.normalized() - Vector3d::UnitZ()).norm(), 1e-5) << up.transpose();
    }
}

TEST(AgreeingScale, IsTheStandardDeviationOfTheResidualsThatAgree) {
    for (unsigned seed = 430; seed < 436; ++seed) {
        test::Random random(seed);
        const double sigma = random.uniform(0.5, 5);
        const double share = random.uniform(0, 0.35);
        EXPECT_NEAR(agreeingScale(contaminated(sigma, share, random), 50), sigma, 0.1 * sigma)
            << "seed " << seed << ", wrong " << share;
    }
}

TEST(AgreeingScale, DoesNotSeeSigns) {
    test::Random random(437);
    SCOPED_TRACE(random.seed());
    std::vector<double> residuals = contaminated(2, 0.2, random);
    const double before = agreeingScale(residuals, 50);
    for (double& residual : residuals) {
        residual = -residual;
    }
    EXPECT_EQ(agreeingScale(residuals, 50), before);
}

TEST(AgreeingScale, KeepsWithinItsRange) {
    EXPECT_EQ(agreeingScale(std::vector<double>(100, 0.0), 8), 0.3);
    EXPECT_EQ(agreeingScale(std::vector<double>(100, 1e6), 8), 8);
    EXPECT_EQ(agreeingScale(std::vector<double>(7, 5.0), 8), 1);
    EXPECT_EQ(agreeingScale({}, 8), 1);
}

TEST(UnitMatch, HasUnitBearingsAndASensibleSigma) {
    const auto match = unitMatch({Vector3d(1.5, 0, 0), Vector3d(0, 0, -0.6), 0.002});
    ASSERT_TRUE(match);
    EXPECT_EQ(match->inA, Vector3d(Vector3d::UnitX()));
    EXPECT_EQ(match->inB, Vector3d(-Vector3d::UnitZ()));
    EXPECT_EQ(match->sigmaRad, 0.002);
    for (const double sigmaRad : {0.0, -1.0, 1.0, std::nan(""), HUGE_VAL}) {
        EXPECT_EQ(unitMatch({Vector3d::UnitX(), Vector3d::UnitY(), sigmaRad})->sigmaRad, 0.001) << sigmaRad;
    }
}

TEST(UnitMatch, IsNoneForBearingsThatAreNoDirections) {
    for (const double bad : {0.0, 0.4, 3.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        EXPECT_FALSE(unitMatch({Vector3d(bad, 0, 0), Vector3d::UnitX(), 0.001})) << bad;
        EXPECT_FALSE(unitMatch({Vector3d::UnitX(), Vector3d(0, bad, 0), 0.001})) << bad;
    }
}

TEST(EpipolarResidual, IsZeroForWhatBothPhotosSeeAndOneSigmaForItsNoise) {
    test::Random random(440);
    SCOPED_TRACE(random.seed());
    const Vector3d baseline = random.direction();
    double squares = 0;
    constexpr int kDraws = 4000;
    for (int i = 0; i < kDraws; ++i) {
        const Vector3d fromA = 3 * random.direction();
        const Vector3d inA = fromA.normalized();
        const Vector3d inB = (fromA - 0.3 * baseline).normalized();
        EXPECT_NEAR(epipolarResidual(inA, inB, baseline, 0.001).value, 0, 1e-9);
        const double noisy = epipolarResidual((inA + random.vector(0.001)).normalized(),
                                              (inB + random.vector(0.001)).normalized(), baseline, 0.001)
                                 .value;
        squares += noisy * noisy;
    }
    EXPECT_NEAR(std::sqrt(squares / kDraws), 1, 0.06);
}

TEST(EpipolarResidual, HasItsDerivatives) {
    test::Random random(441);
    SCOPED_TRACE(random.seed());
    constexpr double kStep = 1e-6;
    for (int i = 0; i < 50; ++i) {
        const Vector3d inA = random.direction();
        const Vector3d inB = random.direction();
        const Vector3d baseline = random.direction();
        const EpipolarResidual at = epipolarResidual(inA, inB, baseline, 0.1);
        if (std::min(at.sineA, at.sineB) < kLeastSine) {
            continue;
        }
        for (int axis = 0; axis < 3; ++axis) {
            const Vector3d step = kStep * Vector3d::Unit(axis);
            const auto value = [](const Vector3d& a, const Vector3d& b, const Vector3d& t) {
                return epipolarResidual(a, b, t, 0.1).value;
            };
            const double byA = value(inA + step, inB, baseline) - value(inA - step, inB, baseline);
            const double byB = value(inA, inB + step, baseline) - value(inA, inB - step, baseline);
            const double byT = value(inA, inB, baseline + step) - value(inA, inB, baseline - step);
            EXPECT_NEAR(byA / (2 * kStep), at.byA[axis], 1e-4 * (1 + at.byA.norm()));
            EXPECT_NEAR(byB / (2 * kStep), at.byB[axis], 1e-4 * (1 + at.byB.norm()));
            EXPECT_NEAR(byT / (2 * kStep), at.byBaseline[axis], 1e-4 * (1 + at.byBaseline.norm()));
        }
    }
}

TEST(Parallax, IsPositiveInFrontNegativeBehindAndAboutTheAngle) {
    test::Random random(442);
    SCOPED_TRACE(random.seed());
    for (int i = 0; i < 300; ++i) {
        const Vector3d baseline = random.direction();
        const Vector3d fromA = random.uniform(2, 5) * random.direction();
        const Vector3d inA = fromA.normalized();
        const Vector3d inB = (fromA - 0.02 * baseline).normalized();
        if (inA.cross(baseline).norm() < kLeastSine) {
            continue;
        }
        EXPECT_NEAR(parallaxOf(inA, inB, baseline), angleBetween(inA, inB).value(), 1e-4);
        EXPECT_LT(parallaxOf(Vector3d(-inA), Vector3d(-inB), baseline), 0);
    }
}

TEST(DisjointSets, AreThoseOfRelabellingEverything) {
    test::Random random(443);
    SCOPED_TRACE(random.seed());
    DisjointSets sets(40);
    std::vector<int> label(40);
    std::iota(label.begin(), label.end(), 0);
    for (int i = 0; i < 60; ++i) {
        const int a = random.integer(0, 39);
        const int b = random.integer(0, 39);
        const int name = sets.of(b);
        sets.join(a, b);
        EXPECT_EQ(sets.of(a), name);
        std::replace(label.begin(), label.end(), int{label[static_cast<std::size_t>(a)]},
                     int{label[static_cast<std::size_t>(b)]});
        const int x = random.integer(0, 39);
        const int y = random.integer(0, 39);
        EXPECT_EQ(sets.of(x) == sets.of(y),
                  label[static_cast<std::size_t>(x)] == label[static_cast<std::size_t>(y)]);
    }
}

TEST(DisjointSets, GrowByElementsOfTheirOwn) {
    DisjointSets sets;
    EXPECT_EQ(sets.count(), 0);
    EXPECT_EQ(sets.add(), 0);
    EXPECT_EQ(sets.add(), 1);
    EXPECT_NE(sets.of(0), sets.of(1));
    EXPECT_EQ(sets.count(), 2);
}

} // namespace spherewalk::align
