// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/camera/live_preview.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/base/text.h"

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

} // namespace spherewalk::camera
