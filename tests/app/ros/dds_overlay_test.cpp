// SPDX-License-Identifier: GPL-3.0-or-later
// A simulator's objects in the pictures of the node of ROS 2's wire protocol.
#include "dds_fixture.h"
#include "temporary_folder.h"

#include "spherewalk/base/file.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <dds/ddsi/ddsi_serdata.h>
#include <tuple>

namespace spherewalk::ros {

namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 120;
constexpr std::size_t kPixels = std::size_t{kWidth} * kHeight;

/// Bytes as DDS carries them (plain CDR, lowest byte first), read without the product's own description.
class Cdr {
  public:
    explicit Cdr(std::vector<std::uint8_t> bytes) : m_bytes(std::move(bytes)) {
        EXPECT_EQ(m_bytes.at(1), 1) << "plain CDR, lowest byte first";
    }

    template <class Number>
    Number number() {
        m_at = (m_at + sizeof(Number) - 1) / sizeof(Number) * sizeof(Number);
        Number value{};
        if (kStart + m_at + sizeof(Number) > m_bytes.size()) {
            throw std::out_of_range("The message ends early.");
        }
        std::memcpy(&value, m_bytes.data() + kStart + m_at, sizeof(Number));
        m_at += sizeof(Number);
        return value;
    }

    std::string text() {
        std::string value(number<std::uint32_t>(), 0);
        for (char& one : value) {
            one = number<char>();
        }
        value.pop_back(); // the closing zero
        return value;
    }

    std::size_t left() const { return m_bytes.size() - kStart - m_at; }

  private:
    static constexpr std::size_t kStart = 4;
    std::vector<std::uint8_t> m_bytes;
    std::size_t m_at = 0;
};

/// Label, left, top, right, bottom.
using Box = std::tuple<int, int, int, int, int>;

struct Detections {
    Stamp stamp{};
    std::string frame;
    std::vector<Box> boxes;
};

Stamp readStamp(Cdr& cdr) {
    const auto seconds = cdr.number<std::int32_t>();
    return std::chrono::seconds(seconds) + std::chrono::nanoseconds(cdr.number<std::uint32_t>());
}

/// By the definitions of vision_msgs 4, which Humble and Jazzy have.
Box readDetection(Cdr& cdr, const Detections& in) {
    EXPECT_EQ(readStamp(cdr), in.stamp);
    EXPECT_EQ(cdr.text(), in.frame);
    EXPECT_EQ(cdr.number<std::uint32_t>(), 1U) << "results";
    const int label = std::stoi(cdr.text()); // class_id
    EXPECT_EQ(cdr.number<double>(), 1) << "score";
    for (const double expected : {0, 0, 0, 0, 0, 0, 1}) {
        EXPECT_EQ(cdr.number<double>(), expected) << "pose";
    }
    for (int i = 0; i < 36; ++i) {
        EXPECT_EQ(cdr.number<double>(), 0) << "covariance";
    }
    const auto x = cdr.number<double>();
    const auto y = cdr.number<double>();
    EXPECT_EQ(cdr.number<double>(), 0) << "theta";
    const auto width = cdr.number<double>();
    const auto height = cdr.number<double>();
    EXPECT_EQ(cdr.text(), "") << "id";
    const auto whole = [](double value) {
        EXPECT_EQ(value, std::round(value));
        return static_cast<int>(value);
    };
    return {label, whole(x - (width - 1) / 2), whole(y - (height - 1) / 2), whole(x + (width - 1) / 2),
            whole(y + (height - 1) / 2)};
}

Detections readDetections(Cdr cdr) {
    Detections read;
    read.stamp = readStamp(cdr);
    read.frame = cdr.text();
    const auto count = cdr.number<std::uint32_t>();
    for (std::uint32_t i = 0; i < count; ++i) {
        read.boxes.push_back(readDetection(cdr, read));
    }
    EXPECT_LT(cdr.left(), 4U) << "no more than padding";
    return read;
}

/// A participant of its own that takes Detection2DArrays as bytes.
class DetectionsReader {
  public:
    DetectionsReader(std::uint32_t domain, const std::string& topic)
        : m_participant(dds_create_participant(domain, nullptr, nullptr)) {
        const dds_topic_descriptor_t& type = vision_msgs_msg_dds__Detection2DArray__desc;
        EXPECT_STREQ(type.m_typename, "vision_msgs::msg::dds_::Detection2DArray_");
        const dds_entity_t entity =
            dds_create_topic(m_participant, &type, ("rt" + topic).c_str(), nullptr, nullptr);
        dds_qos_t* qos = dds_create_qos();
        dds_qset_reliability(qos, DDS_RELIABILITY_RELIABLE, DDS_MSECS(10));
        dds_qset_history(qos, DDS_HISTORY_KEEP_LAST, 100);
        m_reader = dds_create_reader(m_participant, entity, qos, nullptr);
        EXPECT_GT(m_reader, 0) << topic;
        dds_delete_qos(qos);
    }

