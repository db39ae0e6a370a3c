// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/photo/april_tag.h"

#include <optional>
#include <span>

namespace spherewalk::photo {

/// A pixel near a tag, on a plane that touches the sphere of directions there. Frames: x right, y down.
struct TagPixel {
    Eigen::Vector2d at;
    double grey = 0;
};

struct TagFit {
    TagCorners<Eigen::Vector2d> corners; ///< On the same plane.
    double sigma = 0;                    ///< Standard deviation of a corner along either axis.
};

/// Moves the corners to where the tag's whole pattern fits the pixels best: least squares over a homography,
/// the light (with a gradient), the blur, and how much white outshines black. pitch: distance of neighbouring
/// pixels. Empty if the pattern is not there.
std::optional<TagFit> fittedTag(const TagCells& cells, std::span<const TagPixel> pixels, double pitch,
                                const TagCorners<Eigen::Vector2d>& about);

} // namespace spherewalk::photo
