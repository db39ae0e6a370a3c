// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "camera/camera_node.h"

#include <diagnostic_msgs/msg/diagnostic_array.hpp>
#include <geometry_msgs/msg/pose_stamped.hpp>
#include <memory>
#include <rclcpp/rclcpp.hpp>
#include <sensor_msgs/msg/camera_info.hpp>
#include <sensor_msgs/msg/image.hpp>
#include <sensor_msgs/srv/set_camera_info.hpp>
#include <tf2_msgs/msg/tf_message.hpp>
#include <vector>

namespace spherewalk::ros {

/// Carries messages of ROS 2, as of Humble, to a CameraNode and back.
class RclcppNode : public rclcpp::Node {
  public:
    /// Errors: those of CameraNode; rclcpp's for parameters of another type.
    RclcppNode();

  private:
    using SetCameraInfo = sensor_msgs::srv::SetCameraInfo;

    NodeOptions readParameters();
    void subscribePoses();
    void subscribe(OverlayTopic topic);
    void publish(const PublishedFrame& frame);
    void publishDiagnostics();
    void setCamera(const SetCameraInfo::Request& request, SetCameraInfo::Response& response);

    rclcpp::Publisher<sensor_msgs::msg::Image>::SharedPtr m_images;
    rclcpp::Publisher<sensor_msgs::msg::CameraInfo>::SharedPtr m_infos;
    rclcpp::Publisher<diagnostic_msgs::msg::DiagnosticArray>::SharedPtr m_diagnostics;
    std::unique_ptr<CameraNode> m_node;
    std::vector<rclcpp::SubscriptionBase::SharedPtr>
        m_subscriptions; ///< last: their callbacks use the others
    rclcpp::Service<SetCameraInfo>::SharedPtr m_service;
    std::vector<rclcpp::TimerBase::SharedPtr> m_timers;
};

} // namespace spherewalk::ros
