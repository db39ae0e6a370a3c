// SPDX-License-Identifier: GPL-3.0-or-later
// A robot's camera for ROS 2 by its wire protocol alone; resources/docs/guide/ros.md says how it is used.
#include "dds_messages.h"
#include "dds_port.h"
#include "program/command_line.h"
#include "program/program.h"
#include "program/render_options.h"

#include "spherewalk/base/error.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace spherewalk::ros {

namespace {

/// How long a frame waits for a reader. DDS takes a process that does not answer for dead after ten seconds.
constexpr auto kPatience = std::chrono::seconds(1);
constexpr auto kMostPatience = std::chrono::seconds(10);

struct DdsOptions {
    NodeOptions node;
    std::string nameSpace = "/"; ///< that the camera's topics are in
    std::uint32_t domain = 0;
    bool usesSimTime = false; ///< time is what /clock says
};

/// Carries ROS 2's messages to a CameraNode and back.
class DdsNode {
  public:
    /// Errors: those of CameraNode and DdsPort.
    explicit DdsNode(const DdsOptions& options);

    /// Until a stop is asked for; what it asks is looked at a hundred times a second. Errors: those of
    /// DdsPort.
    void run(const std::stop_token& stop);

  private:
    using Clock = std::chrono::steady_clock;

    /// Writers of one camera; 0 for what is not wanted.
    struct Writers {
        dds_entity_t images = 0;
        dds_entity_t infos = 0;
        dds_entity_t depths = 0;
        dds_entity_t depthInfos = 0;
        dds_entity_t labels = 0;
        dds_entity_t detections = 0;
    };

    std::string topic(const std::string& name) const;
    Writers writersOf(const PublishedCamera& camera);
    void readPoses();
    void readOverlay(OverlayTopic topic, std::size_t camera);
    void readCamera(std::size_t camera);
    void publish(const PublishedFrame& frame);
    /// Waits for readers that are busy, so that frames are left out as a whole. Errors: Timeout for one that
    /// takes nothing where every frame counts.
    void write(dds_entity_t writer, const void* message) const;
    void publishDiagnostics();
    bool hasReaders() const;
    Stamp now() const;

