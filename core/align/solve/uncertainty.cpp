// SPDX-License-Identifier: GPL-3.0-or-later
#include "pairs/pair_geometry.h"
#include "solve/solution_report.h"

#include "spherewalk/base/statistics.h"
#include "spherewalk/geometry/rotation.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <vector>

namespace spherewalk::align {

namespace {

using Draws = Eigen::MatrixXd;

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
