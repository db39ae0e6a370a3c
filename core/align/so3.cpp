// SPDX-License-Identifier: GPL-3.0-or-later
#include "so3.h"

#include <cmath>

namespace spherewalk::align {

Eigen::Quaterniond turn(const Eigen::Vector3d& turnRad) {
    const double angle = turnRad.norm();
    const double half = angle / 2;
    // The series of sin(angle / 2) / angle: the division loses all digits at zero.
    const double scale = angle < 1e-6 ? 0.5 - angle * angle / 48 : std::sin(half) / angle;
    return {std::cos(half), scale * turnRad.x(), scale * turnRad.y(), scale * turnRad.z()};
}

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

} // namespace spherewalk::align
