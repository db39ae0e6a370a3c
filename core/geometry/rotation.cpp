// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/geometry/rotation.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <cmath>

namespace spherewalk {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

Quaterniond rotation(const YawPitchRoll& angles) {
    return AngleAxisd(angles.yaw.value(), Vector3d::UnitZ()) *
           AngleAxisd(angles.pitch.value(), Vector3d::UnitY()) *
           AngleAxisd(angles.roll.value(), Vector3d::UnitX());
}

YawPitchRoll yawPitchRoll(const Quaterniond& rotation) {
    const Eigen::Matrix3d m = rotation.normalized().toRotationMatrix();
    // atan2 of both components keeps pitch exact near the poles, where asin loses half of the digits.
    const double cosPitch = std::hypot(m(0, 0), m(1, 0));
    const Radians pitch(std::atan2(-m(2, 0), cosPitch));
    const double roll = cosPitch < 1e-12 ? 0 : std::atan2(m(2, 1), m(2, 2));
    // With the roll undone, the second column is (-sin yaw, cos yaw, 0): well conditioned at any pitch.
    const double yaw = std::atan2(m(0, 2) * std::sin(roll) - m(0, 1) * std::cos(roll),
                                  m(1, 1) * std::cos(roll) - m(1, 2) * std::sin(roll));
    return {wrapped(Radians(yaw)), pitch, wrapped(Radians(roll))};
}

Quaterniond yawRotation(Radians yaw) {
    return Quaterniond(AngleAxisd(yaw.value(), Vector3d::UnitZ()));
}

Radians angleBetween(const Quaterniond& a, const Quaterniond& b) {
    const Quaterniond difference = a.conjugate() * b;
    return Radians(2 * std::atan2(difference.vec().norm(), std::abs(difference.w())));
}

Radians angleBetween(const Vector3d& a, const Vector3d& b) {
    // Kahan's formula: accurate for parallel and antiparallel directions alike.
    const Vector3d u = a.normalized();
    const Vector3d v = b.normalized();
    return Radians(2 * std::atan2((u - v).norm(), (u + v).norm()));
}

Quaterniond bodyFromOptical() {
    return {0.5, -0.5, 0.5, -0.5};
}

Quaterniond checkedQuaternion(double w, double x, double y, double z, std::string_view whose) {
    const Quaterniond q(w, x, y, z);
    const double length = q.norm();
    if (!std::isfinite(length) || std::abs(length - 1) > 0.01) {
        throw Error(ErrorKind::InvalidInput,
                    text("The rotation of ", whose, " (w ", w, ", x ", x, ", y ", y, ", z ", z,
                         ") is not a unit quaternion; check the order and the values of its components."));
    }
    return q.normalized();
}

Eigen::Quaterniond turn(const Eigen::Vector3d& turnRad) {
    const double angle = turnRad.norm();
    const double half = angle / 2;
    // Near zero the division loses all digits; the series of sin(angle / 2) / angle keeps them.
    const double scale = angle < 1e-6 ? 0.5 - angle * angle / 48 : std::sin(half) / angle;
    return {std::cos(half), scale * turnRad.x(), scale * turnRad.y(), scale * turnRad.z()};
}

} // namespace spherewalk
