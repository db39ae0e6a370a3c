// SPDX-License-Identifier: GPL-3.0-or-later
#include "pairs/pair_fit.h"
#include "pairs/pair_geometry.h"

#include "spherewalk/base/fixed_random.h"
#include "spherewalk/base/statistics.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <span>

namespace spherewalk::align {

namespace {

constexpr double kLargestTurnSigmas = 4; // Of the distance in two dimensions: Rayleigh, so 1 in 3000.
constexpr double kEnough = 0.85;         // With this share of its inliers, a turn replaces the baseline.

struct TurnFit {
    Eigen::Matrix3d aFromB;
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    double squares = 0;
    std::vector<int> agree;
};

// One step of robust least squares on both components of the bearings' distance.
void turnStep(const Bearings& bearings, std::span<const int> used, double width, TurnFit& turned) {
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

std::vector<int> agreeWithTurn(const Bearings& bearings, std::span<const int> inside, const TurnFit& turned,
                               double scale) {
    std::vector<int> agree;
    for (const int at : inside) {
        const auto i = static_cast<std::size_t>(at);
        const double distance = (bearings.inA[i] - turned.aFromB * bearings.inB[i]).norm();
        if (distance < kLargestTurnSigmas * scale * M_SQRT2 * bearings.sigmaRad[i]) {
            agree.push_back(at);
        }
    }
    return agree;
}

/// Takes the baseline out of a fit where a turn alone explains what the baseline does. inside: the bearings
/// that are judged.
void preferTurn(const Bearings& bearings, std::span<const int> inside, EpipolarFit& fit) {
    TurnFit turned{fit.aFromB, {}, 0, {}};
    for (const double width : {40.0, 20.0, 10.0, 5.0, 3.0, 3.0}) {
        turnStep(bearings, inside, width, turned);
    }
    const double scale = std::max(fit.scale, 1.0);
    turned.agree = agreeWithTurn(bearings, inside, turned, scale);
    if (turned.agree.size() < 6 || static_cast<double>(turned.agree.size()) < kEnough * fit.inliers) {
        return;
    }
    for (int round = 0; round < 3; ++round) {
        turnStep(bearings, turned.agree, 1e6, turned);
        turned.agree = agreeWithTurn(bearings, inside, turned, scale);
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

} // namespace

namespace {

using Matrix5d = Eigen::Matrix<double, 5, 5>;
using Vector5d = Eigen::Matrix<double, 5, 1>;

constexpr double kInlierSigmas = 3.5;
constexpr double kLargestFitScale = 4; // Larger residuals are no noise.
constexpr std::size_t kTried = 240;    // Number of bearings that directions are tried with.
constexpr std::size_t kRefinedWith = 800;
constexpr int kDirections = 24;
constexpr std::size_t kBest = 3;

struct Geometry {
    Eigen::Matrix3d aFromB = Eigen::Matrix3d::Identity();
    Eigen::Vector3d baseline = Eigen::Vector3d::UnitX();
    double cost = 0;
};

EpipolarResidual residualOf(const Bearings& bearings, int at, const Geometry& geometry) {
    const auto i = static_cast<std::size_t>(at);
    return epipolarResidual(bearings.inA[i], geometry.aFromB * bearings.inB[i], geometry.baseline,
                            bearings.sigmaRad[i]);
}

bool isUsable(const Bearings& bearings, const EpipolarResidual& residual) {
    return std::min(residual.sineA, residual.sineB) > bearings.leastSine;
}

struct EpipolarNormal {
    Matrix5d matrix = Matrix5d::Zero();
    Vector5d gradient = Vector5d::Zero();
    double cost = 0; // Geman and McClure's
};

// Order: 3 of a turn of b in a's frame, 2 of the baseline in its tangent plane.
EpipolarNormal normalEquations(const Bearings& bearings, std::span<const int> used, const Geometry& geometry,
                               double width) {
    EpipolarNormal normal;
    const Eigen::Matrix<double, 3, 2> tangent = tangentBasis(geometry.baseline);
    for (const int at : used) {
        const EpipolarResidual residual = residualOf(bearings, at, geometry);
        if (!isUsable(bearings, residual)) {
            normal.cost += 0.5; // It speaks neither for nor against.
            continue;
        }
        const double ratio = residual.value / width;
        const double root = 1 / (1 + ratio * ratio);
        Vector5d row;
        row.head<3>() = (geometry.aFromB * bearings.inB[static_cast<std::size_t>(at)]).cross(residual.byB);
        row.tail<2>() = tangent.transpose() * residual.byBaseline;
        normal.matrix.noalias() += (root * root) * row * row.transpose();
        normal.gradient += (root * root * residual.value) * row;
        normal.cost += ratio * ratio * root;
    }
    return normal;
}

void epipolarStep(Geometry& geometry, const EpipolarNormal& normal) {
    Matrix5d damped = normal.matrix;
    damped.diagonal() *= 1 + 1e-3;
    damped.diagonal().array() += 1e-6 * normal.matrix.trace() + 1e-12;
    Vector5d delta = -damped.ldlt().solve(normal.gradient);
    const double length = delta.cwiseAbs().maxCoeff();
    if (!std::isfinite(length)) {
        return;
    }
    delta *= std::min(1.0, 0.3 / std::max(length, 1e-12));
    geometry.aFromB = turn(delta.head<3>()).toRotationMatrix() * geometry.aFromB;
    geometry.baseline = (geometry.baseline + tangentBasis(geometry.baseline) * delta.tail<2>()).normalized();
}

void refineGeometry(const Bearings& bearings, std::span<const int> used, std::span<const double> widths,
                    Geometry& geometry) {
    for (const double width : widths) {
        epipolarStep(geometry, normalEquations(bearings, used, geometry, width));
    }
    geometry.cost = normalEquations(bearings, used, geometry, widths.back()).cost;
}

std::vector<int> gated(const Bearings& bearings, const Eigen::Matrix3d& start) {
    std::vector<int> inside;
    for (const int at : FixedRandom(0x5EED0002).permutation(bearings.count())) {
        const auto i = static_cast<std::size_t>(at);
        if (bearings.inA[i].dot(start * bearings.inB[i]) > std::cos(bearings.reach.value())) {
            inside.push_back(at);
        }
    }
    return inside;
}

// Directions spread evenly over half of the sphere: a baseline and its opposite make the same planes.
Eigen::Vector3d triedDirection(int index) {
    const double z = (index + 0.5) / kDirections;
    const double azimuth = index * M_PI * (3 - std::sqrt(5.0));
    const double radius = std::sqrt(1 - z * z);
    return {radius * std::cos(azimuth), radius * std::sin(azimuth), z};
}

std::vector<Geometry> bestGeometries(const Bearings& bearings, std::span<const int> inside,
                                     const Eigen::Matrix3d& start) {
    const std::span<const int> tried = inside.first(std::min(inside.size(), kTried));
    const double degree = 0.0175 / median(bearings.sigmaRad);
    const std::vector<double> widths = {2 * degree, 2 * degree, degree, std::max(0.5 * degree, 4.0),
                                        std::max(0.3 * degree, 4.0)};
    std::vector<Geometry> found;
    for (int direction = 0; direction < kDirections; ++direction) {
        Geometry geometry{start, triedDirection(direction), 0};
        refineGeometry(bearings, tried, widths, geometry);
        found.push_back(geometry);
    }
    std::ranges::stable_sort(found, {}, &Geometry::cost);
    // The same minimum is reached from many directions.
    std::vector<Geometry> best;
    for (const Geometry& one : found) {
        const bool isNew = std::ranges::none_of(
            best, [&](const Geometry& other) { return std::abs(one.baseline.dot(other.baseline)) > 0.97; });
        if (isNew && best.size() < kBest) {
            best.push_back(one);
        }
    }
    return best;
}

double scaleOf(const Bearings& bearings, std::span<const int> used, const Geometry& geometry) {
    std::vector<double> residuals;
    for (const int at : used) {
        const EpipolarResidual residual = residualOf(bearings, at, geometry);
        if (isUsable(bearings, residual)) {
            residuals.push_back(residual.value);
        }
    }
    return agreeingScale(std::move(residuals), kLargestFitScale);
}

std::vector<int> agreeWithPlanes(const Bearings& bearings, std::span<const int> inside,
                                 const Geometry& geometry, double scale) {
    std::vector<int> agree;
    for (const int at : inside) {
        const EpipolarResidual residual = residualOf(bearings, at, geometry);
        if (isUsable(bearings, residual) && std::abs(residual.value) < kInlierSigmas * scale) {
            agree.push_back(at);
        }
    }
    return agree;
}

// Turns the baseline so that most inliers lie in front, and counts them.
void judgeParallax(const Bearings& bearings, std::span<const int> agree, Geometry& geometry,
                   EpipolarFit& fit) {
    std::vector<double> moved;
    int forward = 0;
    for (const int at : agree) {
        const auto i = static_cast<std::size_t>(at);
        const Eigen::Vector3d turnedB = geometry.aFromB * bearings.inB[i];
        moved.push_back(2 * std::asin(std::min(1.0, (bearings.inA[i] - turnedB).norm() / 2)));
        const double parallax = parallaxOf(bearings.inA[i], turnedB, geometry.baseline);
        if (std::abs(parallax) > 4.2 * fit.scale * bearings.sigmaRad[i]) {
            ++fit.measurable;
            forward += parallax > 0 ? 1 : 0;
        }
    }
    if (2 * forward < fit.measurable) {
        geometry.baseline = -geometry.baseline;
        forward = fit.measurable - forward;
    }
    fit.forwardShare = fit.measurable > 0 ? static_cast<double>(forward) / fit.measurable : 0;
    fit.parallaxRad = median(std::move(moved));
}

EpipolarFit fitOf(const Bearings& bearings, std::span<const int> inside, Geometry geometry) {
    const std::span<const int> used = inside.first(std::min(inside.size(), kRefinedWith));
    refineGeometry(bearings, used, std::vector<double>{10, 7, 5, 4, 4}, geometry);
    EpipolarFit fit;
    fit.scale = scaleOf(bearings, used, geometry);
    std::vector<int> agree = agreeWithPlanes(bearings, inside, geometry, fit.scale);
    for (int round = 0; round < 3; ++round) { // Plain least squares over the bearings that agree.
        refineGeometry(bearings, agree, std::vector<double>{1e6}, geometry);
        agree = agreeWithPlanes(bearings, inside, geometry, fit.scale);
    }
    fit.scale = scaleOf(bearings, agree, geometry);
    judgeParallax(bearings, agree, geometry, fit);
    fit.aFromB = geometry.aFromB;
    fit.baselineInA = geometry.baseline;
    fit.inliers = static_cast<int>(agree.size());
    fit.gated = static_cast<int>(inside.size());
    fit.isInlier.assign(static_cast<std::size_t>(bearings.count()), false);
    for (const int at : agree) {
        fit.isInlier[static_cast<std::size_t>(at)] = true;
    }
    const EpipolarNormal normal = normalEquations(bearings, agree, geometry, 1e6);
    const Matrix5d inverse = (normal.matrix + 1e-9 * normal.matrix.trace() * Matrix5d::Identity()).inverse();
    const double freedom = std::max(1.0, fit.inliers - 5.0);
    const double variance = std::max(normal.cost * 1e12 / freedom, 1e-6);
    fit.rotationCovariance = variance * inverse.topLeftCorner<3, 3>();
    fit.baselineSigmaRad = std::sqrt(variance * inverse.bottomRightCorner<2, 2>().trace() / 2);
    return fit;
}

} // namespace

EpipolarFit refineEpipolar(const Bearings& bearings, const Eigen::Matrix3d& start) {
    const std::vector<int> inside = gated(bearings, start);
    if (inside.size() < 6) {
        EpipolarFit none;
        none.aFromB = start;
        none.isInlier.assign(static_cast<std::size_t>(bearings.count()), false);
        none.gated = static_cast<int>(inside.size());
        return none;
    }
    EpipolarFit best;
    double bestWeight = -1;
    for (const Geometry& geometry : bestGeometries(bearings, inside, start)) {
        EpipolarFit fit = fitOf(bearings, inside, geometry);
        // Of two minima with like support, the one whose points lie in front wins.
        const double weight = fit.inliers * (fit.measurable > 8 ? fit.forwardShare : 0.8);
        if (weight > bestWeight) {
            bestWeight = weight;
            best = std::move(fit);
        }
    }
    preferTurn(bearings, inside, best);
    return best;
}

} // namespace spherewalk::align
