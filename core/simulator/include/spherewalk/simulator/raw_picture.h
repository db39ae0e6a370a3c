// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/geometry/camera_model.h"

#include <cstdint>
#include <span>
#include <string_view>

namespace spherewalk::simulator {

/// A picture as a message carries it; nothing of it is believed.
struct RawPicture {
    std::int64_t width = 0;
    std::int64_t height = 0;
    std::uint64_t stepBytes = 0; ///< of a row; 0: rows follow each other without padding
    std::string_view encoding;   ///< by the ROS names: rgb8, bgr8, 32FC1, ...
    bool isBigEndian = false;
    std::span<const std::uint8_t> bytes;
};

/// A picture's pixels in the form that the camera uses. Each copies; a picture that is refused costs nothing.
/// Shape: that of the camera. Errors: InvalidInput with a sentence for another size than the camera's or too
/// few bytes; Unsupported for an encoding that is none of those that are named.
RgbImage colourOf(const RawPicture& picture, const CameraIntrinsics& camera);  ///< rgb8, bgr8, rgba8, bgra8
DepthImage depthOf(const RawPicture& picture, const CameraIntrinsics& camera); ///< 32FC1 (m), 16UC1 (mm)
MaskImage labelsOf(const RawPicture& picture,
                   const CameraIntrinsics& camera); ///< mono8, 8UC1; rgb8 and 8UC3, of which the first byte

} // namespace spherewalk::simulator
