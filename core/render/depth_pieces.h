// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// The flat pieces that a surface is drawn as. The same bytes on every processor.
namespace spherewalk::render::simd {

/// Quads as the camera sees them, their vertices in turn.
struct Quads {
    static constexpr int kMost = 64;
    static constexpr int kMore = 16;                             ///< SIMD writes as many beyond the last
    std::array<std::array<float, kMost + kMore>, 4> x, y, value; ///< as ProjectedPart
    int count = 0;
};

/// Flat pieces side by side, one for each of the quads.
struct PieceColumns {
    using Floats = std::array<float, Quads::kMost>;
    using Pixels = std::array<std::int32_t, Quads::kMost>;
    std::array<Floats, 4> a, b, c;
    Floats slopeX, slopeY, base, least, most;
    Pixels left, top, right, bottom; ///< none if left is beyond right, or top below bottom
    Floats sign;                     ///< 0 of quads that are not convex
};

/// A flat convex piece with up to four edges. A pixel lies inside if a x + b y + c >= 0 for each.
struct Piece {
    std::array<float, 4> a, b, c;
    float slopeX, slopeY, base; ///< value = slopeX x + slopeY y + base
    float least, most;
    int left, top, right, bottom; ///< pixels that it may cover, the last ones included
};

/// What the quads are in a view of that size. A convex quad is one piece, whose values are the plane's
/// through its middle that rises as its diagonals do; another is two triangles. Those with a vertex that is
/// not placed have no pixels.
void cut(const Quads& quads, int width, int height, PieceColumns& columns);

/// Adds the pieces that a quad is, of those that were cut.
void add(const Quads& quads, const PieceColumns& columns, std::size_t quad, std::vector<Piece>& pieces);

/// How many columns a buffer's rows have more than a view needs: multiples of this.
constexpr int kColumns = 16;

/// Draws rows [begin, end) of the pieces: the greater value wins. Range: pitch a multiple of kColumns.
void draw(std::span<const Piece> pieces, int begin, int end, float* values, std::ptrdiff_t pitch);

} // namespace spherewalk::render::simd
