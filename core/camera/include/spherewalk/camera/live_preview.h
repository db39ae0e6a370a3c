// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/bytes.h"
#include "spherewalk/camera/osc_client.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <stop_token>

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

    /// maxFrameBytes: a larger picture is left out.
    explicit PreviewParser(std::size_t maxFrameBytes = 4 << 20) : m_maxFrameBytes(maxFrameBytes) {}

    /// Takes the next bytes, cut anywhere, and calls the sink for each picture that they complete.
    void feed(ByteView bytes, const Sink& sink);

    /// Number of pictures that began and never ended well.
    std::int64_t dropped() const { return m_dropped; }

  private:
    /// What the next byte is.
    enum class Expect {
        Start,      ///< Start of a picture, matched byte by byte.
        Prefix,     ///< 0xff before a marker.
        Marker,     ///< Code of the marker.
        LengthHigh, ///< High byte of a segment's length.
        LengthLow,
        Segment, ///< Content of a segment.
        Coded,   ///< Entropy-coded data.
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
    int m_segmentBytes = 0; ///< Bytes of the segment's content.
    int m_taken = 0;        ///< Bytes of it that were taken.
    std::int64_t m_dropped = 0;
};

/// How patient a preview is, and how large its pictures may be.
struct PreviewOptions {
    std::chrono::milliseconds frameTimeout{5'000}; ///< Longest time without a picture.
    int attempts = 4;                              ///< Number of tries if the camera refuses the preview.
    std::chrono::milliseconds retryPause{500};     ///< Pause between the tries.
    int mostWidth = 1024; ///< Largest width; WiFi cannot carry wider pictures in time.
    std::size_t maxFrameBytes = 4 << 20;

    /// Errors: InvalidInput, with the option and its range.
    void validate() const;
    /// The pauses that the camera's own pace asks for, times the factor; the timeout stays.
    PreviewOptions scaled(double factor) const;
};

/// Makes the camera show what it sees, picture by picture, and returns how many came when the camera ends it,
/// as it does when it takes a picture. Before, the camera's preview is set to the widest format up to
/// mostWidth, at its lowest rate. The sink should be quick: while it works, pictures wait.
/// Errors: Timeout, if no picture comes for the frame timeout, whatever else does; those of
/// OscClient::streamPreview; what the sink throws. Stop: within 200 ms. Threads: the client's.
std::int64_t showLivePreview(OscClient& client, Clock& clock, const PreviewOptions& options,
                             const PreviewParser::Sink& sink, const std::stop_token& stop);

} // namespace spherewalk::camera
