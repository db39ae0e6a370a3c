// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/overlay.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace spherewalk::jobs {

/// A ball in the room. It stands for an object that a simulator would render into a view.
struct Ball {
    Eigen::Vector3d centreM = Eigen::Vector3d::Zero(); ///< Room frame.
    double radiusM = 0.2;
    std::array<std::uint8_t, 3> colour = {215, 60, 30}; ///< Red, green, blue.

    /// Errors: InvalidInput for numbers that are not finite, and for a radius of zero or less.
    void validate() const;
};

/// The ball that "x y z radius" spells, in metres. Errors: InvalidInput.
Ball parseBall(std::string_view text);

/// Colour and depth of the ball as a simulator would render it from the view's own pose, lit from above. The
/// pictures are empty where the camera stands in the ball or does not see it.
///
/// Errors: those of Ball::validate().
/// Cost: about 0.1 microseconds for each pixel of the box around the ball.
render::Overlay ballOverlay(const Ball& ball, const CameraModel& camera, const Rigid3& roomFromCamera);

/// 255 in each pixel at whose centre the ball would be seen if nothing hid it, else 0: the pixels of
/// ballOverlay().
MaskImage ballMask(const Ball& ball, const CameraModel& camera, const Rigid3& roomFromCamera);

} // namespace spherewalk::jobs
