// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fast_view.h"

#include <vector>

namespace spherewalk::bench {

/// A photo in the forms that views are taken from.
struct Source {
    RgbImage picture;
    render::PhotoPlane plane;
    render::PhotoPlane half;
};

struct Fidelity {
    double meanDb = 0;
    double worstDb = 0;
};

constexpr std::array kRungs{render::Sampling::Nearest, render::Sampling::Bilinear, render::Sampling::Reduced,
                            render::Sampling::Footprint, render::Sampling::Bicubic};

/// Peak signal to noise ratio of each rung (as kRungs) against the mean of 8 x 8 samples a pixel, each
/// bilinear and in double precision, over so many directions with pitches to +-80 degrees.
std::vector<Fidelity> fidelity(const Source& source, const CameraModel& camera, int directions);

/// A view looking so many degrees left and up.
Rigid3 lookingTo(double yawDeg, double pitchDeg, const Eigen::Vector3d& at = Eigen::Vector3d::Zero());

} // namespace spherewalk::bench
