// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/base/image.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/rigid3.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace spherewalk::dataset {

/// The two generations of ROS, which lay the same messages out differently.
enum class Ros {
    One, ///< Little-endian, packed.
    Two, ///< Little-endian CDR with its encapsulation header.
};

/// The types of messages for pictures with poses.
enum class RosType { Image, CompressedImage, CameraInfo, PoseStamped, TfMessage };

/// The description of a type, for readers that do not know the type.
struct RosSchema {
    std::string name;       ///< "sensor_msgs/Image"; for ROS 2 "sensor_msgs/msg/Image".
    std::string definition; ///< Fields of the type and of all types in it.
    std::string md5;        ///< The hash of ROS 1; "" for ROS 2.
};

RosSchema rosSchema(Ros ros, RosType type);

struct RosHeader {
    std::uint32_t sequence = 0; ///< Only ROS 1 has it.
    std::int64_t stampNs = 0;
    std::string frame;
};

/// The stamp of a time. Because 0 means "no time" in ROS, a time of 0 becomes 1 ns. Errors: InvalidInput
/// outside of 0 to 2^31 s.
std::int64_t rosStampNs(double timeS);

// The bytes of messages. Frames: poses and transforms are given in the header's frame.

/// A sensor_msgs/Image of encoding rgb8.
Bytes imageMessage(Ros ros, const RosHeader& header, const RgbImage& picture);
/// A sensor_msgs/Image of encoding 16UC1: labels, or depths in millimetres (REP 118).
Bytes imageMessage(Ros ros, const RosHeader& header, const Image<std::uint16_t, 1>& picture);
/// A sensor_msgs/CompressedImage. png: the bytes of a PNG file.
Bytes pngMessage(Ros ros, const RosHeader& header, ByteView png);
Bytes cameraInfoMessage(Ros ros, const RosHeader& header, const Calibration& camera);
Bytes poseMessage(Ros ros, const RosHeader& header, const Rigid3& pose);
/// A tf2_msgs/TFMessage with one transform, from the child's frame to the header's frame.
Bytes tfMessage(Ros ros, const RosHeader& header, std::string_view child, const Rigid3& parentFromChild);

} // namespace spherewalk::dataset
