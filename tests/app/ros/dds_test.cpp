// SPDX-License-Identifier: GPL-3.0-or-later
// The node of ROS 2's wire protocol, from another process that reads and writes the same protocol.
#include "dds_messages.h"
#include "dds_port.h"
#include "program.h"
#include "temporary_folder.h"

#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/render/camera_info.h"
#include "spherewalk/render/renderer.h"
#include "spherewalk/render/sensor.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <map>
#include <optional>
#include <unistd.h>

namespace spherewalk::ros {

using namespace std::chrono_literals;

namespace {

constexpr auto kPatience = 60s; // for what comes at once on a machine that is not busy
const std::string kDataset = std::string(SPHEREWALK_DATASET) + "/dataset";
const std::string kCamera = std::string(SPHEREWALK_DATASET) + "/camera.yaml";

struct Image {
    Stamp stamp{};
    std::string frame;
    std::string encoding;
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> data;
};

/// The camera on its base, and the base in the room.
const Rigid3 kBaseFromCamera{bodyFromOptical(), {0.1, 0, 0.05}};

Rigid3 baseAt(Stamp stamp) {
    const double seconds = std::chrono::duration<double>(stamp).count();
    return {yawRotation(Radians(0.3 * seconds)), {1.5 + 0.5 * std::sin(seconds), 1.5, 1.2}};
}

class DdsTest : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        ::setenv(
            "CYCLONEDDS_URI",
            "<CycloneDDS><Domain><General><Interfaces><NetworkInterface name='lo'/></Interfaces>"
            "<AllowMulticast>false</AllowMulticast></General><Discovery><ParticipantIndex>auto"
            "</ParticipantIndex><Peers><Peer address='127.0.0.1'/></Peers></Discovery></Domain></CycloneDDS>",
            1);
    }

    DdsTest() {
        port.read<ImageMessage>("/robot/camera/image_raw", sensor_msgs_msg_dds__Image__desc, Quality::Sensor,
                                [this](const ImageMessage& message) { takeImage(message); });
        port.read<CameraInfoMessage>("/robot/camera/camera_info", sensor_msgs_msg_dds__CameraInfo__desc,
                                     Quality::Sensor, [this](const CameraInfoMessage& message) {
                                         infos[stampOf(message.header.stamp)] = calibrationOf(message);
                                     });
        port.read<DiagnosticMessage>("/diagnostics", diagnostic_msgs_msg_dds__DiagnosticArray__desc,
                                     Quality::Reliable, [this](const DiagnosticMessage& message) {
                                         ++reports;
                                         const auto& status = message.status._buffer[0];
                                         for (std::uint32_t i = 0; i < status.values._length; ++i) {
                                             diagnostics[status.values._buffer[i].key] =
                                                 status.values._buffer[i].value;
                                         }
                                     });
        tf = port.writer("/tf", tf2_msgs_msg_dds__TFMessage__desc, Quality::Reliable);
        tfStatic = port.writer("/tf_static", tf2_msgs_msg_dds__TFMessage__desc, Quality::Latched);
        sendTransform(tfStatic, "base", "camera_optical", 0s, kBaseFromCamera);
    }

    void takeImage(const ImageMessage& message) {
        images.push_back({stampOf(message.header.stamp),
                          message.header.frame_id,
                          message.encoding,
                          static_cast<int>(message.width),
                          static_cast<int>(message.height),
                          {message.data._buffer, message.data._buffer + message.data._length}});
    }

    void startNode(const std::vector<std::string>& more = {}, const std::string& rate = "0",
                   const std::vector<std::string>& cameras = {"--camera", kCamera}) {
        std::vector<std::string> command{
            SPHEREWALK_DDS, kDataset, "--namespace", "/robot",   "--pace",
            "every",        "--rate", rate,          "--domain", std::to_string(domain)};
        command.insert(command.end(), cameras.begin(), cameras.end());
        command.insert(command.end(), more.begin(), more.end());
        node.emplace(command);
    }

