// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/camera/preview_parser.h"

#include <array>
#include <utility>

namespace spherewalk::camera {

namespace {

constexpr std::array<std::uint8_t, 3> kStart{0xff, 0xd8, 0xff};
constexpr std::uint8_t kPrefix = 0xff;
constexpr std::uint8_t kStartOfImage = 0xd8;
constexpr std::uint8_t kEndOfImage = 0xd9;
constexpr std::uint8_t kStartOfScan = 0xda;
constexpr int kLargestSide = 8192; // of a preview; larger ones would only cost memory

bool isRestart(std::uint8_t code) {
    return code >= 0xd0 && code <= 0xd7;
}

/// Markers that begin a frame; those left out in their range are tables and extensions.
bool isFrameHeader(std::uint8_t code) {
    return code >= 0xc0 && code <= 0xcf && code != 0xc4 && code != 0xc8 && code != 0xcc;
}

/// Markers that are followed by a length and so many bytes.
bool hasSegment(std::uint8_t code) {
    return code >= 0xc0 && !isRestart(code) && code != kStartOfImage && code != kEndOfImage;
}

} // namespace

void PreviewParser::feed(ByteView bytes, const Sink& sink) {
    for (const std::uint8_t byte : bytes) {
        take(byte, sink);
    }
}

void PreviewParser::take(std::uint8_t byte, const Sink& sink) {
    if (m_expect == Expect::Start) {
        return takeStart(byte);
    }
    m_frame.jpeg.push_back(byte);
    if (m_frame.jpeg.size() > m_maxFrameBytes) {
        return drop();
    }
    switch (m_expect) {
    case Expect::Start:
        return;
    case Expect::Prefix:
        if (byte != kPrefix) {
            return drop();
        }
        m_expect = Expect::Marker;
        return;
    case Expect::Marker:
        return takeMarker(byte, sink);
    case Expect::LengthHigh:
        m_segmentBytes = byte << 8;
        m_expect = Expect::LengthLow;
        return;
    case Expect::LengthLow:
        m_segmentBytes += byte - 2;
        return beginSegment();
    case Expect::Segment:
        return takeSegment(byte);
    case Expect::Coded:
        m_expect = byte == kPrefix ? Expect::CodedEscape : Expect::Coded;
        return;
    case Expect::CodedEscape:
        if (byte == 0 || isRestart(byte)) {
            m_expect = Expect::Coded;
            return;
        }
        return takeMarker(byte, sink);
    }
}

void PreviewParser::takeStart(std::uint8_t byte) {
    const auto matched = static_cast<std::size_t>(m_matched);
    m_matched = byte == kStart.at(matched) ? m_matched + 1 : byte == kPrefix ? 1 : 0;
    if (m_matched == static_cast<int>(kStart.size())) {
        m_frame.jpeg.assign(kStart.begin(), kStart.end());
        m_expect = Expect::Marker;
    }
}

void PreviewParser::takeMarker(std::uint8_t code, const Sink& sink) {
    if (code == kPrefix) {
        return; // any number of them may stand before a marker
    }
    if (code == kEndOfImage) {
        return finish(sink);
    }
    if (code == kStartOfImage) { // the picture was cut off, and the next one begins
        drop();
        m_matched = 2;
        return;
    }
    if (!hasSegment(code)) {
        return drop();
    }
    m_marker = code;
    m_expect = Expect::LengthHigh;
}

void PreviewParser::beginSegment() {
    m_taken = 0;
    m_expect = Expect::Segment;
    if (m_segmentBytes < 0) {
        return drop();
    }
    if (m_segmentBytes == 0) {
        endSegment();
    }
}

void PreviewParser::takeSegment(std::uint8_t byte) {
    if (isFrameHeader(m_marker)) { // precision, height, width
        int& side = m_taken < 3 ? m_frame.height : m_frame.width;
        if (m_taken >= 1 && m_taken <= 4) {
            side = m_taken % 2 == 1 ? byte << 8 : side + byte;
        }
    }
    if (++m_taken == m_segmentBytes) {
        endSegment();
    }
}

void PreviewParser::endSegment() {
    m_hasScan = m_hasScan || m_marker == kStartOfScan;
    m_expect = m_marker == kStartOfScan ? Expect::Coded : Expect::Prefix;
}

void PreviewParser::drop() {
    ++m_dropped;
    m_frame = {};
    m_hasScan = false;
    m_matched = 0;
    m_expect = Expect::Start;
}

void PreviewParser::finish(const Sink& sink) {
    const auto isSide = [](int pixels) { return pixels > 0 && pixels <= kLargestSide; };
    if (!m_hasScan || !isSide(m_frame.width) || !isSide(m_frame.height)) {
        return drop();
    }
    PreviewFrame frame = std::exchange(m_frame, {});
    m_hasScan = false;
    m_matched = 0;
    m_expect = Expect::Start;
    sink(std::move(frame));
}

} // namespace spherewalk::camera
