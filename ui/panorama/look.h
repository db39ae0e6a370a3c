// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/angle.h"
#include "spherewalk/geometry/camera_model.h"
#include "spherewalk/geometry/rigid3.h"

namespace spherewalk::ui {

/// Where the viewer of a panorama looks. Frames: room.
struct Look {
    static constexpr Degrees kNarrowest{10};
    static constexpr Degrees kWidest{120};

    Radians yaw;                 ///< counter-clockwise, (-pi, pi]
    Radians up;                  ///< above the horizon, [-pi/2, pi/2]
    Radians fov = Degrees(90.0); ///< across the picture

    /// Range: any; up stops at the poles.
    void turn(Radians left, Radians higher);
    /// factor > 1 widens the field of view.
    void zoom(double factor);

    /// Of the camera's optical frame.
    Rigid3 roomFromCamera(const Eigen::Vector3d& at) const;
    /// Range: sizes of 1 and more.
    CameraIntrinsics camera(int width, int height) const;
};

} // namespace spherewalk::ui