    DdsOptions m_options;
    const bool m_isEvery; ///< Every frame counts.
    std::atomic<bool> m_isStopping = false;
    DdsPort m_port;
    dds_entity_t m_diagnostics;
    std::vector<Writers> m_writers; ///< one a camera; constant once somebody listens
    Stamp m_clock{};                ///< what /clock said last
    CameraNode m_node;              ///< after what its thread writes to
};

DdsNode::DdsNode(const DdsOptions& options)
    : m_options(options),
      m_isEvery(options.node.pace == "every"),
      m_port(options.domain),
      m_diagnostics(
          m_port.writer("/diagnostics", diagnostic_msgs_msg_dds__DiagnosticArray__desc, Quality::Reliable)),
      m_node(
          options.node, [this](const PublishedFrame& frame) { publish(frame); },
          [](const std::string& sentence) { program::printLine(stderr, sentence); }) {
    for (const PublishedCamera& camera : m_node.cameras()) {
        m_writers.push_back(writersOf(camera));
    }
    readPoses();
    for (std::size_t camera = 0; camera < m_writers.size(); ++camera) {
        readCamera(camera);
        for (const OverlayTopic overlay : m_node.overlayTopics()) {
            readOverlay(overlay, camera);
        }
    }
    if (options.usesSimTime) {
        m_port.read<ClockMessage>("/clock", rosgraph_msgs_msg_dds__Clock__desc, Quality::Sensor,
                                  [this](const ClockMessage& message) { m_clock = stampOf(message.clock); });
    }
}

std::string DdsNode::topic(const std::string& name) const {
    const std::string& in = m_options.nameSpace;
    return (in.starts_with('/') ? "" : "/") + in + (in.ends_with('/') ? "" : "/") + name;
}

DdsNode::Writers DdsNode::writersOf(const PublishedCamera& camera) {
    const auto writer = [this](const std::string& name, const dds_topic_descriptor_t& type) {
        return m_port.writer(topic(name), type, Quality::Sensor);
    };
    Writers writers;
    writers.images = writer(camera.name + "/image_raw", sensor_msgs_msg_dds__Image__desc);
    writers.infos = writer(camera.name + "/camera_info", sensor_msgs_msg_dds__CameraInfo__desc);
    if (!camera.depthTopic.empty()) {
        writers.depths = writer(camera.depthTopic, sensor_msgs_msg_dds__Image__desc);
        writers.depthInfos =
            writer(camera.name + "/depth/camera_info", sensor_msgs_msg_dds__CameraInfo__desc);
    }
    if (!camera.labelsTopic.empty()) {
        writers.labels = writer(camera.labelsTopic, sensor_msgs_msg_dds__Image__desc);
        writers.detections = writer(camera.detectionsTopic, vision_msgs_msg_dds__Detection2DArray__desc);
    }
    return writers;
}

void DdsNode::readPoses() {
    const auto read = [this](const char* topic, Quality quality, bool isStatic) {
        m_port.read<TransformsMessage>(topic, tf2_msgs_msg_dds__TFMessage__desc, quality,
                                       [this, isStatic](const TransformsMessage& message) {
                                           for (std::uint32_t i = 0; i < message.transforms._length; ++i) {
                                               m_node.takeTransform(
                                                   transformOf(message.transforms._buffer[i]), isStatic);
                                           }
                                       });
    };
    read("/tf_static", Quality::Latched, true);
    read("/tf", Quality::Reliable, false);
    m_port.read<PoseMessage>(topic("camera/pose"), geometry_msgs_msg_dds__PoseStamped__desc, Quality::Sensor,
                             [this](const PoseMessage& message) {
                                 const auto& header = message.header;
                                 m_node.takePose(header.frame_id, stampOf(header.stamp), poseOf(message));
                             });
}

void DdsNode::readOverlay(OverlayTopic overlay, std::size_t camera) {
    m_port.read<ImageMessage>(topic(m_node.overlayTopic(overlay, camera)), sensor_msgs_msg_dds__Image__desc,
                              Quality::Offered, [this, overlay, camera](const ImageMessage& message) {
                                  const std::string encoding = message.encoding;
                                  m_node.takeOverlay(overlay, stampOf(message.header.stamp),
                                                     {message.width, message.height, message.step, encoding,
                                                      message.is_bigendian != 0, message.data._buffer,
                                                      message.data._length},
                                                     camera);
                              });
}

/// ROS 2's services are laid out differently by each of its middlewares; a topic is the same for all.
void DdsNode::readCamera(std::size_t camera) {
    m_port.read<CameraInfoMessage>(topic(m_node.cameras()[camera].name + "/set_camera_info"),
                                   sensor_msgs_msg_dds__CameraInfo__desc, Quality::Reliable,
                                   [this, camera](const CameraInfoMessage& message) {
                                       try {
                                           m_node.setCamera(calibrationOf(message), camera);
                                       } catch (const Error& error) {
                                           program::printLine(stderr, error.sentence());
                                       }
                                   });
}

void DdsNode::write(dds_entity_t writer, const void* message) const {
    const Clock::time_point end = Clock::now() + (m_isEvery ? kMostPatience : kPatience);
    while (!DdsPort::write(writer, message) && !m_isStopping) {
        if (Clock::now() < end) {
            continue;
        }
        if (m_isEvery) {
            throw Error(ErrorKind::Timeout,
                        "A frame was not published whole: a reader of this camera's topics took nothing for "
                        "ten seconds. End that reader, or let it ask for best effort.");
        }
        return; // the others shall have the newest
    }
}

void DdsNode::publish(const PublishedFrame& frame) {
    const std::string& frameId = m_node.cameras()[frame.camera].frameId;
    const Writers& writers = m_writers[frame.camera];
    const CameraInfoMessage info = cameraInfoOf(frame, frameId);
    const ImageMessage image = imageOf(frame, frame.image, frameId);
    write(writers.infos, &info);
    write(writers.images, &image);
    if (writers.depths != 0 && frame.depth.bytes != nullptr) {
        const ImageMessage depth = imageOf(frame, frame.depth, frameId);
        write(writers.depthInfos, &info);
        write(writers.depths, &depth);
    }
    if (writers.labels != 0 && frame.labels.bytes != nullptr) {
        const ImageMessage labels = imageOf(frame, frame.labels, frameId);
        const FrameDetections detections(frame, frameId);
        write(writers.labels, &labels);
        write(writers.detections, &detections.message());
    }
}

void DdsNode::publishDiagnostics() {
    Diagnostics diagnostics = m_node.diagnostics();
    std::vector<diagnostic_msgs_msg_dds__KeyValue_> values;
    for (auto& [key, value] : diagnostics.values) {
        values.push_back({key.data(), value.data()});
    }
    std::string name = topic("camera");
    std::string hardware = "spherewalk";
    std::string none;
    diagnostic_msgs_msg_dds__DiagnosticStatus_ status{};
    status.level = diagnostics.level;
    status.name = name.data();
    status.message = diagnostics.message.data();
    status.hardware_id = hardware.data();
    status.values._length = status.values._maximum = static_cast<std::uint32_t>(values.size());
    status.values._buffer = values.data();
    DiagnosticMessage message{};
    message.header = {timeOf(now()), none.data()};
    message.status._length = message.status._maximum = 1;
    message.status._buffer = &status;
    DdsPort::write(m_diagnostics, &message);
}

Stamp DdsNode::now() const {
    return m_options.usesSimTime
               ? m_clock
               : std::chrono::duration_cast<Stamp>(std::chrono::system_clock::now().time_since_epoch());
}

bool DdsNode::hasReaders() const {
    const auto is = [](dds_entity_t writer) { return writer != 0 && DdsPort::readersOf(writer) > 0; };
    return std::any_of(m_writers.begin(), m_writers.end(), [&is](const Writers& of) {
        return is(of.images) || is(of.infos) || is(of.depths) || is(of.depthInfos) || is(of.labels) ||
               is(of.detections);
    });
}

void DdsNode::run(const std::stop_token& stop) {
    constexpr std::chrono::milliseconds kTurn(10);
    Clock::time_point diagnosed = Clock::now();
    while (!stop.stop_requested()) {
        m_port.spinFor(kTurn);
        m_node.setListening(hasReaders());
        m_node.takeTime(now());
        if (Clock::now() - diagnosed >= std::chrono::seconds(1)) {
            diagnosed = Clock::now();
            publishDiagnostics();
        }
    }
    m_isStopping = true;
}

} // namespace

} // namespace spherewalk::ros

