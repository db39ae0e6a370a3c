// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

namespace spherewalk::align {

/// The matrix of the cross product: skew(a) * b = a x b.
inline Eigen::Matrix3d skew(const Eigen::Vector3d& a) {
    Eigen::Matrix3d matrix;
    matrix << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
    return matrix;
}

/// The turn about this vector by its length, in radians.
Eigen::Quaterniond turn(const Eigen::Vector3d& turnRad);

/// The vector that turn() takes back to the rotation; its length is in [0, pi].
Eigen::Vector3d turnVector(const Eigen::Quaterniond& rotation);

/// How turn(turnRad) follows a small change: turn(v + dv) = turn(leftJacobian(v) * dv) * turn(v).
Eigen::Matrix3d leftJacobian(const Eigen::Vector3d& turnRad);

/// Two unit vectors that make a right-handed frame with this unit vector.
Eigen::Matrix<double, 3, 2> tangentBasis(const Eigen::Vector3d& unit);

} // namespace spherewalk::align
