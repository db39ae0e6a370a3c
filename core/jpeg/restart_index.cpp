// SPDX-License-Identifier: Apache-2.0
#include "restart_layout.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jpeg/restart.h"
#include "spherewalk/jpeg/segments.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace spherewalk::jpeg {

namespace {

[[noreturn]] void fail(ErrorKind kind, std::string_view source, std::string_view what) {
    throw Error(kind, text("Could not index the restart markers of ", source, ": ", what, "."));
}

int word(ByteView bytes, std::size_t offset) {
    return bytes[offset] << 8 | bytes[offset + 1];
}

/// Size, MCU size and component count of the frame header. Source: T.81, B.2.2.
int readFrame(ByteView content, std::string_view source, RestartIndex& index) {
    const bool isLong = content.size() >= 6;
    const int components = isLong ? content[5] : 0;
    if (!isLong || content.size() != 6 + 3 * static_cast<std::size_t>(components) || components == 0) {
        fail(ErrorKind::Corrupt, source, "its frame header is damaged");
    }
    index.height = word(content, 1);
    index.width = word(content, 3);
    int horizontal = 1;
    int vertical = 1;
    for (int i = 0; i < components; ++i) {
        const int factors = content[7 + 3 * static_cast<std::size_t>(i)];
        horizontal = std::max(horizontal, factors >> 4);
        vertical = std::max(vertical, factors & 15);
    }
    index.mcuWidth = 8 * (components == 1 ? 1 : horizontal);
    index.mcuHeight = 8 * (components == 1 ? 1 : vertical);
    return components;
}

/// The next marker at or behind the position, in entropy-coded data; stuffed and fill bytes are passed over.
std::size_t nextMarker(ByteView jpeg, std::size_t position, std::string_view source) {
    while (position + 1 < jpeg.size()) {
        const void* found = std::memchr(&jpeg[position], 0xFF, jpeg.size() - 1 - position);
        if (found == nullptr) {
            break;
        }
        position = static_cast<std::size_t>(static_cast<const std::uint8_t*>(found) - jpeg.data());
        const std::uint8_t next = jpeg[position + 1];
        if (next != 0x00 && next != 0xFF) {
            return position;
        }
        position += next == 0x00 ? 2 : 1;
    }
    fail(ErrorKind::Corrupt, source, "it ends within the picture");
}

} // namespace

RestartIndex readRestartLayout(ByteView jpeg, std::string_view source, const std::vector<Segment>& header) {
    RestartIndex index;
    index.fileSizeBytes = jpeg.size();
    int components = 0;
    for (const Segment& segment : header) {
        const ByteView content = segment.content(jpeg);
        if (segment.marker == kSof0 || segment.marker == kSof1) {
            components = readFrame(content, source, index);
        } else if (segment.marker == kDri && content.size() == 2) {
            index.mcusPerInterval = word(content, 0);
        }
    }
    if (components == 0) {
        fail(ErrorKind::Unsupported, source, "it is not a baseline JPEG");
    }
    if (index.mcusPerInterval == 0) {
        fail(ErrorKind::Unsupported, source, "it has none");
    }
    const ByteView scan = header.back().content(jpeg);
    if (scan.empty() || scan[0] != components) {
        fail(ErrorKind::Unsupported, source, "its colours are in separate scans");
    }
    if (!isPlausible(index)) {
        fail(ErrorKind::Corrupt, source, "its header is damaged");
    }
    return index;
}

RestartIndex indexRestarts(ByteView jpeg, std::string_view source) {
    if (jpeg.size() > std::numeric_limits<std::uint32_t>::max()) {
        fail(ErrorKind::Unsupported, source, "it has more than 4 GB");
    }
    const std::vector<Segment> header = segments(jpeg, source);
    RestartIndex index = readRestartLayout(jpeg, source, header);
    const std::size_t intervals = intervalCount(index);
    std::size_t position = header.back().offset + header.back().size;
    index.offsets.push_back(static_cast<std::uint32_t>(position));
    for (;;) {
        position = nextMarker(jpeg, position, source);
        const std::uint8_t marker = jpeg[position + 1];
        if (marker == kEoi) {
            break;
        }
        if (marker < kRst0 || marker > kRst7) {
            fail(ErrorKind::Unsupported, source,
                 text("there is more than one scan, or a foreign marker at byte ", position));
        }
        if (marker != kRst0 + (index.offsets.size() - 1) % 8 || index.offsets.size() == intervals) {
            fail(ErrorKind::Corrupt, source,
                 text("the restart marker at byte ", position, " is out of order"));
        }
        position += 2;
        index.offsets.push_back(static_cast<std::uint32_t>(position));
    }
    if (index.offsets.size() != intervals) {
        fail(ErrorKind::Corrupt, source,
             text("there are ", index.offsets.size(), " intervals instead of ", intervals));
    }
    if (!areOffsetsPlausible(index)) {
        fail(ErrorKind::Corrupt, source, "some of its restart intervals are empty");
    }
    return index;
}

} // namespace spherewalk::jpeg