    DetectionsReader(const DetectionsReader&) = delete;
    DetectionsReader& operator=(const DetectionsReader&) = delete;

    ~DetectionsReader() { dds_delete(m_participant); }

    /// All that came so far.
    const std::map<Stamp, Detections>& all() {
        constexpr std::size_t kAtOnce = 16;
        std::array<ddsi_serdata*, kAtOnce> data{};
        std::array<dds_sample_info_t, kAtOnce> infos{};
        const int count = dds_takecdr(m_reader, data.data(), kAtOnce, infos.data(), DDS_ANY_STATE);
        for (std::size_t i = 0; i < static_cast<std::size_t>(std::max(count, 0)); ++i) {
            if (infos[i].valid_data) {
                std::vector<std::uint8_t> bytes(ddsi_serdata_size(data[i]));
                ddsi_serdata_to_ser(data[i], 0, bytes.size(), bytes.data());
                const Detections one = readDetections(Cdr(std::move(bytes)));
                m_all[one.stamp] = one;
            }
            ddsi_serdata_unref(data[i]);
        }
        return m_all;
    }

  private:
    dds_entity_t m_participant;
    dds_entity_t m_reader = 0;
    std::map<Stamp, Detections> m_all;
};

/// The extremes of the pixels of each label of a picture of 16 bits.
std::vector<Box> extremesOf(const Image& labels) {
    std::map<int, std::vector<int>> columns;
    std::map<int, std::vector<int>> rows;
    for (int i = 0; i < labels.width * labels.height; ++i) {
        const auto at = static_cast<std::size_t>(2 * i);
        if (const int label = labels.data[at] + 256 * labels.data[at + 1]; label != 0) {
            columns[label].push_back(i % labels.width);
            rows[label].push_back(i / labels.width);
        }
    }
    std::vector<Box> boxes;
    for (const auto& [label, x] : columns) {
        const auto [left, right] = std::minmax_element(x.begin(), x.end());
        const auto [top, bottom] = std::minmax_element(rows[label].begin(), rows[label].end());
        boxes.emplace_back(label, *left, *top, *right, *bottom);
    }
    return boxes;
}

/// A simulator's pictures of objects in front of a room with the label 1.
class Objects {
  public:
    Objects(DdsPort& port, const std::string& topics)
        : m_colour(port.writer(topics + "/image_raw", sensor_msgs_msg_dds__Image__desc, Quality::Sensor)),
          m_depth(port.writer(topics + "/depth", sensor_msgs_msg_dds__Image__desc, Quality::Sensor)),
          m_labels(port.writer(topics + "/labels", sensor_msgs_msg_dds__Image__desc, Quality::Sensor)) {}

    void clear() { std::fill(m_pixels.begin(), m_pixels.end(), std::uint8_t{1}); }

    void put(const Box& box) {
        const auto [label, left, top, right, bottom] = box;
        for (int y = top; y <= bottom; ++y) {
            std::fill_n(m_pixels.begin() + y * kWidth + left, right - left + 1,
                        static_cast<std::uint8_t>(label));
        }
    }

    void send(Stamp stamp) {
        sendOverlay(m_colour, stamp, "rgb8", 3, m_rgb.data());
        sendOverlay(m_depth, stamp, "32FC1", 4, m_metres.data());
        sendOverlay(m_labels, stamp, "mono8", 1, m_pixels.data());
    }

