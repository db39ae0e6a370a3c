// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "middleware.h"
#include "pose_tree.h"

#include "spherewalk/geometry/calibration.h"
#include "spherewalk/simulator/frame.h"
#include "spherewalk/simulator/raw_picture.h"

#include <cstdint>
#include <string>
#include <vector>

namespace spherewalk::gazebo {

/// The poses of a message, as they are. Errors: InvalidInput for a message without a time.
std::vector<NamedPose> posesOf(const msgs::Pose& message);
std::vector<NamedPose> posesOf(const msgs::Pose_V& message);

/// Owner: refers to the message. The time is what the header says. Errors: InvalidInput for a message without
/// one.
simulator::RawPicture pictureOf(const msgs::Image& message);
simulator::Stamp stampOf(const msgs::Header& header);

/// The time, the frame and the number of a message that goes out.
void setHeader(msgs::Header& header, simulator::Stamp stamp, const std::string& frameId,
               std::uint64_t sequence);

void setImage(msgs::Image& message, const RgbImage& picture);
void setCameraInfo(msgs::CameraInfo& message, const Calibration& calibration);

/// What the picture of the same stamp was made from: trust, late, outside, overlay, photo, origin, offset_m,
/// parallax_px, render_ms, latency_ms.
void setReport(msgs::Param& message, const simulator::Frame& frame, double latencyMs);

} // namespace spherewalk::gazebo
