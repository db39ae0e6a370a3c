// SPDX-License-Identifier: GPL-3.0-or-later
// A robot's camera as a node of ROS 2; resources/docs/guide/ros.md says how it is used.
#include "camera/camera_node.h"
#include "camera/message_fields.h"
#include "camera/node_parameters.h"

#include <builtin_interfaces/msg/time.hpp>
#include <chrono>
#include <cstdint>
#include <diagnostic_msgs/msg/diagnostic_array.hpp>
#include <exception>
#include <geometry_msgs/msg/pose.hpp>
#include <geometry_msgs/msg/pose_stamped.hpp>
#include <geometry_msgs/msg/transform_stamped.hpp>
#include <memory>
#include <rcl_interfaces/msg/parameter_descriptor.hpp>
#include <rclcpp/rclcpp.hpp>
#include <sensor_msgs/msg/camera_info.hpp>
#include <sensor_msgs/msg/image.hpp>
#include <sensor_msgs/srv/set_camera_info.hpp>
#include <string>
#include <tf2_msgs/msg/tf_message.hpp>
#include <utility>
#include <vector>

namespace spherewalk::ros {

namespace {

/// Between ROS 2's messages and what the node works with.

Stamp stampOf(const builtin_interfaces::msg::Time& time);
builtin_interfaces::msg::Time timeOf(Stamp stamp);
Rigid3 poseOf(const geometry_msgs::msg::Pose& pose);
Transform transformOf(const geometry_msgs::msg::TransformStamped& message);
Calibration calibrationOf(const sensor_msgs::msg::CameraInfo& message);
/// All but the header.
void fill(sensor_msgs::msg::CameraInfo& message, const Calibration& calibration);
GivenValue givenValue(const rclcpp::ParameterValue& value);

Stamp stampOf(const builtin_interfaces::msg::Time& time) {
    return Stamp(kNanosecondsOfSecond * time.sec + time.nanosec);
}

builtin_interfaces::msg::Time timeOf(Stamp stamp) {
    builtin_interfaces::msg::Time time;
    time.sec = static_cast<std::int32_t>(stamp.count() / kNanosecondsOfSecond);
    time.nanosec = static_cast<std::uint32_t>(stamp.count() % kNanosecondsOfSecond);
    return time;
}

Rigid3 poseOf(const geometry_msgs::msg::Pose& pose) {
    return rigidOf(pose.position, pose.orientation);
}

Transform transformOf(const geometry_msgs::msg::TransformStamped& message) {
    return transformIn(message, stampOf(message.header.stamp));
}

Calibration calibrationOf(const sensor_msgs::msg::CameraInfo& message) {
    return calibrationIn(message, message.d, message.k);
}

void fill(sensor_msgs::msg::CameraInfo& message, const Calibration& calibration) {
    fillCalibration(message, message.d, message.k, message.r, message.p, calibration);
}

GivenValue givenValue(const rclcpp::ParameterValue& value) {
    switch (value.get_type()) {
    case rclcpp::ParameterType::PARAMETER_BOOL:
        return value.get<bool>();
    case rclcpp::ParameterType::PARAMETER_INTEGER:
        return value.get<std::int64_t>();
    case rclcpp::ParameterType::PARAMETER_DOUBLE:
        return value.get<double>();
    case rclcpp::ParameterType::PARAMETER_STRING:
        return value.get<std::string>();
    case rclcpp::ParameterType::PARAMETER_INTEGER_ARRAY:
        return value.get<std::vector<std::int64_t>>();
    default:
        return {};
    }
}

/// Carries messages of ROS 2, as of Humble, to a CameraNode and back.
class RclcppNode : public rclcpp::Node {
  public:
    /// Errors: those of CameraNode and assign().
    RclcppNode();

  private:
    using SetCameraInfo = sensor_msgs::srv::SetCameraInfo;

    NodeOptions readParameters();
    void subscribePoses();
    void subscribe(OverlayTopic topic);
    void publish(const PublishedFrame& frame);
    bool hasListeners() const;
    void publishDiagnostics();
    void setCamera(const SetCameraInfo::Request& request, SetCameraInfo::Response& response);

