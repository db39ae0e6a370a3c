// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "camera_watch.h"
#include "shot_settler.h"

#include "spherewalk/camera/capture.h"

namespace spherewalk::camera {

struct Capture::Parts {
    Parts(OscClient& client, Clock& clock, const CaptureOptions& options)
        : guard(client, options.profile), settler(client, clock, options), watch(options) {}

    SettingsGuard guard;
    ShotSettler settler;
    CameraWatch watch;
};

} // namespace spherewalk::camera
