// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "camera/message_fields.h"
#include "ros_messages.h"

#include <string>
#include <vector>

namespace spherewalk::ros {

// Shorter names for the types of the IDL compiler.
using TimeMessage = builtin_interfaces_msg_dds__Time_;
using ImageMessage = sensor_msgs_msg_dds__Image_;
using CameraInfoMessage = sensor_msgs_msg_dds__CameraInfo_;
using TransformMessage = geometry_msgs_msg_dds__TransformStamped_;
using TransformsMessage = tf2_msgs_msg_dds__TFMessage_;
using PoseMessage = geometry_msgs_msg_dds__PoseStamped_;
using DetectionsMessage = vision_msgs_msg_dds__Detection2DArray_;
using DiagnosticMessage = diagnostic_msgs_msg_dds__DiagnosticArray_;
using ClockMessage = rosgraph_msgs_msg_dds__Clock_;

Stamp stampOf(const TimeMessage& time);
TimeMessage timeOf(Stamp stamp);
Rigid3 poseOf(const PoseMessage& message);
Transform transformOf(const TransformMessage& message);
Calibration calibrationOf(const CameraInfoMessage& message);

// Messages of a frame. Owner: they refer to the frame and to frameId, which must outlive them.

/// picture: of the frame.
ImageMessage imageOf(const PublishedFrame& frame, const PublishedPicture& picture,
                     const std::string& frameId);
CameraInfoMessage cameraInfoOf(const PublishedFrame& frame, const std::string& frameId);

/// The boxes of a frame, each with its label as the only hypothesis. A simulator's label is certain, so its
/// score is 1. The places of objects are not told: their poses are the identity.
class FrameDetections {
  public:
    FrameDetections(const PublishedFrame& frame, const std::string& frameId);
    FrameDetections(const FrameDetections&) = delete;
    FrameDetections& operator=(const FrameDetections&) = delete;

    /// Owner: the message refers to this object, too.
    const DetectionsMessage& message() const { return m_message; }

  private:
    std::vector<vision_msgs_msg_dds__ObjectHypothesisWithPose_> m_hypotheses; ///< one a detection
    std::vector<vision_msgs_msg_dds__Detection2D_> m_detections;
    DetectionsMessage m_message{};
};

} // namespace spherewalk::ros
