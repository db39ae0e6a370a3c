// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/geometry/camera_model.h"

#include <vector>

namespace spherewalk::test {

/// One camera of each lens model, of this size; the fisheye's field ends inside of its picture.
inline std::vector<CameraIntrinsics> everyLens(int width, int height) {
    std::vector<CameraIntrinsics> cameras(4, CameraIntrinsics::pinhole(width, height, 1.3));
    cameras[1].lens = LensModel::PlumbBob;
    cameras[1].distortion = {-0.28, 0.07, 0.0012, -0.0008, 0.01};
    cameras[2].lens = LensModel::RationalPolynomial;
    cameras[2].distortion = {0.3, -0.05, 0.0005, 0.0003, 0.004, 0.6, 0.02, 0.01};
    cameras[3].lens = LensModel::Equidistant;
    cameras[3].fx = cameras[3].fy = 0.16 * width;
    cameras[3].distortion = {-0.02, 0.004, -0.001, 0.0002};
    return cameras;
}

} // namespace spherewalk::test