    static void sendTransform(dds_entity_t writer, std::string parent, std::string child, Stamp stamp,
                              const Rigid3& pose) {
        TransformMessage transform{};
        transform.header = {timeOf(stamp), parent.data()};
        transform.child_frame_id = child.data();
        const Eigen::Vector3d& t = pose.translation;
        const Eigen::Quaterniond& q = pose.rotation;
        transform.transform = {{t.x(), t.y(), t.z()}, {q.x(), q.y(), q.z(), q.w()}};
        TransformsMessage message{};
        message.transforms._length = message.transforms._maximum = 1;
        message.transforms._buffer = &transform;
        DdsPort::write(writer, &message);
    }

    void move() {
        now += 10ms;
        sendTransform(tf, "map", "base", now, baseAt(now));
    }

    template <class Condition>
    void moveUntil(const char* what, Condition condition) {
        const auto end = std::chrono::steady_clock::now() + kPatience;
        while (!condition()) {
            ASSERT_LT(std::chrono::steady_clock::now(), end) << what << "; the node said: " << node->errors();
            move();
            port.spinFor(20ms);
        }
    }

    template <class Condition>
    void waitFor(const char* what, Condition condition) {
        const auto end = std::chrono::steady_clock::now() + kPatience;
        while (!condition()) {
            ASSERT_LT(std::chrono::steady_clock::now(), end) << what << "; the node said: " << node->errors();
            port.spinFor(20ms);
        }
    }

    /// The render library's own picture at the image's stamp.
    static void expectRendered(const Image& image, const CameraIntrinsics& camera) {
        const render::Renderer renderer(
            std::make_shared<const render::Dataset>(render::Dataset::open(kDataset)));
        const RgbImage expected =
            renderer.render(CameraModel(camera), baseAt(image.stamp) * kBaseFromCamera).picture;
        EXPECT_EQ(image.frame, "camera_optical");
        EXPECT_EQ(image.encoding, "rgb8");
        ASSERT_EQ(image.data.size(), expected.values().size());
        EXPECT_TRUE(std::equal(image.data.begin(), image.data.end(), expected.values().begin()));
    }

    bool wasRefused(const std::string& kind) const {
        const auto found = diagnostics.find("refused so far: " + kind);
        return found != diagnostics.end() && found->second != "0";
    }

    std::uint32_t domain = 1 + static_cast<std::uint32_t>(::getpid()) % 200;
    DdsPort port{domain};
    dds_entity_t tf = 0;
    dds_entity_t tfStatic = 0;
    std::vector<Image> images;
    std::map<Stamp, Calibration> infos;
    std::map<std::string, std::string> diagnostics;
    int reports = 0; ///< of diagnostics
    Stamp now = 1000s;
    std::optional<test::Program> node;
};

} // namespace

TEST_F(DdsTest, ShowsTransformsWithTheirStampsAsTheRenderLibraryDoes) {
    startNode();
    moveUntil("a frame", [&] { return images.size() > 10 && infos.size() > 10; });
    const CameraIntrinsics camera = render::readCameraInfo(kCamera);
    const Calibration expected = calibration(camera);
    for (std::size_t i = 0; i < images.size(); i += 4) {
        EXPECT_EQ(images[i].stamp.count() % 10'000'000, 0) << "that of a transform";
        expectRendered(images[i], camera);
    }
    const Calibration& info = infos.rbegin()->second;
    EXPECT_EQ(info.k, expected.k);
    EXPECT_EQ(info.d, expected.d);
    EXPECT_EQ(info.distortionModel, "plumb_bob");
    EXPECT_EQ(info.width, 160);
    EXPECT_TRUE(infos.contains(images.back().stamp) || infos.contains(images[images.size() - 2].stamp));
    node->signal(SIGINT);
    EXPECT_EQ(node->wait(), 0) << node->errors();
}

