// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/geometry/camera_model.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace spherewalk::render {

/// The camera that a ROS camera-info YAML describes, as camera_calibration and camera_info_manager write it:
/// image_width, image_height, camera_matrix, distortion_model (plumb_bob, rational_polynomial, equidistant or
/// fisheye, none or absent) and distortion_coefficients. Its rectification and projection matrices concern
/// rectified pictures and are not used: a view shows what the camera itself would. Errors: NotFound, Io;
/// InvalidInput, naming the file and the entry.
CameraIntrinsics readCameraInfo(const std::filesystem::path& file);

/// The same from the YAML's text; source: what it is, for sentences.
CameraIntrinsics parseCameraInfo(std::string_view yaml, const std::string& source);

/// The YAML that parseCameraInfo() turns back into the same camera.
std::string cameraInfoYaml(const CameraIntrinsics& camera, const std::string& cameraName);

} // namespace spherewalk::render
