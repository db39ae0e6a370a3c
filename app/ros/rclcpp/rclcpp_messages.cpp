// SPDX-License-Identifier: GPL-3.0-or-later
#include "rclcpp_messages.h"

#include <algorithm>

namespace spherewalk::ros {

namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

Rigid3 rigid(const auto& place, const auto& turn) {
    return {Eigen::Quaterniond(turn.w, turn.x, turn.y, turn.z), Eigen::Vector3d(place.x, place.y, place.z)};
}

} // namespace

Stamp stampOf(const builtin_interfaces::msg::Time& time) {
    return Stamp(kSecond * time.sec + time.nanosec);
}

builtin_interfaces::msg::Time timeOf(Stamp stamp) {
    builtin_interfaces::msg::Time time;
    time.sec = static_cast<std::int32_t>(stamp.count() / kSecond);
    time.nanosec = static_cast<std::uint32_t>(stamp.count() % kSecond);
    return time;
}

Rigid3 poseOf(const geometry_msgs::msg::Pose& pose) {
    return rigid(pose.position, pose.orientation);
}

Transform transformOf(const geometry_msgs::msg::TransformStamped& message) {
    return {message.header.frame_id, message.child_frame_id, stampOf(message.header.stamp),
            rigid(message.transform.translation, message.transform.rotation)};
}

Picture pictureOf(const sensor_msgs::msg::Image& message) {
    return {
        message.width,       message.height,     message.step, message.encoding, message.is_bigendian != 0,
        message.data.data(), message.data.size()};
}

Calibration calibrationOf(const sensor_msgs::msg::CameraInfo& message) {
    Calibration calibration;
    calibration.width = static_cast<int>(message.width);
    calibration.height = static_cast<int>(message.height);
    calibration.distortionModel = message.distortion_model;
    calibration.d = message.d;
    std::copy(message.k.begin(), message.k.end(), calibration.k.begin());
    return calibration;
}

void fill(sensor_msgs::msg::Image& message, const PublishedFrame& frame) {
    message.width = static_cast<std::uint32_t>(frame.width);
    message.height = static_cast<std::uint32_t>(frame.height);
    message.step = 3 * message.width;
    message.encoding = "rgb8";
    message.data.assign(frame.rgb, frame.rgb + std::size_t{message.step} * message.height);
}

void fill(sensor_msgs::msg::CameraInfo& message, const Calibration& calibration) {
    message.width = static_cast<std::uint32_t>(calibration.width);
    message.height = static_cast<std::uint32_t>(calibration.height);
    message.distortion_model = calibration.distortionModel;
    message.d = calibration.d;
    std::copy(calibration.k.begin(), calibration.k.end(), message.k.begin());
    std::copy(calibration.r.begin(), calibration.r.end(), message.r.begin());
    std::copy(calibration.p.begin(), calibration.p.end(), message.p.begin());
}

diagnostic_msgs::msg::DiagnosticStatus statusOf(const Diagnostics& diagnostics, const std::string& node) {
    diagnostic_msgs::msg::DiagnosticStatus status;
    status.level = diagnostics.level;
    status.name = node + ": camera";
    status.hardware_id = "spherewalk";
    status.message = diagnostics.message;
    for (const auto& [key, value] : diagnostics.values) {
        status.values.emplace_back();
        status.values.back().key = key;
        status.values.back().value = value;
    }
    return status;
}

} // namespace spherewalk::ros
