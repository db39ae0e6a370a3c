// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/render/view_stream.h"
#include "spherewalk/simulator/mounting.h"
#include "spherewalk/simulator/overlay_options.h"

#include <optional>
#include <string_view>

namespace spherewalk::simulator {

/// What becomes of a frame whose turn comes before the one before it is rendered.
enum class Pace {
    Newest, ///< frames that are late are left out: for a simulation that runs by itself
    Every,  ///< all are rendered in turn: for lock-step and recordings
};

/// "newest", "every". Errors of the latter: InvalidInput.
std::string_view name(Pace pace);
Pace pace(std::string_view name);

struct CameraOptions {
    render::ViewOptions view; ///< its overlays are not used
    render::StreamOptions stream;
    Mounting mounting;
    /// Frames a second of simulation time, each at the first pose at or after a multiple of 1/rate; a pose up
    /// to a microsecond before one is at it. 0: a frame for each pose. Range: up to 1000.
    double rateHz = 30;
    Pace pace = Pace::Newest;
    std::optional<OverlayOptions> overlay; ///< nothing: frames are photos alone

    /// Errors: InvalidInput with a sentence.
    void validate() const;
};

} // namespace spherewalk::simulator
