// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"

#include "spherewalk/base/json.h"
#include "spherewalk/dataset/pose_formats.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <sstream>

namespace spherewalk::dataset {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr double kExact = 1e-9;

CameraIntrinsics robotCamera() {
    return {640, 480, 500, 510, 320.25, 238.5, LensModel::PlumbBob, {-0.2, 0.05, 0.001, -0.002, 0.01}};
}

/// Two poses that look about, and a point before both.
const Vector3d kPoint(4, 1.5, 1.1);

std::vector<PosedFrame> frames() {
    const auto lookingAt = [](const Vector3d& from, double rollRad) {
        const Vector3d z = (kPoint + Vector3d(0.1, -0.2, 0.15) - from).normalized();
        const Vector3d x = z.cross(Vector3d::UnitZ()).normalized();
        Matrix3d axes;
        axes << x, z.cross(x), z;
        return Rigid3{Quaterniond(axes) * Eigen::AngleAxisd(rollRad, Vector3d::UnitZ()), from};
    };
    return {{"000000.png", 10, lookingAt({1, 1, 1.2}, 0.3)},
            {"000001.png", 10.5, lookingAt({1.2, 0.8, 1.25}, -2.9)},
            {"000002.png", 11.5, lookingAt({1.4, 0.8, 1.3}, 1)}};
}

Vector2d expectedPixel(const PosedFrame& frame) {
    return CameraModel(robotCamera()).project(frame.roomFromCamera.inverse() * kPoint).value();
}

std::string fileOf(PoseFormat format, const std::string& path, const FrameCamera& camera = robotCamera()) {
    for (const TextFile& file : poseFiles(format, camera, frames())) {
        if (file.path == path) {
            return file.text;
        }
    }
    ADD_FAILURE() << "no " << path;
    return "";
}

/// The lines that are no comments, split at spaces and commas.
std::vector<std::vector<std::string>> fieldsOf(const std::string& text) {
    std::vector<std::vector<std::string>> lines;
    std::istringstream all(text);
    for (std::string line; std::getline(all, line);) {
        if (line.empty() || line.starts_with('#')) {
            continue;
        }
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream fields(line);
        lines.emplace_back(std::istream_iterator<std::string>(fields), std::istream_iterator<std::string>());
    }
    return lines;
}

double number(const std::string& field) {
    return std::stod(field);
}

Eigen::Matrix4d matrixOf(const Json& rows) {
    Eigen::Matrix4d matrix;
    for (Eigen::Index i = 0; i < 16; ++i) {
        matrix(i / 4, i % 4) = rows[static_cast<std::size_t>(i / 4)][static_cast<std::size_t>(i % 4)];
    }
    return matrix;
}

} // namespace

TEST(PoseFormats, ColmapProjectsThePointWhereTheCameraDoes) {
    const auto camera = fieldsOf(fileOf(PoseFormat::Colmap, "sparse/0/cameras.txt")).at(0);
    ASSERT_EQ(camera[1], "FULL_OPENCV");
    const CameraIntrinsics k{std::stoi(camera[2]),
                             std::stoi(camera[3]),
                             number(camera[4]),
                             number(camera[5]),
                             number(camera[6]),
                             number(camera[7]),
                             LensModel::RationalPolynomial,
                             {number(camera[8]), number(camera[9]), number(camera[10]), number(camera[11]),
                              number(camera[12]), number(camera[13]), number(camera[14]),
                              number(camera[15])}};
    const auto images = fieldsOf(fileOf(PoseFormat::Colmap, "sparse/0/images.txt"));
    ASSERT_EQ(images.size(), frames().size());
    for (std::size_t i = 0; i < images.size(); ++i) {
        const auto& line = images[i];
        EXPECT_EQ(line.at(9), frames()[i].file);
        const Quaterniond q(number(line[1]), number(line[2]), number(line[3]), number(line[4]));
        const Vector3d t(number(line[5]), number(line[6]), number(line[7]));
        const Vector2d pixel = CameraModel(k).project(q * kPoint + t).value();
        EXPECT_LT((pixel - Vector2d(0.5, 0.5) - expectedPixel(frames()[i])).norm(), kExact);
    }
}

