// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/image.h"
#include "spherewalk/base/progress.h"
#include "spherewalk/geometry/polygon.h"
#include "spherewalk/place/seen_depth.h"
#include "spherewalk/place/surface.h"

#include <Eigen/Core>

#include <span>
#include <stop_token>
#include <string>

namespace spherewalk::place {

/// Values of cells, as map_server and Nav2 write and read them.
enum OccupancyCell : std::uint8_t { kOccupied = 0, kUnknown = 205, kFree = 254 };

struct OccupancyOptions {
    double cellM = 0.05;
    double floorM = 0;          ///< Height of the floor in the room.
    double leastHeightM = 0.05; ///< Above the floor; what is lower, a robot drives over.
    double mostHeightM = 1.8;   ///< Above the floor; a robot passes below what is higher.
    Polygon outline = {}; ///< Of the room; cells more than 15 cm beyond are unknown. Empty: no such limit.
    int threads = 0;      ///< 0: all that the machine has.

    /// Errors: InvalidInput for a cell that is not 1 cm to 1 m, and heights that are not finite or do not
    /// rise.
    void validate() const;
};

/// A map of where a robot can drive. Frames: rows run from the greatest y to the least, columns along x.
struct OccupancyGrid {
    Eigen::Vector2d originM = Eigen::Vector2d::Zero(); ///< The lower left corner of the lower left cell.
    double cellM = 0;
    MaskImage cells; ///< Values of OccupancyCell.
};

/// The map of what was seen. A cell is occupied if there is a surface of 10 square centimetres or more
/// between the two heights. Where nothing is sure, two photos that are not sure make it occupied, too, unless
/// more look through. A cell is free if neither holds and a quarter of its floor is seen, or if photos look
/// through nine tenths of its lower half, between the heights. All other cells are unknown. Errors:
/// InvalidInput for options, a surface without triangles, and a map of more than 2^28 cells. Stop: Stopped.
OccupancyGrid occupancyOf(const Surface& surface, std::span<const SeenDepth> photos,
                          const OccupancyOptions& options, const std::stop_token& stop);

/// The map as a binary PGM of 8 bits.
Bytes pgmFile(const OccupancyGrid& grid);

/// What map_server and Nav2 read beside the PGM. image: its file name.
std::string mapYaml(const OccupancyGrid& grid, const std::string& image);

} // namespace spherewalk::place
