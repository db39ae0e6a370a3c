// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/geometry/angle.h"

#include <Eigen/Geometry>

#include <string_view>

namespace spherewalk {

/// Rotations are Eigen quaternions. A variable aFromB takes coordinates of frame b to frame a.

/// The angles of the rotation Rz(yaw) Ry(pitch) Rx(roll), right-handed: a positive yaw turns left, a positive
/// pitch lowers the nose, a positive roll raises the left side. Frames: x forward, y left, z up (REP 103).
struct YawPitchRoll {
    Radians yaw;
    Radians pitch;
    Radians roll;
};

Eigen::Quaterniond rotation(const YawPitchRoll& angles);

/// The angles from which rotation() makes the same rotation. Range: yaw and roll in (-pi, pi], pitch in
/// [-pi/2, pi/2]. At pitch = +-pi/2 only a sum of yaw and roll is defined; there roll is 0.
YawPitchRoll yawPitchRoll(const Eigen::Quaterniond& rotation);

/// The rotation about z by this angle.
Eigen::Quaterniond yawRotation(Radians yaw);

/// The smallest angle that takes one rotation to the other, in [0, pi]. It is exact for small angles too.
Radians angleBetween(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b);

/// The angle between two directions of any length, in [0, pi]. It is exact for small angles too.
Radians angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// The rotation from the camera's optical frame (z forward, x right, y down) to the body or panorama frame
/// (x forward, y left, z up).
Eigen::Quaterniond bodyFromOptical();

/// The unit quaternion of components from outside, of either sign. `whose` names their owner in a sentence.
/// Errors: InvalidInput if they are not finite or differ from unit length by more than 1 %.
Eigen::Quaterniond checkedQuaternion(double w, double x, double y, double z, std::string_view whose);

/// The matrix of the cross product: skew(a) * b = a x b.
inline Eigen::Matrix3d skew(const Eigen::Vector3d& a) {
    Eigen::Matrix3d matrix;
    matrix << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
    return matrix;
}

/// The rotation about this vector by its length, in radians.
Eigen::Quaterniond turn(const Eigen::Vector3d& turnRad);

} // namespace spherewalk
