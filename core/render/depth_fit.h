// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "depth_locate.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// Photo coordinates of a view's cells as polynomials. The same bytes on every processor.
namespace spherewalk::render::simd {

/// A row of cells of a view without distortion, whose rays are (x, y, 1). Cells have nodes at their pixels 0,
/// 7 and 14 along each axis.
struct NodeRays {
    static constexpr std::array<int, 3> kNodes{0, 7, 14};

    std::array<const float*, 3> x; ///< of each cell's nodes
    std::array<float, 3> y;
    float stepX; ///< from one pixel to the next
    float stepY;
};

/// Coordinates of the pixels of a row of cells as polynomials of second degree in x, y and the inverse depth
/// w, through 3 x 3 x 3 places each. Since directions are linear in each of these, all that moves along a
/// line through them moves along a great circle: with g the speed at the nearest point, its acceleration is
/// at most g^2 and its jerk 2 g^3, which the bounds (2) of lattice.h take to third derivatives. As there, the
/// error is at most
///     h^3 / (9 sqrt 3) (max|d3f/dx3| + 1.61 max|d3f/dy3| + 1.61^2 max|d3f/dw3|),
/// h being half of what the nodes span, and 1.61 by how much interpolating up to pixel 15 enlarges.
struct CellFits {
    static constexpr std::size_t kTerms = 27;
    static constexpr float kTolerancePx = 0.03F;

    explicit CellFits(int cells);

    std::size_t pitch;
    /// Of x^i y^j w^k at [9 k + 3 j + i] for all cells, each variable from -1 to 1. Units: 2^-16 pixels.
    std::vector<float> u;
    std::vector<float> v;
    std::vector<std::int32_t> middleU; ///< what the terms are relative to
    std::vector<std::int32_t> middleV;
    std::vector<float> errorPx; ///< bound, in pixels at the photo's equator; may be infinite or no number
    std::vector<float> inverse; ///< that is 0 in w
    std::vector<float> perSpan; ///< from inverse depth to w
};

/// Fits a row's cells that are wanted, where that is 1. least, greatest: inverse depth of each, with room for
/// 16 more.
void fit(const PhotoTarget& target, const NodeRays& rays, const float* least, const float* greatest,
         std::span<const std::uint8_t> isWanted, CellFits& fits);

/// As the other locate(), but u may lie beyond the seam. Range: errorPx is bounded.
void locate(const CellFits& fits, int cell, const float* inverse, std::ptrdiff_t pitch, std::int32_t* u,
            std::int32_t* v);

/// How coordinates change from one pixel to the next about pixel (7, 7), where the inverse depth is that:
/// du/dx, dv/dx, du/dy, dv/dy in fixed point.
std::array<std::int32_t, 4> slopes(const CellFits& fits, int cell, float inverse);

} // namespace spherewalk::render::simd
