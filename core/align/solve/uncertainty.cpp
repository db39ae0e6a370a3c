// SPDX-License-Identifier: GPL-3.0-or-later
#include "uncertainty.h"

#include "fixed_random.h"
#include "normal_matrix.h"
#include "pair_normal.h"

#include "spherewalk/base/error.h"
#include "spherewalk/geometry/rotation.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace spherewalk::align {

namespace {

constexpr int kDraws = 192; // a standard deviation of so many is right to 5 %
constexpr double kLeastCurvature = 0.3;

using Matrix9d = Eigen::Matrix<double, 9, 9>;
using Draws = Eigen::MatrixXd; // one column a draw

// What the priors leave open, drawn for every photo: the tilt and the position, if the model solves them not.
struct Unsolved {
    Draws turn;     // 3 rows a photo
    Draws position; // 3 rows a photo
};

Draws normalDraws(Eigen::Index rows, FixedRandom& random) {
    Draws draws(rows, kDraws);
    for (Eigen::Index column = 0; column < kDraws; ++column) {
        for (Eigen::Index row = 0; row < rows; ++row) {
            draws(row, column) = random.normal();
        }
    }
    return draws;
}

Unsolved unsolved(const Unknowns& unknowns, std::span<const PhotoPrior> priors, Model model) {
    const auto count = static_cast<Eigen::Index>(unknowns.photo.size());
    Unsolved made{Draws::Zero(3 * count, kDraws), Draws::Zero(3 * count, kDraws)};
    FixedRandom random(0x5EED0003);
    for (Eigen::Index i = 0; i < count; ++i) {
        const PhotoPrior& prior =
            priors[static_cast<std::size_t>(unknowns.photo[static_cast<std::size_t>(i)])];
        if (!solvesTilt(model)) {
            made.turn.middleRows(3 * i, 2) = upPrior(prior).sigmaRad * normalDraws(2, random);
        }
        if (!solvesPosition(model)) {
            made.position.middleRows(3 * i, 3) = offsetSigmasM(prior).asDiagonal() * normalDraws(3, random);
        }
    }
    return made;
}

// The scores of a pair's matches and their curvature.
struct PairScores {
    Matrix9d matrix = Matrix9d::Zero();
    Eigen::Matrix<double, 9, Eigen::Dynamic> scores;
    std::vector<int> track;
    double curvature = 0; // summed
};

PairScores scoresOf(const UsedPair& pair, std::span<const PhotoState> states,
                    const RefinementOptions& options) {
    PairScores made;
    made.scores.resize(9, static_cast<Eigen::Index>(2 * pair.matches.size()));
    Eigen::Index count = 0;
    forEachRow(pair, states, [&](const UsedMatch& match, const MatchRow& row) {
        const double residual = row.residual / options.scale;
        const Bounded robust = bounded(residual, options.width);
        const double ratio = residual * residual / (options.width * options.width);
        made.curvature += (1 - 3 * ratio) / ((1 + ratio) * (1 + ratio) * (1 + ratio));
        made.scores.col(count++) = (robust.value * robust.slope / options.scale) * row.by;
        made.matrix += row.by * row.by.transpose() / (options.scale * options.scale);
        made.track.push_back(match.track);
    });
    made.scores.conservativeResize(9, count);
    return made;
}

// A sign a row and draw, equal within a track.
Draws signs(const std::vector<int>& track) {
    Draws made(static_cast<Eigen::Index>(track.size()), kDraws);
    for (std::size_t row = 0; row < track.size(); ++row) {
        FixedRandom random(0x51604ULL + static_cast<std::uint64_t>(track[row]) * 0x9E3779B97F4A7C15ULL);
        std::uint64_t bits = 0;
        for (int column = 0; column < kDraws; ++column) {
            if (column % 64 == 0) {
                bits = random.next();
            }
            made(static_cast<Eigen::Index>(row), column) = (bits >> (column % 64)) & 1 ? 1 : -1;
        }
    }
    return made;
}

// How much larger than their priors say the offsets turned out to be along each axis, as far as there are
// enough of them to tell.
Eigen::Vector3d offsetFactors(const Unknowns& unknowns, std::span<const PhotoPrior> priors, Model model) {
    const auto photos = static_cast<double>(unknowns.photo.size());
    const auto rails = static_cast<double>(unknowns.placement.size());
    // Taken up by the priors' own common errors: place, scale and heading; height and tilt; the rails.
    const Eigen::Vector3d freedom(photos - 2 - 1.5 * rails, photos - 2 - 1.5 * rails, photos - 3);
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
                    std::span<const UsedPair> pairs, const RefinementOptions& options, const Unsolved& errors,
                    const std::stop_token& stop) {
    const std::vector<PhotoState> states = unknowns.states();
    Draws right = Draws::Zero(columns.count(), kDraws);
    Draws passedOn = right; // by what is not solved
    std::vector<Matrix9d> matrices;
    double curvature = 0;
    double count = 0;
    for (const UsedPair& pair : pairs) {
        throwIfStopped(stop);
        const PairScores scores = scoresOf(pair, states, options);
        curvature += scores.curvature;
        count += static_cast<double>(scores.track.size());
        const Eigen::Matrix<double, 9, Eigen::Dynamic> sums = scores.scores * signs(scores.track);
        Eigen::Matrix<double, 9, Eigen::Dynamic> moved(9, kDraws);
        moved.topRows<3>() = errors.turn.middleRows<3>(3 * pair.a);
        moved.middleRows<3>(3) = errors.turn.middleRows<3>(3 * pair.b);
        moved.bottomRows<3>() =
            errors.position.middleRows<3>(3 * pair.b) - errors.position.middleRows<3>(3 * pair.a);
        const PairColumns at = pairColumns(columns, unknowns, pair);
        const Draws scattered = at.chain * sums;
        const Draws scatteredMoved = at.chain * (scores.matrix * moved);
        for (std::size_t row = 0; row < at.column.size(); ++row) {
            right.row(at.column[row]) += scattered.row(static_cast<Eigen::Index>(row));
            passedOn.row(at.column[row]) += scatteredMoved.row(static_cast<Eigen::Index>(row));
        }
        matrices.push_back(scores.matrix);
    }
    const double mean = count > 0 ? std::max(curvature / count, kLeastCurvature) : 1;
    for (Matrix9d& matrix : matrices) {
        matrix *= mean;
    }
    right += mean * passedOn;
    const std::vector<PriorRow> rows = priorRows(columns, unknowns, priors, options);
    addPriors(rows, offsetFactors(unknowns, priors, options.model), right);
    return {normalMatrix(columns, unknowns, pairs, matrices, rows), std::move(right)};
}

// From a turn about the room's axes to changes of yaw, pitch and roll.
Eigen::Matrix3d anglesByTurn(const Eigen::Quaterniond& roomFromPhoto) {
    const YawPitchRoll angles = yawPitchRoll(roomFromPhoto);
    Eigen::Matrix3d axes;
    axes.col(0) = Eigen::Vector3d::UnitZ();
    axes.col(1) = yawRotation(angles.yaw) * Eigen::Vector3d::UnitY();
    axes.col(2) = roomFromPhoto * Eigen::Vector3d::UnitX();
    // Looking straight up or down, yaw and roll are one: then the room's axes say it better.
    if (std::abs(axes.determinant()) < 0.05) {
        return Eigen::Matrix3d::Identity();
    }
    return axes.inverse();
}

double rootMeanSquare(const Eigen::RowVectorXd& values) {
    return std::sqrt(values.squaredNorm() / static_cast<double>(values.size()));
}

} // namespace

