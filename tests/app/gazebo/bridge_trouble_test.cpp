// SPDX-License-Identifier: GPL-3.0-or-later
#include "gazebo_fixture.h"

#include "spherewalk/base/json.h"

#include <gmock/gmock.h>

#include <cmath>
#include <csignal>
#include <limits>

namespace spherewalk::test {
namespace {

using namespace std::chrono_literals;
using testing::AllOf;
using testing::HasSubstr;

TEST_F(Gazebo, ANodeThatIsKilledIsStartedAgainAndGoesOn) {
    Simulation simulation;
    Listener listener("/robot/front");
    for (int life = 0; life < 3; ++life) {
        start();
        connect(simulation, listener);
        simulation.robotAt(5s, 0.6, 0);
        ASSERT_TRUE(listener.waitFor(1)) << life;
        expectPicture(listener.images().back(), expected(0.6, 0));
        program->signal(SIGKILL);
        EXPECT_EQ(program->wait(), 128 + SIGKILL);
        listener.clear();
    }
}

TEST_F(Gazebo, EndsBySigtermWithASummary) {
    start();
    Simulation simulation;
    Listener listener("/robot/front");
    connect(simulation, listener);
    EXPECT_GE(end(SIGTERM)["frames"].get<int>(), 1);
}

TEST_F(Gazebo, APublisherOfGarbageDoesNoHarmAndIsReported) {
    start();
    Simulation simulation;
    Listener listener("/robot/front");
    connect(simulation, listener);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto publish = [&](std::optional<Stamp> stamp, const std::string& frame, const Rigid3& at) {
        gz::Pose_V message;
        if (stamp) {
            Simulation::setStamp(*message.mutable_header(), *stamp);
        }
        Simulation::add(message, "world", frame, at);
        simulation.publish(message);
    };
    const Rigid3 fine;
    for (int i = 0; i < 50; ++i) { // fewer than the transport drops
        publish(1s, "robot", {Eigen::Quaterniond::Identity(), Eigen::Vector3d(nan, 0, 0)});
        publish(1s, "robot", {Eigen::Quaterniond(2, 0, 0, 0), Eigen::Vector3d(0, 0, 0)});
        publish(std::nullopt, "robot", fine);
        publish(-5s, "robot", fine);
        publish(1s + i * 1ms, "somebody::else", fine);
    }
    gz::Pose_V empty;
    simulation.publish(empty);
    simulation.robotAt(3s, 0.8, 0.3);
    ASSERT_TRUE(listener.waitFor(1)) << program->errors();
    EXPECT_EQ(stampOf(listener.images().back().header()), 3s);
    expectPicture(listener.images().back(), expected(0.8, 0.3));
    const Json summary = end();
    EXPECT_EQ(summary["refused"]["place"], 50);
    EXPECT_EQ(summary["refused"]["rotation"], 50);
    EXPECT_EQ(summary["refused"]["time"], 100);
    EXPECT_GE(summary["refused"]["frame_id"].get<int>(), 40);
    const std::string errors = program->errors();
    EXPECT_THAT(errors, AllOf(HasSubstr("x nan"), HasSubstr("not a unit quaternion"),
                              HasSubstr("no simulation time"), HasSubstr("somebody::else")));
    EXPECT_LT(std::count(errors.begin(), errors.end(), '\n'), 30);
}

TEST_F(Gazebo, AMessageOfAnotherTypeOnThePosesTopicIsNotTaken) {
    start();
    Node node;
    auto publisher = node.Advertise<gz::Image>("/model/robot/pose");
    Simulation simulation;
    Listener listener("/robot/front");
    connect(simulation, listener);
    for (int i = 0; i < 20; ++i) {
        publisher.Publish(gz::Image());
    }
    simulation.robotAt(3s, 0.8, 0.3);
    ASSERT_TRUE(listener.waitFor(1)) << program->errors();
    expectPicture(listener.images().back(), expected(0.8, 0.3));
}

/// A camera, a depth camera and a segmentation camera that see a square in the middle, 0.3 m away.
class GazeboObjects : public Gazebo {
  protected:
    static bool isObject(int x, int y) { return std::abs(x - 80) < 20 && std::abs(y - 60) < 20; }

    static gz::Image image(Stamp stamp, gz::PixelFormatType format, int width = 160) {
        gz::Image message;
        Simulation::setStamp(*message.mutable_header(), stamp);
        message.set_width(static_cast<std::uint32_t>(width));
        message.set_height(120);
        message.set_pixel_format_type(format);
        return message;
    }

    void publish(Stamp stamp) {
        gz::Image colour = image(stamp, gz::RGB_INT8);
        gz::Image depth = image(stamp, gz::R_FLOAT32);
        gz::Image labels = image(stamp, gz::RGB_INT8);
        for (int y = 0; y < 120; ++y) {
            for (int x = 0; x < 160; ++x) {
                const bool is = isObject(x, y);
                const float metres = is ? 0.3F : 4.0F;
                colour.mutable_data()->append(is ? "\x0a\xc8\x14" : "\xb2\xb2\xb2", 3);
                labels.mutable_data()->append(3, is ? '\x0a' : '\x01');
                depth.mutable_data()->append(reinterpret_cast<const char*>(&metres), 4);
            }
        }
        m_depth.Publish(depth);
        m_labels.Publish(labels);
        m_colour.Publish(colour);
    }

    /// The labels of this stamp.
    static std::optional<gz::Image> labelled(Listener& listener, Stamp stamp) {
        for (const gz::Image& message : listener.labels()) {
            if (stampOf(message.header()) == stamp) {
                return message;
            }
        }
        return std::nullopt;
    }

