// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/dataset/pose_formats.h"

#include "spherewalk/base/enum_names.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/trajectory.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace spherewalk::dataset {

using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace {

constexpr EnumNames<PoseFormat, 5> kPoseFormats{{{PoseFormat::Tum, "tum"},
                                                 {PoseFormat::Kitti, "kitti"},
                                                 {PoseFormat::Euroc, "euroc"},
                                                 {PoseFormat::Colmap, "colmap"},
                                                 {PoseFormat::Nerfstudio, "nerfstudio"}}};
constexpr double kCorner = 0.5; ///< from a pixel's centre to where COLMAP and nerfstudio count from

/// One sign for the two quaternions of a rotation.
Quaterniond upright(const Quaterniond& q) {
    return q.w() < 0 ? Quaterniond(-q.w(), -q.x(), -q.y(), -q.z()) : q;
}

std::vector<TextFile> tum(std::span<const PosedFrame> frames) {
    std::vector<TimedPose> poses;
    for (const PosedFrame& frame : frames) {
        poses.push_back({frame.timeS, frame.roomFromCamera});
    }
    return {{"groundtruth.txt", tumText(poses)}};
}

std::vector<TextFile> kitti(std::span<const PosedFrame> frames) {
    std::string poses;
    std::string times;
    const Rigid3 firstFromRoom = frames.front().roomFromCamera.inverse();
    for (const PosedFrame& frame : frames) {
        const Rigid3 firstFromCamera = firstFromRoom * frame.roomFromCamera;
        const Eigen::Matrix3d rotation = firstFromCamera.rotation.toRotationMatrix();
        for (Eigen::Index row = 0; row < 3; ++row) {
            poses += text(row == 0 ? "" : " ", rotation(row, 0), " ", rotation(row, 1), " ", rotation(row, 2),
                          " ", firstFromCamera.translation[row]);
        }
        poses += "\n";
        times += text(frame.timeS, "\n");
    }
    return {{"poses.txt", poses}, {"times.txt", times}};
}

/// Differences to the neighbours on either side; at the ends to the one there is.
Vector3d velocity(std::span<const PosedFrame> frames, std::size_t i) {
    const PosedFrame& before = frames[i > 0 ? i - 1 : 0];
    const PosedFrame& after = frames[std::min(i + 1, frames.size() - 1)];
    const double seconds = after.timeS - before.timeS;
    return seconds > 0
               ? Vector3d((after.roomFromCamera.translation - before.roomFromCamera.translation) / seconds)
               : Vector3d::Zero();
}

std::vector<TextFile> euroc(std::span<const PosedFrame> frames) {
    std::string lines =
        "#timestamp, p_RS_R_x [m], p_RS_R_y [m], p_RS_R_z [m], q_RS_w [], q_RS_x [], q_RS_y [], "
        "q_RS_z [], v_RS_R_x [m s^-1], v_RS_R_y [m s^-1], v_RS_R_z [m s^-1], b_w_RS_S_x [rad "
        "s^-1], b_w_RS_S_y [rad s^-1], b_w_RS_S_z [rad s^-1], b_a_RS_S_x [m s^-2], b_a_RS_S_y [m "
        "s^-2], b_a_RS_S_z [m s^-2]\n";
    for (std::size_t i = 0; i < frames.size(); ++i) {
        if (i > 0 && !(frames[i].timeS > frames[i - 1].timeS)) {
            throw Error(ErrorKind::InvalidInput,
                        text("Could not write EuRoC's poses: the time ", frames[i].timeS, " s of ",
                             frames[i].file,
                             " is not after the one before; give poses in the order of rising times."));
        }
        const Vector3d& t = frames[i].roomFromCamera.translation;
        const Quaterniond q = upright(frames[i].roomFromCamera.rotation);
        const Vector3d v = velocity(frames, i);
        lines +=
            text(std::llround(1e9 * frames[i].timeS), ",", t.x(), ",", t.y(), ",", t.z(), ",", q.w(), ",",
                 q.x(), ",", q.y(), ",", q.z(), ",", v.x(), ",", v.y(), ",", v.z(), ",0,0,0,0,0,0\n");
    }
    return {{"mav0/state_groundtruth_estimate0/data.csv", lines}};
}

/// A camera as COLMAP knows it.
std::string colmapCamera(const CameraIntrinsics& k) {
    std::string line =
        text(k.width, " ", k.height, " ", k.fx, " ", k.fy, " ", k.cx + kCorner, " ", k.cy + kCorner);
    const auto& d = k.distortion;
    switch (k.lens) {
    case LensModel::Pinhole:
        return "PINHOLE " + line;
    case LensModel::PlumbBob:
        return text("FULL_OPENCV ", line, " ", d[0], " ", d[1], " ", d[2], " ", d[3], " ", d[4], " 0 0 0");
    case LensModel::RationalPolynomial:
        if (d.size() > 8) {
            throw Error(ErrorKind::Unsupported,
                        "COLMAP has no lens model with a thin prism or a tilted sensor: render with a camera "
                        "of another lens model.");
        }
        return text("FULL_OPENCV ", line, " ", d[0], " ", d[1], " ", d[2], " ", d[3], " ", d[4], " ", d[5],
                    " ", d[6], " ", d[7]);
    case LensModel::Equidistant:
        return text("OPENCV_FISHEYE ", line, " ", d[0], " ", d[1], " ", d[2], " ", d[3]);
    }
    throw Error(ErrorKind::Internal, "A lens model that COLMAP has no name for.");
}

bool hasTests(std::span<const PosedFrame> frames) {
    return std::any_of(frames.begin(), frames.end(), [](const PosedFrame& frame) { return frame.isTest; });
}

std::string colmapPoints(std::span<const ColouredPoint> points) {
    std::string lines = "# POINT3D_ID, X, Y, Z, R, G, B, ERROR, TRACK[] as (IMAGE_ID, POINT2D_IDX)\n";
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vector3d& at = points[i].pInRoom;
        const auto& [red, green, blue] = points[i].colour;
        lines += text(i + 1, " ", at.x(), " ", at.y(), " ", at.z(), " ", int{red}, " ", int{green}, " ",
                      int{blue}, " -1\n");
    }
    return lines;
}

