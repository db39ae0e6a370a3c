// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sphere/exact_view.h"

#include "spherewalk/geometry/camera_model.h"

#include <span>

namespace spherewalk::render::simd {

/// The depths, along the axis, of a row of a pinhole's pixels in the sphere. They are computed in double
/// precision, and are the same on every processor. inCamera: the camera in the optical frame.
void sphereDepths(const CameraIntrinsics& camera, const DisplacedCamera& inCamera, double radiusM, int y,
                  std::span<float> depths);

} // namespace spherewalk::render::simd
