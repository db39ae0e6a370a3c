// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/simulator/calibration.h"

namespace spherewalk::simulator {

Calibration calibration(const CameraIntrinsics& camera) {
    const auto& [width, height, fx, fy, cx, cy, lens, distortion] = camera;
    const bool isPinhole = lens == LensModel::Pinhole;
    return {width,
            height,
            std::string(name(isPinhole ? LensModel::PlumbBob : lens)),
            isPinhole ? std::vector<double>(5) : distortion,
            {fx, 0, cx, 0, fy, cy, 0, 0, 1},
            {1, 0, 0, 0, 1, 0, 0, 0, 1},
            {fx, 0, cx, 0, 0, fy, cy, 0, 0, 0, 1, 0}};
}

} // namespace spherewalk::simulator
