// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "camera/message_fields.h"

#include <builtin_interfaces/msg/time.hpp>
#include <geometry_msgs/msg/pose.hpp>
#include <geometry_msgs/msg/transform_stamped.hpp>
#include <sensor_msgs/msg/camera_info.hpp>

namespace spherewalk::ros {

/// Between ROS 2's messages and what the node works with.

Stamp stampOf(const builtin_interfaces::msg::Time& time);
builtin_interfaces::msg::Time timeOf(Stamp stamp);
Rigid3 poseOf(const geometry_msgs::msg::Pose& pose);
Transform transformOf(const geometry_msgs::msg::TransformStamped& message);
Calibration calibrationOf(const sensor_msgs::msg::CameraInfo& message);
/// All but the header.
void fill(sensor_msgs::msg::CameraInfo& message, const Calibration& calibration);

} // namespace spherewalk::ros
