// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "lattice.h"
#include "photo_plane.h"

namespace spherewalk::render::simd {

constexpr double kOffsetU = PlaneLayout::kGuard + kRoundingU; ///< of fixed point
constexpr double kOffsetV = PlaneLayout::kGuard;

/// Rays, each component contiguous.
struct RayArrays {
    const double* x;
    const double* y;
    const double* z;
};

/// Rays (x + i step, y, 1).
struct PixelRow {
    double x;
    double y;
    double step;
};

// Arrays may be read and written up to 16 values beyond their count.

/// The coordinates, and what else of `out` is not null, of so many rays.
void photoCoordinates(const Lattice& lattice, const RayArrays& rays, int count, const NodeValues& out);
void affineCoordinates(const Lattice& lattice, const PixelRow& row, int count, const NodeValues& out);

/// The bound of the error in each cell of a row; of `centres`, cosine and along are used.
void errorBounds(const Lattice& lattice, int cellY, const NodeValues& centres, double* bound);

/// The patches [begin, end) of a row from its three rows of nodes.
void fitPatches(const Lattice& lattice, const std::array<NodeRow, 3>& rows, int begin, int end,
                const PatchRow& out);

/// The coordinates, or places and fractions, of a cell that is cut into parts x parts patches (1, 2 or 4), of
/// as many rows.
void fillCoordinates(const PatchRow* rows, int parts, int cellX, int samplesPerAxis, std::int32_t* u,
                     std::int32_t* v);
void fillPlaces(const PatchRow* rows, int parts, int cellX, int samplesPerAxis, const Placing& placing,
                std::int32_t* places, std::int32_t* fractions);

/// Makes places of u and fractions of v, count of them, a multiple of 16.
void locate(const Placing& placing, int count, std::int32_t* u, std::int32_t* v);

/// Exact doubles to fixed point, count of them, a multiple of 16.
void toFixed(const double* values, int count, double offset, std::int32_t* out);

/// Brings values back into [0, period) + least that are at most one period off.
void wrapFixed(std::int32_t* values, int count, std::int32_t least, std::int32_t period);

} // namespace spherewalk::render::simd
