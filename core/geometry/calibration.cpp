// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/geometry/calibration.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/camera_model.h"

#include <algorithm>

namespace spherewalk {

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

namespace {

LensModel lensOf(const Calibration& calibration) {
    if (std::all_of(calibration.d.begin(), calibration.d.end(), [](double one) { return one == 0; })) {
        return LensModel::Pinhole;
    }
    for (const LensModel lens :
         {LensModel::PlumbBob, LensModel::RationalPolynomial, LensModel::Equidistant}) {
        if (calibration.distortionModel == name(lens)) {
            return lens;
        }
    }
    throw Error(ErrorKind::Unsupported,
                text("The distortion model \"", printable(calibration.distortionModel),
                     "\" is unknown; there are plumb_bob, rational_polynomial and equidistant."));
}

} // namespace

CameraIntrinsics intrinsicsOf(const Calibration& calibration) {
    const auto& k = calibration.k;
    if (k[1] != 0 || k[3] != 0 || k[6] != 0 || k[7] != 0 || k[8] != 1) {
        throw Error(
            ErrorKind::Unsupported,
            "The camera matrix K is not fx 0 cx, 0 fy cy, 0 0 1; a camera with skewed pixels cannot be "
            "simulated.");
    }
    const LensModel lens = lensOf(calibration);
    const CameraIntrinsics camera{calibration.width,
                                  calibration.height,
                                  k[0],
                                  k[4],
                                  k[2],
                                  k[5],
                                  lens,
                                  lens == LensModel::Pinhole ? std::vector<double>() : calibration.d};
    camera.validate();
    return camera;
}

} // namespace spherewalk
