// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dds_messages.h"
#include "dds_port.h"
#include "program.h"

#include "spherewalk/geometry/rotation.h"
#include "spherewalk/render/camera_info.h"
#include "spherewalk/render/renderer.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <optional>
#include <unistd.h>

namespace spherewalk::ros {

using namespace std::chrono_literals;

inline constexpr auto kPatience = 60s; // for what comes at once on a machine that is not busy
inline const std::string kDataset = std::string(SPHEREWALK_DATASET) + "/dataset";
inline const std::string kCamera = std::string(SPHEREWALK_DATASET) + "/camera.yaml";

struct Image {
    Stamp stamp{};
    std::string frame;
    std::string encoding;
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> data;
};

/// The camera on its base, and the base in the room.
inline const Rigid3 kBaseFromCamera{bodyFromOptical(), {0.1, 0, 0.05}};

/// The camera stays nearest to the photo at (2.5, 1.5): at a border a stream keeps its photo for 2 cm, and a
/// single view does not.
inline Rigid3 baseAt(Stamp stamp) {
    const double seconds = std::chrono::duration<double>(stamp).count();
    return {yawRotation(Radians(0.3 * seconds)), {2.5 + 0.3 * std::sin(seconds), 1.5, 1.2}};
}

/// A picture of 160 x 120 pixels.
inline void sendOverlay(dds_entity_t writer, Stamp stamp, std::string encoding, std::uint32_t pixelBytes,
                        void* data) {
    std::string frame;
    ImageMessage message{};
    message.header = {timeOf(stamp), frame.data()};
    message.width = 160;
    message.height = 120;
    message.encoding = encoding.data();
    message.step = 160 * pixelBytes;
    message.data._length = message.data._maximum = message.step * message.height;
    message.data._buffer = static_cast<std::uint8_t*>(data);
    DdsPort::write(writer, &message);
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
                   const std::vector<std::string>& cameras = {"--camera", kCamera},
                   const std::string& pace = "every") {
        std::vector<std::string> command{
            SPHEREWALK_DDS, kDataset, "--namespace", "/robot",   "--pace",
            pace,           "--rate", rate,          "--domain", std::to_string(domain)};
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

} // namespace spherewalk::ros