TEST(PoseFormats, ColmapKnowsEveryLens) {
    for (const auto& [lens, count, name] : {std::tuple{LensModel::Pinhole, 0, "PINHOLE"},
                                            std::tuple{LensModel::RationalPolynomial, 8, "FULL_OPENCV"},
                                            std::tuple{LensModel::Equidistant, 4, "OPENCV_FISHEYE"}}) {
        CameraIntrinsics camera = robotCamera();
        camera.lens = lens;
        camera.distortion.assign(static_cast<std::size_t>(count), 0.001);
        const auto fields = fieldsOf(fileOf(PoseFormat::Colmap, "sparse/0/cameras.txt", camera)).at(0);
        EXPECT_EQ(fields[1], name);
        EXPECT_EQ(fields.size(), 8U + static_cast<std::size_t>(count));
    }
    test::expectError(ErrorKind::Unsupported, "cube", [] {
        poseFiles(PoseFormat::Colmap, EquirectSize{2048, 1024}, frames());
    });
}

TEST(PoseFormats, NerfstudioSeesThePointWhereTheCameraDoes) {
    const Json json = parseJson(fileOf(PoseFormat::Nerfstudio, "transforms.json"), "transforms.json");
    EXPECT_EQ(json["camera_model"], "OPENCV");
    const CameraIntrinsics k{json["w"],
                             json["h"],
                             json["fl_x"],
                             json["fl_y"],
                             json["cx"].get<double>() - 0.5,
                             json["cy"].get<double>() - 0.5,
                             LensModel::PlumbBob,
                             {json["k1"], json["k2"], json["p1"], json["p2"], json["k3"]}};
    ASSERT_EQ(json["frames"].size(), frames().size());
    for (std::size_t i = 0; i < frames().size(); ++i) {
        const Eigen::Matrix4d worldFromGl = matrixOf(json["frames"][i]["transform_matrix"]);
        const Vector3d inGl = (worldFromGl.inverse() * kPoint.homogeneous()).head<3>();
        EXPECT_LT(inGl.z(), 0) << "it looks along -z";
        const Vector2d pixel = CameraModel(k).project({inGl.x(), -inGl.y(), -inGl.z()}).value();
        EXPECT_LT((pixel - expectedPixel(frames()[i])).norm(), 1e-6);
    }
    CameraIntrinsics camera = robotCamera();
    camera.lens = LensModel::RationalPolynomial;
    camera.distortion.assign(8, 0.001);
    test::expectError(ErrorKind::Unsupported, "rational",
                      [&] { poseFiles(PoseFormat::Nerfstudio, camera, frames()); });
    camera.distortion.assign(12, 0.001);
    test::expectError(ErrorKind::Unsupported, "thin prism",
                      [&] { poseFiles(PoseFormat::Colmap, camera, frames()); });
}

TEST(PoseFormats, TellLearnersPointsAndTests) {
    std::vector<PosedFrame> split = frames();
    split[1].isTest = true;
    const std::vector<ColouredPoint> points{{{1, -2, 0.125}, {255, 0, 7}}};
    std::map<std::string, std::string> files;
    for (const PoseFormat format : {PoseFormat::Colmap, PoseFormat::Nerfstudio}) {
        for (const TextFile& file : poseFiles(format, robotCamera(), split, points)) {
            files[file.path] = file.text;
        }
    }
    EXPECT_EQ(files["sparse/0/test.txt"], "000001.png\n");
    EXPECT_EQ(files["sparse/0/train.txt"], "000000.png\n000002.png\n");
    EXPECT_THAT(files["sparse/0/points3D.txt"], testing::EndsWith("\n1 1 -2 0.125 255 0 7 -1\n"));
    const Json json = parseJson(files["transforms.json"], "transforms.json");
    EXPECT_EQ(json["ply_file_path"], "points.ply");
    EXPECT_EQ(json["test_filenames"], Json::array({"000001.png"}));
    EXPECT_EQ(json["val_filenames"], json["test_filenames"]);
    EXPECT_EQ(json["train_filenames"], Json::array({"000000.png", "000002.png"}));
    test::expectError(ErrorKind::InvalidInput, "nerfstudio",
                      [&] { poseFiles(PoseFormat::Tum, robotCamera(), split); });
    test::expectError(ErrorKind::InvalidInput, "nerfstudio",
                      [&] { poseFiles(PoseFormat::Kitti, robotCamera(), frames(), points); });
}

