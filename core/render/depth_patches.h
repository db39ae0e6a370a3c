// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "depth_simd.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace spherewalk::render {

class DepthMesh;

/// What a photo's surface is where it is torn, at the edges of things: rectangles of the photo that face it.
/// Of four pixels whose distances differ too much each stands by itself, or with one beside it, up to the
/// middle between them and the others. Where two by two quads have such an edge all four are made of patches,
/// joined with their neighbours where the distance is even. Threads: const, any number.
class DepthPatches {
  public:
    static constexpr int kSquare = simd::PartBoxes::kSquare; ///< quads along an edge of what is kept together
    static constexpr int kSquares = simd::PartBoxes::kSquares; ///< of a block, along an edge

    DepthPatches() = default;

    /// Of all edges of the mesh. Reads its vertices only.
    explicit DepthPatches(const DepthMesh& mesh);

    struct Range {
        std::uint32_t begin = 0, end = 0;
    };

    /// Those of a block's square: where one ends the next begins, in the order of orderInBlock(). block:
    /// counted row by row.
    Range ofSquare(std::size_t block, int square) const {
        const std::size_t index = block * (kSquares * kSquares) + static_cast<std::size_t>(square);
        return {m_first[index], m_first[index + 1]};
    }

    /// The square at these vertices of a block, in turn as a quadtree's leaves. Range: multiples of kSquare.
    static int orderInBlock(int x, int y) {
        const int column = x / kSquare;
        const int row = y / kSquare;
        return row / 2 * 8 + column / 2 * 4 + row % 2 * 2 + column % 2;
    }

    /// Those of squares that follow each other may be had together.
    simd::SurfacePatches at(Range range) const;

  private:
    struct Patch;

    static std::pair<int, int> placeInBlock(int square);
    static void addSquare(const DepthMesh& mesh, int left, int top, std::vector<Patch>& patches);
    static void addQuad(const DepthMesh& mesh, int x, int y, std::vector<Patch>& patches);
    static void addEdge(const DepthMesh& mesh, int x, int y, std::vector<Patch>& patches);
    static void add(Patch patch, std::vector<Patch>& patches);
    void keep(const DepthMesh& mesh, const std::vector<Patch>& patches);

    std::vector<std::uint32_t> m_first;         ///< of each square, and the end
    std::array<std::vector<float>, 4> m_cosine; ///< as SurfacePatches
    std::array<std::vector<float>, 4> m_sine;
    std::array<std::vector<float>, 4> m_inverse;
};

} // namespace spherewalk::render