    /// The picture of this stamp, with the objects in it.
    static std::optional<gz::Image> laid(Listener& listener, Stamp stamp) {
        for (const gz::Param& report : listener.reports()) {
            if (stampOf(report.header()) == stamp && report.params().at("overlay").string_value() == "laid") {
                for (const gz::Image& message : listener.images()) {
                    if (stampOf(message.header()) == stamp) {
                        return message;
                    }
                }
            }
        }
        return std::nullopt;
    }

    bool isHeard() const {
        return m_colour.HasConnections() && m_depth.HasConnections() && m_labels.HasConnections();
    }

    const std::vector<std::string> kOptions = {
        "--rate",          "0",          "--pace",           "every",
        "--overlay-wait",  "1",          "--overlay-colour", "/o/colour/image",
        "--overlay-depth", "/o/d/image", "--overlay-labels", "/o/l/labels_map"};
    Node m_node;
    Node::Publisher m_colour = m_node.Advertise<gz::Image>("/o/colour/image");
    Node::Publisher m_depth = m_node.Advertise<gz::Image>("/o/d/image");
    Node::Publisher m_labels = m_node.Advertise<gz::Image>("/o/l/labels_map");
};

TEST_F(GazeboObjects, AreLaidIntoThePictureOfTheirStampAndTheRoomIsThePhoto) {
    start(kOptions);
    Simulation simulation;
    {
        Listener listener("/robot/front");
        ASSERT_TRUE(repeatUntil(
            [&] { return listener.has(1); },
            [&](int i) { simulation.robotAt(i * 1s, 0.3, 0); })) // each ends the wait for the one before
            << program->errors();
        EXPECT_EQ(listener.reports().front().params().at("overlay").string_value(), "missing");
        expectPicture(listener.images().front(), expected(0.3, 0));
        Stamp stamp = std::chrono::hours(2) + 3ns;
        ASSERT_TRUE(repeatUntil([&] { return laid(listener, stamp).has_value(); },
                                [&](int) {
                                    stamp += 1s;
                                    publish(stamp);
                                    simulation.robotAt(stamp, 0.3, 0);
                                }))
            << program->errors();
        stamp += 1s;
        m_colour.Publish(image(stamp, gz::RGB_INT8)); // without pixels
        m_depth.Publish(image(stamp, gz::RGB_INT8));
        m_labels.Publish(image(stamp, gz::R_FLOAT32, 1 << 30));
        publish(stamp);
        simulation.robotAt(stamp, 0.8, 0.3);
        ASSERT_TRUE(waitUntil([&] { return laid(listener, stamp).has_value(); })) << program->errors();
        ASSERT_TRUE(waitUntil([&] { return labelled(listener, stamp).has_value(); })) << program->errors();
        const gz::Image labels = labelled(listener, stamp).value();
        EXPECT_EQ(labels.pixel_format_type(), gz::L_INT16);
        ASSERT_EQ(labels.data().size(), 2U * 160 * 120);
        ASSERT_TRUE(waitUntil([&] {
            const auto all = listener.boxes();
            return !all.empty() && stampOf(all.back().header()) == stamp;
        }));
        const gz::AnnotatedAxisAligned2DBox_V boxes = listener.boxes().back();
        ASSERT_EQ(boxes.annotated_box_size(), 1);
        EXPECT_EQ(boxes.annotated_box(0).label(), 10U);
        const gz::AxisAligned2DBox& box = boxes.annotated_box(0).box();
        EXPECT_EQ(box.min_corner().x(), 61);
        EXPECT_EQ(box.min_corner().y(), 41);
        EXPECT_EQ(box.max_corner().x(), 99);
        EXPECT_EQ(box.max_corner().y(), 79);
        const gz::Image picture = laid(listener, stamp).value();
        const RgbImage photo = expected(0.8, 0.3);
        for (int y = 0; y < 120; ++y) {
            for (int x = 0; x < 160; ++x) {
                const std::string seen =
                    picture.data().substr(static_cast<std::size_t>(3 * (160 * y + x)), 3);
                const std::string wanted =
                    isObject(x, y) ? "\x0a\xc8\x14"
                                   : std::string(reinterpret_cast<const char*>(photo.at(x, y)), 3);
                ASSERT_EQ(seen, wanted) << x << " " << y;
                const std::string label =
                    labels.data().substr(static_cast<std::size_t>(2 * (160 * y + x)), 2);
                ASSERT_EQ(label, std::string(isObject(x, y) ? "\x0a\0" : "\0\0", 2)) << x << " " << y;
            }
        }
    }
    // The simulator need not render what nobody wants.
    EXPECT_TRUE(waitUntil([this] { return !isHeard(); }));
    const Json summary = end();
    EXPECT_GE(summary["overlays_laid"].get<int>(), 2);
    EXPECT_EQ(summary["refused"]["size"], 1);
    EXPECT_EQ(summary["refused"]["encoding"], 2);
}

TEST_F(Gazebo, WrongUsageEndsWithASentence) {
    const auto runs = [this](const std::vector<std::string>& options, int status,
                             const std::string& sentence) {
        Program wrong(command(options));
        EXPECT_EQ(wrong.wait(), status) << sentence;
        EXPECT_THAT(wrong.errors(), HasSubstr(sentence));
    };
    runs({"--image", "/image"}, 1, "has one level");
    runs({"--poses", "no topic"}, 1, "cannot be a topic's name");
    runs({"--overlay-colour", "/o/colour/image"}, 1, "--overlay-depth");
    runs({"--overlay-colour", "/o/c/image", "--overlay-depth", "/o/d/image"}, 1, "--overlay-labels");
    runs({"--rate", "-1"}, 2, "--rate");
    runs({"--mount", "0 0 0"}, 1, "x y z qx qy qz qw");
    runs({"--camera", folder / "absent.yaml"}, 1, "absent.yaml");
}

} // namespace
} // namespace spherewalk::test
