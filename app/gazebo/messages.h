// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pose_tree.h"

#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/simulator/frame.h"
#include "spherewalk/simulator/raw_picture.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

// One name for Gazebo's transport and messages. Up to Fortress they are called ignition-transport and
// ignition-msgs, later gz-transport and gz-msgs.
#ifdef SPHEREWALK_IGNITION
#include <ignition/msgs/annotated_axis_aligned_2d_box_v.pb.h>
#include <ignition/msgs/camera_info.pb.h>
#include <ignition/msgs/image.pb.h>
#include <ignition/msgs/param.pb.h>
#include <ignition/msgs/pose.pb.h>
#include <ignition/msgs/pose_v.pb.h>
#include <ignition/transport/Node.hh>

namespace spherewalk::gazebo {
namespace msgs = ignition::msgs;
namespace transport = ignition::transport;
} // namespace spherewalk::gazebo
#else
#include <gz/msgs/annotated_axis_aligned_2d_box_v.pb.h>
#include <gz/msgs/camera_info.pb.h>
#include <gz/msgs/image.pb.h>
#include <gz/msgs/param.pb.h>
#include <gz/msgs/pose.pb.h>
#include <gz/msgs/pose_v.pb.h>
#include <gz/transport/Node.hh>

namespace spherewalk::gazebo {
namespace msgs = gz::msgs;
namespace transport = gz::transport;
} // namespace spherewalk::gazebo
#endif

namespace spherewalk::gazebo {

/// Ends a program that used the transport. Its thread of discovery is never joined, so static objects must
/// not be destroyed under it.
[[noreturn]] inline void endProgram(int status) {
    std::fflush(nullptr);
    std::_Exit(status);
}

/// The poses of a message, unchanged. Errors: InvalidInput for a message without a time.
std::vector<NamedPose> posesOf(const msgs::Pose& message);
std::vector<NamedPose> posesOf(const msgs::Pose_V& message);

/// The picture of a message. Owner: the result refers to the message.
simulator::RawPicture pictureOf(const msgs::Image& message);
/// The simulation's time. Errors: InvalidInput for a header without a time.
simulator::Stamp stampOf(const msgs::Header& header);

/// Fills the time, the frame and the number of an outgoing message.
void setHeader(msgs::Header& header, simulator::Stamp stamp, const std::string& frameId,
               std::uint64_t sequence);

void setImage(msgs::Image& message, const RgbImage& picture);
/// As Gazebo's depth cameras: single precision, metres along the optical axis.
void setDepth(msgs::Image& message, const DepthImage& depth);
/// One channel of 16 bits (L_INT16): Gazebo's own pictures of labels hold 255 at most.
void setLabels(msgs::Image& message, const render::LabelImage& labels);

/// The boxes of simulator::labelBoxes(). Their corners are those of Gazebo's bounding box camera, too.
void setBoxes(msgs::AnnotatedAxisAligned2DBox_V& message, const render::LabelImage& labels);
void setCameraInfo(msgs::CameraInfo& message, const Calibration& calibration);

/// Fills the report on the picture of the same stamp: trust, late, outside, overlay, photo, origin, offset_m,
/// parallax_px, render_ms, latency_ms.
void setReport(msgs::Param& message, const simulator::Frame& frame, double latencyMs);

} // namespace spherewalk::gazebo
