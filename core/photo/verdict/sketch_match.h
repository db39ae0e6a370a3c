// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/angle.h"
#include "spherewalk/photo/sketch.h"

#include <array>
#include <cstdint>
#include <span>

namespace spherewalk::photo {

/// The brightness of a pixel's red, green and blue as the eye weighs them, [0, 255]. Source: ITU-R BT.601.
inline float brightness(const std::uint8_t* rgb) {
    return 0.299F * static_cast<float>(rgb[0]) + 0.587F * static_cast<float>(rgb[1]) +
           0.114F * static_cast<float>(rgb[2]);
}

/// How a photo compares with one that was taken near it.
struct SketchMatch {
    double likeness = 0;           ///< Correlation of brightness at the best turn, in [-1, 1].
    double upsideDownLikeness = 0; ///< The same for the photo turned upside down.
    Radians turn; ///< Turn of the photo against the other one, counter-clockwise, in (-pi, pi].
    /// Ratio of the photo's red, green and blue to the other one's: the median over what both show.
    std::array<double, 3> gains{1, 1, 1};
};

/// Compares two photos at every turn. Cost: about 5 ms.
SketchMatch match(const Sketch& photo, const Sketch& other);

/// A neighbour with its match.
struct MatchedSketch {
    const Sketch* sketch = nullptr;
    SketchMatch match;
    double distanceM = 0; ///< Distance between the two positions.
};

/// The largest connected area of a photo that none of its neighbours shows anywhere near.
struct ForeignArea {
    double part = 0; ///< Part of the sphere, in [0, 1].
    Radians azimuth; ///< Direction of the area's middle in the photo's panorama frame.
    Radians elevation;
};

/// Finds the largest foreign area. Things closer than 0.4 m count as foreign; the areas right above and below
/// the camera are not searched.
/// Cost: about 10 ms a neighbour 20 cm away, growing with the square of the distance.
ForeignArea foreignArea(const Sketch& photo, std::span<const MatchedSketch> neighbours);

} // namespace spherewalk::photo
