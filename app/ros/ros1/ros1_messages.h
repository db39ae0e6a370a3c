// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "camera/message_fields.h"

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/TransformStamped.h>
#include <ros/time.h>
#include <sensor_msgs/CameraInfo.h>

namespace spherewalk::ros {

/// Between ROS 1's messages and what the node works with.

Stamp stampOf(const ::ros::Time& time);
::ros::Time rosTime(Stamp stamp);
Rigid3 poseOf(const geometry_msgs::Pose& pose);
Transform transformOf(const geometry_msgs::TransformStamped& message);
Calibration calibrationOf(const sensor_msgs::CameraInfo& message);
/// All but the header.
void fill(sensor_msgs::CameraInfo& message, const Calibration& calibration);

} // namespace spherewalk::ros
