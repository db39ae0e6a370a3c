// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/geometry/camera_model.h"

#include <cstdint>
#include <span>
#include <string_view>

namespace spherewalk::simulator {

/// A picture as a message carries it. No field is trusted to fit the others.
struct RawPicture {
    std::int64_t width = 0;
    std::int64_t height = 0;
    std::uint64_t stepBytes = 0; ///< Length of a row; 0 stands for rows without padding.
    std::string_view encoding;   ///< A name of ROS: rgb8, bgr8, 32FC1, ...
    bool isBigEndian = false;
    std::span<const std::uint8_t> bytes;
};

// Each function copies a picture's pixels into the form that the camera uses. Shape: the camera's. Errors of
// each: InvalidInput for another size than the camera's and for too few bytes; Unsupported for another
// encoding than the function names. A refused picture costs nothing.

/// Encodings: rgb8, bgr8, rgba8, bgra8.
RgbImage colourOf(const RawPicture& picture, const CameraIntrinsics& camera);
/// Metres. Encodings: 32FC1 in metres, 16UC1 in millimetres.
DepthImage depthOf(const RawPicture& picture, const CameraIntrinsics& camera);
/// Encodings: mono8, 8UC1; rgb8 and 8UC3, of which the first byte counts.
MaskImage labelsOf(const RawPicture& picture, const CameraIntrinsics& camera);

} // namespace spherewalk::simulator
