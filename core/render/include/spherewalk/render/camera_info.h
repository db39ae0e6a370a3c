// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/geometry/camera_model.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace spherewalk::render {

/// The camera of a ROS camera-info YAML, as camera_calibration and camera_info_manager write it. It reads
/// image_width, image_height, camera_matrix, distortion_model and distortion_coefficients, as intrinsicsOf()
/// does. The rectification and projection matrices are not used: they concern rectified pictures, and a view
/// shows what the camera itself sees. Errors: NotFound, Io; InvalidInput, with the file and the entry.
CameraIntrinsics readCameraInfo(const std::filesystem::path& file);

/// The same from the YAML's text. source: a name of the text for sentences.
CameraIntrinsics parseCameraInfo(std::string_view yaml, const std::string& source);

/// A YAML that parseCameraInfo() turns back into the same camera.
std::string cameraInfoYaml(const CameraIntrinsics& camera, const std::string& cameraName);

} // namespace spherewalk::render
