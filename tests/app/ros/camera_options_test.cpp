// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera/camera_options.h"
#include "expect_error.h"

#include <gtest/gtest.h>

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

} // namespace spherewalk::ros
