// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/jpeg/segments.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

namespace spherewalk::jpeg {

namespace {

[[noreturn]] void fail(std::string_view source, std::string_view what) {
    throw Error(ErrorKind::Corrupt,
                text("Could not read ", source, ": ", what, "; fetch or copy the file again."));
}

bool hasNoContent(std::uint8_t marker) {
    constexpr std::uint8_t kTem = 0x01;
    return marker == kTem || (marker >= kRst0 && marker <= kRst7);
}

/// The segment at the offset, where fill bytes may come first.
Segment segmentAt(ByteView jpeg, std::size_t offset, std::string_view source) {
    if (offset < jpeg.size() && jpeg[offset] != 0xFF) {
        fail(source, text("a marker was expected at byte ", offset));
    }
    while (offset + 1 < jpeg.size() && jpeg[offset + 1] == 0xFF) {
        ++offset;
    }
    if (offset + 1 >= jpeg.size()) {
        fail(source, "it ends within the JPEG header");
    }
    const std::uint8_t marker = jpeg[offset + 1];
    if (hasNoContent(marker)) {
        return {marker, offset, 2};
    }
    if (marker == 0x00 || marker == kSoi || marker == kEoi) {
        fail(source, text("there is no picture before byte ", offset));
    }
    const std::size_t left = jpeg.size() - offset;
    const std::size_t size = left < 4 ? 0 : 2 + (std::size_t{jpeg[offset + 2]} << 8 | jpeg[offset + 3]);
    if (size < 4 || size > left) {
        fail(source, text("the segment at byte ", offset, " is cut off or has an impossible length"));
    }
    return {marker, offset, size};
}

} // namespace

std::vector<Segment> segments(ByteView jpeg, std::string_view source) {
    if (jpeg.size() < 2 || jpeg[0] != 0xFF || jpeg[1] != kSoi) {
        fail(source, "it is not a JPEG");
    }
    std::vector<Segment> found;
    std::size_t offset = 2;
    do {
        found.push_back(segmentAt(jpeg, offset, source));
        offset = found.back().offset + found.back().size;
    } while (found.back().marker != kSos);
    return found;
}

} // namespace spherewalk::jpeg
