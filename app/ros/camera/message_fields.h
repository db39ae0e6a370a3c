// SPDX-License-Identifier: GPL-3.0-or-later
// Conversions for messages of ROS 1, ROS 2 and DDS, whose types differ and whose fields have the same names.
#pragma once

#include "camera_node.h"

#include "spherewalk/base/error.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace spherewalk::ros {

inline constexpr std::int64_t kNanosecondsOfSecond = 1'000'000'000;

template <class Place, class Turn>
Rigid3 rigidOf(const Place& place, const Turn& turn) {
    return {Eigen::Quaterniond(turn.w, turn.x, turn.y, turn.z), Eigen::Vector3d(place.x, place.y, place.z)};
}

/// The transform of a TransformStamped whose texts are std::string.
template <class Message>
Transform transformIn(const Message& message, Stamp stamp) {
    return {message.header.frame_id, message.child_frame_id, stamp,
            rigidOf(message.transform.translation, message.transform.rotation)};
}

/// The picture of an Image whose texts are std::string and whose arrays are std::vector. Owner: refers to the
/// message.
template <class Message>
Picture pictureOf(const Message& message) {
    return {
        message.width,       message.height,     message.step, message.encoding, message.is_bigendian != 0,
        message.data.data(), message.data.size()};
}

/// The calibration of a CameraInfo. d, k: fields of the message, which ROS 1 spells in capitals and ROS 2
/// does not.
template <class Message, class Coefficients, class Matrix>
Calibration calibrationIn(const Message& message, const Coefficients& d, const Matrix& k) {
    Calibration calibration;
    calibration.width = static_cast<int>(message.width);
    calibration.height = static_cast<int>(message.height);
    calibration.distortionModel = message.distortion_model;
    calibration.d.assign(d.begin(), d.end());
    std::copy(k.begin(), k.end(), calibration.k.begin());
    return calibration;
}

/// Fills all of a CameraInfo but the header. d, k, r, p: fields of the message.
template <class Message, class Coefficients, class Square, class Projection>
void fillCalibration(Message& message, Coefficients& d, Square& k, Square& r, Projection& p,
                     const Calibration& calibration) {
    message.width = static_cast<std::uint32_t>(calibration.width);
    message.height = static_cast<std::uint32_t>(calibration.height);
    message.distortion_model = calibration.distortionModel;
    d.assign(calibration.d.begin(), calibration.d.end());
    std::copy(calibration.k.begin(), calibration.k.end(), k.begin());
    std::copy(calibration.r.begin(), calibration.r.end(), r.begin());
    std::copy(calibration.p.begin(), calibration.p.end(), p.begin());
}

/// Fills all of an Image but the header.
template <class Message>
void fillImage(Message& message, const PublishedPicture& picture) {
    message.width = static_cast<std::uint32_t>(picture.width);
    message.height = static_cast<std::uint32_t>(picture.height);
    message.step = static_cast<std::uint32_t>(picture.pixelBytes) * message.width;
    message.encoding = picture.encoding;
    message.data.assign(picture.bytes, picture.bytes + std::size_t{message.step} * message.height);
}

/// Fills all of a Detection2DArray of vision_msgs 4 but its header, which the detections share. A simulator's
/// label is certain, so its score is 1. The places of objects are not told: their poses stay the identity.
template <class Message>
void fillDetections(Message& message, const std::vector<Detection>& detections) {
    for (const Detection& detection : detections) {
        auto& one = message.detections.emplace_back();
        one.header = message.header;
        auto& hypothesis = one.results.emplace_back().hypothesis;
        hypothesis.class_id = detection.classId;
        hypothesis.score = 1;
        one.bbox.center.position.x = detection.centreX;
        one.bbox.center.position.y = detection.centreY;
        one.bbox.size_x = detection.sizeX;
        one.bbox.size_y = detection.sizeY;
    }
}

/// The DiagnosticStatus with these diagnostics. node: name of the node.
template <class Message>
Message statusOf(const Diagnostics& diagnostics, const std::string& node) {
    Message status;
    status.level = static_cast<decltype(status.level)>(diagnostics.level);
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

/// Gives the camera to the node, and fills the response of SetCameraInfo.
template <class Response>
void answerSetCamera(CameraNode& node, const Calibration& calibration, std::size_t camera,
                     Response& response) {
    try {
        node.setCamera(calibration, camera);
        response.success = true;
        response.status_message = "The camera is used until the node ends; its file is unchanged.";
    } catch (const Error& error) {
        response.success = false;
        response.status_message = error.sentence();
    }
}

} // namespace spherewalk::ros
