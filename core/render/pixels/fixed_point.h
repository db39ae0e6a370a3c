// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace spherewalk::render {

/// Photo coordinates in fixed point, and the places that samplers read. (0, 0) is the centre of the photo's
/// pixel (-PlaneLayout::kGuard, -PlaneLayout::kGuard). u points right, v points down.
constexpr int kFractionBits = 16;

/// Units of fixed point in a pixel.
constexpr int kFixedOne = 1 << kFractionBits;

/// Pixels that u has more than the coordinate: half of the horizontal weights' step. Cutting bits off then
/// rounds.
constexpr double kRoundingU = 1.0 / 510;

/// A view is computed in cells of so many pixels along each axis.
constexpr int kCell = 16;

/// How coordinates become places. A place is the number of bytes from a plane's first pixel to a sample's
/// upper left pixel.
struct Placing {
    int stride;             ///< Pixels from one of the plane's rows to the next.
    std::int32_t roundingU; ///< These are added, so that cutting bits off rounds as the sampling needs.
    std::int32_t roundingV;
};

} // namespace spherewalk::render
