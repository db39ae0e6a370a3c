// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli_run.h"
#include "messages.h"
#include "temporary_folder.h"
#include "test_dataset.h"

#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/render/renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <unistd.h>
#include <vector>

namespace spherewalk::test {

namespace gz = gazebo::msgs;
using gazebo::transport::Node;
using simulator::Stamp;

/// Everything of one test talks on a partition of its own, on this machine only.
struct Partition {
    Partition() {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        const std::string name = text("spherewalk_", test->name(), "_", ::getpid());
        for (const char* variable : {"IGN_PARTITION", "GZ_PARTITION"}) {
            ::setenv(variable, name.c_str(), 1);
        }
        ::setenv("IGN_IP", "127.0.0.1", 1);
        ::setenv("GZ_IP", "127.0.0.1", 1);
    }
};

/// What a subscriber gets of a camera. Threads: messages come in others.
class Listener {
  public:
    explicit Listener(const std::string& topic) {
        listen(topic + "/image", m_images);
        listen(topic + "/camera_info", m_infos);
        listen(topic + "/report", m_reports);
        listen(topic + "/labels", m_labels);
        listen(topic + "/boxes", m_boxes);
    }

    /// The messages once there are as many of each. A test fails if that takes a minute.
    bool waitFor(std::size_t count) {
        std::unique_lock lock(m_mutex);
        return m_changed.wait_for(lock, std::chrono::minutes(1), [&] { return hasAll(count); });
    }

    bool has(std::size_t count) {
        const std::scoped_lock lock(m_mutex);
        return hasAll(count);
    }

    void clear() {
        const std::scoped_lock lock(m_mutex);
        m_images.clear();
        m_infos.clear();
        m_reports.clear();
    }

    std::vector<gz::Image> images() { return copy(m_images); }

    std::vector<gz::CameraInfo> infos() { return copy(m_infos); }

    std::vector<gz::Param> reports() { return copy(m_reports); }

    std::vector<gz::Image> labels() { return copy(m_labels); }

    std::vector<gz::AnnotatedAxisAligned2DBox_V> boxes() { return copy(m_boxes); }

  private:
    template <class Message>
    void listen(const std::string& topic, std::vector<Message>& into) {
        std::function<void(const Message&)> keep = [this, &into](const Message& message) {
            const std::scoped_lock lock(m_mutex);
            into.push_back(message);
            m_changed.notify_all();
        };
        EXPECT_TRUE(m_node.Subscribe(topic, keep));
    }

    template <class Message>
    std::vector<Message> copy(const std::vector<Message>& messages) {
        const std::scoped_lock lock(m_mutex);
        return messages;
    }

    bool hasAll(std::size_t count) const {
        return m_images.size() >= count && m_infos.size() >= count && m_reports.size() >= count;
    }

    std::mutex m_mutex;
    std::condition_variable m_changed;
    std::vector<gz::Image> m_images;
    std::vector<gz::CameraInfo> m_infos;
    std::vector<gz::Param> m_reports;
    std::vector<gz::Image> m_labels;                      ///< none without an overlay
    std::vector<gz::AnnotatedAxisAligned2DBox_V> m_boxes; ///< the same
    Node m_node;                                          ///< last: its callbacks use the others
};

/// In Gazebo's place: says where a robot is whose camera is 1 m above it.
class Simulation {
  public:
    explicit Simulation(const std::string& topic = "/model/robot/pose")
        : m_publisher(m_node.Advertise<gz::Pose_V>(topic)) {}

    static Rigid3 cameraAt(double x, double yaw) {
        return {yawRotation(Radians(yaw)), Eigen::Vector3d(x, 0.5, 1)};
    }

    void robotAt(Stamp stamp, double x, double yaw) {
        gz::Pose_V message;
        setStamp(*message.mutable_header(), stamp);
        add(message, "world", "robot", {cameraAt(x, yaw).rotation, Eigen::Vector3d(x, 0.5, 0)});
        add(message, "robot", "robot::camera", {Eigen::Quaterniond::Identity(), Eigen::Vector3d(0, 0, 1)});
        publish(message);
    }

    void publish(const gz::Pose_V& message) { EXPECT_TRUE(m_publisher.Publish(message)); }

    static void setStamp(gz::Header& header, Stamp stamp) {
        header.mutable_stamp()->set_sec(stamp / std::chrono::seconds(1));
        header.mutable_stamp()->set_nsec(
            static_cast<std::int32_t>((stamp % std::chrono::seconds(1)).count()));
    }

    /// parent "": as scene topics do, by the bare name alone.
    static gz::Pose& add(gz::Pose_V& message, const std::string& parent, const std::string& child,
                         const Rigid3& at) {
        gz::Pose& pose = *message.add_pose();
        if (parent.empty()) {
            pose.set_name(child);
        } else {
            setEntry(pose, "frame_id", parent);
            setEntry(pose, "child_frame_id", child);
        }
        pose.mutable_position()->set_x(at.translation.x());
        pose.mutable_position()->set_y(at.translation.y());
        pose.mutable_position()->set_z(at.translation.z());
        pose.mutable_orientation()->set_w(at.rotation.w());
        pose.mutable_orientation()->set_x(at.rotation.x());
        pose.mutable_orientation()->set_y(at.rotation.y());
        pose.mutable_orientation()->set_z(at.rotation.z());
        return pose;
    }

