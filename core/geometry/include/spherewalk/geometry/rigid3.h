// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>

#include <cmath>

namespace spherewalk {

#ifdef SPHEREWALK_EIGEN_ALIGNMENT // what the installed library was compiled with
static_assert(alignof(Eigen::Quaterniond) == SPHEREWALK_EIGEN_ALIGNMENT,
              "The render library was compiled for other instructions (-march, -mavx), with which Eigen "
              "aligns otherwise: compile this program with -DEIGEN_MAX_STATIC_ALIGN_BYTES as the library, "
              "16 by default, or use the C interface.");
#endif

/// A pose: a rotation followed by a translation in metres. A variable aFromB takes coordinates of frame b to
/// frame a, so pInA = aFromB * pInB. Its translation is the origin of b in a.
struct Rigid3 {
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
    Eigen::Vector3d translation = Eigen::Vector3d::Zero();

    Eigen::Vector3d operator*(const Eigen::Vector3d& pInB) const { return rotation * pInB + translation; }

    /// The two poses one after the other: aFromC = aFromB * bFromC.
    Rigid3 operator*(const Rigid3& bFromC) const {
        return {(rotation * bFromC.rotation).normalized(), rotation * bFromC.translation + translation};
    }

    /// The pose bFromA of aFromB. Range: a unit quaternion.
    Rigid3 inverse() const {
        const Eigen::Quaterniond bFromA = rotation.conjugate();
        return {bFromA, -(bFromA * translation)};
    }
};

/// True for a translation of at most 10^9 m and a quaternion whose length is 1 within the tolerance. Farther
/// away, squares of single precision overflow.
inline bool isPose(const Rigid3& pose, double tolerance = 1e-3) {
    constexpr double kFarthestM = 1e9;
    return pose.translation.norm() <= kFarthestM &&
           std::abs(pose.rotation.norm() - 1) <= tolerance; // false for NaN
}

/// A pose between two: a at share 0, b at share 1. The translation follows the straight line. The rotation
/// turns evenly, the short way.
inline Rigid3 interpolated(const Rigid3& a, const Rigid3& b, double share) {
    return {a.rotation.slerp(share, b.rotation).normalized(),
            a.translation + share * (b.translation - a.translation)};
}

} // namespace spherewalk
