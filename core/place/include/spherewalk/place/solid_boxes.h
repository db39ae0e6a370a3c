// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/place/seen_depth.h"
#include "spherewalk/place/surface.h"

#include <Eigen/Geometry>

#include <span>
#include <stop_token>
#include <vector>

namespace spherewalk::place {

struct BoxOptions {
    double cellM = 0.04; ///< Edge of the cells that boxes are made of.
    double floorM = 0;   ///< Height of the floor in the room.
    int threads = 0;     ///< 0: all that the machine has. The result is the same for any number.

    /// Errors: InvalidInput for a cell that is not 5 mm to 1 m.
    void validate() const;
};

/// Boxes that together stand where things are, for collisions. They lie along the room's axes, and do not
/// overlap. A cell is solid if the surface passes through it. It is solid, too, if it lies below such a cell,
/// down to the floor or to the first cell that is free (see spaceAt()): things stand on something, and sides
/// that nobody saw are closed. Below a mirror's cell the floor that photos show is its reflection. things: a
/// surface of triangles smaller than cells, see furnitureOf(). photos: those that saw it. Errors: those of
/// BoxOptions::validate(), and InvalidInput for a surface that would need more than 2^28 cells. Stop:
/// Stopped. Cost: about a second of one core for ten million cells and photos.
std::vector<Eigen::AlignedBox3d> solidBoxes(const Surface& things, std::span<const SeenDepth> photos,
                                            const BoxOptions& options, const std::stop_token& stop = {});

/// Boxes that close a surface from behind, where nobody saw it: as solidBoxes(), but none of their cells is
/// seen through at any of four points (see isSeenThrough()), and along x and y they end half a cell inside of
/// things, so that what was seen stands in front of them. What is thinner than two cells, as a leg, keeps
/// whole cells. Errors, Stop: as for solidBoxes().
std::vector<Eigen::AlignedBox3d> closingBoxes(const Surface& things, std::span<const SeenDepth> photos,
                                              const BoxOptions& options, const std::stop_token& stop = {});

/// Adds the sides of boxes to a surface, in grey, as nobody saw them. With boxes that are inset, a surface
/// with holes is closed, and what was seen of it stays in front.
void addBoxes(Surface& surface, std::span<const Eigen::AlignedBox3d> boxes);

} // namespace spherewalk::place
