// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/geometry/rigid3.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace spherewalk::dataset {

/// Text formats in which other programs read pictures with poses.
enum class PoseFormat {
    Tum,        ///< groundtruth.txt: time, position, quaternion.
    Kitti,      ///< times.txt; poses.txt with a 3 x 4 matrix a line, relative to the first picture.
    Euroc,      ///< mav0/state_groundtruth_estimate0/data.csv
    Colmap,     ///< sparse/0/cameras.txt, images.txt, points3D.txt; with tests also train.txt, test.txt
    Nerfstudio, ///< transforms.json
};

/// The words "tum", "kitti", "euroc", "colmap", "nerfstudio". Errors: poseFormat() throws InvalidInput for
/// another word.
std::string_view name(PoseFormat format);
PoseFormat poseFormat(std::string_view name);

/// A picture with its pose.
struct PosedFrame {
    std::string file; ///< Path relative to the folder of the format's files.
    double timeS = 0;
    /// The pose of the optical frame. For a spherical picture, the z axis of this frame goes through the
    /// picture's middle.
    Rigid3 roomFromCamera;
    bool isTest = false; ///< Whether it is left out of training, to be compared with.
};

/// A point that pictures show.
struct ColouredPoint {
    Eigen::Vector3d pInRoom = Eigen::Vector3d::Zero();
    std::array<std::uint8_t, 3> colour = {}; ///< Red, green, blue.
};

/// A pinhole camera with or without distortion, or a whole sphere.
using FrameCamera = std::variant<CameraIntrinsics, EquirectSize>;

struct TextFile {
    std::string path; ///< Relative to the folder that is exported to.
    std::string text;
};

/// The name of the point cloud that nerfstudio's file refers to, if there are points.
inline constexpr const char* kPointsFile = "points.ply";

/// Whether a format has points, and tells the pictures for tests.
bool knowsLearning(PoseFormat format);

/// The files of a format. points: COLMAP's get no tracks and no error (-1); nerfstudio's file only names
/// kPointsFile. Numbers have as many digits as they need to be read back exactly. Frames: the room
/// is the world; KITTI's is the first picture's camera. Pixels: COLMAP and nerfstudio count from the corner
/// of the first pixel, so their centres are half a pixel greater. COLMAP names pictures within their folder
/// and numbers them in the order of their names. EuRoC's velocities are differences between neighbours, its
/// biases 0. Errors: Unsupported for a sphere with COLMAP, and for lenses that a format does not have;
/// InvalidInput for no frames, for times of EuRoC that do not rise, and for points and tests in a format that
/// does not know them.
std::vector<TextFile> poseFiles(PoseFormat format, const FrameCamera& camera,
                                std::span<const PosedFrame> frames,
                                std::span<const ColouredPoint> points = {});

} // namespace spherewalk::dataset