TEST_F(DdsTest, GivesDepthImagesOfTheSameStampsAsRep118Says) {
    for (const std::string encoding : {"32FC1", "16UC1"}) {
        const bool isMetres = encoding == "32FC1";
        std::vector<Image> depths;
        std::map<Stamp, Calibration> depthInfos;
        DdsPort listener(domain);
        listener.read<ImageMessage>(isMetres ? "/robot/camera/depth/image" : "/robot/camera/depth/image_raw",
                                    sensor_msgs_msg_dds__Image__desc, Quality::Sensor,
                                    [&](const ImageMessage& message) {
                                        takeImage(message);
                                        depths.push_back(images.back());
                                    });
        listener.read<CameraInfoMessage>(
            "/robot/camera/depth/camera_info", sensor_msgs_msg_dds__CameraInfo__desc, Quality::Sensor,
            [&](const CameraInfoMessage& message) {
                depthInfos[stampOf(message.header.stamp)] = calibrationOf(message);
            });
        startNode({"--depth", encoding, "--scene", "sphere"});
        moveUntil("a depth image", [&] {
            listener.spinFor(20ms);
            return depths.size() > 3 && depthInfos.size() > 3;
        });
        const render::Renderer renderer(
            std::make_shared<const render::Dataset>(render::Dataset::open(kDataset)));
        render::ViewOptions options;
        options.scene = render::SceneKind::Sphere;
        options.wantsDepth = true;
        const CameraModel camera(render::readCameraInfo(kCamera));
        for (const Image& depth : depths) {
            const DepthImage expected =
                renderer.render(camera, baseAt(depth.stamp) * kBaseFromCamera, options).depth;
            EXPECT_EQ(depth.encoding, encoding);
            EXPECT_EQ(depth.frame, "camera_optical");
            const auto millimetres = render::depthMillimetres(expected);
            const auto* bytes = isMetres ? reinterpret_cast<const std::uint8_t*>(expected.values().data())
                                         : reinterpret_cast<const std::uint8_t*>(millimetres.values().data());
            ASSERT_EQ(depth.data.size(), expected.values().size() * (isMetres ? 4 : 2));
            EXPECT_TRUE(std::equal(depth.data.begin(), depth.data.end(), bytes));
        }
        EXPECT_EQ(depthInfos.begin()->second.k, calibration(camera.intrinsics()).k);
        node->signal(SIGINT);
        EXPECT_EQ(node->wait(), 0) << node->errors();
    }
}

// The rig's file places the left camera on camera_optical; transforms place the right one.
TEST_F(DdsTest, ARigGivesColourAndDepthOfItsCamerasWithEqualStamps) {
    const test::TemporaryFolder folder;
    const CameraModel camera({160, 120, 120, 120, 79.5, 59.5, LensModel::Pinhole, {}});
    const std::string file = folder / "pinhole.yaml";
    writeFile(file, bytesOf(render::cameraInfoYaml(camera.intrinsics(), "robot")));
    writeFile(folder / "rig.yaml",
              bytesOf("cameras:\n  - {name: left, camera_info: " + file +
                      ", rig_from_camera: [0, 0, 0, 0, 0, 0, 1]}\n  - {name: right, camera_info: " + file +
                      "}\n"));
    const Rigid3 leftFromRight{Eigen::Quaterniond::Identity(), {0.12, 0, 0}};
    std::map<std::string, std::map<Stamp, Image>> came;
    std::map<std::string, double> p3;
    DdsPort listener(domain);
    for (const std::string name : {"left", "right"}) {
        for (const std::string topic : {"image_raw", "depth/image"}) {
            listener.read<ImageMessage>("/robot/" + name + "/" + topic, sensor_msgs_msg_dds__Image__desc,
                                        Quality::Reliable,
                                        [&, key = name + topic](const ImageMessage& message) {
                                            takeImage(message);
                                            came[key][images.back().stamp] = images.back();
                                        });
        }
        listener.read<CameraInfoMessage>(
            "/robot/" + name + "/camera_info", sensor_msgs_msg_dds__CameraInfo__desc, Quality::Reliable,
            [&, name](const CameraInfoMessage& message) { p3[name] = message.p[3]; });
    }
    startNode({"--depth", "32FC1", "--scene", "sphere"}, "0", {"--rig", folder / "rig.yaml"});
    moveUntil("pictures of both cameras", [&] {
        // Who came late to the static transforms has the last one only.
        sendTransform(tfStatic, "base", "camera_optical", 0s, kBaseFromCamera);
        sendTransform(tfStatic, "base", "right_optical", 0s, kBaseFromCamera * leftFromRight);
        listener.spinFor(20ms);
        return came["rightimage_raw"].size() > 3 && came["rightdepth/image"].size() > 3 && p3.size() == 2;
    });
    const render::Renderer renderer(std::make_shared<const render::Dataset>(render::Dataset::open(kDataset)));
    render::ViewOptions options;
    options.scene = render::SceneKind::Sphere;
    options.wantsDepth = true;
    std::size_t pairs = 0;
    for (const auto& [stamp, right] : came["rightimage_raw"]) {
        EXPECT_EQ(right.frame, "right_optical");
        const Rigid3 pose = baseAt(stamp) * kBaseFromCamera * leftFromRight;
        const RgbImage expected = renderer.render(camera, pose, options).picture;
        EXPECT_TRUE(std::equal(right.data.begin(), right.data.end(), expected.values().begin(),
                               expected.values().end()));
        pairs += came["leftimage_raw"].contains(stamp) && came["leftdepth/image"].contains(stamp) ? 1 : 0;
    }
    EXPECT_GE(pairs, 3U) << "the same stamps";
    EXPECT_EQ(p3["left"], 0);
    EXPECT_NEAR(p3["right"], -camera.intrinsics().fx * 0.12, 1e-6);
    node->signal(SIGINT);
    EXPECT_EQ(node->wait(), 0) << node->errors();
}

