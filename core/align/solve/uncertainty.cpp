// SPDX-License-Identifier: GPL-3.0-or-later
#include "graph/pose_graph.h"
#include "pairs/pair_geometry.h"
#include "solve/normal_equations.h"
#include "solve/solution_report.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/fixed_random.h"
#include "spherewalk/base/statistics.h"
#include "spherewalk/geometry/rotation.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace spherewalk::align {

namespace {

using Matrix9d = Eigen::Matrix<double, 9, 9>;
using Draws = Eigen::MatrixXd;

Draws normalDraws(Eigen::Index rows, FixedRandom& random) {
    Draws draws(rows, kBootstrapDraws);
    for (Eigen::Index column = 0; column < kBootstrapDraws; ++column) {
        for (Eigen::Index row = 0; row < rows; ++row) {
            draws(row, column) = random.sumNormal();
        }
    }
    return draws;
}

// Random errors of every photo's tilt and position, as far as the model does not solve them.
ErrorDraws unsolved(const Unknowns& unknowns, std::span<const PhotoPrior> priors, Model model) {
    const auto count = static_cast<Eigen::Index>(unknowns.photo.size());
    ErrorDraws made{Draws::Zero(3 * count, kBootstrapDraws), Draws::Zero(3 * count, kBootstrapDraws)};
    FixedRandom random(0x5EED0003);
    for (Eigen::Index i = 0; i < count; ++i) {
        const PhotoPrior& prior =
            priors[static_cast<std::size_t>(unknowns.photo[static_cast<std::size_t>(i)])];
        if (!solvesTilt(model)) {
            made.turn.middleRows(3 * i, 2) = knownUp(prior).sigmaRad * normalDraws(2, random);
        }
        if (!solvesPosition(model)) {
            made.position.middleRows(3 * i, 3) = offsetSigmasM(prior).asDiagonal() * normalDraws(3, random);
        }
    }
    return made;
}

// The scores of a pair's matches, and how they change with the pair's nine numbers.
struct PairScores {
    Matrix9d matrix = Matrix9d::Zero();
    Eigen::Matrix<double, 9, Eigen::Dynamic> scores;
    std::vector<int> track;
};

// The derivative of a score by its residual: less than 1 for a residual that the norm bounds. Matches of what
// is near, or of blurred photos, miss by more, and hold their photos less than their number says. What would
// be negative counts as 0, so that the normal matrix stays definite.
double scoreSlope(double residual, double width) {
    const double ratio = residual * residual / (width * width);
    return std::max(0.0, (1 - 3 * ratio) / ((1 + ratio) * (1 + ratio) * (1 + ratio)));
}

PairScores scoresOf(const UsedPair& pair, std::span<const PhotoState> states,
                    const RefinementOptions& options) {
    PairScores made;
    made.scores.resize(9, static_cast<Eigen::Index>(2 * pair.matches.size()));
    Eigen::Index count = 0;
    forEachRow(pair, states, [&](const UsedMatch& match, const MatchRow& row) {
        const double residual = row.residual / options.scale;
        const Bounded robust = bounded(residual, options.width);
        made.scores.col(count++) =
            (robust.value * robust.slope / options.scale / (1 - match.leverage)) * row.by;
        const double slope = scoreSlope(residual, options.width) / (options.scale * options.scale);
        made.matrix += slope * row.by * row.by.transpose();
        made.track.push_back(match.track);
    });
    made.scores.conservativeResize(9, count);
    return made;
}

// One sign for each row and draw, equal within a track.
Draws signs(const std::vector<int>& track) {
    Draws made(static_cast<Eigen::Index>(track.size()), kBootstrapDraws);
    for (std::size_t row = 0; row < track.size(); ++row) {
        FixedRandom random(0x51604ULL + static_cast<std::uint64_t>(track[row]) * 0x9E3779B97F4A7C15ULL);
        std::uint64_t bits = 0;
        for (int column = 0; column < kBootstrapDraws; ++column) {
            if (column % 64 == 0) {
                bits = random.next();
            }
            made(static_cast<Eigen::Index>(row), column) = (bits >> (column % 64)) & 1 ? 1 : -1;
        }
    }
    return made;
}

// The ratio of the offsets found to their priors' deviations along each axis; 1 where there are not enough of
// them to tell.
Eigen::Vector3d offsetFactors(const Unknowns& unknowns, std::span<const PhotoPrior> priors, Model model) {
    const Eigen::Vector3d freedom = offsetFreedom(unknowns);
    if (!solvesPosition(model)) {
        return Eigen::Vector3d::Ones();
    }
    Eigen::Vector3d squares = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < unknowns.photo.size(); ++i) {
        const Eigen::Map<const Eigen::Vector3d> offset(unknowns.offset[i].data());
        const Eigen::Vector3d sigmas = offsetSigmasM(priors[static_cast<std::size_t>(unknowns.photo[i])]);
        squares += offset.cwiseQuotient(sigmas).cwiseAbs2();
    }
    Eigen::Vector3d factors = Eigen::Vector3d::Ones();
    for (int axis = 0; axis < 3; ++axis) {
        if (freedom[axis] >= 5) {
            factors[axis] = std::clamp(std::sqrt(squares[axis] / freedom[axis]), 0.2, 3.0);
        }
    }
    return factors;
}

