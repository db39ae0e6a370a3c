// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/camera/capture_options.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <cmath>

namespace spherewalk::camera {

namespace {

void requireTime(const char* option, std::chrono::milliseconds value, std::chrono::milliseconds least) {
    if (value < least || value > std::chrono::hours(1)) {
        throw Error(ErrorKind::InvalidInput,
                    text("The capture option ", option, " must lie between ", least.count(), " ms and 1 h."));
    }
}

void requireNumber(const char* option, double value, double most) {
    if (!(value >= 0 && value <= most)) {
        throw Error(ErrorKind::InvalidInput,
                    text("The capture option ", option, " must lie between 0 and ", most, "."));
    }
}

} // namespace

void CaptureOptions::validate() const {
    using std::chrono::milliseconds;
    requireTime("pollInterval", pollInterval, milliseconds(1));
    requireTime("allowance.base", allowance.base, milliseconds(1));
    requireTime("allowance.filterExtra", allowance.filterExtra, milliseconds(0));
    requireTime("confirmTime", confirmTime, milliseconds(1));
    requireTime("reconnectTime", reconnectTime, milliseconds(1));
    requireTime("reconnectPause", reconnectPause, milliseconds(1));
    requireTime("idleTime", idleTime, milliseconds(1));
    requireTime("busyPause", busyPause, milliseconds(0));
    requireNumber("allowance.exposureFactor", allowance.exposureFactor, 100);
    requireNumber("allowance.timeScale", allowance.timeScale, 100);
    requireNumber("batteryWarning", batteryWarning, 1);
    requireNumber("batteryMinimum", batteryMinimum, 1);
    download.validate();
    if (profile) {
        profile->validate();
    }
}

CaptureOptions CaptureOptions::scaled(double factor) const {
    if (!(factor > 0 && factor <= 100)) {
        throw Error(ErrorKind::InvalidInput, "The time scale of a camera must lie above 0 and up to 100.");
    }
    CaptureOptions result = *this;
    for (auto* time : {&result.pollInterval, &result.allowance.base, &result.allowance.filterExtra,
                       &result.confirmTime, &result.reconnectTime, &result.reconnectPause, &result.idleTime,
                       &result.busyPause, &result.download.restartPause}) {
        *time = std::chrono::milliseconds(std::max(1LL, std::llround(double(time->count()) * factor)));
    }
    result.allowance.timeScale *= factor;
    return result;
}

} // namespace spherewalk::camera
