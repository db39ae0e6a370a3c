// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/rigid3.h"

namespace spherewalk::simulator {

/// Which way a camera's frame looks.
enum class CameraAxes {
    Body,    ///< x forward, y left, z up: links of simulators
    Optical, ///< z forward, x right, y down: frames whose names end in _optical
};

/// How a simulator's pose becomes that of the camera in the room.
struct Mounting {
    Rigid3 roomFromWorld;               ///< identity where the simulator's world is the dataset's room
    Rigid3 linkFromCamera;              ///< of the camera's frame on the link whose poses come
    CameraAxes axes = CameraAxes::Body; ///< of the camera's frame

    /// Of the optical frame.
    Rigid3 roomFromOptical(const Rigid3& worldFromLink) const;

    /// Errors: InvalidInput for transforms that are not finite or not turned by unit quaternions.
    void validate() const;
};

} // namespace spherewalk::simulator