    rclcpp::Publisher<sensor_msgs::msg::Image>::SharedPtr m_images;
    rclcpp::Publisher<sensor_msgs::msg::CameraInfo>::SharedPtr m_infos;
    rclcpp::Publisher<sensor_msgs::msg::Image>::SharedPtr m_depths; ///< null unless depth is wanted
    rclcpp::Publisher<sensor_msgs::msg::CameraInfo>::SharedPtr m_depthInfos;
    rclcpp::Publisher<sensor_msgs::msg::Image>::SharedPtr m_labels; ///< null without an overlay
    rclcpp::Publisher<diagnostic_msgs::msg::DiagnosticArray>::SharedPtr m_diagnostics;
    std::unique_ptr<CameraNode> m_node;
    std::vector<rclcpp::SubscriptionBase::SharedPtr>
        m_subscriptions; ///< last: their callbacks use the others
    rclcpp::Service<SetCameraInfo>::SharedPtr m_service;
    std::vector<rclcpp::TimerBase::SharedPtr> m_timers;
};

constexpr std::size_t kTransformQueue = 100; ///< as tf2_ros has it

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
    if (const std::string depth = m_node->depthTopic(); !depth.empty()) {
        m_depths = create_publisher<sensor_msgs::msg::Image>(depth, rclcpp::QoS(2));
        m_depthInfos =
            create_publisher<sensor_msgs::msg::CameraInfo>("camera/depth/camera_info", rclcpp::QoS(2));
    }
    if (const std::string labels = m_node->labelsTopic(); !labels.empty()) {
        m_labels = create_publisher<sensor_msgs::msg::Image>(labels, rclcpp::QoS(2));
    }
    subscribePoses();
    for (const OverlayTopic topic : m_node->overlayTopics()) {
        subscribe(topic);
    }
    m_service = create_service<SetCameraInfo>(
        "camera/set_camera_info",
        [this](const SetCameraInfo::Request::SharedPtr request,
               const SetCameraInfo::Response::SharedPtr response) { setCamera(*request, *response); });
    m_timers.push_back(create_wall_timer(std::chrono::milliseconds(10), [this] {
        m_node->setListening(hasListeners());
        m_node->takeTime(Stamp(get_clock()->now().nanoseconds()));
    }));
    m_timers.push_back(create_wall_timer(std::chrono::seconds(1), [this] { publishDiagnostics(); }));
}

NodeOptions RclcppNode::readParameters() {
    NodeOptions options;
    visitParameters(options, [this](const char* name, const char* description, auto& value) {
        rcl_interfaces::msg::ParameterDescriptor descriptor;
        descriptor.description = description;
        descriptor.read_only = true;
        descriptor.dynamic_typing = true; // people write rate:=15
        const rclcpp::ParameterValue given =
            declare_parameter(name, rclcpp::ParameterValue(value), descriptor);
        assign(name, givenValue(given), value);
    });
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

bool RclcppNode::hasListeners() const {
    return m_images->get_subscription_count() > 0 || m_infos->get_subscription_count() > 0 ||
           (m_depths &&
            (m_depths->get_subscription_count() > 0 || m_depthInfos->get_subscription_count() > 0)) ||
           (m_labels && m_labels->get_subscription_count() > 0);
}

void RclcppNode::publish(const PublishedFrame& frame) {
    auto info = std::make_unique<sensor_msgs::msg::CameraInfo>();
    info->header.stamp = timeOf(frame.stamp);
    info->header.frame_id = m_node->options().cameraFrame;
    fill(*info, frame.calibration);
    auto image = std::make_unique<sensor_msgs::msg::Image>();
    image->header = info->header;
    fillImage(*image, frame.image);
    if (m_depths && frame.depth.bytes != nullptr) {
        auto depth = std::make_unique<sensor_msgs::msg::Image>();
        depth->header = info->header;
        fillImage(*depth, frame.depth);
        m_depthInfos->publish(*info);
        m_depths->publish(std::move(depth));
    }
    if (m_labels && frame.labels.bytes != nullptr) {
        auto labels = std::make_unique<sensor_msgs::msg::Image>();
        labels->header = info->header;
        fillImage(*labels, frame.labels);
        m_labels->publish(std::move(labels));
    }
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

} // namespace

} // namespace spherewalk::ros

int main(int argc, char** argv) {
    int status = 0;
    try {
        rclcpp::init(argc, argv);
        rclcpp::spin(std::make_shared<spherewalk::ros::RclcppNode>());
    } catch (const std::exception& error) { // ours with its sentence, or one of rclcpp's
        RCLCPP_FATAL(rclcpp::get_logger("spherewalk"), "%s", error.what());
        status = 1;
    }
    rclcpp::shutdown();
    return status;
}
