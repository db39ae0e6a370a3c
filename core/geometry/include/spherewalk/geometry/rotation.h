// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/geometry/angle.h"

#include <Eigen/Geometry>

#include <string_view>

namespace spherewalk {

/// Rotations as Eigen quaternions. A variable is named aFromB and takes b's coordinates to a's.

/// Rz(yaw) Ry(pitch) Rx(roll), right-handed: yaw > 0 turns left, pitch > 0 lowers the nose, roll > 0 raises
/// the left side. Frames: x forward, y left, z up (REP 103).
struct YawPitchRoll {
    Radians yaw;
    Radians pitch;
    Radians roll;
};

Eigen::Quaterniond rotation(const YawPitchRoll& angles);

/// The angles that rotation() turns back into the same rotation. Range: yaw and roll in (-pi, pi], pitch in
/// [-pi/2, pi/2]; at pitch = +-pi/2, where only yaw -+ roll is defined, roll is 0.
YawPitchRoll yawPitchRoll(const Eigen::Quaterniond& rotation);

/// The turn about z alone.
Eigen::Quaterniond yawRotation(Radians yaw);

/// The smallest angle that takes one rotation to the other, in [0, pi]; exact for small angles too.
Radians angleBetween(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b);

/// The angle between two directions of any length, in [0, pi]; exact for small angles too.
Radians angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// Takes the camera optical frame (z forward, x right, y down) to the body or panorama frame (x forward, y
/// left, z up).
Eigen::Quaterniond bodyFromOptical();

/// The unit quaternion of these components, of either sign. Errors: InvalidInput if they are not finite or
/// not within 1 % of unit length; whose: what they belong to, for the sentence.
Eigen::Quaterniond checkedQuaternion(double w, double x, double y, double z, std::string_view whose);

} // namespace spherewalk
