// SPDX-License-Identifier: GPL-3.0-or-later
// A robot's camera as a node of ROS 2; resources/docs/guide/ros.md says how it is used.
#include "camera/camera_node.h"
#include "camera/message_fields.h"
#include "camera/node_parameters.h"

#include <algorithm>
#include <builtin_interfaces/msg/time.hpp>
#include <chrono>
#include <cstddef>
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
#if __has_include(<vision_msgs/msg/detection2_d_array.hpp>)
#include <vision_msgs/msg/detection2_d_array.hpp>
#define SPHEREWALK_VISION_MSGS
#endif

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

/// Pictures that are kept for reliable subscribers. Of two, busy subscribers lost those that were sent last.
constexpr std::size_t kPictureQueue = 32;

/// Publishes boxes; where the program was built without vision_msgs, it does nothing.
class DetectionsPublisher {
  public:
#ifdef SPHEREWALK_VISION_MSGS
    void advertise(rclcpp::Node& node, const std::string& topic) {
        m_publisher =
            node.create_publisher<vision_msgs::msg::Detection2DArray>(topic, rclcpp::QoS(kPictureQueue));
    }

    bool isHeard() const {
        return m_publisher && m_publisher->get_subscription_count() > 0;
    }

    /// header: that of the picture.
    template <class Header>
    void publish(const Header& header, const std::vector<Detection>& detections) const {
        auto message = std::make_unique<vision_msgs::msg::Detection2DArray>();
        message->header = header;
        fillDetections(*message, detections);
        m_publisher->publish(std::move(message));
    }

  private:
    rclcpp::Publisher<vision_msgs::msg::Detection2DArray>::SharedPtr m_publisher; ///< null until advertised
#else
    void advertise(rclcpp::Node& /*node*/, const std::string& /*topic*/) {
    }

    bool isHeard() const {
        return false;
    }

    template <class Header>
    void publish(const Header& /*header*/, const std::vector<Detection>& /*detections*/) const {
    }
#endif
};

/// Carries messages of ROS 2, as of Humble, to a CameraNode and back.
class RclcppNode : public rclcpp::Node {
  public:
    /// Errors: those of CameraNode and assign().
    RclcppNode();

  private:
    using SetCameraInfo = sensor_msgs::srv::SetCameraInfo;

    /// Publishers of one camera; null for what is not wanted.
    struct Publishers {
        rclcpp::Publisher<sensor_msgs::msg::Image>::SharedPtr images;
        rclcpp::Publisher<sensor_msgs::msg::CameraInfo>::SharedPtr infos;
        rclcpp::Publisher<sensor_msgs::msg::Image>::SharedPtr depths;
        rclcpp::Publisher<sensor_msgs::msg::CameraInfo>::SharedPtr depthInfos;
        rclcpp::Publisher<sensor_msgs::msg::Image>::SharedPtr labels;
        DetectionsPublisher detections;
    };

    NodeOptions readParameters();
    void advertise(const PublishedCamera& camera);
    void subscribePoses();
    void subscribe(OverlayTopic topic, std::size_t camera);
    /// Errors: Network, in place of rclcpp's own exceptions, which the camera's thread does not take.
    void publish(const PublishedFrame& frame);
    void publishPictures(const PublishedFrame& frame);
    bool hasListeners() const;
    void publishDiagnostics();

    std::vector<Publishers> m_publishers; ///< one a camera
    rclcpp::Publisher<diagnostic_msgs::msg::DiagnosticArray>::SharedPtr m_diagnostics;
    std::unique_ptr<CameraNode> m_node;
    std::vector<rclcpp::SubscriptionBase::SharedPtr>
        m_subscriptions; ///< last: their callbacks use the others
    std::vector<rclcpp::Service<SetCameraInfo>::SharedPtr> m_services; ///< one a camera
    std::vector<rclcpp::TimerBase::SharedPtr> m_timers;
};

constexpr std::size_t kTransformQueue = 100; ///< as tf2_ros has it

RclcppNode::RclcppNode() : rclcpp::Node("spherewalk") {
    m_diagnostics = create_publisher<diagnostic_msgs::msg::DiagnosticArray>("/diagnostics", rclcpp::QoS(10));
    m_node = std::make_unique<CameraNode>(
        readParameters(), [this](const PublishedFrame& frame) { publish(frame); },
        [logger = get_logger()](const std::string& sentence) {
            RCLCPP_WARN(logger, "%s", sentence.c_str());
        });
    for (const PublishedCamera& camera : m_node->cameras()) {
        advertise(camera);
    }
    subscribePoses();
    for (std::size_t camera = 0; camera < m_publishers.size(); ++camera) {
        for (const OverlayTopic topic : m_node->overlayTopics()) {
            subscribe(topic, camera);
        }
    }
    m_timers.push_back(create_wall_timer(std::chrono::milliseconds(10), [this] {
        m_node->setListening(hasListeners());
        m_node->takeTime(Stamp(get_clock()->now().nanoseconds()));
    }));
    m_timers.push_back(create_wall_timer(std::chrono::seconds(1), [this] { publishDiagnostics(); }));
}

