// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/base/image.h"
#include "spherewalk/geometry/calibration.h"
#include "spherewalk/geometry/rigid3.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace spherewalk::dataset {

/// The two generations of ROS: the same messages, laid out differently.
enum class Ros {
    One, ///< little-endian, packed
    Two, ///< CDR, little-endian, with its encapsulation header
};

/// Messages that pictures with poses are told in.
enum class RosType { Image, CompressedImage, CameraInfo, PoseStamped, TfMessage };

/// What a reader needs to know of a type that it has never seen.
struct RosSchema {
    std::string name;       ///< "sensor_msgs/Image"; of ROS 2 "sensor_msgs/msg/Image"
    std::string definition; ///< with those of all that it is made of
    std::string md5;        ///< of ROS 1
};

RosSchema rosSchema(Ros ros, RosType type);

struct RosHeader {
    std::uint32_t sequence = 0; ///< ROS 1 only
    std::int64_t stampNs = 0;
    std::string frame;
};

/// The stamp of a time. As 0 means "no time" in ROS, a time of 0 becomes 1 ns. Errors: InvalidInput for what
/// is no time from 0 to 2^31 s.
std::int64_t rosStampNs(double timeS);

/// Frames of the following: the header's frame is what the message is seen in. Errors: none.
Bytes imageMessage(Ros ros, const RosHeader& header, const RgbImage& picture); ///< rgb8
/// png: the bytes of a PNG file.
Bytes pngMessage(Ros ros, const RosHeader& header, ByteView png);
Bytes cameraInfoMessage(Ros ros, const RosHeader& header, const Calibration& camera);
Bytes poseMessage(Ros ros, const RosHeader& header, const Rigid3& pose);
/// A TFMessage with one transform. parentFromChild: the header's frame from the child's.
Bytes tfMessage(Ros ros, const RosHeader& header, std::string_view child, const Rigid3& parentFromChild);

} // namespace spherewalk::dataset
