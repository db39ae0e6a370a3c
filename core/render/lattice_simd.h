// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "lattice.h"

namespace spherewalk::render::simd {

/// Fills the coordinates at `count` rays (each component contiguous; all arrays may be read and written up to
/// 16 values beyond); cosine and along may be null.
struct RayArrays {
    const double* x;
    const double* y;
    const double* z;
};

void photoCoordinates(const Lattice& lattice, const RayArrays& rays, int count, double* u, double* v,
                      double* cosine, double* along);

/// The same for rays (x + i step, y, 1).
struct PixelRow {
    double x;
    double y;
    double step;
};

void affineCoordinates(const Lattice& lattice, const PixelRow& row, int count, double* u, double* v,
                       double* cosine, double* along);

/// From a row of cells' nodes: the coefficients, and the bound of the error.
void biquadratics(const Lattice& lattice, int cellY, const std::array<LatticeScratch::NodeRow, 3>& rows,
                  const LatticeScratch::Quadratics& out, double* bound);

/// The fixed-point values of one biquadratic at the samples of size x size pixels (16, 8 or 4).
struct PatchShape {
    int size;
    int samplesPerAxis;
};

void fillPatch(const PatchShape& shape, const std::array<float, 9>& coefficients, std::int32_t base,
               std::int32_t* out);

/// Exact doubles to fixed point, count of them, a multiple of 16.
void toFixed(const double* values, int count, double offset, std::int32_t* out);

/// Brings values back into [0, period) + least that are at most one period off.
void wrapFixed(std::int32_t* values, int count, std::int32_t least, std::int32_t period);

} // namespace spherewalk::render::simd