std::vector<TextFile> colmap(const FrameCamera& camera, std::span<const PosedFrame> frames,
                             std::span<const ColouredPoint> points) {
    const auto* intrinsics = std::get_if<CameraIntrinsics>(&camera);
    if (intrinsics == nullptr) {
        throw Error(
            ErrorKind::Unsupported,
            "COLMAP's text files know no spherical pictures: have them cut into the faces of a cube.");
    }
    std::vector<PosedFrame> sorted; // as COLMAP numbers the pictures of a folder
    for (const PosedFrame& frame : frames) {
        sorted.push_back(
            {frame.file.substr(frame.file.rfind('/') + 1), frame.timeS, frame.roomFromCamera, frame.isTest});
    }
    std::sort(sorted.begin(), sorted.end(),
              [](const PosedFrame& a, const PosedFrame& b) { return a.file < b.file; });
    std::string images = "# IMAGE_ID, QW, QX, QY, QZ, TX, TY, TZ, CAMERA_ID, NAME\n# POINTS2D[] as (X, Y, "
                         "POINT3D_ID)\n";
    std::array<std::string, 2> names; // of pictures to train with, and to test with
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        const Rigid3 cameraFromRoom = sorted[i].roomFromCamera.inverse();
        const Quaterniond q = upright(cameraFromRoom.rotation);
        const Vector3d& t = cameraFromRoom.translation;
        images += text(i + 1, " ", q.w(), " ", q.x(), " ", q.y(), " ", q.z(), " ", t.x(), " ", t.y(), " ",
                       t.z(), " 1 ", sorted[i].file, "\n\n");
        names.at(sorted[i].isTest ? 1 : 0) += sorted[i].file + "\n";
    }
    std::vector<TextFile> files{
        {"sparse/0/cameras.txt",
         text("# CAMERA_ID, MODEL, WIDTH, HEIGHT, PARAMS[]\n1 ", colmapCamera(*intrinsics), "\n")},
        {"sparse/0/images.txt", images},
        {"sparse/0/points3D.txt", colmapPoints(points)}};
    if (hasTests(frames)) {
        files.push_back({"sparse/0/train.txt", names[0]});
        files.push_back({"sparse/0/test.txt", names[1]});
    }
    return files;
}