TEST_F(DdsTest, TakesGarbageWithoutHarmAndReportsIt) {
    startNode({"--overlay", "alone", "--overlay-wait", "0"});
    moveUntil("a frame", [&] { return !images.empty(); });
    const double nan = std::numeric_limits<double>::quiet_NaN();
    sendTransform(tf, "map", "base", now, {Eigen::Quaterniond::Identity(), {nan, 0, 0}});
    sendTransform(tf, "map", "base", now, {{0, 0, 0, 0}, {0, 0, 0}});
    sendTransform(tf, "", "base", now, {});
    sendTransform(tf, "base", "map", now, {}); // a ring
    sendTransform(tf, "nowhere", "base", now, {});
    const dds_entity_t overlay =
        port.writer("/robot/overlay/image_raw", sensor_msgs_msg_dds__Image__desc, Quality::Sensor);
    const auto sendPicture = [&](std::uint32_t width, std::string encoding, std::uint32_t step) {
        std::string frame;
        ImageMessage message{};
        message.header = {timeOf(now), frame.data()};
        message.width = message.height = width;
        message.encoding = encoding.data();
        message.step = step;
        DdsPort::write(overlay, &message);
    };
    moveUntil("reports", [&] {
        sendPicture(0xffffffff, "rgb8", 0);
        sendPicture(160, "rgb8", 0xffffffff);
        sendPicture(160, "yuv422", 320);
        return wasRefused("place") && wasRefused("rotation") && wasRefused("frame_id") &&
               wasRefused("size") && wasRefused("encoding");
    });
    const std::size_t before = images.size();
    moveUntil("frames after it", [&] { return images.size() > before + 2; });
    expectRendered(images.back(), render::readCameraInfo(kCamera));
}

TEST_F(DdsTest, TakesAnotherCameraWhileItRuns) {
    startNode();
    moveUntil("a frame", [&] { return !images.empty(); });
    const CameraIntrinsics fisheye{64, 48, 40, 40, 31.5, 23.5, LensModel::Equidistant, {0.01, 0, 0, 0}};
    std::string frame;
    PublishedFrame like;
    like.calibration = calibration(fisheye);
    CameraInfoMessage message = cameraInfoOf(like, frame);
    const dds_entity_t writer = port.writer("/robot/camera/set_camera_info",
                                            sensor_msgs_msg_dds__CameraInfo__desc, Quality::Reliable);
    waitFor("the node", [&] { return DdsPort::readersOf(writer) > 0; });
    DdsPort::write(writer, &message);
    moveUntil("a frame of the new camera", [&] { return images.back().width == 64; });
    expectRendered(images.back(), fisheye);
    message.width = 0;
    DdsPort::write(writer, &message);
    const std::size_t before = images.size();
    moveUntil("frames as before", [&] { return images.size() > before + 2; });
    EXPECT_EQ(images.back().width, 64);
}