  private:
    static void setEntry(gz::Pose& pose, const char* key, const std::string& value) {
        auto* entry = pose.mutable_header()->add_data();
        entry->set_key(key);
        entry->add_value(value);
    }

    Node m_node;
    Node::Publisher m_publisher;
};

inline Stamp stampOf(const gz::Header& header) {
    return std::chrono::seconds(header.stamp().sec()) + std::chrono::nanoseconds(header.stamp().nsec());
}

inline std::string entryOf(const gz::Header& header, const std::string& key) {
    for (const auto& entry : header.data()) {
        if (entry.key() == key) {
            return entry.value(0);
        }
    }
    return "";
}

/// A room with photos along its middle, and spherewalk-gz in it.
class Gazebo : public testing::Test {
  protected:
    Gazebo() {
        std::vector<Rigid3> poses;
        for (int i = 0; i < 4; ++i) {
            poses.push_back({yawRotation(Radians(i)), Eigen::Vector3d(0.2 + 0.4 * i, 0.5, 1)});
        }
        render::DatasetInfo info = writeTestDataset(dataset(), poses, smoothWorld, 512, 2.0);
        info.outline = {{0, 0}, {2, 0}, {2, 1}, {0, 1}};
        info.ceilingM = 2.5;
        rewriteInfo(dataset(), info);
        writeSmallCamera(cameraFile());
        renderer.emplace(std::make_shared<const render::Dataset>(render::Dataset::open(dataset())));
    }

    std::filesystem::path dataset() const { return folder / "dataset"; }

    std::filesystem::path cameraFile() const { return folder / "camera.yaml"; }

    /// The options, and what is usual in tests for those that are not given.
    std::vector<std::string> command(const std::vector<std::string>& options) const {
        std::vector<std::string> words = {SPHEREWALK_GZ, dataset(), "--json"};
        words.insert(words.end(), options.begin(), options.end());
        const std::map<std::string, std::string> usual = {{"--camera", cameraFile()},
                                                          {"--poses", "/model/robot/pose"},
                                                          {"--frame", "robot::camera"},
                                                          {"--image", "/robot/front/image"}};
        const auto isGiven = [&options](const std::string& option) {
            return std::find(options.begin(), options.end(), option) != options.end();
        };
        for (const auto& [option, value] : usual) {
            if (!isGiven(option) && !(option == "--camera" && isGiven("--rig"))) {
                words.insert(words.end(), {option, value});
            }
        }
        return words;
    }

    void start(const std::vector<std::string>& options = {"--rate", "0", "--pace", "every"}) {
        program = std::make_unique<Program>(command(options));
        ASSERT_NE(program->waitForError("Waits for poses"), "") << program->errors();
    }

    /// Does it with 0, 1, ..., until the condition holds: what is published at first may be lost. False if
    /// that takes a minute, or the program ends.
    template <class Condition, class Action>
    bool repeatUntil(const Condition& holds, const Action& act) {
        constexpr int kMost = 3000;
        for (int i = 0; i < kMost && !holds(); ++i) {
            act(i);
            if (program->endsWithin(std::chrono::milliseconds(20))) {
                break;
            }
        }
        return holds();
    }

    template <class Condition>
    bool waitUntil(const Condition& holds) {
        return repeatUntil(holds, [](int) {});
    }

    /// Until poses get there and pictures come back, by poses of a time that is over then.
    void connect(Simulation& simulation, Listener& listener) {
        ASSERT_TRUE(repeatUntil([&] { return listener.has(1); },
                                [&](int i) { simulation.robotAt(std::chrono::milliseconds(i), 0.3, 0); }))
            << program->errors();
        settle(simulation, listener);
    }

    /// Until there is nothing left of what was published before.
    void settle(Simulation& simulation, Listener& listener) {
        const Stamp last = std::chrono::hours(1);
        simulation.robotAt(last, 0.3, 0);
        EXPECT_TRUE(waitUntil([&] {
            const auto reports = listener.reports();
            return !reports.empty() && stampOf(reports.back().header()) == last;
        }));
        listener.clear();
    }

    /// Its summary. It ends as Ctrl-C ends it.
    Json end(int signal = SIGINT) {
        program->signal(signal);
        EXPECT_EQ(program->wait(), 0) << program->errors();
        return parseJson(program->output(), "the summary");
    }

    RgbImage expected(double x, double yaw) const {
        const Rigid3 optical =
            Simulation::cameraAt(x, yaw) * Rigid3{bodyFromOptical(), Eigen::Vector3d::Zero()};
        return renderer->render(camera, optical).picture;
    }

    static void expectPicture(const gz::Image& message, const RgbImage& picture) {
        EXPECT_EQ(message.width(), static_cast<std::uint32_t>(picture.width()));
        EXPECT_EQ(message.height(), static_cast<std::uint32_t>(picture.height()));
        EXPECT_EQ(message.step(), 3U * static_cast<std::uint32_t>(picture.width()));
        EXPECT_EQ(message.pixel_format_type(), gz::RGB_INT8);
        const auto values = picture.values();
        EXPECT_TRUE(message.data() ==
                    std::string(reinterpret_cast<const char*>(values.data()), values.size()));
    }

    Partition partition;
    TemporaryFolder folder;
    CameraModel camera{{160, 120, 120, 120, 79.5, 59.5, LensModel::Pinhole, {}}};
    std::optional<render::Renderer> renderer;
    std::unique_ptr<Program> program;
};

} // namespace spherewalk::test