void RclcppNode::advertise(const PublishedCamera& camera) {
    // Offered reliably, which suits subscribers of both kinds.
    using sensor_msgs::msg::CameraInfo;
    using sensor_msgs::msg::Image;
    const std::size_t index = m_publishers.size();
    Publishers publishers;
    publishers.images = create_publisher<Image>(camera.name + "/image_raw", rclcpp::QoS(kPictureQueue));
    publishers.infos = create_publisher<CameraInfo>(camera.name + "/camera_info", rclcpp::QoS(kPictureQueue));
    if (!camera.depthTopic.empty()) {
        publishers.depths = create_publisher<Image>(camera.depthTopic, rclcpp::QoS(kPictureQueue));
        publishers.depthInfos =
            create_publisher<CameraInfo>(camera.name + "/depth/camera_info", rclcpp::QoS(kPictureQueue));
    }
    if (!camera.labelsTopic.empty()) {
        publishers.labels = create_publisher<Image>(camera.labelsTopic, rclcpp::QoS(kPictureQueue));
        publishers.detections.advertise(*this, camera.detectionsTopic);
    }
    m_publishers.push_back(publishers);
    m_services.push_back(create_service<SetCameraInfo>(
        camera.name + "/set_camera_info", [this, index](const SetCameraInfo::Request::SharedPtr request,
                                                        const SetCameraInfo::Response::SharedPtr response) {
            answerSetCamera(*m_node, calibrationOf(request->camera_info), index, *response);
        }));
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

void RclcppNode::subscribe(OverlayTopic topic, std::size_t camera) {
    rclcpp::SubscriptionOptions options; // a simulator that publishes reliably need not lose pictures
    options.qos_overriding_options = rclcpp::QosOverridingOptions::with_default_policies();
    m_subscriptions.push_back(create_subscription<sensor_msgs::msg::Image>(
        m_node->overlayTopic(topic, camera), rclcpp::SensorDataQoS(),
        [this, topic, camera](const sensor_msgs::msg::Image::ConstSharedPtr message) {
            m_node->takeOverlay(topic, stampOf(message->header.stamp), pictureOf(*message), camera);
        },
        options));
}

bool RclcppNode::hasListeners() const {
    const auto is = [](const auto& publisher) {
        return publisher && publisher->get_subscription_count() > 0;
    };
    return std::any_of(m_publishers.begin(), m_publishers.end(), [&is](const Publishers& of) {
        return is(of.images) || is(of.infos) || is(of.depths) || is(of.depthInfos) || is(of.labels) ||
               of.detections.isHeard();
    });
}

void RclcppNode::publish(const PublishedFrame& frame) {
    try {
        publishPictures(frame);
    } catch (const rclcpp::exceptions::RCLErrorBase& error) {
        throw Error(ErrorKind::Network, "A frame could not be published: " + error.formatted_message);
    }
}

void RclcppNode::publishPictures(const PublishedFrame& frame) {
    auto info = std::make_unique<sensor_msgs::msg::CameraInfo>();
    info->header.stamp = timeOf(frame.stamp);
    info->header.frame_id = m_node->cameras()[frame.camera].frameId;
    const Publishers& publishers = m_publishers[frame.camera];
    fill(*info, frame.calibration);
    auto image = std::make_unique<sensor_msgs::msg::Image>();
    image->header = info->header;
    fillImage(*image, frame.image);
    if (publishers.depths && frame.depth.bytes != nullptr) {
        auto depth = std::make_unique<sensor_msgs::msg::Image>();
        depth->header = info->header;
        fillImage(*depth, frame.depth);
        publishers.depthInfos->publish(*info);
        publishers.depths->publish(std::move(depth));
    }
    if (publishers.labels && frame.labels.bytes != nullptr) {
        auto labels = std::make_unique<sensor_msgs::msg::Image>();
        labels->header = info->header;
        fillImage(*labels, frame.labels);
        publishers.labels->publish(std::move(labels));
        publishers.detections.publish(info->header, frame.detections);
    }
    publishers.infos->publish(std::move(info));
    publishers.images->publish(std::move(image));
}

void RclcppNode::publishDiagnostics() {
    diagnostic_msgs::msg::DiagnosticArray message;
    message.header.stamp = get_clock()->now();
    message.status.push_back(
        statusOf<diagnostic_msgs::msg::DiagnosticStatus>(m_node->diagnostics(), get_fully_qualified_name()));
    m_diagnostics->publish(message);
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
