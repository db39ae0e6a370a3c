// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "pixels/photo_plane.h"
#include "sphere/lattice.h"

namespace spherewalk::render::simd {

constexpr double kOffsetU = PlaneLayout::kGuard + kRoundingU; ///< Fixed point has so many pixels more.
constexpr double kOffsetV = PlaneLayout::kGuard;

/// Rays, each component contiguous.
struct RayArrays {
    const double* x;
    const double* y;
    const double* z;
};

/// The rays (x + i step, y, 1).
struct PixelRow {
    double x;
    double y;
    double step;
};

// All functions may read and write arrays up to 16 values beyond their count.

/// Computes the coordinates of so many rays, and the other values of `out` that are not null.
void photoCoordinates(const LatticeFrame& frame, const RayArrays& rays, int count, const NodeValues& out);
void affineCoordinates(const LatticeFrame& frame, const PixelRow& row, int count, const NodeValues& out);

/// Computes the bound of the error in each cell of a row. It uses cosine and along of `centres`.
void errorBounds(const LatticeFrame& frame, int cellY, const NodeValues& centres, double* bound);

/// Computes the patches [begin, end) of a row from its three rows of nodes.
void fitPatches(const LatticeFrame& frame, const std::array<NodeRow, 3>& rows, int begin, int end,
                const PatchRow& out);

/// Computes the coordinates of a cell that is cut into parts x parts patches (1, 2 or 4). rows: as many rows
/// of patches.
void fillCoordinates(const PatchRow* rows, int parts, int cellX, int samplesPerAxis, std::int32_t* u,
                     std::int32_t* v);

/// The same as places and fractions: see LatticeRow::places().
void fillPlaces(const PatchRow* rows, int parts, int cellX, int samplesPerAxis, const Placing& placing,
                std::int32_t* places, std::int32_t* fractions);

/// Turns u into places and v into fractions. count: a multiple of 16.
void locate(const Placing& placing, int count, std::int32_t* u, std::int32_t* v);

/// Turns exact doubles into fixed point. offset: pixels that are added. count: a multiple of 16.
void toFixed(const double* values, int count, double offset, std::int32_t* out);

/// Brings values back to [least, least + period). They may be one period off at most.
void wrapFixed(std::int32_t* values, int count, std::int32_t least, std::int32_t period);

} // namespace spherewalk::render::simd
