// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/camera/live_preview.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/base/text.h"

#include <array>
#include <cmath>
#include <utility>

namespace spherewalk::camera {

namespace {

using Steady = std::chrono::steady_clock;

/// Whether the first format is the better one to preview with: wider, then slower, as pictures that cannot be
/// carried in time only come late.
bool isBetter(const Json& format, const Json& than, int mostWidth) {
    const auto width = wholeNumber(format, "width").value_or(0);
    const auto otherWidth = wholeNumber(than, "width").value_or(0);
    if (width <= 0 || width > mostWidth || width < otherWidth) {
        return false;
    }
    return width > otherWidth ||
           finiteNumber(format, "framerate").value_or(0) < finiteNumber(than, "framerate").value_or(0);
}

void chooseFormat(OscClient& client, int mostWidth, const std::stop_token& stop) {
    const auto options = client.findOptions({"previewFormat", "previewFormatSupport"}, stop);
    if (!options || !options->contains("previewFormatSupport") ||
        !(*options)["previewFormatSupport"].is_array()) {
        return; // the camera leaves no choice
    }
    Json best;
    for (const Json& format : (*options)["previewFormatSupport"]) {
        if (isBetter(format, best, mostWidth)) {
            best = format;
        }
    }
    if (!best.is_null() && best != options->value("previewFormat", Json())) {
        client.setOptions({{"previewFormat", best}}, stop);
    }
}

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

void PreviewOptions::validate() const {
    const auto require = [](bool isGood, const char* range) {
        if (!isGood) {
            throw Error(ErrorKind::InvalidInput, text("The preview option ", range, "."));
        }
    };
    using namespace std::chrono_literals;
    require(frameTimeout >= 1ms && frameTimeout <= 10min, "frameTimeout must lie between 1 ms and 10 min");
    require(retryPause >= 0ms && retryPause <= 10min, "retryPause must lie between 0 and 10 min");
    require(attempts >= 1 && attempts <= 100, "attempts must lie between 1 and 100");
    require(mostWidth >= 64 && mostWidth <= 8192, "mostWidth must lie between 64 and 8192");
    require(maxFrameBytes >= 1024 && maxFrameBytes <= (256U << 20),
            "maxFrameBytes must lie between 1 kB and 256 MB");
}

PreviewOptions PreviewOptions::scaled(double factor) const {
    PreviewOptions result = *this;
    result.retryPause =
        std::chrono::milliseconds(std::llround(static_cast<double>(retryPause.count()) * factor));
    return result;
}

std::int64_t showLivePreview(OscClient& client, Clock& clock, const PreviewOptions& options,
                             const PreviewParser::Sink& sink, const std::stop_token& stop) {
    options.validate();
    chooseFormat(client, options.mostWidth, stop);
    std::int64_t pictures = 0;
    for (int attempt = 1;; ++attempt) {
        PreviewParser parser(options.maxFrameBytes);
        Steady::time_point latest = Steady::now();
        const auto take = [&](PreviewFrame frame) {
            ++pictures;
            sink(std::move(frame));
            latest = Steady::now(); // the time that the sink took is not the camera's
        };
        const auto watch = [&] {
            if (Steady::now() - latest > options.frameTimeout) {
                throw Error(ErrorKind::Timeout,
                            text("The camera at ", client.endpoint().name(),
                                 " has sent no picture of its preview for ",
                                 std::chrono::duration<double>(options.frameTimeout).count(),
                                 " s; check the WiFi, press the camera's button in case it sleeps, and "
                                 "start the preview again."));
            }
        };
        try {
            client.streamPreview([&](ByteView bytes) { parser.feed(bytes, take); }, watch, stop);
            return pictures;
        } catch (const Error& error) {
            // A camera that has just been set refuses for a moment.
            if (error.kind() != ErrorKind::Busy || attempt >= options.attempts) {
                throw;
            }
        }
        clock.sleep(options.retryPause, stop);
        throwIfStopped(stop);
    }
}

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
