// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include <cmath>

namespace spherewalk::align {

/// How far two bearings are from lying in one plane with the baseline, in standard deviations, signed.
/// Frames: all in one frame, of any orientation; in and out are unit vectors, the baseline too.
/// Source: Sampson's approximation for bearings; both ends have the error sigmaRad.
struct EpipolarResidual {
    double value = 0;
    double sineA = 0; ///< of the angle between the bearing and the baseline
    double sineB = 0;
    Eigen::Vector3d byA = Eigen::Vector3d::Zero();        ///< by the bearing of a
    Eigen::Vector3d byB = Eigen::Vector3d::Zero();        ///< by the bearing of b
    Eigen::Vector3d byBaseline = Eigen::Vector3d::Zero(); ///< by the baseline, taken as any vector
};

/// Nearer to the baseline than this a bearing says nothing: its plane turns with the least error.
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

/// By how much the bearing moved along the baseline's plane as a point in front moves, radians; negative for
/// what would lie behind. Range: sine of the angle to the baseline not 0.
inline double parallaxOf(const Eigen::Vector3d& inA, const Eigen::Vector3d& inB,
                         const Eigen::Vector3d& baseline) {
    const Eigen::Vector3d across = baseline - baseline.dot(inA) * inA;
    return (inA - inB).dot(across) / std::max(across.norm(), 1e-9);
}

} // namespace spherewalk::align
