// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/render/camera_info.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <vector>

namespace spherewalk::render {

namespace {

[[noreturn]] void refuseCamera(const std::string& source, const std::string& what) {
    throw Error(ErrorKind::InvalidInput, text("Could not read the camera ", source, ": ", what,
                                              "; it should be a ROS camera-info YAML."));
}

std::vector<double> matrixOf(const YAML::Node& root, const std::string& key, const std::string& source) {
    const YAML::Node data = root[key] ? root[key]["data"] : YAML::Node();
    if (!data || !data.IsSequence() || data.size() > 64) {
        refuseCamera(source, text("the entry ", key, "/data is missing or no list"));
    }
    try {
        return data.as<std::vector<double>>();
    } catch (const YAML::Exception&) {
        refuseCamera(source, text("the entry ", key, "/data holds something that is not a number"));
    }
}

int sizeOf(const YAML::Node& root, const std::string& key, const std::string& source) {
    try {
        return root[key].as<int>();
    } catch (const YAML::Exception&) {
        refuseCamera(source, text("the entry ", key, " is missing or not a whole number"));
    }
}

void readDistortion(const YAML::Node& root, const std::string& source, Calibration& calibration) {
    const YAML::Node model = root["distortion_model"];
    calibration.distortionModel = model && model.IsScalar() ? model.as<std::string>() : "";
    const bool isPinhole = calibration.distortionModel.empty() || calibration.distortionModel == "none";
    if (!isPinhole || root["distortion_coefficients"]) {
        calibration.d = matrixOf(root, "distortion_coefficients", source);
    }
}

} // namespace

CameraIntrinsics parseCameraInfo(std::string_view yaml, const std::string& source) {
    YAML::Node root;
    try {
        root = YAML::Load(std::string(yaml));
    } catch (const YAML::Exception&) {
        refuseCamera(source, "it is not valid YAML");
    }
    if (!root.IsMap()) {
        refuseCamera(source, "it holds no entries");
    }
    const std::vector<double> k = matrixOf(root, "camera_matrix", source);
    if (k.size() != 9) {
        refuseCamera(source, text("the camera_matrix has ", k.size(), " values, not 9"));
    }
    Calibration calibration;
    calibration.width = sizeOf(root, "image_width", source);
    calibration.height = sizeOf(root, "image_height", source);
    std::copy(k.begin(), k.end(), calibration.k.begin());
    readDistortion(root, source, calibration);
    try {
        return intrinsicsOf(calibration);
    } catch (const Error& error) {
        throw Error(ErrorKind::InvalidInput,
                    text("Could not use the camera ", source, ": ", error.sentence()));
    }
}

CameraIntrinsics readCameraInfo(const std::filesystem::path& file) {
    constexpr std::uint64_t kLargest = 1 << 20;
    return parseCameraInfo(readTextFile(file, kLargest), file.string());
}

std::string cameraInfoYaml(const CameraIntrinsics& camera, const std::string& cameraName) {
    std::string coefficients;
    for (const double k : camera.distortion) {
        coefficients += text(coefficients.empty() ? "" : ", ", k);
    }
    const auto& [width, height, fx, fy, cx, cy, lensModel, distortion] = camera;
    return text("image_width: ", width, "\nimage_height: ", height, "\ncamera_name: ", cameraName,
                "\ncamera_matrix:\n  rows: 3\n  cols: 3\n  data: [", fx, ", 0, ", cx, ", 0, ", fy, ", ", cy,
                ", 0, 0, 1]\ndistortion_model: ", name(lensModel),
                "\ndistortion_coefficients:\n  rows: 1\n  cols: ", distortion.size(), "\n  data: [",
                coefficients,
                "]\nrectification_matrix:\n  rows: 3\n  cols: 3\n  data: [1, 0, 0, 0, 1, 0, 0, 0, 1]\n",
                "projection_matrix:\n  rows: 3\n  cols: 4\n  data: [", fx, ", 0, ", cx, ", 0, 0, ", fy, ", ",
                cy, ", 0, 0, 0, 1, 0]\n");
}

} // namespace spherewalk::render
