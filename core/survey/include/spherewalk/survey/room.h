// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/polygon.h"

#include <cstddef>
#include <vector>

namespace spherewalk::survey {

inline constexpr double kLargestRoomM = 2000;         ///< longest side of a room's bounds
inline constexpr double kFarthestCoordinateM = 1e8;   ///< beyond it a double no longer holds a micrometre
inline constexpr std::size_t kMostRoomCorners = 2000; ///< of the outline and all obstacles together

/// The room's shape. Frames: room. Units: metres.
struct Room {
    Polygon outline;                ///< the walls on the floor; may be concave
    std::vector<Polygon> obstacles; ///< what stands on the floor and the rail cannot pass; may overlap a wall
    double ceilingM = 0;

    /// Errors: InvalidInput, naming the polygon and its defect, an obstacle that lies wholly outside the
    /// outline, a room beyond the limits above, or a ceiling that is not positive.
    void validate() const;
};

} // namespace spherewalk::survey
