// SPDX-License-Identifier: GPL-3.0-or-later
#include "rclcpp_messages.h"

namespace spherewalk::ros {

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

} // namespace spherewalk::ros