/// The camera's part of transforms.json.
Json nerfstudioCamera(const CameraIntrinsics& k) {
    Json camera{{"camera_model", k.lens == LensModel::Equidistant ? "OPENCV_FISHEYE" : "OPENCV"},
                {"w", k.width},
                {"h", k.height},
                {"fl_x", k.fx},
                {"fl_y", k.fy},
                {"cx", k.cx + kCorner},
                {"cy", k.cy + kCorner}};
    const bool isFisheye = k.lens == LensModel::Equidistant;
    constexpr std::array kFisheye{"k1", "k2", "k3", "k4"};
    constexpr std::array kOpenCv{"k1", "k2", "p1", "p2", "k3"};
    if (k.lens == LensModel::RationalPolynomial) {
        throw Error(ErrorKind::Unsupported,
                    "nerfstudio has no lens model with a rational polynomial: render with "
                    "a camera of another lens model.");
    }
    for (std::size_t i = 0; i < k.distortion.size(); ++i) {
        camera[isFisheye ? kFisheye.at(i) : kOpenCv.at(i)] = k.distortion[i];
    }
    return camera;
}

Json nerfstudioCamera(const EquirectSize& size) {
    return {{"camera_model", "EQUIRECTANGULAR"},
            {"w", size.width},
            {"h", size.height},
            {"fl_x", size.width / 2.0}, // pixels for half a turn
            {"fl_y", size.height},
            {"cx", size.width / 2.0},
            {"cy", size.height / 2.0}};
}

std::vector<TextFile> nerfstudio(const FrameCamera& camera, std::span<const PosedFrame> frames,
                                 std::span<const ColouredPoint> points) {
    Json json = std::visit([](const auto& one) { return nerfstudioCamera(one); }, camera);
    json["frames"] = Json::array();
    for (const PosedFrame& frame : frames) {
        Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
        matrix.topLeftCorner<3, 3>() = frame.roomFromCamera.rotation.toRotationMatrix();
        matrix.col(1) *= -1; // its y axis points up,
        matrix.col(2) *= -1; // and its z axis backwards
        matrix.topRightCorner<3, 1>() = frame.roomFromCamera.translation;
        Json rows = Json::array();
        for (Eigen::Index row = 0; row < 4; ++row) {
            rows.push_back({matrix(row, 0), matrix(row, 1), matrix(row, 2), matrix(row, 3)});
        }
        json["frames"].push_back({{"file_path", frame.file}, {"transform_matrix", rows}});
    }
    if (!points.empty()) {
        json["ply_file_path"] = kPointsFile;
    }
    if (hasTests(frames)) {
        for (const char* split : {"train_filenames", "val_filenames", "test_filenames"}) {
            json[split] = Json::array(); // nerfstudio refuses a file without one of the three
        }
        for (const PosedFrame& frame : frames) {
            if (frame.isTest) {
                json["val_filenames"].push_back(frame.file);
            }
            json[frame.isTest ? "test_filenames" : "train_filenames"].push_back(frame.file);
        }
    }
    return {{"transforms.json", json.dump(1) + "\n"}};
}

} // namespace

std::string_view name(PoseFormat format) {
    return nameOf(kPoseFormats, format);
}

PoseFormat poseFormat(std::string_view name) {
    return valueOf(kPoseFormats, "The format of poses", name);
}

bool knowsLearning(PoseFormat format) {
    return format == PoseFormat::Colmap || format == PoseFormat::Nerfstudio;
}

std::vector<TextFile> poseFiles(PoseFormat format, const FrameCamera& camera,
                                std::span<const PosedFrame> frames, std::span<const ColouredPoint> points) {
    if (frames.empty()) {
        throw Error(ErrorKind::InvalidInput, "There are no frames to write poses of.");
    }
    if (!knowsLearning(format) && (!points.empty() || hasTests(frames))) {
        throw Error(ErrorKind::InvalidInput, text("The format ", name(format),
                                                  " knows no points and no pictures for tests: choose colmap "
                                                  "or nerfstudio."));
    }
    switch (format) {
    case PoseFormat::Tum:
        return tum(frames);
    case PoseFormat::Kitti:
        return kitti(frames);
    case PoseFormat::Euroc:
        return euroc(frames);
    case PoseFormat::Colmap:
        return colmap(camera, frames, points);
    case PoseFormat::Nerfstudio:
        return nerfstudio(camera, frames, points);
    }
    throw Error(ErrorKind::Internal, "A format of poses without a writer.");
}

} // namespace spherewalk::dataset
