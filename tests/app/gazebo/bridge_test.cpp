// SPDX-License-Identifier: GPL-3.0-or-later
#include "gazebo_fixture.h"

#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/photo/picture_file.h"

#include <gmock/gmock.h>

namespace spherewalk::test {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;

TEST_F(Gazebo, InLockStepEachPoseGivesItsPictureWithItsStamp) {
    start();
    Simulation simulation;
    Listener listener("/robot/front");
    connect(simulation, listener);
    for (int i = 0; i < 10; ++i) {
        const Stamp stamp(1'000'000'007LL * (i + 1));
        const double x = 0.2 + 0.15 * i;
        simulation.robotAt(stamp, x, 0.4 * i);
        ASSERT_TRUE(listener.waitFor(static_cast<std::size_t>(i + 1))) << program->errors();
        const gz::Image image = listener.images().back();
        const gz::CameraInfo info = listener.infos().back();
        EXPECT_EQ(stampOf(image.header()), stamp);
        EXPECT_EQ(stampOf(info.header()), stamp);
        EXPECT_EQ(stampOf(listener.reports().back().header()), stamp);
        EXPECT_EQ(entryOf(image.header(), "frame_id"), "robot::camera_optical");
        EXPECT_EQ(entryOf(info.header(), "frame_id"), "robot::camera_optical");
        expectPicture(image, expected(x, 0.4 * i));
    }
    const gz::CameraInfo info = listener.infos().back();
    EXPECT_EQ(info.width(), 160U);
    EXPECT_EQ(info.height(), 120U);
    EXPECT_THAT(info.intrinsics().k(), ElementsAre(120, 0, 79.5, 0, 120, 59.5, 0, 0, 1));
    EXPECT_THAT(info.projection().p(), ElementsAre(120, 0, 79.5, 0, 0, 120, 59.5, 0, 0, 0, 1, 0));
    EXPECT_THAT(info.distortion().k(), ElementsAre(0, 0, 0, 0, 0));
    EXPECT_EQ(listener.images().size(), 10U);
    const Json summary = end();
    EXPECT_EQ(summary["dropped"], 0);
    // Poses that came before anyone was known to listen gave none.
    EXPECT_GE(summary["frames"], 12);
    EXPECT_GE(summary["poses"], summary["frames"]);
}

TEST_F(Gazebo, ARigGivesPicturesOfAllItsCamerasWithOneStamp) {
    writeFile(folder / "rig.yaml", bytesOf("axes: body\ncameras:\n"
                                           "  - {name: left, camera_info: camera.yaml, rig_from_camera: "
                                           "[0, 0.06, 0, 0, 0, 0, 1]}\n"
                                           "  - {name: right, camera_info: camera.yaml, rig_from_camera: "
                                           "[0, -0.06, 0, 0, 0, 0, 1], frame_id: eye}\n"));
    start({"--rate", "0", "--pace", "every", "--rig", folder / "rig.yaml"});
    Simulation simulation;
    Listener left("/robot/front/left");
    Listener right("/robot/front/right");
    connect(simulation, left);
    settle(simulation, right);
    left.clear();
    simulation.robotAt(5s, 0.7, 0.3);
    ASSERT_TRUE(left.waitFor(1) && right.waitFor(1)) << program->errors();
    EXPECT_EQ(stampOf(left.images().back().header()), 5s);
    EXPECT_EQ(stampOf(right.images().back().header()), 5s);
    EXPECT_EQ(entryOf(left.images().back().header(), "frame_id"), "left_optical");
    EXPECT_EQ(entryOf(right.images().back().header(), "frame_id"), "eye");
    EXPECT_EQ(entryOf(left.images().back().header(), "seq"), entryOf(right.images().back().header(), "seq"));
    const auto seen = [&](double y) {
        return renderer->render(camera, Simulation::cameraAt(0.7, 0.3) * Rigid3{bodyFromOptical(), {0, y, 0}})
            .picture;
    };
    expectPicture(left.images().back(), seen(0.06));
    expectPicture(right.images().back(), seen(-0.06));
    EXPECT_EQ(left.infos().back().projection().p(3), 0);
    EXPECT_NEAR(right.infos().back().projection().p(3), -120 * 0.12, 1e-6);
    end();
}

TEST_F(Gazebo, ThePictureIsThatOfTheCommandLinesView) {
    start();
    Simulation simulation;
    Listener listener("/robot/front");
    connect(simulation, listener);
    simulation.robotAt(5s, 0.7, 0);
    ASSERT_TRUE(listener.waitFor(1));
    const CliResult view = runCli({"view", dataset(), "--camera", cameraFile(), "--frame", "body", "--pose",
                                   "0.7 0.5 1 0 0 0 1", "--out", folder / "view.png"});
    ASSERT_EQ(view.status, 0) << view.errors;
    expectPicture(listener.images().back(), photo::readPicture(folder / "view.png"));
}

TEST_F(Gazebo, GivesTheRateThatIsAskedForOnTheSimulationsClock) {
    start({"--rate", "30", "--pace", "every"});
    Simulation simulation;
    Listener listener("/robot/front");
    connect(simulation, listener);
    for (int ms = 0; ms <= 2000; ms += 4) {
        simulation.robotAt(ms * 1ms, 0.3 + 0.0005 * ms, 0);
    }
    ASSERT_TRUE(listener.waitFor(61)) << program->errors();
    const std::vector<gz::Image> images = listener.images();
    ASSERT_EQ(images.size(), 61U);
    for (int k = 0; k <= 60; ++k) {
        const int due = (1000 * k + 29) / 30; // ms, rounded up
        EXPECT_EQ(stampOf(images[static_cast<std::size_t>(k)].header()), (due + 3) / 4 * 4 * 1ms) << k;
    }
}

TEST_F(Gazebo, TakesPosesOfTheSceneByBareNames) {
    start({"--rate", "0", "--poses", "/world/default/dynamic_pose/info", "--frame-id", "eye"});
    Simulation simulation("/world/default/dynamic_pose/info");
    Listener listener("/robot/front");
    const auto publish = [&](Stamp stamp) {
        gz::Pose_V message;
        Simulation::setStamp(*message.mutable_header(), stamp);
        Simulation::add(message, "", "robot", {yawRotation(Radians(1)), Eigen::Vector3d(0.9, 0.5, 0.2)});
        Simulation::add(message, "", "wheel", {});
        Simulation::add(message, "", "camera", {Eigen::Quaterniond::Identity(), Eigen::Vector3d(0, 0, 0.8)});
        simulation.publish(message);
    };
    ASSERT_TRUE(repeatUntil([&] { return listener.has(1); }, [&](int i) { publish(i * 1ms); }))
        << program->errors();
    expectPicture(listener.images().front(), expected(0.9, 1));
    EXPECT_EQ(entryOf(listener.images().front().header(), "frame_id"), "eye");
}

TEST_F(Gazebo, NothingIsRenderedWhileNobodyListens) {
    start();
    Simulation simulation;
    // What is refused tells how far the program has come; the first messages may be lost.
    const auto refused = [&](const Eigen::Quaterniond& rotation, double x) {
        gz::Pose_V message;
        Simulation::setStamp(*message.mutable_header(), 0s);
        Simulation::add(message, "world", "robot", {rotation, Eigen::Vector3d(x, 0, 0)});
        simulation.publish(message);
    };
    const auto isTold = [&](const std::string& sentence) {
        return program->errors().find(sentence) != std::string::npos;
    };
    ASSERT_TRUE(repeatUntil([&] { return isTold("not a unit quaternion"); },
                            [&](int) {
                                refused({2, 0, 0, 0}, 0);
                            }));
    constexpr int kUnheard = 200;
    for (int i = 0; i < kUnheard; ++i) {
        simulation.robotAt(i * 1ms, 0.3, 0);
    }
    refused({1, 0, 0, 0}, 1e9);
    ASSERT_TRUE(waitUntil([&] { return isTold("within 10^7 m"); }));
    Listener listener("/robot/front");
    int heard = 0;
    ASSERT_TRUE(repeatUntil([&] { return listener.has(1); },
                            [&](int) { simulation.robotAt((kUnheard + heard++) * 1ms, 0.3, 0); }));
    EXPECT_GE(stampOf(listener.images().front().header()), kUnheard * 1ms);
    const Json summary = end();
    EXPECT_LE(summary["frames"].get<int>(), heard);
    EXPECT_EQ(summary["refused"]["place"], 1);
    EXPECT_GT(summary["poses"].get<int>(), kUnheard); // all came, in turn
}

TEST_F(Gazebo, TheTopicToolSeesWhatWasPromised) {
    start();
    Simulation simulation;
    Listener listener("/robot/front");
    connect(simulation, listener);
    Program topics({SPHEREWALK_TOPIC_TOOL, "-l"});
    EXPECT_EQ(topics.wait(), 0);
    for (const char* topic : {"/robot/front/image", "/robot/front/camera_info", "/robot/front/report"}) {
        EXPECT_THAT(topics.output(), HasSubstr(topic));
    }
    Program info({SPHEREWALK_TOPIC_TOOL, "-i", "-t", "/robot/front/image"});
    EXPECT_EQ(info.wait(), 0);
    EXPECT_THAT(info.output(), HasSubstr(".msgs.Image"));
    Program echo({SPHEREWALK_TOPIC_TOOL, "-e", "-n", "1", "-t", "/robot/front/report"});
    for (int i = 0; i < 3000 && !echo.endsWithin(20ms); ++i) {
        simulation.robotAt(7s + i * 1ms, 0.4, 0);
    }
    EXPECT_THAT(echo.output(), AllOf(HasSubstr("sec: 7"), HasSubstr("trust"), HasSubstr("late"),
                                     HasSubstr("robot::camera_optical")));
}

} // namespace
} // namespace spherewalk::test
