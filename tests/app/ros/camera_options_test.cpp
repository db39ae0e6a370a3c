// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera/camera_options.h"
#include "expect_error.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

namespace spherewalk::ros {

TEST(NodeOptions, BecomeThoseOfTheCamera) {
    NodeOptions options;
    options.rate = 15;
    options.scene = "depth";
    options.overlay = "labels";
    options.roomLabels = {0, 7};
    options.overlayWait = 0.25;
    const simulator::CameraOptions camera = cameraOptions(options);
    EXPECT_EQ(camera.rateHz, 15);
    EXPECT_EQ(camera.view.scene, render::SceneKind::Depth);
    EXPECT_EQ(camera.mounting.axes, simulator::CameraAxes::Optical);
    ASSERT_TRUE(camera.overlay);
    EXPECT_EQ(camera.overlay->by, simulator::ObjectsBy::Labels);
    EXPECT_EQ(camera.overlay->roomLabels, (std::vector<std::uint8_t>{0, 7}));
    EXPECT_EQ(camera.overlay->wait, std::chrono::milliseconds(250));
    EXPECT_FALSE(cameraOptions({}).overlay);
    EXPECT_FALSE(cameraOptions({}).wantsDepth);
    EXPECT_FALSE(cameraOptions({}).sensor);
    options.depth = "16UC1";
    EXPECT_TRUE(cameraOptions(options).wantsDepth);
}

TEST(NodeOptions, AreRefusedWhereTheyMeanNothing) {
    const auto expectRefused = [](const std::string& part, auto change) {
        NodeOptions options;
        change(options);
        test::expectError(ErrorKind::InvalidInput, part, [&] { cameraOptions(options); });
    };
    expectRefused("cubist", [](NodeOptions& o) { o.scene = "cubist"; });
    expectRefused("sampling", [](NodeOptions& o) { o.sampling = ""; });
    expectRefused("never", [](NodeOptions& o) { o.late = "never"; });
    expectRefused("pace", [](NodeOptions& o) { o.pace = "fast"; });
    expectRefused("some", [](NodeOptions& o) { o.overlay = "some"; });
    expectRefused("label", [](NodeOptions& o) { o.overlay = "labels", o.roomLabels = {256}; });
    expectRefused("wait", [](NodeOptions& o) { o.overlay = "alone", o.overlayWait = -1; });
    expectRefused("none, 32FC1 and 16UC1", [](NodeOptions& o) { o.depth = "mono16"; });
    expectRefused("frames a second", [](NodeOptions& o) { o.rate = -1; });
    expectRefused("need names", [](NodeOptions& o) { o.roomFrame = ""; });
    expectRefused("need names", [](NodeOptions& o) { o.cameraFrame = o.roomFrame; });
    expectRefused("threads", [](NodeOptions& o) { o.threads = -1; });
    expectRefused("cache", [](NodeOptions& o) { o.cacheMb = 0; });
}

namespace {

/// Sets a variable of the environment until its end.
class Variable {
  public:
    Variable(const char* name, const std::string& value) : m_name(name) {
        if (const char* before = std::getenv(name)) {
            m_before = before;
        }
        setenv(name, value.c_str(), 1);
    }

    ~Variable() { m_before ? setenv(m_name, m_before->c_str(), 1) : unsetenv(m_name); }

    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

  private:
    const char* m_name;
    std::optional<std::string> m_before;
};

void writeEmpty(const std::filesystem::path& file) {
    create_directories(file.parent_path());
    const std::ofstream written(file);
}

} // namespace

TEST(CameraInfoUrl, IsAPathOrAUrlOfAFile) {
    EXPECT_EQ(fileOf("robot.yaml", "camera"), "robot.yaml");
    EXPECT_EQ(fileOf("/a b/robot.yaml", "camera"), "/a b/robot.yaml");
    EXPECT_EQ(fileOf("file:///a b/robot.yaml", "camera"), "/a b/robot.yaml");
    EXPECT_EQ(fileOf("FILE:///robot.yaml", "camera"), "/robot.yaml");
    EXPECT_EQ(fileOf("odd/a://b", "camera"), "odd/a://b");
    EXPECT_EQ(fileOf("", "camera"), "");
}

TEST(CameraInfoUrl, HasTheVariablesOfCameraInfoManager) {
    const Variable home("HOME", "/home/r2d2");
    {
        const Variable rosHome("ROS_HOME", "/ros");
        EXPECT_EQ(fileOf("file://${ROS_HOME}/camera_info/${NAME}.yaml", "left"),
                  "/ros/camera_info/left.yaml");
    }
    const Variable noRosHome("ROS_HOME", "");
    EXPECT_EQ(fileOf("file://${ROS_HOME}/${NAME}/${NAME}.yaml", "${NAME}"),
              "/home/r2d2/.ros/${NAME}/${NAME}.yaml");
    EXPECT_EQ(fileOf("/${OTHER}/$5.yaml", "left"), "/${OTHER}/$5.yaml");
}

TEST(CameraInfoUrl, FindsPackagesOfBothRos) {
    const test::TemporaryFolder folder;
    const std::filesystem::path root = folder.path();
    writeEmpty(root / "two/share/ament_index/resource_index/packages/cameras");
    writeEmpty(root / "one/cameras/package.xml");
    writeEmpty(root / "one/lenses/package.xml");
    const Variable ament("AMENT_PREFIX_PATH", "/nowhere:" + (root / "two").string());
    const Variable packages("ROS_PACKAGE_PATH",
                            (root / "one").string() + "::" + (root / "one/lenses").string());
    EXPECT_EQ(fileOf("package://cameras/a/${NAME}.yaml", "left"), root / "two/share/cameras/a/left.yaml");
    EXPECT_EQ(fileOf("package://lenses/b.yaml", "left"), root / "one/lenses/b.yaml");
    const Variable itself("ROS_PACKAGE_PATH", (root / "one/lenses").string());
    EXPECT_EQ(fileOf("package://lenses/b.yaml", "left"), root / "one/lenses/b.yaml");
    test::expectError(ErrorKind::NotFound, "package wheels", [] { fileOf("package://wheels/b.yaml", ""); });
}

TEST(CameraInfoUrl, OfAnotherKindIsRefused) {
    for (const char* url : {"flash:///robot.yaml", "https://host/robot.yaml"}) {
        test::expectError(ErrorKind::InvalidInput, "file:// or package://", [url] { fileOf(url, "camera"); });
    }
    for (const char* url : {"package://", "package:///robot.yaml", "package://name", "package://name/"}) {
        test::expectError(ErrorKind::InvalidInput, "package://NAME/FILE", [url] { fileOf(url, "camera"); });
    }
}

} // namespace spherewalk::ros
