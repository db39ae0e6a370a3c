// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/render/camera_info.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
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

// -------- rigs

namespace {

constexpr std::uint64_t kLargestRig = 1 << 20;

/// Reads the entries of a rig's YAML, and says which of them is wrong.
class RigReader {
  public:
    explicit RigReader(std::filesystem::path file) : m_file(std::move(file)) {}

    std::vector<RigCamera> read() {
        const YAML::Node root = load();
        requireKnown(root, {"cameras", "axes"}, "");
        const std::string axes = root["axes"] ? word(root, "axes", "") : "optical";
        if (axes != "optical" && axes != "body") {
            fail(
                text("axes is \"", printable(axes), "\"; it can be optical (z forward) or body (x forward)"));
        }
        const YAML::Node list = root["cameras"];
        if (!list || !list.IsSequence() || list.size() == 0 || list.size() > kMostRigCameras) {
            fail(text("the entry cameras must be a list of 1 to ", kMostRigCameras, " cameras"));
        }
        std::vector<RigCamera> cameras;
        std::set<std::string> names;
        std::set<std::string> frames;
        for (const YAML::Node& entry : list) {
            cameras.push_back(camera(entry, axes == "body", cameras.size() + 1));
            if (!names.insert(cameras.back().name).second || !frames.insert(cameras.back().frameId).second) {
                fail(text("two cameras are called ", cameras.back().name, ", or have the frame ",
                          printable(cameras.back().frameId)));
            }
        }
        return cameras;
    }

  private:
    [[noreturn]] void fail(const std::string& why) const {
        throw Error(ErrorKind::InvalidInput,
                    text("Could not read the rig ", m_file.string(), ": ", why, "."));
    }

    YAML::Node load() const {
        const std::string yaml = readTextFile(m_file, kLargestRig);
        try {
            const YAML::Node root = YAML::Load(yaml);
            if (root.IsMap()) {
                return root;
            }
        } catch (const YAML::Exception&) { // told below
        }
        fail("it is no YAML with an entry cameras");
    }

    void requireKnown(const YAML::Node& map, const std::set<std::string>& known,
                      const std::string& whose) const {
        for (const auto& entry : map) {
            const auto name = entry.first.as<std::string>("");
            if (!known.contains(name)) {
                std::string list;
                for (const std::string& one : known) {
                    list += text(list.empty() ? "" : ", ", one);
                }
                fail(text("the entry ", printable(name), whose, " is unknown; there are ", list));
            }
        }
    }

    std::string word(const YAML::Node& map, const std::string& key, const std::string& whose) const {
        const YAML::Node node = map[key];
        const auto value = node && node.IsScalar() ? node.as<std::string>("") : "";
        if (value.empty()) {
            fail(text("the entry ", key, whose, " is missing or no word"));
        }
        return value;
    }

    RigCamera camera(const YAML::Node& entry, bool isBody, std::size_t number) const {
        if (!entry.IsMap()) {
            fail(text("camera ", number, " has no entries"));
        }
        RigCamera camera;
        camera.name = word(entry, "name", text(" of camera ", number));
        const auto isPlain = [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
        };
        if (camera.name.size() > 64 || !std::all_of(camera.name.begin(), camera.name.end(), isPlain)) {
            fail(text("camera ", number, " is called \"", printable(camera.name),
                      "\"; a name has up to 64 letters, digits and _"));
        }
        const std::string whose = text(" of camera ", camera.name);
        requireKnown(entry, {"name", "camera_info", "rig_from_camera", "frame_id"}, whose);
        camera.frameId = entry["frame_id"] ? word(entry, "frame_id", whose) : camera.name + "_optical";
        camera.camera = readCameraInfo(m_file.parent_path() / word(entry, "camera_info", whose));
        if (const YAML::Node place = entry["rig_from_camera"]) {
            camera.rigFromOptical =
                pose(place, whose) *
                Rigid3{isBody ? bodyFromOptical() : Eigen::Quaterniond::Identity(), Eigen::Vector3d::Zero()};
        }
        return camera;
    }

    Rigid3 pose(const YAML::Node& node, const std::string& whose) const {
        std::vector<double> v;
        try {
            v = node.as<std::vector<double>>();
        } catch (const YAML::Exception&) { // told below
        }
        const Rigid3 pose = v.size() == 7 ? Rigid3{{v[6], v[3], v[4], v[5]}, {v[0], v[1], v[2]}}
                                          : Rigid3{{0, 0, 0, 0}, {0, 0, 0}};
        if (!isPose(pose)) {
            fail(text("the entry rig_from_camera", whose,
                      " must be a list of seven numbers, [x, y, z, qx, qy, qz, qw], in metres and with a "
                      "rotation of unit length"));
        }
        return {pose.rotation.normalized(), pose.translation};
    }

    std::filesystem::path m_file;
};

} // namespace

std::vector<RigCamera> readRig(const std::filesystem::path& file) {
    return RigReader(file).read();
}

std::vector<Rigid3> placesOnRig(const std::vector<RigCamera>& rig, std::string_view what) {
    std::vector<Rigid3> places;
    for (const RigCamera& camera : rig) {
        if (!camera.rigFromOptical) {
            throw Error(ErrorKind::InvalidInput,
                        text("The camera ", camera.name, " of the rig ", what,
                             " has no rig_from_camera: write where it sits; only a node of ROS can take that "
                             "from tf."));
        }
        places.push_back(*camera.rigFromOptical);
    }
    return places;
}

double stereoBaselineM(const CameraIntrinsics& first, const CameraIntrinsics& second,
                       const Rigid3& firstFromSecond) {
    constexpr double kLevelM = 1e-5; // what files round to
    constexpr double kEvenRad = 1e-5;
    constexpr double kPerM = 1e9;
    const Eigen::Vector3d& at = firstFromSecond.translation;
    const bool isSideBySide =
        first == second && first.lens == LensModel::Pinhole && std::abs(at.y()) < kLevelM &&
        std::abs(at.z()) < kLevelM &&
        firstFromSecond.rotation.angularDistance(Eigen::Quaterniond::Identity()) < kEvenRad;
    return isSideBySide ? std::round(at.x() * kPerM) / kPerM : 0;
}

Calibration stereoCalibration(const CameraIntrinsics& camera, double baselineM) {
    Calibration result = calibration(camera);
    result.p[3] = baselineM == 0 ? 0 : -camera.fx * baselineM;
    return result;
}

} // namespace spherewalk::render