namespace {

void declare(const spherewalk::program::Command& command, spherewalk::ros::DdsOptions& options) {
    spherewalk::ros::NodeOptions& node = options.node;
    command.option("dataset", node.dataset, "Folder of the dataset").required();
    spherewalk::program::declareCameras(command, node.cameraInfoUrl, node.rig);
    command.option("--namespace", options.nameSpace, "That the camera's topics are in").showDefault();
    command.option("--domain", options.domain, "DDS domain")
        .fromEnvironment("ROS_DOMAIN_ID")
        .range(0, 232)
        .showDefault();
    command.flag("--sim-time", options.usesSimTime, "Time is what /clock says");
    command.option("--room-frame", node.roomFrame, "Frame of the dataset's room").showDefault();
    command.option("--camera-frame", node.cameraFrame, "Optical frame of the camera; of a rig, its own frame")
        .showDefault();
    command.option("--rate", node.rate, "Frames a second of simulation time; 0: one for each pose")
        .showDefault();
    command.option("--scene", node.scene, "none, sphere, room, depth, blend, or auto").showDefault();
    command
        .option("--sampling", node.sampling, "nearest, bilinear, reduced, footprint, bicubic, best, or auto")
        .showDefault();
    command
        .option("--late", node.late,
                "What a frame is made from when its photo is not decoded yet: wait, coarse, or previous")
        .showDefault();
    command
        .option("--pace", node.pace,
                "Frames whose turn has passed: newest leaves them out, every renders all")
        .showDefault();
    command
        .option("--overlay", node.overlay,
                "How a simulator's objects are told from its room: labels, depth or alone; none: no objects")
        .showDefault();
    command.option("--room-label", node.roomLabels, "With labels: those of the room, which show the photo")
        .showDefault();
    command.option("--overlay-wait", node.overlayWait, "Seconds that a frame waits for its overlay")
        .showDefault();
    command.option("--threads", node.threads, "Threads to render with; 0: all").showDefault();
    command.option("--cache-mb", node.cacheMb, "Of decoded photos").showDefault();
    command.option("--sensor", node.sensor,
                   "Sensor that is not perfect: a YAML with noise, exposure, shutter and other effects");
    command
        .option("--depth", node.depth,
                "Depth images beside the pictures: 32FC1 (metres), 16UC1 (millimetres), or none")
        .among({"none", "32FC1", "16UC1"})
        .showDefault();
}

int run(const spherewalk::ros::DdsOptions& options) {
    const spherewalk::program::StopOnSignal stop;
    spherewalk::ros::DdsNode node(options);
    spherewalk::program::printLine(stderr, "Ready; frames are rendered while somebody listens.");
    node.run(stop.token());
    return spherewalk::program::kDone;
}

} // namespace

int main(int argc, char** argv) {
    spherewalk::program::CommandLine line(
        "A robot's camera for ROS 2, by its wire protocol: no ROS is needed to run it.", "spherewalk-dds",
        "spherewalk-dds " SPHEREWALK_VERSION);
    spherewalk::ros::DdsOptions options;
    declare(line.program(), options);
    if (const std::optional<int> status = line.parse(argc, argv)) {
        return *status;
    }
    return spherewalk::program::guarded([&] { return run(options); });
}
