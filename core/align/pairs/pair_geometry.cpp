// SPDX-License-Identifier: GPL-3.0-or-later
#include "pairs/pair_geometry.h"

#include "spherewalk/base/statistics.h"

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>

namespace spherewalk::align {

Eigen::Vector3d turnVector(const Eigen::Quaterniond& rotation) {
    const double sign = rotation.w() < 0 ? -1 : 1;
    const Eigen::Vector3d axis = sign * rotation.vec();
    const double sine = axis.norm();
    if (sine < 1e-9) {
        return 2 * axis;
    }
    return axis * (2 * std::atan2(sine, sign * rotation.w()) / sine);
}

Eigen::Matrix3d leftJacobian(const Eigen::Vector3d& turnRad) {
    const double angle = turnRad.norm();
    const Eigen::Matrix3d cross = skew(turnRad);
    if (angle < 1e-5) {
        return Eigen::Matrix3d::Identity() + cross / 2;
    }
    const double squared = angle * angle;
    return Eigen::Matrix3d::Identity() + cross * ((1 - std::cos(angle)) / squared) +
           cross * cross * ((angle - std::sin(angle)) / (squared * angle));
}

Eigen::Matrix<double, 3, 2> tangentBasis(const Eigen::Vector3d& unit) {
    Eigen::Matrix<double, 3, 2> basis;
    basis.col(0) = unit.unitOrthogonal();
    basis.col(1) = unit.cross(basis.col(0));
    return basis;
}

Eigen::Matrix3d bestRotation(const Eigen::Matrix3d& moment) {
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(moment, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Vector3d signs = Eigen::Vector3d::Ones();
    signs.z() = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
    // Eigen sums in another order where it constructs the product instead of assigning it.
    Eigen::Matrix3d rotation;
    rotation = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
    return rotation;
}

Eigen::Quaterniond uprightFrom(const Eigen::Vector3d& up) {
    const Eigen::Vector3d unit = up.normalized();
    if (unit.z() < -1 + 1e-12) {
        return {0, 1, 0, 0}; // It is upside down: any horizontal axis will do.
    }
    // This is Eigen's FromTwoVectors(), whose case of opposite vectors takes seconds to compile.
    const double s = std::sqrt((1 + unit.z()) * 2);
    const Eigen::Vector3d axis = unit.cross(Eigen::Vector3d::UnitZ()) * (1 / s);
    return {s * 0.5, axis.x(), axis.y(), axis.z()};
}

namespace {

constexpr double kLeastScale = 0.3;
constexpr double kSigmasLookedAt = 2.5; // Only residuals within so many standard deviations count.
constexpr double kLeftWithin = 0.951;   // What the cut leaves of a normal distribution's deviation.
constexpr double kAtThirtieth = 0.385;  // 30 % of a normal distribution stay below this.

} // namespace

double agreeingScale(std::vector<double> residuals, double largest) {
    if (residuals.size() < 8) {
        return 1;
    }
    for (double& residual : residuals) {
        residual = std::abs(residual);
    }
    // The scale is a fixed point, found from above: the root mean square within the threshold.
    double scale = std::clamp(quantileInPlace(residuals, 0.3) / kAtThirtieth, kLeastScale, largest);
    for (int round = 0; round < 8; ++round) {
        double sum = 0;
        int count = 0;
        for (const double residual : residuals) {
            if (residual < kSigmasLookedAt * scale) {
                sum += residual * residual;
                ++count;
            }
        }
        if (count == 0) {
            return largest;
        }
        scale = std::clamp(std::sqrt(sum / count) / kLeftWithin, kLeastScale, largest);
    }
    return scale;
}

namespace {

constexpr double kDefaultSigmaRad = 0.001;

} // namespace

std::optional<UnitMatch> unitMatch(const Correspondence& match) {
    const double lengthA = match.inA.norm();
    const double lengthB = match.inB.norm();
    // Written so that NaN fails.
    if (!(lengthA > 0.5 && lengthA < 2 && lengthB > 0.5 && lengthB < 2)) {
        return std::nullopt;
    }
    const bool hasSigma = match.sigmaRad > 1e-6 && match.sigmaRad < 0.1;
    return UnitMatch{match.inA / lengthA, match.inB / lengthB, hasSigma ? match.sigmaRad : kDefaultSigmaRad};
}

} // namespace spherewalk::align
