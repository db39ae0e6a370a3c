// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"
#include "temporary_folder.h"

#include "spherewalk/base/file.h"
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

namespace {

/// A folder with left.yaml, and rigs that name it.
class RigFile : public testing::Test {
  protected:
    RigFile() { writeFile(folder / "left.yaml", bytesOf(kHead + kMatrix)); }

    std::vector<RigCamera> read(const std::string& yaml) {
        writeFile(folder / "rig.yaml", bytesOf(yaml));
        return readRig(folder / "rig.yaml");
    }

    test::TemporaryFolder folder;
};

const std::string kLeft =
    "  - {name: left, camera_info: left.yaml, rig_from_camera: [0, 0.1, 0, 0, 0, 0, 1]}\n";
const std::string kRight =
    "  - {name: right, camera_info: left.yaml, rig_from_camera: [0, -0.02, 0, 0, 0, 0, 1], frame_id: r}\n";

} // namespace

TEST_F(RigFile, PlacesCamerasByAxesOfTheBodyOrOfTheOpticalFrame) {
    const std::vector<RigCamera> body = read("axes: body\ncameras:\n" + kLeft + kRight);
    ASSERT_EQ(body.size(), 2U);
    EXPECT_EQ(body[0].name, "left");
    EXPECT_EQ(body[0].frameId, "left_optical");
    EXPECT_EQ(body[1].frameId, "r");
    EXPECT_EQ(body[0].camera.fx, 500);
    // The left camera of a body stands on its left, and its optical axis looks along the body's x.
    EXPECT_TRUE(body[0].rigFromOptical->translation.isApprox(Eigen::Vector3d(0, 0.1, 0)));
    EXPECT_LT((body[0].rigFromOptical->rotation * Eigen::Vector3d::UnitZ() - Eigen::Vector3d::UnitX()).norm(),
              1e-12);
    const std::vector<RigCamera> optical = read("cameras:\n" + kLeft);
    EXPECT_LT(
        (optical[0].rigFromOptical->rotation * Eigen::Vector3d::UnitZ() - Eigen::Vector3d::UnitZ()).norm(),
        1e-12);
}

TEST_F(RigFile, ABaselineIsThatOfPicturesThatNeedNoRectification) {
    const std::vector<RigCamera> rig = read("axes: body\ncameras:\n" + kLeft + kRight);
    const Rigid3 leftFromRight = rig[0].rigFromOptical->inverse() * *rig[1].rigFromOptical;
    const double baselineM = stereoBaselineM(rig[0].camera, rig[1].camera, leftFromRight);
    EXPECT_EQ(baselineM, 0.12);
    EXPECT_EQ(stereoCalibration(rig[1].camera, baselineM).p[3], -500 * 0.12);
    EXPECT_EQ(stereoCalibration(rig[0].camera, 0).p[3], 0);
    CameraIntrinsics other = rig[1].camera;
    other.fx = 510;
    EXPECT_EQ(stereoBaselineM(rig[0].camera, other, leftFromRight), 0) << "another lens";
    Rigid3 moved = leftFromRight;
    moved.translation.z() = 0.01;
    EXPECT_EQ(stereoBaselineM(rig[0].camera, other, moved), 0) << "one before the other";
    moved = leftFromRight;
    moved.rotation = Eigen::AngleAxisd(0.01, Eigen::Vector3d::UnitY());
    EXPECT_EQ(stereoBaselineM(rig[0].camera, rig[1].camera, moved), 0) << "squinting";
}

TEST_F(RigFile, ThatIsWrongIsRefusedWithWhatToMend) {
    const std::vector<std::pair<std::string, std::string>> wrong{
        {"", "entry cameras"},
        {"cameras: [", "entry cameras"},
        {"cameras: []", "list of 1 to 16 cameras"},
        {"cameras: 3", "list of 1 to 16 cameras"},
        {"cameras: [3]", "camera 1 has no entries"},
        {"axes: up\ncameras:\n" + kLeft, "axes is \"up\""},
        {"camera: x\ncameras:\n" + kLeft, "entry camera is unknown; there are axes, cameras"},
        {"cameras: [{camera_info: left.yaml}]", "name of camera 1 is missing"},
        {"cameras: [{name: ../up, camera_info: left.yaml}]", "letters, digits and _"},
        {"cameras: [{name: left}]", "camera_info of camera left is missing"},
        {"cameras: [{name: left, camera_info: left.yaml, pose: 3}]", "pose of camera left is unknown"},
        {"cameras: [{name: left, camera_info: left.yaml, rig_from_camera: [0, 0, 0]}]", "seven numbers"},
        {"cameras: [{name: left, camera_info: left.yaml, rig_from_camera: [0, 0, 0, 0, 0, 0, 2]}]",
         "unit length"},
        {"cameras: [{name: left, camera_info: left.yaml, rig_from_camera: [.nan, 0, 0, 0, 0, 0, 1]}]",
         "seven numbers"},
        {"cameras:\n" + kLeft + kLeft, "two cameras are called left"},
    };
    for (const auto& [yaml, sentence] : wrong) {
        SCOPED_TRACE(yaml);
        expectError(ErrorKind::InvalidInput, sentence, [&, &text = yaml] { read(text); });
    }
    expectError(ErrorKind::NotFound, "right.yaml",
                [&] { read("cameras: [{name: right, camera_info: right.yaml}]"); });
    expectError(ErrorKind::NotFound, "no.yaml", [&] { readRig(folder / "no.yaml"); });
}

TEST_F(RigFile, MayLeavePlacesToTransformsOnlyWhereThereAreSome) {
    const std::vector<RigCamera> rig = read("cameras: [{name: left, camera_info: left.yaml}]");
    EXPECT_FALSE(rig.front().rigFromOptical);
    expectError(ErrorKind::InvalidInput, "camera left of the rig rig.yaml has no rig_from_camera",
                [&] { placesOnRig(rig, "rig.yaml"); });
}

} // namespace spherewalk::render
