// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/camera/osc_client.h"
#include "spherewalk/camera/preview_parser.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <stop_token>

namespace spherewalk::camera {

struct PreviewOptions {
    std::chrono::milliseconds frameTimeout{5'000}; ///< the longest time without a picture
    int attempts = 4;                              ///< of a preview that the camera refuses
    std::chrono::milliseconds retryPause{500};     ///< between these
    int mostWidth = 1024;                          ///< of the pictures; wider ones are more than WiFi carries
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
