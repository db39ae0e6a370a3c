// SPDX-License-Identifier: GPL-3.0-or-later
#include "rclcpp_camera.h"

#include "camera/camera_node.h"
#include "camera/message_fields.h"
#include "camera/node_parameters.h"

#include <algorithm>
#include <builtin_interfaces/msg/time.hpp>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <diagnostic_msgs/msg/diagnostic_array.hpp>
#include <geometry_msgs/msg/pose.hpp>
#include <geometry_msgs/msg/pose_stamped.hpp>
#include <geometry_msgs/msg/transform_stamped.hpp>
#include <memory>
#include <rcl_interfaces/msg/parameter_descriptor.hpp>
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_components/register_node_macro.hpp>
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
#ifdef SPHEREWALK_IMAGE_TRANSPORT
#include <image_transport/exception.hpp>
#include <image_transport/image_transport.hpp>
#endif

namespace spherewalk::ros {

namespace {

// Between ROS 2's messages and what the node works with.

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

/// All but the header.
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

/// Offered reliably, which suits subscribers of both kinds; parameters (qos_overrides) say otherwise.
template <class Message>
typename rclcpp::Publisher<Message>::SharedPtr advertised(rclcpp::Node& node, const std::string& topic) {
    rclcpp::PublisherOptions options;
    options.qos_overriding_options = rclcpp::QosOverridingOptions::with_default_policies();
    return node.create_publisher<Message>(topic, rclcpp::QoS(kPictureQueue), options);
}

/// Publishes pictures, and beside them what the plugins of image_transport make of them.
class PicturesPublisher {
  public:
    void advertise(rclcpp::Node& node, const std::string& topic) {
        m_pictures = advertised<sensor_msgs::msg::Image>(node, topic);
#ifdef SPHEREWALK_IMAGE_TRANSPORT
        advertiseTransports(node, topic);
#endif
    }

    bool isHeard() const {
        return m_pictures && (m_pictures->get_subscription_count() > 0 || hasTransportListeners());
    }

    void publish(std::unique_ptr<sensor_msgs::msg::Image> picture) const {
        if (!hasTransportListeners()) {
            m_pictures->publish(std::move(picture)); // without a copy to subscribers in the same process
            return;
        }
        m_pictures->publish(*picture);
#ifdef SPHEREWALK_IMAGE_TRANSPORT
        m_transports.publish(*picture);
#endif
    }

  private:
#ifdef SPHEREWALK_IMAGE_TRANSPORT
    void advertiseTransports(rclcpp::Node& node, const std::string& topic);

    bool hasTransportListeners() const {
        return m_transports && m_transports.getNumSubscribers() > 0;
    }

