// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/rigid3.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

/// A camera of a rig: of several cameras that a robot carries together, as a stereo pair.
struct RigCamera {
    std::string name;    ///< Names its folder and its topics. Range: letters, digits and "_".
    std::string frameId; ///< Of its optical frame, in the headers of pictures.
    CameraIntrinsics camera;
    /// The pose of the optical frame in the rig's frame, whose poses the simulator knows. Nothing where the
    /// file leaves it to the transforms of a robot (tf).
    std::optional<Rigid3> rigFromOptical;
};

inline constexpr std::size_t kMostRigCameras = 16;

/// The cameras of a rig's YAML; resources/docs/formats.md has its entries. Camera-info files are looked for
/// beside the YAML. Errors: NotFound, Io; InvalidInput, with the file, the camera and the entry.
std::vector<RigCamera> readRig(const std::filesystem::path& file);

/// The poses of the rig's cameras in the rig. what: the rig, for the sentence. Errors: InvalidInput for a
/// camera that leaves its pose to tf.
std::vector<Rigid3> placesOnRig(const std::vector<RigCamera>& rig, std::string_view what);

/// How far the second camera stands to the right of the first, to a nanometre, if the pictures of both need
/// no rectification: the same pinhole, turned the same, side by side. Otherwise 0.
double stereoBaselineM(const CameraIntrinsics& first, const CameraIntrinsics& second,
                       const Rigid3& firstFromSecond);

/// The calibration of a camera that stands baselineM to the right of a stereo pair's left one. Programs that
/// look for disparities take the baseline from the matrix p.
Calibration stereoCalibration(const CameraIntrinsics& camera, double baselineM);

} // namespace spherewalk::render
