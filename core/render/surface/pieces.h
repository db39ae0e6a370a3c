// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// The flat pieces that a surface is drawn as. The bytes are the same on every processor.
namespace spherewalk::render::simd {

/// Quads as the camera sees them, with their vertices in turn.
struct Quads {
    static constexpr int kMost = 64;
    static constexpr int kMore = 16; ///< SIMD writes so many values beyond the last.
    std::array<std::array<float, kMost + kMore>, 4> x, y, value; ///< As in ProjectedBlock.
    int count = 0;
};

/// A flat convex piece with up to four edges. A pixel lies inside if a x + b y + c >= 0 for each edge.
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
    Box box; ///< The pixels that it may cover, the last ones included.
    float most;
};

/// The pieces of quads as SIMD makes them: each value is a group of four.
struct CutQuads {
    template <class Value>
    using Fours = std::array<Value, std::size_t{4} * Quads::kMost>;

    Fours<float> a, b, c, plane;
    Fours<std::int32_t> box; ///< A box without pixels has left beyond right, or top below bottom.
    std::array<float, Quads::kMost> most;
    std::array<float, Quads::kMost> sign; ///< This is 0 for quads that are not convex.

    Piece::Box boxOf(std::size_t quad) const {
        return {box[4 * quad], box[4 * quad + 1], box[4 * quad + 2], box[4 * quad + 3]};
    }
};

/// Cuts quads into pieces for a view of that size. A convex quad becomes one piece, and any other two
/// triangles. The piece's plane goes through the quad's middle and rises as its diagonals do. A quad with a
/// vertex that is not in front of the camera has no pixels.
void cut(const Quads& quads, int width, int height, CutQuads& cut);

/// Adds the pieces of a quad that was cut.
void add(const Quads& quads, const CutQuads& cut, std::size_t quad, std::vector<Piece>& pieces);

/// The rows of a buffer have a multiple of so many columns.
constexpr int kColumns = 16;

/// Draws rows [begin, end) of the pieces. Of two values the greater wins. Range: pitch a multiple of
/// kColumns.
void draw(std::span<const Piece> pieces, int begin, int end, float* values, std::ptrdiff_t pitch);

} // namespace spherewalk::render::simd
