// SPDX-License-Identifier: GPL-3.0-or-later
// A robot's camera as a node of ROS 1; resources/docs/guide/ros.md says how it is used.
#include "camera/camera_node.h"
#include "camera/message_fields.h"
#include "camera/node_parameters.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <cstddef>
#include <diagnostic_msgs/DiagnosticArray.h>
#include <geometry_msgs/Pose.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/TransformStamped.h>
#include <image_transport/image_transport.h>
#include <memory>
#include <ros/ros.h>
#include <ros/time.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/SetCameraInfo.h>
#include <string>
#include <tf2_msgs/TFMessage.h>
#include <vector>

namespace spherewalk::ros {

namespace {

/// Between ROS 1's messages and what the node works with.

Stamp stampOf(const ::ros::Time& time);
::ros::Time rosTime(Stamp stamp);
Rigid3 poseOf(const geometry_msgs::Pose& pose);
Transform transformOf(const geometry_msgs::TransformStamped& message);
Calibration calibrationOf(const sensor_msgs::CameraInfo& message);
/// All but the header.
void fill(sensor_msgs::CameraInfo& message, const Calibration& calibration);

Stamp stampOf(const ::ros::Time& time) {
    return Stamp(kNanosecondsOfSecond * time.sec + time.nsec);
}

::ros::Time rosTime(Stamp stamp) {
    return {static_cast<std::uint32_t>(stamp.count() / kNanosecondsOfSecond),
            static_cast<std::uint32_t>(stamp.count() % kNanosecondsOfSecond)};
}

Rigid3 poseOf(const geometry_msgs::Pose& pose) {
    return rigidOf(pose.position, pose.orientation);
}

Transform transformOf(const geometry_msgs::TransformStamped& message) {
    return transformIn(message, stampOf(message.header.stamp));
}

Calibration calibrationOf(const sensor_msgs::CameraInfo& message) {
    return calibrationIn(message, message.D, message.K);
}

void fill(sensor_msgs::CameraInfo& message, const Calibration& calibration) {
    fillCalibration(message, message.D, message.K, message.R, message.P, calibration);
}

/// The parameters of a private name space. Errors: InvalidInput, naming the parameter, for one of another
/// type than it should have.
NodeOptions readParameters(const ::ros::NodeHandle& handle);

/// Carries ROS 1's messages to a CameraNode and back.
class Ros1Node {
  public:
    /// handle: of the name space that topics are relative to. Errors: those of CameraNode.
    Ros1Node(const ::ros::NodeHandle& handle, const NodeOptions& options);

  private:
    /// Publishers of one camera.
    struct Publishers {
        image_transport::CameraPublisher images;
        image_transport::CameraPublisher depths; ///< unless no depth is wanted
        ::ros::Publisher labels; ///< Unless there is no overlay. No transport that may lose pixels.
    };

    void advertise(const PublishedCamera& camera);
    void subscribe(OverlayTopic topic, std::size_t camera);
    void listen();
    void publish(const PublishedFrame& frame);
    void publishDiagnostics();
    void takeTransforms(const tf2_msgs::TFMessage& message, bool isStatic);

