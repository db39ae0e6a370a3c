// SPDX-License-Identifier: GPL-3.0-or-later
#include "ros1_node.h"

#include "ros1_messages.h"

namespace spherewalk::ros {

namespace {

constexpr std::uint32_t kTransformQueue = 100; ///< as tf2_ros has it
constexpr std::uint32_t kPictureQueue = 5;

/// Frames that wait to be sent; where every one counts there is no limit.
std::uint32_t frameQueue(const NodeOptions& options) {
    return options.pace == "every" ? 0 : 2;
}

} // namespace

Ros1Node::Ros1Node(const ::ros::NodeHandle& handle, const NodeOptions& options)
    : m_handle(handle),
      m_transport(handle),
      m_node(
          options, [this](const PublishedFrame& frame) { publish(frame); },
          [](const std::string& sentence) { ROS_WARN("%s", sentence.c_str()); }) {
    const auto changed = [this](const auto&) { listen(); };
    m_publisher = m_transport.advertiseCamera("camera/image_raw", frameQueue(options), changed, changed,
                                              changed, changed);
    m_diagnostics = m_handle.advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", 10);
    m_service = m_handle.advertiseService("camera/set_camera_info", &Ros1Node::setCamera, this);
    m_subscribers.push_back(m_handle.subscribe<tf2_msgs::TFMessage>(
        "/tf_static", kTransformQueue,
        [this](const tf2_msgs::TFMessage::ConstPtr& message) { takeTransforms(*message, true); }));
    m_subscribers.push_back(m_handle.subscribe<tf2_msgs::TFMessage>(
        "/tf", kTransformQueue,
        [this](const tf2_msgs::TFMessage::ConstPtr& message) { takeTransforms(*message, false); }, {},
        ::ros::TransportHints().tcpNoDelay()));
    m_subscribers.push_back(m_handle.subscribe<geometry_msgs::PoseStamped>(
        "camera/pose", kTransformQueue, [this](const geometry_msgs::PoseStamped::ConstPtr& message) {
            m_node.takePose(message->header.frame_id, stampOf(message->header.stamp), poseOf(message->pose));
        }));
    for (const OverlayTopic topic : m_node.overlayTopics()) {
        subscribe(topic);
    }
    if (options.rate > 0) {
        m_clock = m_handle.createTimer(::ros::Duration(1 / options.rate), [this](const ::ros::TimerEvent&) {
            m_node.takeTime(stampOf(::ros::Time::now()));
        });
    }
    m_listening = m_handle.createWallTimer(::ros::WallDuration(0.5),
                                           [this](const ::ros::WallTimerEvent&) { listen(); });
    m_diagnosing = m_handle.createWallTimer(::ros::WallDuration(1),
                                            [this](const ::ros::WallTimerEvent&) { publishDiagnostics(); });
}

void Ros1Node::subscribe(OverlayTopic topic) {
    m_subscribers.push_back(m_handle.subscribe<sensor_msgs::Image>(
        nameOf(topic), kPictureQueue,
        [this, topic](const sensor_msgs::Image::ConstPtr& message) {
            m_node.takeOverlay(topic, stampOf(message->header.stamp), pictureOf(*message));
        },
        {}, ::ros::TransportHints().tcpNoDelay()));
}

void Ros1Node::listen() {
    m_node.setListening(m_publisher.getNumSubscribers() > 0);
}

void Ros1Node::publish(const PublishedFrame& frame) {
    m_image.header.stamp = rosTime(frame.stamp);
    m_image.header.frame_id = m_node.options().cameraFrame;
    fillImage(m_image, frame);
    fill(m_info, frame.calibration);
    m_info.header = m_image.header;
    m_publisher.publish(m_image, m_info);
}

void Ros1Node::publishDiagnostics() {
    diagnostic_msgs::DiagnosticArray message;
    message.header.stamp = ::ros::Time::now();
    message.status.push_back(
        statusOf<diagnostic_msgs::DiagnosticStatus>(m_node.diagnostics(), ::ros::this_node::getName()));
    m_diagnostics.publish(message);
}

bool Ros1Node::setCamera(sensor_msgs::SetCameraInfo::Request& request,
                         sensor_msgs::SetCameraInfo::Response& response) {
    answerSetCamera(m_node, calibrationOf(request.camera_info), response);
    return true; // it was answered
}

void Ros1Node::takeTransforms(const tf2_msgs::TFMessage& message, bool isStatic) {
    for (const geometry_msgs::TransformStamped& one : message.transforms) {
        m_node.takeTransform(transformOf(one), isStatic);
    }
}

} // namespace spherewalk::ros
