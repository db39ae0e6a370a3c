// SPDX-License-Identifier: GPL-3.0-or-later
#include "turn_refinement.h"

#include "so3.h"

#include "spherewalk/base/median.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <vector>

namespace spherewalk::align {

namespace {

constexpr double kLargestSigmas = 4; // of the two-dimensional distance: Rayleigh, so 1 in 3000
constexpr double kEnough = 0.85;     // of the baseline's inliers, for the baseline to be given up

struct Turn {
    Eigen::Matrix3d aFromB;
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    double squares = 0;
    std::vector<int> agree;
};

// One step of robust least squares on both components of the bearings' distance.
void step(const Bearings& bearings, std::span<const int> used, double width, Turn& turned) {
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
    turned.squares = 0;
    for (const int at : used) {
        const auto i = static_cast<std::size_t>(at);
        const Eigen::Vector3d b = turned.aFromB * bearings.inB[i];
        const Eigen::Vector3d distance = bearings.inA[i] - b;
        const double information = 0.5 / (bearings.sigmaRad[i] * bearings.sigmaRad[i]);
        const double squared = distance.squaredNorm() * information;
        const double root = 1 / (1 + squared / (width * width));
        const double weight = information * root * root;
        matrix += weight * (Eigen::Matrix3d::Identity() - b * b.transpose());
        gradient += weight * b.cross(distance);
        turned.squares += squared;
    }
    turned.information = matrix;
    matrix += 1e-9 * matrix.trace() * Eigen::Matrix3d::Identity();
    const Eigen::Vector3d delta = matrix.ldlt().solve(gradient);
    if (delta.allFinite()) {
        turned.aFromB = turn(delta).toRotationMatrix() * turned.aFromB;
    }
}

std::vector<int> agreeing(const Bearings& bearings, std::span<const int> inside, const Turn& turned,
                          double scale) {
    std::vector<int> agree;
    for (const int at : inside) {
        const auto i = static_cast<std::size_t>(at);
        const double distance = (bearings.inA[i] - turned.aFromB * bearings.inB[i]).norm();
        if (distance < kLargestSigmas * scale * M_SQRT2 * bearings.sigmaRad[i]) {
            agree.push_back(at);
        }
    }
    return agree;
}

} // namespace

void preferTurn(const Bearings& bearings, std::span<const int> inside, EpipolarFit& fit) {
    Turn turned{fit.aFromB, {}, 0, {}};
    for (const double width : {40.0, 20.0, 10.0, 5.0, 3.0, 3.0}) {
        step(bearings, inside, width, turned);
    }
    const double scale = std::max(fit.scale, 1.0);
    turned.agree = agreeing(bearings, inside, turned, scale);
    if (turned.agree.size() < 6 || static_cast<double>(turned.agree.size()) < kEnough * fit.inliers) {
        return;
    }
    for (int round = 0; round < 3; ++round) {
        step(bearings, turned.agree, 1e6, turned);
        turned.agree = agreeing(bearings, inside, turned, scale);
    }
    fit.aFromB = turned.aFromB;
    fit.hasBaseline = false;
    fit.inliers = static_cast<int>(turned.agree.size());
    fit.isInlier.assign(static_cast<std::size_t>(bearings.count()), false);
    for (const int at : turned.agree) {
        fit.isInlier[static_cast<std::size_t>(at)] = true;
    }
    const double variance = turned.squares / std::max(1.0, 2.0 * fit.inliers - 3);
    fit.scale = std::sqrt(variance);
    fit.rotationCovariance =
        variance *
        (turned.information + 1e-9 * turned.information.trace() * Eigen::Matrix3d::Identity()).inverse();
    std::vector<double> moved;
    for (const int at : turned.agree) {
        const auto i = static_cast<std::size_t>(at);
        moved.push_back((bearings.inA[i] - fit.aFromB * bearings.inB[i]).norm());
    }
    fit.parallaxRad = median(std::move(moved));
    fit.measurable = 0;
    fit.forwardShare = 0;
}

} // namespace spherewalk::align
