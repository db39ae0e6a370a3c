// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/camera/photo_download.h"
#include "spherewalk/camera/settings_guard.h"
#include "spherewalk/survey/capture_profile.h"

#include <chrono>
#include <optional>

namespace spherewalk::camera {

/// How patient the capture workflow is. The defaults suit a real camera; scaled() suits a practice camera
/// whose time runs faster.
struct CaptureOptions {
    std::chrono::milliseconds pollInterval{500}; ///< between questions about a running shot
    ShotAllowance allowance;
    /// Files are looked at twice, this far apart, before a shot is declared not taken or unclear: longer than
    /// the camera takes from trigger to a listed file without filters.
    std::chrono::milliseconds confirmTime{5'000};
    std::chrono::milliseconds reconnectTime{60'000}; ///< how long a lost camera is looked for
    std::chrono::milliseconds reconnectPause{3'000};
    std::chrono::milliseconds idleTime{30'000}; ///< how long a busy camera is waited for
    std::chrono::milliseconds busyPause{1'000}; ///< after a refused trigger; doubled, at most three times
    double batteryWarning = 0.33;
    double batteryMinimum = 0.15;
    int remainingWarning = 50; ///< photos left on the camera
    DownloadOptions download;
    std::optional<survey::CaptureProfile> profile; ///< none: the exposure stays as the camera is set

    /// Errors: InvalidInput, with the option and its range.
    void validate() const;
    /// All times of the camera times the factor. Range: 0 < factor <= 100.
    CaptureOptions scaled(double factor) const;
};

} // namespace spherewalk::camera
