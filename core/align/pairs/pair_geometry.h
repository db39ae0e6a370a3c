// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/align/photo_pair.h"
#include "spherewalk/geometry/rotation.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace spherewalk::align {

/// The vector that turn() takes to the rotation. Its length is in [0, pi].
Eigen::Vector3d turnVector(const Eigen::Quaterniond& rotation);

/// The matrix by which turn() follows a small change. To first order,
/// turn(v + dv) = turn(leftJacobian(v) * dv) * turn(v).
Eigen::Matrix3d leftJacobian(const Eigen::Vector3d& turnRad);

/// Two unit vectors that make a right-handed frame with this unit vector.
Eigen::Matrix<double, 3, 2> tangentBasis(const Eigen::Vector3d& unit);

/// The rotation R with the largest trace of R^T * moment: for a moment that sums a * b^T over pairs of
/// directions, R brings the b nearest to the a (least squares). Source: Kabsch 1976.
Eigen::Matrix3d bestRotation(const Eigen::Matrix3d& moment);

/// The smallest rotation that takes the direction to +z. Range: any length but 0.
Eigen::Quaterniond uprightFrom(const Eigen::Vector3d& up);

/// A match as it is computed with: its bearings are unit vectors, and its standard deviation is sensible.
struct UnitMatch {
    Eigen::Vector3d inA;
    Eigen::Vector3d inB;
    double sigmaRad = 0;
};

/// The match as it is computed with. Empty for a bearing whose length is not in (0.5, 2). 1 mrad replaces a
/// sigmaRad outside of (1e-6, 0.1).
std::optional<UnitMatch> unitMatch(const Correspondence& match);

/// The standard deviation of the residuals that agree; a minority of wrong ones is ignored. Units: residuals
/// and result in supposed standard deviations; residuals have any sign. Range of the result: [0.3, largest];
/// 1 for fewer than eight residuals; the largest if none agrees.
double agreeingScale(std::vector<double> residuals, double largest);

/// How far two bearings are from lying in one plane with the baseline, in standard deviations, signed.
/// Frames: both bearings and the baseline are unit vectors of one frame, which may have any orientation.
/// Source: Sampson's approximation for bearings; both ends have the error sigmaRad.
struct EpipolarResidual {
    double value = 0;
    double sineA = 0; ///< Sine of the angle between a's bearing and the baseline.
    double sineB = 0;
    Eigen::Vector3d byA = Eigen::Vector3d::Zero();        ///< Derivative by the bearing of a.
    Eigen::Vector3d byB = Eigen::Vector3d::Zero();        ///< Derivative by the bearing of b.
    Eigen::Vector3d byBaseline = Eigen::Vector3d::Zero(); ///< Derivative by the baseline, its length free.
};

/// The least sine of the angle between a bearing and the baseline with which the bearing tells a plane. That
/// of a lesser one turns with the least error.
constexpr double kLeastSine = 0.12;

inline EpipolarResidual epipolarResidual(const Eigen::Vector3d& inA, const Eigen::Vector3d& inB,
                                         const Eigen::Vector3d& baseline, double sigmaRad) {
    EpipolarResidual residual;
    const double alongA = baseline.dot(inA);
    const double alongB = baseline.dot(inB);
    residual.sineA = std::sqrt(std::max(0.0, 1 - alongA * alongA));
    residual.sineB = std::sqrt(std::max(0.0, 1 - alongB * alongB));
    const Eigen::Vector3d normal = inA.cross(inB);
    const double volume = baseline.dot(normal);
    const double variance = std::max(2 - alongA * alongA - alongB * alongB, 1e-6);
    const double scale = 1 / (sigmaRad * std::sqrt(variance));
    const double slope = volume * scale / variance;
    residual.value = volume * scale;
    residual.byA = scale * inB.cross(baseline) + slope * alongA * baseline;
    residual.byB = scale * baseline.cross(inA) + slope * alongB * baseline;
    residual.byBaseline = scale * normal + slope * (alongA * inA + alongB * inB);
    return residual;
}

/// The sine of the angle by which the bearing moved in its plane with the baseline. A point in front of both
/// photos gives a positive sine, a point behind a negative one. Frames: those of epipolarResidual(). Range:
/// the angle is below pi/2; inA does not lie on the baseline.
inline double parallaxOf(const Eigen::Vector3d& inA, const Eigen::Vector3d& inB,
                         const Eigen::Vector3d& baseline) {
    const Eigen::Vector3d across = baseline - baseline.dot(inA) * inA;
    return (inA - inB).dot(across) / std::max(across.norm(), 1e-9);
}

} // namespace spherewalk::align
