// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/view.h"

#include <chrono>

namespace spherewalk::simulator {

/// Simulation time since its zero.
using Stamp = std::chrono::nanoseconds;

/// Whether a simulator's objects were laid into a frame.
enum class OverlayUse {
    NotWanted,
    Laid,
    Missing, ///< none came for this frame in time
};

/// What the camera saw at one pose.
struct Frame {
    Stamp stamp{};         ///< of the pose that was rendered, unchanged
    Rigid3 roomFromCamera; ///< of the optical frame
    CameraIntrinsics camera;
    render::View view;
    OverlayUse overlay = OverlayUse::NotWanted;
    bool isOutside = false; ///< of the dataset's outline, or below its floor or above its ceiling
    double trust = 0;       ///< ViewReport::trust; 0 where isOutside
    std::chrono::steady_clock::time_point poseTakenAt; ///< when the pose was handed over
};

} // namespace spherewalk::simulator