TEST_F(DdsTest, AKilledNodeComesBack) {
    startNode();
    moveUntil("a frame", [&] { return !images.empty(); });
    node->signal(SIGKILL);
    node->wait();
    images.clear();
    startNode();
    moveUntil("a frame of the new node", [&] { return !images.empty(); });
    expectRendered(images.back(), render::readCameraInfo(kCamera));
}

TEST_F(DdsTest, LaysASimulatorsObjectsInBetweenTwoTransforms) {
    startNode({"--overlay", "alone", "--overlay-wait", "10"}, "50");
    const dds_entity_t colour =
        port.writer("/robot/overlay/image_raw", sensor_msgs_msg_dds__Image__desc, Quality::Sensor);
    const dds_entity_t depth =
        port.writer("/robot/overlay/depth", sensor_msgs_msg_dds__Image__desc, Quality::Sensor);
    constexpr std::size_t kPixels = 160 * 120;
    std::vector<std::uint8_t> green(3 * kPixels);
    for (std::size_t i = 1; i < green.size(); i += 3) {
        green[i] = 255;
    }
    std::vector<float> metres(kPixels, 0.1F); // in front of all that the scene model knows
    std::string frame;
    const auto send = [&](dds_entity_t writer, std::string encoding, std::uint32_t step, void* data) {
        ImageMessage message{};
        message.header = {timeOf(now + 5ms), frame.data()};
        message.width = 160;
        message.height = 120;
        message.encoding = encoding.data();
        message.step = step;
        message.data._length = message.data._maximum = step * 120;
        message.data._buffer = static_cast<std::uint8_t*>(data);
        DdsPort::write(writer, &message);
    };
    std::vector<Image> labels;
    DdsPort listener(domain);
    listener.read<ImageMessage>("/robot/camera/labels/image_raw", sensor_msgs_msg_dds__Image__desc,
                                Quality::Sensor, [&](const ImageMessage& message) {
                                    takeImage(message);
                                    labels.push_back(images.back());
                                    images.pop_back();
                                });
    moveUntil("a frame", [&] {
        send(colour, "rgb8", 480, green.data());
        send(depth, "32FC1", 640, metres.data());
        listener.spinFor(20ms);
        return !images.empty() && !labels.empty();
    });
    EXPECT_EQ(images.back().stamp.count() % 10'000'000, 5'000'000) << "that of the overlay";
    EXPECT_EQ(images.back().data, green);
    EXPECT_EQ(labels.back().stamp.count() % 10'000'000, 5'000'000);
    EXPECT_EQ(labels.back().encoding, "16UC1");
    EXPECT_EQ(labels.back().data, std::vector<std::uint8_t>(2 * kPixels, 255)) << "objects without a label";
}

TEST_F(DdsTest, ACameraThatStandsStillWaitsForTheSimulationsTime) {
    startNode({"--sim-time"});
    waitFor("two reports", [&] {
        sendTransform(tfStatic, "base", "camera_optical", 0s, kBaseFromCamera);
        sendTransform(tfStatic, "map", "base", 0s, baseAt(0s));
        return reports > 1;
    });
    const dds_entity_t clock = port.writer("/clock", rosgraph_msgs_msg_dds__Clock__desc, Quality::Sensor);
    const ClockMessage message{timeOf(5s)};
    waitFor("a frame", [&] {
        DdsPort::write(clock, &message);
        return !images.empty();
    });
    EXPECT_EQ(images.front().stamp, Stamp(5s));
}

TEST_F(DdsTest, RefusesInASentence) {
    startNode({"--scene", "cubist"});
    EXPECT_EQ(node->wait(), 1);
    EXPECT_NE(node->errors().find("cubist"), std::string::npos) << node->errors();
}

} // namespace spherewalk::ros
