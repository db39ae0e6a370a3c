// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/sensor.h"
#include "spherewalk/render/view.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace spherewalk::simulator {

/// Simulation time since its zero.
using Stamp = std::chrono::nanoseconds;

/// Whether a simulator's objects were laid into a frame.
enum class OverlayUse {
    NotWanted,
    Laid,
    Missing, ///< No overlay came in time for this frame.
};

/// A camera's view from one pose.
struct Frame {
    std::size_t index = 0; ///< Which camera of a rig: 0 for the first, or the only one.
    Stamp stamp{};         ///< The stamp of the rendered pose, unchanged; that of all cameras of a rig.
    Rigid3 roomFromCamera; ///< Pose of the optical frame.
    CameraIntrinsics camera;
    double baselineM = 0; ///< How far right of the rig's first camera: render::stereoBaselineM().
    render::View view;
    std::optional<render::SensorReport> sensor; ///< How the sensor took it; nothing without one.
    OverlayUse overlay = OverlayUse::NotWanted;
    std::chrono::steady_clock::time_point poseTakenAt; ///< When the pose was handed over.
};

/// The box about all pixels that show one label. Units: pixels; the corners are the outermost pixels
/// themselves, so a single pixel is its own left, top, right and bottom.
struct LabelBox {
    std::uint16_t label = 0;
    int left = 0;
    int top = 0;
    int right = 0;
    int bottom = 0;

    bool operator==(const LabelBox&) const = default;
};

/// The boxes of all labels of a picture but 0, the room, with the least label first.
std::vector<LabelBox> labelBoxes(const render::LabelImage& labels);

} // namespace spherewalk::simulator