  private:
    std::vector<std::uint8_t> m_pixels = std::vector<std::uint8_t>(kPixels, 1);
    std::vector<std::uint8_t> m_rgb = std::vector<std::uint8_t>(3 * kPixels, 200);
    std::vector<float> m_metres = std::vector<float>(kPixels, 0.5F);
    dds_entity_t m_colour;
    dds_entity_t m_depth;
    dds_entity_t m_labels;
};

} // namespace

TEST_F(DdsTest, LaysASimulatorsObjectsInBetweenTwoTransforms) {
    startNode({"--overlay", "alone", "--overlay-wait", "10"}, "50");
    const dds_entity_t colour =
        port.writer("/robot/overlay/image_raw", sensor_msgs_msg_dds__Image__desc, Quality::Sensor);
    const dds_entity_t depth =
        port.writer("/robot/overlay/depth", sensor_msgs_msg_dds__Image__desc, Quality::Sensor);
    std::vector<std::uint8_t> green(3 * kPixels);
    for (std::size_t i = 1; i < green.size(); i += 3) {
        green[i] = 255;
    }
    std::vector<float> metres(kPixels, 0.1F); // in front of all that the scene model knows
    std::vector<Image> labels;
    DdsPort listener(domain);
    listener.read<ImageMessage>("/robot/camera/labels/image_raw", sensor_msgs_msg_dds__Image__desc,
                                Quality::Sensor, [&](const ImageMessage& message) {
                                    takeImage(message);
                                    labels.push_back(images.back());
                                    images.pop_back();
                                });
    moveUntil("a frame", [&] {
        sendOverlay(colour, now + 5ms, "rgb8", 3, green.data());
        sendOverlay(depth, now + 5ms, "32FC1", 4, metres.data());
        listener.spinFor(20ms);
        return !images.empty() && !labels.empty();
    });
    EXPECT_EQ(images.back().stamp.count() % 10'000'000, 5'000'000) << "that of the overlay";
    EXPECT_EQ(images.back().data, green);
    EXPECT_EQ(labels.back().stamp.count() % 10'000'000, 5'000'000);
    EXPECT_EQ(labels.back().encoding, "16UC1");
    EXPECT_EQ(labels.back().data, std::vector<std::uint8_t>(2 * kPixels, 255)) << "objects without a label";
}

/// How a reader of another participant asks for what a writer gives.
dds_reliability_kind_t askedOf(dds_entity_t writer) {
    dds_instance_handle_t reader = 0;
    dds_reliability_kind_t kind = DDS_RELIABILITY_BEST_EFFORT;
    if (dds_get_matched_subscriptions(writer, &reader, 1) == 1) {
        dds_builtintopic_endpoint_t* endpoint = dds_get_matched_subscription_data(writer, reader);
        dds_qget_reliability(endpoint->qos, &kind, nullptr);
        dds_builtintopic_free_endpoint(endpoint);
    }
    return kind;
}

TEST_F(DdsTest, AsksForAllPicturesOfObjectsWhileAllWhoGiveThemOfferThat) {
    startNode({"--overlay", "alone", "--overlay-wait", "10"}, "50");
    const dds_topic_descriptor_t& type = sensor_msgs_msg_dds__Image__desc;
    const dds_entity_t reliable = port.writer("/robot/overlay/image_raw", type, Quality::Sensor);
    waitFor("a reliable reader", [&] { return askedOf(reliable) == DDS_RELIABILITY_RELIABLE; });
    const dds_entity_t topic = dds_create_topic(dds_get_participant(reliable), &type,
                                                "rt/robot/overlay/image_raw", nullptr, nullptr);
    dds_qos_t* qos = dds_create_qos();
    dds_qset_reliability(qos, DDS_RELIABILITY_BEST_EFFORT, 0);
    const dds_entity_t hasty = dds_create_writer(dds_get_participant(reliable), topic, qos, nullptr);
    dds_delete_qos(qos);
    waitFor("a reader of both", [&] {
        return DdsPort::readersOf(hasty) == 1 && DdsPort::readersOf(reliable) == 1 &&
               askedOf(reliable) == DDS_RELIABILITY_BEST_EFFORT;
    });
}

