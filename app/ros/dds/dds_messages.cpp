// SPDX-License-Identifier: GPL-3.0-or-later
#include "dds_messages.h"

#include <algorithm>
#include <iterator>

namespace spherewalk::ros {

namespace {

std::string textOf(const char* text) {
    return text == nullptr ? "" : text;
}

/// For a member of a message that is written: C knows no constant strings there.
char* borrowed(const std::string& text) {
    return const_cast<char*>(text.c_str());
}

} // namespace

Stamp stampOf(const TimeMessage& time) {
    return Stamp(kNanosecondsOfSecond * time.sec + time.nanosec);
}

TimeMessage timeOf(Stamp stamp) {
    return {static_cast<std::int32_t>(stamp.count() / kNanosecondsOfSecond),
            static_cast<std::uint32_t>(stamp.count() % kNanosecondsOfSecond)};
}

Rigid3 poseOf(const PoseMessage& message) {
    return rigidOf(message.pose.position, message.pose.orientation);
}

Transform transformOf(const TransformMessage& message) {
    return {textOf(message.header.frame_id), textOf(message.child_frame_id), stampOf(message.header.stamp),
            rigidOf(message.transform.translation, message.transform.rotation)};
}

Calibration calibrationOf(const CameraInfoMessage& message) {
    Calibration calibration;
    calibration.width = static_cast<int>(message.width);
    calibration.height = static_cast<int>(message.height);
    calibration.distortionModel = textOf(message.distortion_model);
    calibration.d.assign(message.d._buffer, message.d._buffer + message.d._length);
    std::copy(std::begin(message.k), std::end(message.k), calibration.k.begin());
    return calibration;
}

ImageMessage imageOf(const PublishedFrame& frame, const PublishedPicture& picture,
                     const std::string& frameId) {
    ImageMessage message{};
    message.header = {timeOf(frame.stamp), borrowed(frameId)};
    message.width = static_cast<std::uint32_t>(picture.width);
    message.height = static_cast<std::uint32_t>(picture.height);
    message.step = static_cast<std::uint32_t>(picture.pixelBytes) * message.width;
    message.encoding = const_cast<char*>(picture.encoding);
    message.data._length = message.data._maximum = message.step * message.height;
    message.data._buffer = const_cast<std::uint8_t*>(picture.bytes);
    return message;
}

CameraInfoMessage cameraInfoOf(const PublishedFrame& frame, const std::string& frameId) {
    const Calibration& calibration = frame.calibration;
    CameraInfoMessage message{};
    message.header = {timeOf(frame.stamp), borrowed(frameId)};
    message.width = static_cast<std::uint32_t>(calibration.width);
    message.height = static_cast<std::uint32_t>(calibration.height);
    message.distortion_model = borrowed(calibration.distortionModel);
    message.d._length = message.d._maximum = static_cast<std::uint32_t>(calibration.d.size());
    message.d._buffer = const_cast<double*>(calibration.d.data());
    std::copy(calibration.k.begin(), calibration.k.end(), message.k);
    std::copy(calibration.r.begin(), calibration.r.end(), message.r);
    std::copy(calibration.p.begin(), calibration.p.end(), message.p);
    return message;
}

FrameDetections::FrameDetections(const PublishedFrame& frame, const std::string& frameId)
    : m_hypotheses(frame.detections.size()), m_detections(frame.detections.size()) {
    m_message.header = {timeOf(frame.stamp), borrowed(frameId)};
    for (std::size_t i = 0; i < m_detections.size(); ++i) {
        const Detection& detection = frame.detections[i];
        m_hypotheses[i].hypothesis = {borrowed(detection.classId), 1};
        m_hypotheses[i].pose.pose.orientation.w = 1;
        m_detections[i].header = m_message.header;
        m_detections[i].results._length = m_detections[i].results._maximum = 1;
        m_detections[i].results._buffer = &m_hypotheses[i];
        m_detections[i].bbox = {
            {{detection.centreX, detection.centreY}, 0}, detection.sizeX, detection.sizeY};
        m_detections[i].id = const_cast<char*>("");
    }
    m_message.detections._length = m_message.detections._maximum =
        static_cast<std::uint32_t>(m_detections.size());
    m_message.detections._buffer = m_detections.data();
}

} // namespace spherewalk::ros