void addPriors(std::span<const PriorRow> rows, const Eigen::Vector3d& factors, Draws& right) {
    FixedRandom random(0x5EED0004);
    for (const PriorRow& row : rows) {
        const double factor = row.offsetAxis ? factors[static_cast<Eigen::Index>(*row.offsetAxis)] : 1;
        const Draws error = factor * normalDraws(1, random);
        for (std::size_t i = 0; i < row.column.size(); ++i) {
            right.row(row.column[i]) += row.by[i] * error;
        }
    }
}

struct Equations {
    Eigen::SparseMatrix<double> matrix;
    Draws right;
};

Equations equations(const Columns& columns, const Unknowns& unknowns, std::span<const PhotoPrior> priors,
                    std::span<const UsedPair> pairs, const RefinementOptions& options,
                    const ErrorDraws& errors, const std::stop_token& stop) {
    const std::vector<PhotoState> states = unknowns.states();
    Draws right = Draws::Zero(columns.count(), kBootstrapDraws);
    std::vector<Matrix9d> matrices;
    for (const UsedPair& pair : pairs) {
        throwIfStopped(stop);
        const PairScores scores = scoresOf(pair, states, options);
        const Eigen::Matrix<double, 9, Eigen::Dynamic> sums = scores.scores * signs(scores.track);
        Eigen::Matrix<double, 9, Eigen::Dynamic> moved(9, kBootstrapDraws);
        moved.topRows<3>() = errors.turn.middleRows<3>(3 * pair.a);
        moved.middleRows<3>(3) = errors.turn.middleRows<3>(3 * pair.b);
        moved.bottomRows<3>() =
            errors.position.middleRows<3>(3 * pair.b) - errors.position.middleRows<3>(3 * pair.a);
        const PairColumns at = pairColumns(columns, unknowns, pair);
        const Draws scattered = at.chain * (sums + scores.matrix * moved);
        for (std::size_t row = 0; row < at.column.size(); ++row) {
            right.row(at.column[row]) += scattered.row(static_cast<Eigen::Index>(row));
        }
        matrices.push_back(scores.matrix);
    }
    const std::vector<PriorRow> rows = priorRows(columns, unknowns, priors, options);
    addPriors(rows, offsetFactors(unknowns, priors, options.model), right);
    return {normalMatrix(columns, unknowns, pairs, matrices, rows), std::move(right)};
}

} // namespace

ErrorDraws errorDraws(const Unknowns& unknowns, std::span<const PhotoPrior> priors,
                      std::span<const UsedPair> pairs, const RefinementOptions& options,
                      const std::stop_token& stop) {
    const Columns columns(unknowns, options.model);
    const ErrorDraws errors = unsolved(unknowns, priors, options.model);
    const Equations system = equations(columns, unknowns, priors, pairs, options, errors, stop);
    throwIfStopped(stop);
    const std::optional<Eigen::MatrixXd> solution = solvedSparse(system.matrix, system.right);
    if (!solution) {
        throw Error(ErrorKind::Internal,
                    "The uncertainty of the alignment could not be computed. Please report it.");
    }
    const Draws& solved = *solution;
    const auto count = unknowns.photo.size();
    ErrorDraws made{errors.turn, errors.position};
    for (std::size_t i = 0; i < count; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            const auto row = static_cast<Eigen::Index>(3 * i) + axis;
            if (const int column = columns.turn(i)[static_cast<std::size_t>(axis)]; column >= 0) {
                made.turn.row(row) = solved.row(column);
            }
            if (const int column = columns.offset(i)[static_cast<std::size_t>(axis)]; column >= 0) {
                made.position.row(row) = solved.row(column);
            }
        }
        if (unknowns.rail[i] >= 0 && solvesPlacement(options.model)) {
            const std::array<int, 3> at = columns.placement(static_cast<std::size_t>(unknowns.rail[i]));
            made.position.middleRows<3>(static_cast<Eigen::Index>(3 * i)) +=
                unknowns.positionByPlacement(i) * solved.middleRows<3>(at[0]);
        }
    }
    return made;
}

