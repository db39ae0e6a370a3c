// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/bytes.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace spherewalk::photo {

/// Namespace of the tag in XMP. Source: resources/docs/formats.md, "Position tag".
inline constexpr std::string_view kTagNamespace = "http://spherewalk.org/ns/survey/1.0/";

/// Where a photo was taken, as it is written into the photo for other tools.
/// Frames: room. Units: metres. Range: finite; texts without control characters, the id not empty.
struct PositionTag {
    std::string surveyId;
    std::int64_t stationId = 0;
    std::string stationName;
    Eigen::Vector3d positionM = Eigen::Vector3d::Zero();
    std::optional<Eigen::Quaterniond> roomFromPhoto;
    /// With a rotation: it is also written as GPano's pose, in place of the camera's, so that viewers turn
    /// the picture rightly. GPano counts headings clockwise from north, which the room's +y stands for.
    bool isPanoramaPose = false;
};

/// The photo with the tag in its XMP, in place of an earlier tag. Everything else stays: the other XMP
/// properties with their values (except GPano's pose if the tag replaces it); every other segment, Exif and
/// maker note among them, and the picture's data byte for byte. That is checked on the result before it is
/// returned. Errors: InvalidInput for a tag out of range; Corrupt if the JPEG or its XMP is damaged;
/// Unsupported if the XMP would exceed its 64 kB; Internal if the check fails. Threads: any, also at a time.
Bytes withPositionTag(ByteView jpeg, const PositionTag& tag, std::string_view source);

/// The tag of a photo; nothing if there is no valid one. isPanoramaPose is never set. Errors:
/// Corrupt if the bytes are no JPEG.
std::optional<PositionTag> readPositionTag(ByteView jpeg, std::string_view source);

} // namespace spherewalk::photo