/// Source of the rays: nerfstudio's documentation of its camera types.
TEST(PoseFormats, NerfstudioSeesASpheresPixelsWhereTheyAre) {
    const EquirectSize size{2048, 1024};
    const Json json = parseJson(fileOf(PoseFormat::Nerfstudio, "transforms.json", size), "transforms.json");
    EXPECT_EQ(json["camera_model"], "EQUIRECTANGULAR");
    for (const Vector2d& pixel : {Vector2d(1023.5, 511.5), Vector2d(100, 300), Vector2d(2000, 900)}) {
        const double theta =
            -std::numbers::pi * (pixel.x() + 0.5 - json["cx"].get<double>()) / json["fl_x"].get<double>();
        const double phi = std::numbers::pi *
                           (0.5 + (pixel.y() + 0.5 - json["cy"].get<double>()) / json["fl_y"].get<double>());
        const Vector3d gl(-std::sin(theta) * std::sin(phi), std::cos(phi), -std::cos(theta) * std::sin(phi));
        const Vector3d optical(gl.x(), -gl.y(), -gl.z());
        const Vector3d inPhoto(optical.z(), -optical.x(), -optical.y()); // x forward, y left, z up
        EXPECT_LT((inPhoto - direction(size, pixel)).norm(), 1e-9);
    }
}

TEST(PoseFormats, KittiIsRelativeToTheFirstCamera) {
    const auto lines = fieldsOf(fileOf(PoseFormat::Kitti, "poses.txt"));
    ASSERT_EQ(lines.size(), frames().size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
        ASSERT_EQ(lines[i].size(), 12U);
        Eigen::Matrix<double, 3, 4> firstFromCamera;
        for (Eigen::Index k = 0; k < 12; ++k) {
            firstFromCamera(k / 4, k % 4) = number(lines[i][static_cast<std::size_t>(k)]);
        }
        const Vector3d inCamera = frames()[i].roomFromCamera.inverse() * kPoint;
        const Vector3d inFirst = firstFromCamera * inCamera.homogeneous();
        EXPECT_LT((inFirst - frames()[0].roomFromCamera.inverse() * kPoint).norm(), kExact);
    }
    EXPECT_EQ(fieldsOf(fileOf(PoseFormat::Kitti, "times.txt")).at(1).at(0), "10.5");
}

TEST(PoseFormats, EurocHasPosesVelocitiesAndNanoseconds) {
    const std::string path = "mav0/state_groundtruth_estimate0/data.csv";
    const auto lines = fieldsOf(fileOf(PoseFormat::Euroc, path));
    ASSERT_EQ(lines.size(), frames().size());
    EXPECT_EQ(lines[1][0], "10500000000");
    for (std::size_t i = 0; i < lines.size(); ++i) {
        ASSERT_EQ(lines[i].size(), 17U);
        const Quaterniond q(number(lines[i][4]), number(lines[i][5]), number(lines[i][6]),
                            number(lines[i][7]));
        EXPECT_LT(q.angularDistance(frames()[i].roomFromCamera.rotation), 1e-7);
        EXPECT_EQ(number(lines[i][1]), frames()[i].roomFromCamera.translation.x());
    }
    EXPECT_NEAR(number(lines[1][8]), (1.4 - 1) / 1.5, kExact); // between its neighbours
    EXPECT_NEAR(number(lines[0][8]), 0.2 / 0.5, kExact);
    std::vector<PosedFrame> standing = frames();
    standing[1].timeS = standing[0].timeS;
    test::expectError(ErrorKind::InvalidInput, "rising",
                      [&] { poseFiles(PoseFormat::Euroc, robotCamera(), standing); });
}

TEST(PoseFormats, TumHasTheRoomsPoses) {
    const auto lines = fieldsOf(fileOf(PoseFormat::Tum, "groundtruth.txt"));
    ASSERT_EQ(lines.size(), frames().size());
    EXPECT_EQ(number(lines[2][0]), 11.5);
    EXPECT_EQ(number(lines[2][2]), frames()[2].roomFromCamera.translation.y());
}

TEST(PoseFormats, AreKnownByTheirNames) {
    for (const PoseFormat format : {PoseFormat::Tum, PoseFormat::Kitti, PoseFormat::Euroc, PoseFormat::Colmap,
                                    PoseFormat::Nerfstudio}) {
        EXPECT_EQ(poseFormat(name(format)), format);
        test::expectError(ErrorKind::InvalidInput, "no frames",
                          [&] { poseFiles(format, robotCamera(), {}); });
    }
    test::expectError(ErrorKind::InvalidInput, "nerfstudio", [] { poseFormat("blender"); });
}

} // namespace spherewalk::dataset
