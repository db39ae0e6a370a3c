// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/clock.h"
#include "spherewalk/camera/capture_journal.h"
#include "spherewalk/camera/osc_client.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <stop_token>
#include <string_view>

namespace spherewalk::camera {

/// Size of a decoded photo in pixels.
struct PhotoFacts {
    int width = 0;
    int height = 0;
};

/// Decodes the whole picture in the file and returns its size. The caller gives this function, because
/// another module decodes pictures. Errors: Corrupt for anything that is not a complete JPEG.
using PhotoCheck = std::function<PhotoFacts(const std::filesystem::path& file)>;

/// How patient a download is, and what it accepts.
struct DownloadOptions {
    PhotoCheck check; ///< Required.
    int restarts = 3; ///< Number of new tries after a cut, stalled or short download.
    std::chrono::milliseconds restartPause{1'000};
    std::uint64_t maxBytes = 256ULL << 20;
    int minWidth = 1024;

    /// Errors: InvalidInput, with the option and its range.
    void validate() const;
};

/// Downloads a photo and proves that it is complete: as long as the answer said and as the camera's list
/// says, framed by the JPEG's start and end markers (padding after the end is tolerated), decodable, twice as
/// wide as high. The result lies at `target`, synced; before, there is only a temporary name beside it.
/// Errors: Corrupt (the photo is damaged or not spherical), NotFound (the camera does not have it), Network,
/// Timeout, Stopped, Full, Io; the photo stays on the camera. Stop: within 200 ms, except in the check.
DownloadedPhoto downloadPhoto(OscClient& client, Clock& clock, std::string_view fileUrl,
                              const std::filesystem::path& target, const DownloadOptions& options,
                              const std::stop_token& stop);

} // namespace spherewalk::camera
