// SPDX-License-Identifier: GPL-3.0-or-later
#include "rclcpp_node.h"

#include "rclcpp_messages.h"

#include <chrono>
#include <utility>

namespace spherewalk::ros {

namespace {

constexpr std::size_t kTransformQueue = 100; ///< as tf2_ros has it

} // namespace

RclcppNode::RclcppNode() : rclcpp::Node("spherewalk") {
    // Offered reliably, which suits subscribers of both kinds.
    m_images = create_publisher<sensor_msgs::msg::Image>("camera/image_raw", rclcpp::QoS(2));
    m_infos = create_publisher<sensor_msgs::msg::CameraInfo>("camera/camera_info", rclcpp::QoS(2));
    m_diagnostics = create_publisher<diagnostic_msgs::msg::DiagnosticArray>("/diagnostics", rclcpp::QoS(10));
    m_node = std::make_unique<CameraNode>(
        readParameters(), [this](const PublishedFrame& frame) { publish(frame); },
        [logger = get_logger()](const std::string& sentence) {
            RCLCPP_WARN(logger, "%s", sentence.c_str());
        });
    subscribePoses();
    for (const OverlayTopic topic : m_node->overlayTopics()) {
        subscribe(topic);
    }
    m_service = create_service<SetCameraInfo>(
        "camera/set_camera_info",
        [this](const SetCameraInfo::Request::SharedPtr request,
               const SetCameraInfo::Response::SharedPtr response) { setCamera(*request, *response); });
    m_timers.push_back(create_wall_timer(std::chrono::milliseconds(10), [this] {
        m_node->setListening(m_images->get_subscription_count() > 0 || m_infos->get_subscription_count() > 0);
        m_node->takeTime(Stamp(get_clock()->now().nanoseconds()));
    }));
    m_timers.push_back(create_wall_timer(std::chrono::seconds(1), [this] { publishDiagnostics(); }));
}

NodeOptions RclcppNode::readParameters() {
    NodeOptions options;
    const auto read = [this](const char* name, auto& value) { value = declare_parameter(name, value); };
    read("dataset", options.dataset);
    read("camera_info_url", options.cameraInfoUrl);
    read("room_frame", options.roomFrame);
    read("camera_frame", options.cameraFrame);
    read("rate", options.rate);
    read("scene", options.scene);
    read("sampling", options.sampling);
    read("late", options.late);
    read("pace", options.pace);
    read("overlay", options.overlay);
    read("overlay_wait", options.overlayWait);
    read("threads", options.threads);
    read("cache_mb", options.cacheMb);
    std::vector<std::int64_t> labels(options.roomLabels.begin(), options.roomLabels.end());
    read("room_labels", labels);
    options.roomLabels.assign(labels.begin(), labels.end());
    return options;
}

void RclcppNode::subscribePoses() {
    const auto transforms = [this](const char* topic, const rclcpp::QoS& quality, bool isStatic) {
        m_subscriptions.push_back(create_subscription<tf2_msgs::msg::TFMessage>(
            topic, quality, [this, isStatic](const tf2_msgs::msg::TFMessage::ConstSharedPtr message) {
                for (const geometry_msgs::msg::TransformStamped& one : message->transforms) {
                    m_node->takeTransform(transformOf(one), isStatic);
                }
            }));
    };
    transforms("/tf_static", rclcpp::QoS(kTransformQueue).transient_local(), true);
    transforms("/tf", rclcpp::QoS(kTransformQueue), false);
    m_subscriptions.push_back(create_subscription<geometry_msgs::msg::PoseStamped>(
        "camera/pose", rclcpp::SensorDataQoS(),
        [this](const geometry_msgs::msg::PoseStamped::ConstSharedPtr message) {
            m_node->takePose(message->header.frame_id, stampOf(message->header.stamp), poseOf(message->pose));
        }));
}

void RclcppNode::subscribe(OverlayTopic topic) {
    m_subscriptions.push_back(create_subscription<sensor_msgs::msg::Image>(
        nameOf(topic), rclcpp::SensorDataQoS(),
        [this, topic](const sensor_msgs::msg::Image::ConstSharedPtr message) {
            m_node->takeOverlay(topic, stampOf(message->header.stamp), pictureOf(*message));
        }));
}

void RclcppNode::publish(const PublishedFrame& frame) {
    auto info = std::make_unique<sensor_msgs::msg::CameraInfo>();
    info->header.stamp = timeOf(frame.stamp);
    info->header.frame_id = m_node->options().cameraFrame;
    fill(*info, frame.calibration);
    auto image = std::make_unique<sensor_msgs::msg::Image>();
    image->header = info->header;
    fillImage(*image, frame);
    m_infos->publish(std::move(info));
    m_images->publish(std::move(image));
}

void RclcppNode::publishDiagnostics() {
    diagnostic_msgs::msg::DiagnosticArray message;
    message.header.stamp = get_clock()->now();
    message.status.push_back(
        statusOf<diagnostic_msgs::msg::DiagnosticStatus>(m_node->diagnostics(), get_fully_qualified_name()));
    m_diagnostics->publish(message);
}

void RclcppNode::setCamera(const SetCameraInfo::Request& request, SetCameraInfo::Response& response) {
    answerSetCamera(*m_node, calibrationOf(request.camera_info), response);
}

} // namespace spherewalk::ros
