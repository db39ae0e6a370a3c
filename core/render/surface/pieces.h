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

/// A flat convex piece with up to four edges. A pixel lies inside if a x + b y + c >= 0 for each.
struct Piece {
    struct Plane {
        float slopeX, slopeY, base; ///< value = slopeX x + slopeY y + base
        float least;
    };

    struct Box {
        std::int32_t left, top, right, bottom;
    };

    std::array<float, 4> a, b, c;
    Plane plane;
    Box box; ///< pixels that it may cover, the last ones included
    float most;
};

/// The pieces that quads are, as SIMD makes them: by fours of their values.
struct CutQuads {
    template <class Value>
    using Fours = std::array<Value, std::size_t{4} * Quads::kMost>;

    Fours<float> a, b, c, plane;
    Fours<std::int32_t> box; ///< without pixels if left is beyond right, or top below bottom
    std::array<float, Quads::kMost> most;
    std::array<float, Quads::kMost> sign; ///< 0 of quads that are not convex

    Piece::Box boxOf(std::size_t quad) const {
        return {box[4 * quad], box[4 * quad + 1], box[4 * quad + 2], box[4 * quad + 3]};
    }
};

/// What the quads are in a view of that size. A convex quad is one piece, whose values are the plane's
/// through its middle that rises as its diagonals do; another is two triangles. Those with a vertex that is
/// not placed have no pixels.
void cut(const Quads& quads, int width, int height, CutQuads& cut);

/// Adds the pieces that a quad is, of those that were cut.
void add(const Quads& quads, const CutQuads& cut, std::size_t quad, std::vector<Piece>& pieces);

/// How many columns a buffer's rows have more than a view needs: multiples of this.
constexpr int kColumns = 16;

/// Draws rows [begin, end) of the pieces: the greater value wins. Range: pitch a multiple of kColumns.
void draw(std::span<const Piece> pieces, int begin, int end, float* values, std::ptrdiff_t pitch);

} // namespace spherewalk::render::simd
