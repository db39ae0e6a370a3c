// SPDX-License-Identifier: GPL-3.0-or-later
#include "made/synthetic_survey.h"
#include "pairs/pair_geometry.h"
#include "solve/refinement.h"

#include "spherewalk/base/fixed_random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace spherewalk::align {

namespace {

PhotoState moved(PhotoState state, const Eigen::Vector3d& turnRad, const Eigen::Vector3d& byM) {
    state.roomFromPhoto = turn(turnRad) * state.roomFromPhoto;
    state.positionM += byM;
    return state;
}

struct Example {
    UsedPair pair;
    PhotoState a;
    PhotoState b;
};

// Near the truth, not at it.
Example example(int seed, bool isTurn) {
    SyntheticSurveyOptions options;
    options.seed = static_cast<std::uint64_t>(seed);
    options.wrongShare = 0.1;
    options.mostMatches = 40;
    const Eigen::Vector3d offset(0.2, 0.1 * seed, 0.02);
    const SyntheticPair made = syntheticPair(options, offset, turn({0.01, 0.02, 0.3 * seed}));
    Example example;
    example.pair.isTurn = isTurn;
    example.pair.toleranceRad = 0.01;
    example.a.roomFromPhoto = turn({0.1, -0.2, 0.5});
    example.b.roomFromPhoto = turn({0.003, 0.002, -0.004}) * example.a.roomFromPhoto * made.aFromB;
    example.b.positionM = example.a.roomFromPhoto * made.baselineInA + Eigen::Vector3d(0.002, -0.001, 0.003);
    for (const Correspondence& match : made.pair.matches) {
        example.pair.matches.push_back({match.inA, match.inB, match.sigmaRad, 0, 0});
    }
    return example;
}

Eigen::Matrix<double, 9, 1> numericDerivative(const Example& at, const UsedMatch& match, int row) {
    constexpr double kStep = 1e-6;
    Eigen::Matrix<double, 9, 1> by;
    for (int i = 0; i < 9; ++i) {
        double values[2];
        for (int side = 0; side < 2; ++side) {
            Eigen::Matrix<double, 9, 1> change = Eigen::Matrix<double, 9, 1>::Zero();
            change[i] = side == 0 ? -kStep : kStep;
            MatchRow rows[2];
            matchRows(at.pair, match, moved(at.a, change.head<3>(), Eigen::Vector3d::Zero()),
                      moved(at.b, change.segment<3>(3), change.tail<3>()), rows);
            values[side] = rows[row].residual;
        }
        by[i] = (values[1] - values[0]) / (2 * kStep);
    }
    return by;
}

} // namespace

TEST(PairNormal, DerivativesAreThoseOfTheResiduals) {
    for (int seed = 1; seed <= 5; ++seed) {
        for (const bool isTurn : {false, true}) {
            Example at = example(seed, isTurn);
            at.a.lenses.aheadM = 0.01 * (seed - 1);
            at.b.lenses.aheadM = 0.015 * (seed - 1);
            for (const UsedMatch& match : at.pair.matches) {
                MatchRow rows[2];
                const int count = matchRows(at.pair, match, at.a, at.b, rows);
                for (int row = 0; row < count; ++row) {
                    const Eigen::Matrix<double, 9, 1> numeric = numericDerivative(at, match, row);
                    EXPECT_LT((numeric - rows[row].by).norm(), 1e-4 * (1 + numeric.norm()))
                        << "seed " << seed << " turn " << isTurn << "\n"
                        << numeric.transpose() << "\n"
                        << rows[row].by.transpose();
                }
            }
        }
    }
}

TEST(PairNormal, CostIsItsLastEntry) {
    const Example at = example(2, false);
    const PairNormal normal = pairNormal(at.pair, at.a, at.b, 1.3, 4);
    EXPECT_NEAR(normal(9, 9), pairCost(at.pair, at.a, at.b, 1.3, 4), 1e-9 * normal(9, 9));
}

TEST(PairNormal, BoundedResidualHasItsSlope) {
    for (const double residual : {-20.0, -1.0, 0.0, 0.5, 3.0, 40.0}) {
        const double numeric = (bounded(residual + 1e-5, 4).value - bounded(residual - 1e-5, 4).value) / 2e-5;
        EXPECT_NEAR(bounded(residual, 4).slope, numeric, 1e-8);
        EXPECT_LE(std::abs(bounded(residual, 4).value), 4);
    }
}

