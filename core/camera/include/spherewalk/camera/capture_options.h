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
    std::chrono::milliseconds pollInterval{500}; ///< Pause between questions about a running shot.
    ShotAllowance allowance;                     ///< Time that a shot may take.
    /// After a restart, a shot whose trigger had no answer owns a picture only if the picture was begun at
    /// most so long after the intention, by the clock of day. The self-timer and the exposure are added.
    std::chrono::milliseconds triggerTime{5'000};
    /// Before a shot is declared NotTaken or Unclear, two looks at the files lie this far apart. It is longer
    /// than the camera takes from the trigger to a listed file without filters.
    std::chrono::milliseconds confirmTime{5'000};
    std::chrono::milliseconds reconnectTime{60'000}; ///< How long a lost camera is looked for.
    std::chrono::milliseconds reconnectPause{3'000}; ///< Pause between two such looks.
    std::chrono::milliseconds idleTime{30'000};      ///< How long to wait for a busy camera.
    std::chrono::milliseconds busyPause{
        1'000};                   ///< Pause after a refused trigger; it doubles, at most three times.
    double batteryWarning = 0.33; ///< Charge, from 0 to 1, at which the operator is warned.
    double batteryMinimum = 0.15; ///< Charge, from 0 to 1, at which the run ends.
    int remainingWarning = 50;    ///< Number of photos left on the camera at which the operator is warned.
    DownloadOptions download;
    std::optional<survey::CaptureProfile>
        profile; ///< Without a profile the exposure stays as the camera is set.

    /// Errors: InvalidInput, with the option and its range.
    void validate() const;
    /// The options with all times of the camera multiplied by the factor. Range: 0 < factor <= 100.
    CaptureOptions scaled(double factor) const;
};

} // namespace spherewalk::camera
