// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/angle.h"
#include "spherewalk/photo/sketch.h"

#include <array>
#include <span>

namespace spherewalk::photo {

/// How a photo compares with one that was taken near it.
struct SketchMatch {
    double likeness = 0; ///< correlation of brightness at the best turn, [-1, 1]
    double upsideDownLikeness = 0;
    Radians turn; ///< of the photo against the other one, counter-clockwise; (-pi, pi]
    /// The photo's colours over the other one's: the median over what both show.
    std::array<double, 3> gains{1, 1, 1};
};

/// Cost: about 5 ms.
SketchMatch match(const Sketch& photo, const Sketch& other);

/// A matched neighbour.
struct MatchedSketch {
    const Sketch* sketch = nullptr;
    SketchMatch match;
    double distanceM = 0; ///< between the two positions
};

/// The largest connected area of a photo that none of its neighbours shows anywhere near.
struct ForeignArea {
    double part = 0; ///< of the sphere
    Radians azimuth; ///< of its middle, in the photo's panorama frame
    Radians elevation;
};

/// What is closer than 0.7 m counts as foreign, and what is right above or below the camera is not looked at.
/// Cost: about 10 ms a neighbour 20 cm away, growing with the square of the distance.
ForeignArea foreignArea(const Sketch& photo, std::span<const MatchedSketch> neighbours);

} // namespace spherewalk::photo
