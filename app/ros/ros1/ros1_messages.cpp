// SPDX-License-Identifier: GPL-3.0-or-later
#include "ros1_messages.h"

#include <algorithm>

namespace spherewalk::ros {

namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

template <class Place, class Turn>
Rigid3 rigid(const Place& place, const Turn& turn) {
    return {Eigen::Quaterniond(turn.w, turn.x, turn.y, turn.z), Eigen::Vector3d(place.x, place.y, place.z)};
}

} // namespace

Stamp stampOf(const ::ros::Time& time) {
    return Stamp(kSecond * time.sec + time.nsec);
}

::ros::Time rosTime(Stamp stamp) {
    return {static_cast<std::uint32_t>(stamp.count() / kSecond),
            static_cast<std::uint32_t>(stamp.count() % kSecond)};
}

Rigid3 poseOf(const geometry_msgs::Pose& pose) {
    return rigid(pose.position, pose.orientation);
}

Transform transformOf(const geometry_msgs::TransformStamped& message) {
    return {message.header.frame_id, message.child_frame_id, stampOf(message.header.stamp),
            rigid(message.transform.translation, message.transform.rotation)};
}

Picture pictureOf(const sensor_msgs::Image& message) {
    return {
        message.width,       message.height,     message.step, message.encoding, message.is_bigendian != 0,
        message.data.data(), message.data.size()};
}

Calibration calibrationOf(const sensor_msgs::CameraInfo& message) {
    Calibration calibration{static_cast<int>(message.width),
                            static_cast<int>(message.height),
                            message.distortion_model,
                            message.D,
                            {},
                            {},
                            {}};
    std::copy(message.K.begin(), message.K.end(), calibration.k.begin());
    return calibration;
}

void fill(sensor_msgs::Image& message, const PublishedFrame& frame) {
    message.width = static_cast<std::uint32_t>(frame.width);
    message.height = static_cast<std::uint32_t>(frame.height);
    message.step = 3 * message.width;
    message.encoding = "rgb8";
    message.data.assign(frame.rgb, frame.rgb + std::size_t{message.step} * message.height);
}

void fill(sensor_msgs::CameraInfo& message, const Calibration& calibration) {
    message.width = static_cast<std::uint32_t>(calibration.width);
    message.height = static_cast<std::uint32_t>(calibration.height);
    message.distortion_model = calibration.distortionModel;
    message.D = calibration.d;
    std::copy(calibration.k.begin(), calibration.k.end(), message.K.begin());
    std::copy(calibration.r.begin(), calibration.r.end(), message.R.begin());
    std::copy(calibration.p.begin(), calibration.p.end(), message.P.begin());
}

diagnostic_msgs::DiagnosticStatus statusOf(const Diagnostics& diagnostics, const std::string& node) {
    diagnostic_msgs::DiagnosticStatus status;
    status.level = static_cast<std::int8_t>(diagnostics.level);
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