namespace {

// The matrix from a turn about the room's axes to changes of yaw, pitch and roll.
Eigen::Matrix3d anglesByTurn(const Eigen::Quaterniond& roomFromPhoto) {
    const YawPitchRoll angles = yawPitchRoll(roomFromPhoto);
    Eigen::Matrix3d axes;
    axes.col(0) = Eigen::Vector3d::UnitZ();
    axes.col(1) = yawRotation(angles.yaw) * Eigen::Vector3d::UnitY();
    axes.col(2) = roomFromPhoto * Eigen::Vector3d::UnitX();
    // For a photo that looks straight up or down yaw and roll are one; the room's axes say it better.
    if (std::abs(axes.determinant()) < 0.05) {
        return Eigen::Matrix3d::Identity();
    }
    return axes.inverse();
}

double rootMeanSquare(const Eigen::RowVectorXd& values) {
    return std::sqrt(values.squaredNorm() / static_cast<double>(values.size()));
}

// The standard deviation of three rows along the axis where they scatter most.
double worstScatter(const Draws& draws) {
    const Eigen::Matrix3d moments = draws * draws.transpose() / static_cast<double>(draws.cols());
    const Eigen::Vector3d variances =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moments, Eigen::EigenvaluesOnly).eigenvalues();
    return std::sqrt(std::max(variances[2], 0.0));
}

/// What all photos are turned by together, one column a draw. The turns' shape: 3 rows a photo. Photos that
/// are well known among the others say it, so that a blurred one makes no other seem less known.
Draws commonTurn(const Draws& turns) {
    constexpr double kTiny = 1e-16; // square radians
    const Eigen::Index count = turns.rows() / 3;
    Draws middle(3, turns.cols());
    std::vector<double> values(static_cast<std::size_t>(count));
    for (Eigen::Index draw = 0; draw < turns.cols(); ++draw) {
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            for (Eigen::Index i = 0; i < count; ++i) {
                values[static_cast<std::size_t>(i)] = turns(3 * i + axis, draw);
            }
            middle(axis, draw) = median(values);
        }
    }
    Draws common = Draws::Zero(3, turns.cols());
    double sum = 0;
    for (Eigen::Index i = 0; i < count; ++i) {
        const auto own = turns.middleRows<3>(3 * i);
        const double weight = 1 / ((own - middle).squaredNorm() / kBootstrapDraws + kTiny);
        common += weight * own;
        sum += weight;
    }
    return common / sum;
}

/// The standard deviation along either axis of the floor, or in height if that is more.
double placeScatter(const Draws& moves) {
    const double floor = std::sqrt(moves.topRows<2>().squaredNorm() / (2.0 * kBootstrapDraws));
    return std::max(floor, rootMeanSquare(moves.row(2)));
}

/// What is left of the photos' moves when all are moved, turned and scaled together. The moves' shape: 3 rows
/// a photo. turn: what all are turned by. Photos whose place is well known say what all are moved by.
Draws ownMoves(const Unknowns& unknowns, const Draws& moves, const Draws& turn) {
    constexpr double kTiny = 1e-12; // square metres
    const Eigen::Index count = moves.rows() / 3;
    Eigen::VectorXd weights(count);
    Eigen::Matrix3Xd places(3, count);
    for (Eigen::Index i = 0; i < count; ++i) {
        weights[i] = 1 / (moves.middleRows<3>(3 * i).squaredNorm() / kBootstrapDraws + kTiny);
        places.col(i) = unknowns.state(static_cast<std::size_t>(i)).positionM;
    }
    weights /= weights.sum();
    places.colwise() -= Eigen::Vector3d(places * weights);
    const double spread = std::max((places.cwiseAbs2() * weights).sum(), kTiny); // 0 for a single photo
    Draws own = moves;
    for (Eigen::Index draw = 0; draw < own.cols(); ++draw) {
        Eigen::Map<Eigen::Matrix3Xd> moved(own.col(draw).data(), 3, count);
        moved.colwise() -= Eigen::Vector3d(moved * weights);
        moved -= skew(turn.col(draw)) * places;
        moved -= (moved.cwiseProduct(places) * weights).sum() / spread * places;
    }
    return own;
}

} // namespace

Uncertainty uncertainty(const Unknowns& unknowns, const ErrorDraws& draws) {
    const auto count = unknowns.photo.size();
    const Draws common = commonTurn(draws.turn);
    Uncertainty made;
    made.commonYawRad = rootMeanSquare(common.row(2));
    made.commonLeanRad = worstScatter(Eigen::Vector3d(1, 1, 0).asDiagonal() * common);
    const Draws own = ownMoves(unknowns, draws.position, common);
    for (std::size_t i = 0; i < count; ++i) {
        const auto row = static_cast<Eigen::Index>(3 * i);
        const double ownRad = worstScatter(draws.turn.middleRows<3>(row) - common);
        const Draws turned = draws.turn.middleRows<3>(row) - Eigen::Vector3d::UnitZ() * common.row(2);
        const Draws a = anglesByTurn(unknowns.reference[i]) * turned;
        made.photos.push_back({rootMeanSquare(a.row(0)), rootMeanSquare(a.row(1)), rootMeanSquare(a.row(2)),
                               placeScatter(draws.position.middleRows<3>(row)), ownRad,
                               placeScatter(own.middleRows<3>(row))});
    }
    return made;
}

} // namespace spherewalk::align
