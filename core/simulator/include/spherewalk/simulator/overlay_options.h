// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/simulator/frame.h"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace spherewalk::simulator {

/// How the simulator's objects are told from its model of the room, which the depth camera sees as well.
enum class ObjectsBy {
    Labels, ///< a segmentation camera says which pixels are the room's
    Depth,  ///< they are nearer than the room of the dataset's outline
    Alone,  ///< the depth camera sees nothing but them
};

/// "labels", "depth", "alone". Errors of the latter: InvalidInput.
std::string_view name(ObjectsBy by);
ObjectsBy objectsBy(std::string_view name);

/// Pictures of the simulator's objects, taken by cameras at the same place as the one that is simulated.
struct OverlayOptions {
    ObjectsBy by = ObjectsBy::Labels;
    /// With ObjectsBy::Labels, what shows the photo: nothing, and the room's own model. All else are objects.
    std::vector<std::uint8_t> roomLabels = {0, 1};
    /// With ObjectsBy::Depth, how much nearer than the room an object is at least: the larger of metres and
    /// share of the room's depth.
    double nearerM = 0.02;
    double nearerShare = 0.01;
    /// How much later, in simulation time, a pose may be before a frame is rendered without an overlay.
    Stamp wait = std::chrono::milliseconds(500);
    std::optional<CameraIntrinsics> camera; ///< that took the pictures; nothing: the simulated one

    /// Errors: InvalidInput with a sentence for what is out of range: wait up to 10 s, distances 0 or more.
    void validate() const;
};

enum class OverlayPart { Colour, Depth, Labels };

/// Pictures of one pose; empty are those that have not come. Shape: all the same.
struct OverlayParts {
    RgbImage colour;
    DepthImage depth; ///< z along the optical axis, metres
    MaskImage labels;

    /// Those of the other that have come, in place of its own.
    void take(OverlayParts&& other);

    bool isWhole(ObjectsBy by) const {
        return !colour.empty() && !depth.empty() && (by != ObjectsBy::Labels || !labels.empty());
    }
};

} // namespace spherewalk::simulator