    image_transport::Publisher m_transports; ///< of all but the pictures as they are
#else
    static bool hasTransportListeners() {
        return false;
    }
#endif
    rclcpp::Publisher<sensor_msgs::msg::Image>::SharedPtr m_pictures; ///< null until advertised
};

#ifdef SPHEREWALK_IMAGE_TRANSPORT
void PicturesPublisher::advertiseTransports(rclcpp::Node& node, const std::string& topic) {
    const auto withoutRaw = [](std::vector<std::string> transports) {
        transports.erase(std::remove(transports.begin(), transports.end(), "image_transport/raw"),
                         transports.end());
        return transports;
    };
    // image_transport reads this parameter, and would give the pictures themselves a second time.
    std::string parameter = topic + "/enable_pub_plugins";
    std::replace(parameter.begin(), parameter.end(), '/', '.');
    rcl_interfaces::msg::ParameterDescriptor descriptor;
    descriptor.description = "Transports in which pictures are offered besides " + topic;
    const std::vector<std::string> transports = withoutRaw(
        node.declare_parameter(parameter, withoutRaw(image_transport::getDeclaredTransports()), descriptor));
    node.set_parameter(rclcpp::Parameter(parameter, transports));
    if (transports.empty()) {
        return;
    }
    try {
        m_transports =
            image_transport::create_publisher(&node, topic, rclcpp::QoS(kPictureQueue).get_rmw_qos_profile());
    } catch (const image_transport::Exception&) {
        RCLCPP_WARN(node.get_logger(), "No transport of %s can be loaded; it is offered as it is.",
                    topic.c_str());
    }
}
#endif

/// Publishes boxes; where the program was built without vision_msgs, it does nothing.
class DetectionsPublisher {
  public:
#ifdef SPHEREWALK_VISION_MSGS
    void advertise(rclcpp::Node& node, const std::string& topic) {
        m_publisher = advertised<vision_msgs::msg::Detection2DArray>(node, topic);
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
class Camera : public rclcpp::Node {
  public:
    /// Errors: those of CameraNode and assign().
    explicit Camera(const rclcpp::NodeOptions& options);

  private:
    using SetCameraInfo = sensor_msgs::srv::SetCameraInfo;

    /// Publishers of one camera; null or not advertised for what is not wanted.
    struct Publishers {
        PicturesPublisher images;
        rclcpp::Publisher<sensor_msgs::msg::CameraInfo>::SharedPtr infos;
        PicturesPublisher depths;
        rclcpp::Publisher<sensor_msgs::msg::CameraInfo>::SharedPtr depthInfos;
        /// No transport that may lose pixels.
        rclcpp::Publisher<sensor_msgs::msg::Image>::SharedPtr labels;
        DetectionsPublisher detections;
    };

    /// Pictures of objects. They are asked for reliably if all who publish them offer so, unless a parameter
    /// (qos_overrides) says how.
    struct Overlay {
        OverlayTopic topic = OverlayTopic::Colour;
        std::size_t camera = 0;
        bool isReliable = false;
        rclcpp::SubscriptionBase::SharedPtr subscription;
        rclcpp::SubscriptionBase::SharedPtr next; ///< until it hears all who publish; else null
    };

    NodeOptions readParameters();
    void advertise(const PublishedCamera& camera);
    void subscribePoses();
    rclcpp::SubscriptionBase::SharedPtr subscribed(const Overlay& overlay);
    void followOffers(Overlay& overlay);
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
    std::vector<Overlay> m_overlays;
    std::vector<rclcpp::Service<SetCameraInfo>::SharedPtr> m_services; ///< one a camera
    std::vector<rclcpp::TimerBase::SharedPtr> m_timers;
};

constexpr std::size_t kTransformQueue = 100; ///< as tf2_ros has it

bool isReliabilityGiven(rclcpp::Node& node, const std::string& topic) {
    const std::string resolved = node.get_node_topics_interface()->resolve_topic_name(topic);
    return node.get_node_parameters_interface()->get_parameter_overrides().count(
               "qos_overrides." + resolved + ".subscription.reliability") > 0;
}

Camera::Camera(const rclcpp::NodeOptions& options) : rclcpp::Node("spherewalk", options) {
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
            m_overlays.push_back({topic, camera, false, nullptr, nullptr});
            m_overlays.back().subscription = subscribed(m_overlays.back());
        }
    }
    m_timers.push_back(create_wall_timer(std::chrono::milliseconds(10), [this] {
        m_node->setListening(hasListeners());
        m_node->takeTime(Stamp(get_clock()->now().nanoseconds()));
    }));
    m_timers.push_back(create_wall_timer(std::chrono::seconds(1), [this] {
        publishDiagnostics();
        std::for_each(m_overlays.begin(), m_overlays.end(),
                      [this](Overlay& overlay) { followOffers(overlay); });
    }));
    RCLCPP_INFO(get_logger(), "Ready; frames are rendered while somebody listens.");
}

void Camera::advertise(const PublishedCamera& camera) {
    using sensor_msgs::msg::CameraInfo;
    const std::size_t index = m_publishers.size();
    Publishers publishers;
    publishers.images.advertise(*this, camera.name + "/image_raw");
    publishers.infos = advertised<CameraInfo>(*this, camera.name + "/camera_info");
    if (!camera.depthTopic.empty()) {
        publishers.depths.advertise(*this, camera.depthTopic);
        publishers.depthInfos = advertised<CameraInfo>(*this, camera.name + "/depth/camera_info");
    }
    if (!camera.labelsTopic.empty()) {
        publishers.labels = advertised<sensor_msgs::msg::Image>(*this, camera.labelsTopic);
        publishers.detections.advertise(*this, camera.detectionsTopic);
    }
    m_publishers.push_back(publishers);
    m_services.push_back(create_service<SetCameraInfo>(
        camera.name + "/set_camera_info", [this, index](const SetCameraInfo::Request::SharedPtr request,
                                                        const SetCameraInfo::Response::SharedPtr response) {
            answerSetCamera(*m_node, calibrationOf(request->camera_info), index, *response);
        }));
}

NodeOptions Camera::readParameters() {
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

void Camera::subscribePoses() {
    const auto transforms = [this](const char* topic, const rclcpp::QoS& quality, bool isStatic) {
        rclcpp::SubscriptionOptions options;
        if (isStatic) { // rclcpp keeps nothing for those who come late within a process
            options.use_intra_process_comm = rclcpp::IntraProcessSetting::Disable;
        }
        m_subscriptions.push_back(create_subscription<tf2_msgs::msg::TFMessage>(
            topic, quality,
            [this, isStatic](const tf2_msgs::msg::TFMessage::ConstSharedPtr message) {
                for (const geometry_msgs::msg::TransformStamped& one : message->transforms) {
                    m_node->takeTransform(transformOf(one), isStatic);
                }
            },
            options));
    };
    transforms("/tf_static", rclcpp::QoS(kTransformQueue).transient_local(), true);
    transforms("/tf", rclcpp::QoS(kTransformQueue), false);
    m_subscriptions.push_back(create_subscription<geometry_msgs::msg::PoseStamped>(
        "camera/pose", rclcpp::SensorDataQoS(),
        [this](const geometry_msgs::msg::PoseStamped::ConstSharedPtr message) {
            m_node->takePose(message->header.frame_id, stampOf(message->header.stamp), poseOf(message->pose));
        }));
}

rclcpp::SubscriptionBase::SharedPtr Camera::subscribed(const Overlay& overlay) {
    const std::string topic = m_node->overlayTopic(overlay.topic, overlay.camera);
    rclcpp::SubscriptionOptions options;
    options.qos_overriding_options = rclcpp::QosOverridingOptions::with_default_policies();
    rclcpp::QoS quality = rclcpp::SensorDataQoS();
    if (!isReliabilityGiven(*this, topic)) {
        options.qos_overriding_options = {rclcpp::QosPolicyKind::History, rclcpp::QosPolicyKind::Depth};
        quality.reliability(overlay.isReliable ? rclcpp::ReliabilityPolicy::Reliable
                                               : rclcpp::ReliabilityPolicy::BestEffort);
    }
    return create_subscription<sensor_msgs::msg::Image>(
        topic, quality,
        [this, part = overlay.topic,
         camera = overlay.camera](const sensor_msgs::msg::Image::ConstSharedPtr message) {
            m_node->takeOverlay(part, stampOf(message->header.stamp), pictureOf(*message), camera);
        },
        options);
}

void Camera::followOffers(Overlay& overlay) {
    const auto offers = get_publishers_info_by_topic(overlay.subscription->get_topic_name());
    const bool areReliable = std::all_of(offers.begin(), offers.end(), [](const auto& offer) {
        return offer.qos_profile().reliability() == rclcpp::ReliabilityPolicy::Reliable;
    });
    const bool isGiven = isReliabilityGiven(*this, overlay.subscription->get_topic_name());
    if (overlay.next && overlay.next->get_publisher_count() >= offers.size()) {
        overlay.subscription = std::move(overlay.next);
    } else if (!overlay.next && !isGiven && !offers.empty() && areReliable != overlay.isReliable) {
        overlay.isReliable = areReliable;
        overlay.next = subscribed(overlay);
    }
}

bool Camera::hasListeners() const {
    const auto is = [](const auto& publisher) {
        return publisher && publisher->get_subscription_count() > 0;
    };
    return std::any_of(m_publishers.begin(), m_publishers.end(), [&is](const Publishers& of) {
        return of.images.isHeard() || is(of.infos) || of.depths.isHeard() || is(of.depthInfos) ||
               is(of.labels) || of.detections.isHeard();
    });
}

void Camera::publish(const PublishedFrame& frame) {
    try {
        publishPictures(frame);
    } catch (const rclcpp::exceptions::RCLErrorBase& error) {
        throw Error(ErrorKind::Network, "A frame could not be published: " + error.formatted_message);
    }
}

void Camera::publishPictures(const PublishedFrame& frame) {
    auto info = std::make_unique<sensor_msgs::msg::CameraInfo>();
    info->header.stamp = timeOf(frame.stamp);
    info->header.frame_id = m_node->cameras()[frame.camera].frameId;
    const Publishers& publishers = m_publishers[frame.camera];
    fill(*info, frame.calibration);
    auto image = std::make_unique<sensor_msgs::msg::Image>();
    image->header = info->header;
    fillImage(*image, frame.image);
    if (frame.depth.bytes != nullptr) { // of a camera with such topics
        auto depth = std::make_unique<sensor_msgs::msg::Image>();
        depth->header = info->header;
        fillImage(*depth, frame.depth);
        publishers.depthInfos->publish(*info);
        publishers.depths.publish(std::move(depth));
    }
    if (publishers.labels && frame.labels.bytes != nullptr) {
        auto labels = std::make_unique<sensor_msgs::msg::Image>();
        labels->header = info->header;
        fillImage(*labels, frame.labels);
        publishers.labels->publish(std::move(labels));
        publishers.detections.publish(info->header, frame.detections);
    }
    publishers.infos->publish(std::move(info));
    publishers.images.publish(std::move(image));
}

void Camera::publishDiagnostics() {
    diagnostic_msgs::msg::DiagnosticArray message;
    message.header.stamp = get_clock()->now();
    message.status.push_back(
        statusOf<diagnostic_msgs::msg::DiagnosticStatus>(m_node->diagnostics(), get_fully_qualified_name()));
    m_diagnostics->publish(message);
}

} // namespace

std::shared_ptr<rclcpp::Node> makeCamera(const rclcpp::NodeOptions& options) {
    return std::make_shared<Camera>(options);
}

} // namespace spherewalk::ros

RCLCPP_COMPONENTS_REGISTER_NODE(spherewalk::ros::Camera)
