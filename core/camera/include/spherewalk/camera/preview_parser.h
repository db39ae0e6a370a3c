// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/bytes.h"

#include <cstddef>
#include <cstdint>
#include <functional>

namespace spherewalk::camera {

/// One picture of a live preview: a JPEG from its start to its end marker, with a sensible size in its
/// header. Whether it decodes is for the decoder to say.
struct PreviewFrame {
    Bytes jpeg;
    int width = 0;
    int height = 0;
};

/// Takes the pictures out of a multipart stream of JPEGs. Boundaries and stated lengths are ignored, as
/// cameras get both wrong: each JPEG says itself, segment by segment, where it ends. So whatever stands
/// between the pictures does not matter, and what is damaged costs the picture it is in and at most the next.
/// Threads: one at a time. Errors: none but what the sink throws. Cost: bounded by the bytes fed.
class PreviewParser {
  public:
    using Sink = std::function<void(PreviewFrame)>;

    /// A picture that grows beyond is left out.
    explicit PreviewParser(std::size_t maxFrameBytes = 4 << 20) : m_maxFrameBytes(maxFrameBytes) {}

    /// The next bytes, cut anywhere. Calls the sink for each picture that they complete.
    void feed(ByteView bytes, const Sink& sink);

    /// Pictures begun that came to nothing.
    std::int64_t dropped() const { return m_dropped; }

  private:
    /// What the next byte is.
    enum class Expect {
        Start,      ///< of a picture, matched byte by byte
        Prefix,     ///< 0xff before a marker
        Marker,     ///< its code
        LengthHigh, ///< of a segment
        LengthLow,
        Segment, ///< its content
        Coded,   ///< entropy-coded data
        CodedEscape,
    };

    void take(std::uint8_t byte, const Sink& sink);
    void takeStart(std::uint8_t byte);
    void takeMarker(std::uint8_t code, const Sink& sink);
    void takeSegment(std::uint8_t byte);
    void beginSegment();
    void endSegment();
    void drop();
    void finish(const Sink& sink);

    std::size_t m_maxFrameBytes;
    Expect m_expect = Expect::Start;
    int m_matched = 0;
    PreviewFrame m_frame;
    bool m_hasScan = false;
    std::uint8_t m_marker = 0;
    int m_segmentBytes = 0; ///< of its content
    int m_taken = 0;        ///< of them
    std::int64_t m_dropped = 0;
};

} // namespace spherewalk::camera