Uncertainty uncertainty(const Unknowns& unknowns, std::span<const PhotoPrior> priors,
                        std::span<const UsedPair> pairs, const RefinementOptions& options,
                        const std::stop_token& stop) {
    const Columns columns(unknowns, options.model);
    const Unsolved errors = unsolved(unknowns, priors, options.model);
    const Equations system = equations(columns, unknowns, priors, pairs, options, errors, stop);
    throwIfStopped(stop);
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(system.matrix);
    if (factor.info() != Eigen::Success) {
        throw Error(ErrorKind::Internal,
                    "The uncertainty of the alignment could not be computed. Please report it.");
    }
    const Draws solved = factor.solve(system.right);
    const auto count = unknowns.photo.size();
    Draws turns = errors.turn;
    Draws positions = errors.position;
    for (std::size_t i = 0; i < count; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            const auto row = static_cast<Eigen::Index>(3 * i) + axis;
            if (const int column = columns.turn(i)[static_cast<std::size_t>(axis)]; column >= 0) {
                turns.row(row) = solved.row(column);
            }
            if (const int column = columns.offset(i)[static_cast<std::size_t>(axis)]; column >= 0) {
                positions.row(row) = solved.row(column);
            }
        }
        if (unknowns.rail[i] >= 0 && solvesPlacement(options.model)) {
            const std::array<int, 3> at = columns.placement(static_cast<std::size_t>(unknowns.rail[i]));
            positions.middleRows<3>(static_cast<Eigen::Index>(3 * i)) +=
                unknowns.positionByPlacement(i) * solved.middleRows<3>(at[0]);
        }
    }
    Eigen::RowVectorXd common = Eigen::RowVectorXd::Zero(kDraws);
    for (std::size_t i = 0; i < count; ++i) {
        common += turns.row(static_cast<Eigen::Index>(3 * i) + 2) / static_cast<double>(count);
    }
    Uncertainty made;
    made.commonYawRad = rootMeanSquare(common);
    for (std::size_t i = 0; i < count; ++i) {
        Draws turned = turns.middleRows<3>(static_cast<Eigen::Index>(3 * i));
        turned.row(2) -= common;
        const Draws angles = anglesByTurn(unknowns.reference[i]) * turned;
        const Draws moved = positions.middleRows<3>(static_cast<Eigen::Index>(3 * i));
        made.photos.push_back({rootMeanSquare(angles.row(0)), rootMeanSquare(angles.row(1)),
                               rootMeanSquare(angles.row(2)),
                               std::sqrt(moved.squaredNorm() / (3.0 * kDraws))});
    }
    return made;
}

} // namespace spherewalk::align
