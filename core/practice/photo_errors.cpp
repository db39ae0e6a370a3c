// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/practice/photo_errors.h"

#include "prng.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"

namespace spherewalk::practice {

void PhotoErrors::validate() const {
    const double tiltDeg = Degrees(tiltSigma).value();
    if (!(tiltDeg >= 0 && tiltDeg <= 30)) {
        throw Error(
            ErrorKind::InvalidInput,
            text("The practice camera's tilt error must be between 0 and 30 degrees, not ", tiltDeg, "."));
    }
    if (!(positionSigmaM >= 0 && positionSigmaM <= 1)) {
        throw Error(ErrorKind::InvalidInput,
                    text("The practice camera's position error must be between 0 and 1 m, not ",
                         positionSigmaM, "."));
    }
}

Rigid3 PhotoErrors::truePose(const Eigen::Vector3d& nominalPositionM, int shot) const {
    Prng random(seed, static_cast<std::uint64_t>(shot));
    const double yaw = random.uniform(-std::numbers::pi, std::numbers::pi);
    const double pitch = random.normal(tiltSigma.value());
    const double roll = random.normal(tiltSigma.value());
    Rigid3 pose;
    pose.rotation = rotation({Radians(anyYaw ? yaw : 0), Radians(pitch), Radians(roll)});
    pose.translation = nominalPositionM;
    for (int i = 0; i < 3; ++i) {
        pose.translation[i] += random.normal(positionSigmaM);
    }
    return pose;
}

} // namespace spherewalk::practice