    ::ros::NodeHandle m_handle;
    image_transport::ImageTransport m_transport;
    std::vector<Publishers> m_publishers; ///< one a camera
    ::ros::Publisher m_diagnostics;
    sensor_msgs::Image m_image;     ///< of the rendering thread
    sensor_msgs::CameraInfo m_info; ///< of the rendering thread
    CameraNode m_node;
    std::vector<::ros::Subscriber> m_subscribers; ///< last: their callbacks use the others
    std::vector<::ros::ServiceServer> m_services; ///< one a camera
    ::ros::Timer m_clock;                         ///< of ROS's time
    ::ros::WallTimer m_listening; ///< who comes and goes without a callback: remote subscribers that die
    ::ros::WallTimer m_diagnosing;
};

/// Leaves the value as it is where there is no such parameter.
template <class Value>
void read(const ::ros::NodeHandle& handle, const std::string& name, Value& value) {
    if (handle.hasParam(name) && !handle.getParam(name, value)) {
        throw Error(ErrorKind::InvalidInput, text("The parameter ", handle.resolveName(name),
                                                  " is of another type than it should be."));
    }
}

NodeOptions readParameters(const ::ros::NodeHandle& handle) {
    NodeOptions options;
    visitParameters(options, [&](const char* name, const char*, auto& value) { read(handle, name, value); });
    return options;
}

constexpr std::uint32_t kTransformQueue = 100; ///< as tf2_ros has it
constexpr std::uint32_t kPictureQueue = 5;

/// Frames that wait to be sent; where every one counts there is no limit.
std::uint32_t frameQueue(const NodeOptions& options) {
    return options.pace == "every" ? 0 : 2;
}

Ros1Node::Ros1Node(const ::ros::NodeHandle& handle, const NodeOptions& options)
    : m_handle(handle),
      m_transport(handle),
      m_node(
          options, [this](const PublishedFrame& frame) { publish(frame); },
          [](const std::string& sentence) { ROS_WARN("%s", sentence.c_str()); }) {
    m_publishers.reserve(m_node.cameras().size());
    for (const PublishedCamera& camera : m_node.cameras()) {
        advertise(camera);
    }
    m_diagnostics = m_handle.advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", 10);
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
    for (std::size_t camera = 0; camera < m_publishers.size(); ++camera) {
        for (const OverlayTopic topic : m_node.overlayTopics()) {
            subscribe(topic, camera);
        }
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

void Ros1Node::advertise(const PublishedCamera& camera) {
    using SetCameraInfo = sensor_msgs::SetCameraInfo;
    const std::uint32_t queue = frameQueue(m_node.options());
    const auto changed = [this](const auto&) { listen(); };
    const std::size_t index = m_publishers.size();
    Publishers publishers;
    publishers.images =
        m_transport.advertiseCamera(camera.name + "/image_raw", queue, changed, changed, changed, changed);
    if (!camera.depthTopic.empty()) {
        publishers.depths =
            m_transport.advertiseCamera(camera.depthTopic, queue, changed, changed, changed, changed);
    }
    if (!camera.labelsTopic.empty()) {
        publishers.labels =
            m_handle.advertise<sensor_msgs::Image>(camera.labelsTopic, queue, changed, changed);
    }
    m_publishers.push_back(publishers);
    const ::ros::ServiceServer service =
        m_handle.advertiseService<SetCameraInfo::Request, SetCameraInfo::Response>(
            camera.name + "/set_camera_info",
            [this, index](SetCameraInfo::Request& request, SetCameraInfo::Response& response) {
                answerSetCamera(m_node, calibrationOf(request.camera_info), index, response);
                return true; // it was answered
            });
    m_services.push_back(service);
}

void Ros1Node::subscribe(OverlayTopic topic, std::size_t camera) {
    m_subscribers.push_back(m_handle.subscribe<sensor_msgs::Image>(
        m_node.overlayTopic(topic, camera), kPictureQueue,
        [this, topic, camera](const sensor_msgs::Image::ConstPtr& message) {
            m_node.takeOverlay(topic, stampOf(message->header.stamp), pictureOf(*message), camera);
        },
        {}, ::ros::TransportHints().tcpNoDelay()));
}

void Ros1Node::listen() {
    const auto isHeard = [](const Publishers& of) {
        return of.images.getNumSubscribers() > 0 || (of.depths && of.depths.getNumSubscribers() > 0) ||
               (of.labels && of.labels.getNumSubscribers() > 0);
    };
    m_node.setListening(std::any_of(m_publishers.begin(), m_publishers.end(), isHeard));
}

void Ros1Node::publish(const PublishedFrame& frame) {
    m_image.header.stamp = rosTime(frame.stamp);
    m_image.header.frame_id = m_node.cameras()[frame.camera].frameId;
    const Publishers& publishers = m_publishers[frame.camera];
    fillImage(m_image, frame.image);
    fill(m_info, frame.calibration);
    m_info.header = m_image.header;
    publishers.images.publish(m_image, m_info);
    if (publishers.depths && frame.depth.bytes != nullptr) {
        fillImage(m_image, frame.depth);
        publishers.depths.publish(m_image, m_info);
    }
    if (publishers.labels && frame.labels.bytes != nullptr) {
        fillImage(m_image, frame.labels);
        publishers.labels.publish(m_image);
    }
}

void Ros1Node::publishDiagnostics() {
    diagnostic_msgs::DiagnosticArray message;
    message.header.stamp = ::ros::Time::now();
    message.status.push_back(
        statusOf<diagnostic_msgs::DiagnosticStatus>(m_node.diagnostics(), ::ros::this_node::getName()));
    m_diagnostics.publish(message);
}

void Ros1Node::takeTransforms(const tf2_msgs::TFMessage& message, bool isStatic) {
    for (const geometry_msgs::TransformStamped& one : message.transforms) {
        m_node.takeTransform(transformOf(one), isStatic);
    }
}

} // namespace

} // namespace spherewalk::ros

int main(int argc, char** argv) {
    ros::init(argc, argv, "spherewalk");
    const ros::NodeHandle handle;
    try {
        spherewalk::ros::Ros1Node node(handle, spherewalk::ros::readParameters(ros::NodeHandle("~")));
        ROS_INFO("Ready; frames are rendered while somebody listens to %s.",
                 handle.resolveName("camera/image_raw").c_str());
        ros::AsyncSpinner spinner(2); // pictures of overlays do not hold up transforms
        spinner.start();
        ros::waitForShutdown();
    } catch (const spherewalk::Error& error) {
        ROS_FATAL("%s", error.sentence().c_str());
        return 1;
    }
    return 0;
}