TEST_F(DdsTest, GivesTheBoxAboutThePixelsOfEachLabelWithThePicturesStamp) {
    startNode({"--overlay", "labels", "--room-label", "1", "--overlay-wait", "0.2"});
    DdsPort listener(domain);
    std::map<Stamp, Image> labels;
    listener.read<ImageMessage>("/robot/camera/labels/image_raw", sensor_msgs_msg_dds__Image__desc,
                                Quality::Reliable, [&](const ImageMessage& message) {
                                    takeImage(message);
                                    labels[images.back().stamp] = images.back();
                                    images.pop_back();
                                });
    DetectionsReader reader(domain, "/robot/camera/labels/detections");
    Objects objects(port, "/robot/overlay");
    const std::vector<Box> drawn{
        {10, 150, 100, 159, 119}, {10, 0, 110, 5, 112}, {7, 80, 60, 80, 60}, {0, 30, 0, 40, 5}};
    const std::vector<Box> boxes{{7, 80, 60, 80, 60}, {10, 0, 100, 159, 119}, {65535, 30, 0, 40, 5}};
    const auto came = [&](const std::vector<Box>& wanted) {
        return std::any_of(images.begin(), images.end(), [&](const Image& image) {
            const auto one = reader.all().find(image.stamp);
            return one != reader.all().end() && one->second.boxes == wanted && labels.contains(image.stamp);
        });
    };
    moveUntil("boxes, and none, of the stamps of pictures", [&] {
        objects.clear();
        for (const Box& box : (now + 10ms) % 20ms == 0ms ? drawn : std::vector<Box>()) {
            objects.put(box);
        }
        objects.send(now + 10ms);
        listener.spinFor(20ms);
        return came(boxes) && came({});
    });
    for (const auto& [stamp, detections] : reader.all()) {
        EXPECT_EQ(detections.frame, "camera_optical");
        if (const auto of = labels.find(stamp); of != labels.end()) {
            EXPECT_EQ(detections.boxes, extremesOf(of->second));
        }
    }
}

TEST_F(DdsTest, EachCameraOfARigHasBoxesOfItsOwn) {
    const test::TemporaryFolder folder;
    const CameraIntrinsics camera{kWidth, kHeight, 120, 120, 79.5, 59.5, LensModel::Pinhole, {}};
    const std::string file = folder / "pinhole.yaml";
    writeFile(file, bytesOf(render::cameraInfoYaml(camera, "robot")));
    writeFile(folder / "rig.yaml",
              bytesOf("cameras:\n  - {name: left, camera_info: " + file +
                      ", rig_from_camera: [0, 0, 0, 0, 0, 0, 1]}\n  - {name: right, camera_info: " + file +
                      ", rig_from_camera: [0.1, 0, 0, 0, 0, 0, 1]}\n"));
    startNode({"--overlay", "labels", "--overlay-wait", "0.2"}, "0", {"--rig", folder / "rig.yaml"});
    DetectionsReader left(domain, "/robot/left/labels/detections");
    DetectionsReader right(domain, "/robot/right/labels/detections");
    Objects ofLeft(port, "/robot/left/overlay");
    Objects ofRight(port, "/robot/right/overlay");
    const Box inLeft{5, 20, 30, 40, 50};
    const Box inRight{6, 10, 30, 30, 50};
    ofLeft.put(inLeft);
    ofRight.put(inRight);
    moveUntil("boxes of one stamp", [&] {
        ofLeft.send(now + 10ms);
        ofRight.send(now + 10ms);
        const auto& all = right.all();
        return std::any_of(all.begin(), all.end(), [&](const auto& one) {
            const auto other = left.all().find(one.first);
            return one.second.boxes == std::vector{inRight} && one.second.frame == "right_optical" &&
                   other != left.all().end() && other->second.boxes == std::vector{inLeft} &&
                   other->second.frame == "left_optical";
        });
    });
}

} // namespace spherewalk::ros
