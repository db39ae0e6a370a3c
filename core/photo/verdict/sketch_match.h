// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/angle.h"
#include "spherewalk/photo/sketch.h"
#include "spherewalk/photo/verdict.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

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
    double distanceM = 0;  ///< Distance between the two positions.
    std::string_view name; ///< Owner: the caller
};

/// By how many stops the photo is brighter than the other one.
double stopsBrighter(const SketchMatch& match);

/// By how many stops the photo is brighter than the neighbour, but for what both say of their exposures.
/// Nothing is left where these explain the whole difference.
double unexplainedStops(const Sketch& photo, const MatchedSketch& neighbour);

/// By how much a photo differs from its neighbours.
struct StandsApart {
    double by = 0;          ///< 0 for a photo that does not stand apart.
    bool isCertain = false; ///< Whether several photos agree that it is this one, and not a neighbour.
    std::size_t other = 0;  ///< Index of the nearest neighbour that it differs from.
};

/// The other photos that one is compared with, the nearest first.
struct Others {
    std::vector<MatchedSketch> near; ///< Its neighbours.
    /// Those that stand next. They are matched when they are first asked for, which most photos never do.
    std::function<std::vector<MatchedSketch>()> around;
};

/// Matches the neighbours at once. Owner: the caller keeps the photo and the neighbours as long as the
/// result.
Others matched(const Sketch& photo, std::span<const Neighbour> neighbours);

/// Tells whether a photo stands apart in a quantity. difference: the photo's value minus the other one's.
/// limit: smaller differences are no fault.
///
/// A photo that differs from less than half of its neighbours and itself does not stand apart, whatever those
/// around show. Otherwise all others decide. A value that more than a quarter of them share is no fault: part
/// of a room may be darker.
StandsApart standsApart(const Others& others, double limit,
                        const std::function<double(const MatchedSketch&)>& difference);

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
