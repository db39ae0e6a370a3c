// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sweep_picture.h"

#include <cstdint>
#include <stop_token>
#include <vector>

namespace spherewalk::scene {

/// A cost for each pixel and each of some distances: [y][x][distance].
template <class Value>
struct CostVolume {
    CostVolume(int widthPx, int heightPx, int distanceCount)
        : width(widthPx),
          height(heightPx),
          distances(distanceCount),
          values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                 static_cast<std::size_t>(distances)) {}

    Value* at(int x, int y) {
        return values.data() +
               (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
                   static_cast<std::size_t>(distances);
    }

    const Value* at(int x, int y) const { return const_cast<CostVolume*>(this)->at(x, y); }

    int width;
    int height;
    int distances;
    std::vector<Value> values;
};

/// What a change of distance from a pixel to the next costs.
struct PathPenalties {
    float step = 6;  ///< to the next distance
    float jump = 60; ///< to any other where the picture is even; less at its edges, never less than 1.5 steps
};

/// The costs with those along eight paths to each pixel added (semi-global matching). The horizontal ones go
/// round the seam. threads: the result is the same for any number. Errors: Stopped.
/// Source: Hirschmueller 2008.
CostVolume<std::int16_t> aggregatedOverPaths(const CostVolume<std::uint8_t>& costs, const SweepPicture& guide,
                                             const PathPenalties& penalties, int threads,
                                             const std::stop_token& stop);

} // namespace spherewalk::scene
