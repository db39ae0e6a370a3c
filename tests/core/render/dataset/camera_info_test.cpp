// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"

#include "spherewalk/base/text.h"
#include "spherewalk/render/camera_info.h"

namespace spherewalk::render {

using test::expectError;

namespace {

const std::string kHead = "image_width: 640\nimage_height: 480\ncamera_name: robot\n";
const std::string kMatrix =
    "camera_matrix:\n  rows: 3\n  cols: 3\n  data: [500, 0, 319.5, 0, 501, 239.5, 0, 0, 1]\n";

std::string lens(const std::string& model, const std::string& coefficients) {
    return "distortion_model: " + model + "\ndistortion_coefficients:\n  rows: 1\n  cols: 5\n  data: [" +
           coefficients + "]\n";
}

} // namespace

TEST(CameraInfo, ReadsWhatRosWrites) {
    const CameraIntrinsics camera =
        parseCameraInfo(kHead + kMatrix + lens("plumb_bob", "0.1, -0.2, 0.001, -0.002, 0"), "c");
    EXPECT_EQ(camera.width, 640);
    EXPECT_EQ(camera.height, 480);
    EXPECT_EQ(camera.fx, 500);
    EXPECT_EQ(camera.fy, 501);
    EXPECT_EQ(camera.cx, 319.5);
    EXPECT_EQ(camera.cy, 239.5);
    EXPECT_EQ(camera.lens, LensModel::PlumbBob);
    EXPECT_EQ(camera.distortion, (std::vector<double>{0.1, -0.2, 0.001, -0.002, 0}));
}

TEST(CameraInfo, KnowsEveryLensAndItsOtherNames) {
    EXPECT_EQ(parseCameraInfo(kHead + kMatrix, "c").lens, LensModel::Pinhole);
    EXPECT_EQ(parseCameraInfo(kHead + kMatrix + lens("\"\"", ""), "c").lens, LensModel::Pinhole);
    EXPECT_EQ(parseCameraInfo(kHead + kMatrix + lens("plumb_bob", "1, 0, 0, 0"), "c").distortion.size(), 5U);
    EXPECT_EQ(parseCameraInfo(kHead + kMatrix + lens("fisheye", "0, 0, 0, 0"), "c").lens,
              LensModel::Equidistant);
    EXPECT_EQ(parseCameraInfo(kHead + kMatrix + lens("equidistant", "0, 0, 0, 0"), "c").lens,
              LensModel::Equidistant);
    EXPECT_EQ(parseCameraInfo(kHead + kMatrix + lens("rational_polynomial", "0,0,0.1,0,0,0,0,0"), "c").lens,
              LensModel::RationalPolynomial);
}

TEST(CameraInfo, TakesALensWithoutDistortionForAPinhole) {
    for (const char* none : {"plumb_bob", "rational_polynomial"}) {
        const bool isPlumbBob = std::string(none) == "plumb_bob";
        const CameraIntrinsics camera = parseCameraInfo(
            kHead + kMatrix + lens(none, isPlumbBob ? "0, 0, 0, 0, 0" : "0, 0, 0, 0, 0, 0, 0, 0"), "c");
        EXPECT_EQ(camera.lens, LensModel::Pinhole);
        EXPECT_TRUE(camera.distortion.empty());
    }
}

TEST(CameraInfo, OfAnIdealFisheyeIsNoPinhole) {
    const CameraIntrinsics camera = parseCameraInfo(kHead + kMatrix + lens("equidistant", "0, 0, 0, 0"), "c");
    EXPECT_EQ(camera.lens, LensModel::Equidistant);
    EXPECT_EQ(parseCameraInfo(cameraInfoYaml(camera, "robot"), "c"), camera);
}

TEST(CameraInfo, ComesBackFromItsOwnYaml) {
    CameraIntrinsics camera = CameraIntrinsics::pinhole(1281, 719, 1.2345678901234567);
    camera.lens = LensModel::Equidistant;
    camera.distortion = {0.1, -1e-17, 3, 4};
    const CameraIntrinsics again = parseCameraInfo(cameraInfoYaml(camera, "robot"), "c");
    EXPECT_EQ(again.fx, camera.fx);
    EXPECT_EQ(again.cy, camera.cy);
    EXPECT_EQ(again.distortion, camera.distortion);
    EXPECT_EQ(again.lens, camera.lens);
}

TEST(CameraInfo, RefusesWhatIsNoCameraNamingTheEntry) {
    const auto refused = [](const std::string& yaml, const std::string& part) {
        expectError(ErrorKind::InvalidInput, part, [&] { parseCameraInfo(yaml, "robot.yaml"); });
    };
    refused("", "robot.yaml");
    refused("just text", "holds no entries");
    refused("a: [1", "not valid YAML");
    refused(kMatrix, "image_width is missing");
    refused(kHead, "camera_matrix/data is missing");
    refused("image_width: many\nimage_height: 480\n" + kMatrix, "image_width");
    refused(kHead + "camera_matrix: {data: [1, 2]}\n", "has 2 values");
    refused(kHead + "camera_matrix: {data: [a, 0, 0, 0, 1, 0, 0, 0, 1]}\n", "not a number");
    refused(kHead + "camera_matrix: {data: [.nan, 0, 0, 0, 1, 0, 0, 0, 1]}\n", "focal lengths");
    refused(kHead + kMatrix + lens("magic", "1"), "\"magic\" is unknown");
    refused(kHead + "camera_matrix: {data: [500, 10, 320, 0, 500, 240, 0, 0, 1]}\n", "skew 10");
    refused(kHead + "camera_matrix: {data: [500, 0, 320, 0, 500, 240, 0, 0, 2]}\n", "0 0 1");
    refused(kHead + kMatrix + "distortion_coefficients: {data: [0.1, 0, 0, 0, 0]}\n",
            "names no distortion model");
    refused(kHead + kMatrix + lens("none", "0.1, 0, 0, 0, 0"), "names no distortion model");
    refused(kHead + kMatrix + lens("plumb_bob", "1, 2"), "5 distortion parameters, not 2");
    refused("image_width: -3\nimage_height: 480\n" + kMatrix, "-3 x 480");
    refused(std::string(100000, '['), "not valid YAML");
}

} // namespace spherewalk::render
