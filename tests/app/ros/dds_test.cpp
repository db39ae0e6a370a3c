// SPDX-License-Identifier: GPL-3.0-or-later
// The node of ROS 2's wire protocol, from another process that reads and writes the same protocol.
#include "dds_fixture.h"
#include "temporary_folder.h"

#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/render/sensor.h"

#include <algorithm>
#include <csignal>
#include <memory>

namespace spherewalk::ros {

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

/// Keeps two pictures until they are taken, and lets the others wait at the node.
class BusyReader {
  public:
    BusyReader(std::uint32_t domain, const std::string& topic)
        : m_participant(dds_create_participant(domain, nullptr, nullptr)) {
        const std::unique_ptr<dds_qos_t, decltype(&dds_delete_qos)> qos(dds_create_qos(), &dds_delete_qos);
        dds_qset_reliability(qos.get(), DDS_RELIABILITY_RELIABLE, DDS_SECS(1));
        dds_qset_history(qos.get(), DDS_HISTORY_KEEP_ALL, 0);
        dds_qset_resource_limits(qos.get(), 2, DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED);
        const dds_entity_t of = dds_create_topic(m_participant, &sensor_msgs_msg_dds__Image__desc,
                                                 ("rt" + topic).c_str(), nullptr, nullptr);
        m_reader = dds_create_reader(m_participant, of, qos.get(), nullptr);
    }

    ~BusyReader() { dds_delete(m_participant); }

    BusyReader(const BusyReader&) = delete;
    BusyReader& operator=(const BusyReader&) = delete;

    void takeOne() {
        void* message = nullptr;
        dds_sample_info_t info{};
        const std::int32_t count = dds_take(m_reader, &message, &info, 1, 1);
        if (count == 1 && info.valid_data) {
            stamps.push_back(stampOf(static_cast<const ImageMessage*>(message)->header.stamp));
        }
        if (count > 0) {
            dds_return_loan(m_reader, &message, count);
        }
    }

    std::vector<Stamp> stamps;

  private:
    dds_entity_t m_participant;
    dds_entity_t m_reader = 0;
};

TEST_F(DdsTest, AReaderThatIsBusyGetsWholeFramesAndAllOfThemWithThePaceEvery) {
    for (const std::string pace : {"every", "newest"}) {
        BusyReader depths(domain, "/robot/camera/depth/image");
        std::vector<Stamp> colours;
        DdsPort listener(domain);
        listener.read<ImageMessage>(
            "/robot/camera/image_raw", sensor_msgs_msg_dds__Image__desc, Quality::Reliable,
            [&](const ImageMessage& message) { colours.push_back(stampOf(message.header.stamp)); });
        startNode({"--depth", "32FC1", "--scene", "sphere"}, "0", {"--camera", kCamera}, pace);
        moveUntil("the first pictures", [&] {
            depths.takeOne();
            listener.spinFor(20ms);
            return !depths.stamps.empty() && !colours.empty();
        });
        for (int i = 0; i < 60; ++i) { // faster than the reader takes them
            move();
            listener.spinFor(5ms);
            if (i % 3 == 0) {
                depths.takeOne();
            }
        }
        waitFor("the last pictures", [&] {
            depths.takeOne();
            listener.spinFor(1ms);
            return depths.stamps.back() == now && colours.back() == now;
        });
        const Stamp first = std::max(depths.stamps.front(), colours.front());
        for (std::vector<Stamp>* stamps : {&depths.stamps, &colours}) {
            stamps->erase(stamps->begin(), std::lower_bound(stamps->begin(), stamps->end(), first));
        }
        EXPECT_EQ(depths.stamps, colours) << pace;
        if (pace == "every") {
            EXPECT_EQ(colours.size(), static_cast<std::size_t>((now - first) / 10ms) + 1);
        }
        for (int i = 0; i < 20; ++i) { // pictures that nobody takes
            move();
            port.spinFor(20ms);
        }
        node->signal(SIGINT);
        EXPECT_EQ(node->wait(), 0) << node->errors();
        EXPECT_EQ(node->errors().find("ten seconds"), std::string::npos) << "the end waits for no reader";
    }
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