namespace {

// Two photos on one rail, a third on another.
struct BlockExample {
    Unknowns unknowns;
    std::vector<UsedPair> pairs;
};

BlockExample blockExample() {
    BlockExample made;
    std::vector<PhotoPrior> priors(3);
    const int rails[] = {7, 7, 9};
    std::vector<Eigen::Quaterniond> rotations;
    for (std::size_t i = 0; i < 3; ++i) {
        priors[i].positionM =
            Eigen::Vector3d(1e6 + 0.2 * static_cast<double>(i), 0.1 * static_cast<double>(i * i), 1);
        priors[i].placement = rails[i];
        rotations.push_back(turn({0.1, 0.2, static_cast<double>(i)}));
    }
    made.unknowns = unknowns(std::vector<int>{0, 1, 2}, priors, rotations);
    FixedRandom random(5);
    for (auto* blocks : {&made.unknowns.turn, &made.unknowns.offset, &made.unknowns.placement}) {
        for (Unknowns::Block& block : *blocks) {
            for (double& value : block) {
                value = 0.02 * random.sumNormal();
            }
        }
    }
    for (const auto& [a, b] : {std::pair(0, 1), std::pair(1, 2)}) {
        UsedPair pair = example(3, false).pair;
        pair.a = a;
        pair.b = b;
        made.pairs.push_back(pair);
    }
    return made;
}

} // namespace

TEST(PairBlock, HasTheSquaresAndTheGradientOfAllMatches) {
    for (const Model model : {Model::Tilt, Model::Placement, Model::Position}) {
        BlockExample at = blockExample();
        for (std::size_t i = 0; i < at.pairs.size(); ++i) {
            PairEvaluation evaluation(at.unknowns, at.pairs, 1, 50, 1, {});
            PairBlock block(evaluation, i, at.pairs[i], model);
            const std::vector<double*> parameters = PairBlock::parameters(at.unknowns, at.pairs[i], model);
            ASSERT_EQ(parameters.size(), block.parameter_block_sizes().size());
            Eigen::Matrix<double, 10, 1> residuals;
            std::vector<Eigen::Matrix<double, 10, 3, Eigen::RowMajor>> jacobians(parameters.size());
            std::vector<double*> into;
            for (auto& jacobian : jacobians) {
                into.push_back(jacobian.data());
            }
            evaluation.PrepareForEvaluation(true, true);
            ASSERT_TRUE(block.Evaluate(parameters.data(), residuals.data(), into.data()));
            evaluation.PrepareForEvaluation(false, true);
            EXPECT_NEAR(residuals.squaredNorm(), evaluation.cost(i), 1e-6 * evaluation.cost(i));
            for (std::size_t p = 0; p < parameters.size(); ++p) {
                for (int k = 0; k < 3; ++k) {
                    const double kept = parameters[p][k];
                    double costs[2];
                    for (int side = 0; side < 2; ++side) {
                        parameters[p][k] = kept + (side == 0 ? -1e-6 : 1e-6);
                        evaluation.PrepareForEvaluation(false, true);
                        costs[side] = evaluation.cost(i);
                    }
                    parameters[p][k] = kept;
                    const double numeric = (costs[1] - costs[0]) / 2e-6;
                    const double analytic = 2 * jacobians[p].col(k).dot(residuals);
                    EXPECT_NEAR(numeric, analytic, 1e-4 * (1 + std::abs(numeric)))
                        << "parameter " << p << "," << k << " model " << name(model);
                }
            }
        }
    }
}

TEST(PriorBlocks, DerivativesAreThoseOfTheResiduals) {
    const UprightBlock block(turn({0.1, -0.05, 2}), Eigen::Vector3d(0.02, 0.03, 1).normalized(), 0.01);
    double value[3] = {0.03, -0.02, 0.4};
    double* parameters[] = {value};
    Eigen::Vector2d residuals;
    Eigen::Matrix<double, 2, 3, Eigen::RowMajor> jacobian;
    double* jacobians[] = {jacobian.data()};
    ASSERT_TRUE(block.Evaluate(parameters, residuals.data(), jacobians));
    for (int k = 0; k < 3; ++k) {
        Eigen::Vector2d sides[2];
        const double kept = value[k];
        for (int side = 0; side < 2; ++side) {
            value[k] = kept + (side == 0 ? -1e-6 : 1e-6);
            block.Evaluate(parameters, sides[side].data(), nullptr);
        }
        value[k] = kept;
        EXPECT_LT(((sides[1] - sides[0]) / 2e-6 - jacobian.col(k)).norm(), 1e-5);
    }
}

} // namespace spherewalk::align
