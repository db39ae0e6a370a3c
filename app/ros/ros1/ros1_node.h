// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "camera/camera_node.h"

#include <diagnostic_msgs/DiagnosticArray.h>
#include <geometry_msgs/PoseStamped.h>
#include <image_transport/image_transport.h>
#include <memory>
#include <ros/ros.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/SetCameraInfo.h>
#include <string>
#include <tf2_msgs/TFMessage.h>
#include <vector>

namespace spherewalk::ros {

/// The parameters of a private name space. Errors: InvalidInput, naming the parameter, for one of another
/// type than it should have.
NodeOptions readParameters(const ::ros::NodeHandle& handle);

/// Carries ROS 1's messages to a CameraNode and back.
class Ros1Node {
  public:
    /// handle: of the name space that topics are relative to. Errors: those of CameraNode.
    Ros1Node(const ::ros::NodeHandle& handle, const NodeOptions& options);

  private:
    void subscribe(OverlayTopic topic);
    void listen();
    void publish(const PublishedFrame& frame);
    void publishDiagnostics();
    bool setCamera(sensor_msgs::SetCameraInfo::Request& request,
                   sensor_msgs::SetCameraInfo::Response& response);
    void takeTransforms(const tf2_msgs::TFMessage& message, bool isStatic);

    ::ros::NodeHandle m_handle;
    image_transport::ImageTransport m_transport;
    image_transport::CameraPublisher m_publisher;
    ::ros::Publisher m_diagnostics;
    sensor_msgs::Image m_image;     ///< of the rendering thread
    sensor_msgs::CameraInfo m_info; ///< of the rendering thread
    CameraNode m_node;
    std::vector<::ros::Subscriber> m_subscribers; ///< last: their callbacks use the others
    ::ros::ServiceServer m_service;
    ::ros::Timer m_clock;         ///< of ROS's time
    ::ros::WallTimer m_listening; ///< who comes and goes without a callback: remote subscribers that die
    ::ros::WallTimer m_diagnosing;
};

} // namespace spherewalk::ros
