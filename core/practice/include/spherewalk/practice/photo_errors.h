// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/angle.h"
#include "spherewalk/geometry/rigid3.h"

#include <cstdint>

namespace spherewalk::practice {

/// How far the camera really stands from where the operator says, as on a real cart: turned by any yaw,
/// tilted and shifted a little. The same seed and shot always err alike.
struct PhotoErrors {
    bool anyYaw = true;               ///< each photo is turned by an angle of its own, else none is
    Radians tiltSigma = Degrees(0.5); ///< of pitch and of roll
    double positionSigmaM = 0.003;    ///< along each axis
    std::uint64_t seed = 1;

    /// Errors: InvalidInput for sigmas below 0, above 30 degrees or 1 m, or not finite.
    void validate() const;

    /// The true roomFromPhoto of a shot that was meant to be taken there.
    Rigid3 truePose(const Eigen::Vector3d& nominalPositionM, int shot) const;
};

} // namespace spherewalk::practice
