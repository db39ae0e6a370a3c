// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>

namespace spherewalk {

#ifdef SPHEREWALK_EIGEN_ALIGNMENT // what the installed library was compiled with
static_assert(alignof(Eigen::Quaterniond) == SPHEREWALK_EIGEN_ALIGNMENT,
              "The render library was compiled for other instructions (-march, -mavx), with which Eigen "
              "aligns otherwise: compile this program with -DEIGEN_MAX_STATIC_ALIGN_BYTES as the library, "
              "16 by default, or use the C interface.");
#endif

/// A rotation followed by a translation, in metres. A variable is named aFromB: pInA = aFromB * pInB, and the
/// translation is the origin of b in a.
struct Rigid3 {
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
    Eigen::Vector3d translation = Eigen::Vector3d::Zero();

    Eigen::Vector3d operator*(const Eigen::Vector3d& pInB) const { return rotation * pInB + translation; }

    /// aFromC = aFromB * bFromC.
    Rigid3 operator*(const Rigid3& bFromC) const {
        return {(rotation * bFromC.rotation).normalized(), rotation * bFromC.translation + translation};
    }

    /// bFromA of aFromB.
    Rigid3 inverse() const {
        const Eigen::Quaterniond bFromA = rotation.conjugate();
        return {bFromA, -(bFromA * translation)};
    }
};

} // namespace spherewalk
