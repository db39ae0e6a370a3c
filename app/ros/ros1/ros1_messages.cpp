// SPDX-License-Identifier: GPL-3.0-or-later
#include "ros1_messages.h"

namespace spherewalk::ros {

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

} // namespace spherewalk::ros
