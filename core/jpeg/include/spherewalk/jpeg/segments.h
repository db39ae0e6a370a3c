// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/bytes.h"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace spherewalk::jpeg {

/// Second bytes of the markers that are named in this program. Source: ITU-T T.81, table B.1.
enum Marker : std::uint8_t {
    kSof0 = 0xC0,
    kSof1 = 0xC1,
    kSof2 = 0xC2,
    kRst0 = 0xD0,
    kRst7 = 0xD7,
    kSoi = 0xD8,
    kEoi = 0xD9,
    kSos = 0xDA,
    kDri = 0xDD,
    kApp0 = 0xE0,
    kApp1 = 0xE1,
    kApp15 = 0xEF,
    kCom = 0xFE,
};

/// One marker segment of a JPEG's header.
struct Segment {
    std::uint8_t marker = 0;
    std::size_t offset = 0; ///< of the marker's 0xFF, from the file's start
    std::size_t size = 0;   ///< marker, length field and content; at least 4 but for markers without content

    /// All of the segment, as it stands in the file that it was found in.
    ByteView whole(ByteView jpeg) const { return jpeg.subspan(offset, size); }

    /// What follows the length field; empty for a marker that has none.
    ByteView content(ByteView jpeg) const { return size < 4 ? ByteView() : whole(jpeg).subspan(4); }

    bool operator==(const Segment&) const = default;
};

/// The segments behind SOI up to the first SOS, which is the last one returned; entropy-coded data follow it.
/// All lie within the bytes. Fill bytes (0xFF before a marker) belong to no segment. Errors: Corrupt if the
/// bytes do not begin with SOI, or a segment is cut off or followed by something else than a marker.
std::vector<Segment> segments(ByteView jpeg, std::string_view source);

} // namespace spherewalk::jpeg
