// SPDX-License-Identifier: Apache-2.0
#include "depth_patches.h"

#include "depth_mesh.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace spherewalk::render {

/// A rectangle of a photo with 1 / distance at its corners, in turn from the upper left. Units: half pixels.
struct DepthPatches::Patch {
    int left, top, right, bottom;
    std::array<float, 4> inverseM;

    /// Both as one, if they are beside each other and even.
    std::optional<Patch> with(const Patch& next) const {
        if (left == next.left && right == next.right && bottom == next.top) {
            const float share = static_cast<float>(bottom - top) / static_cast<float>(next.bottom - top);
            return isEven(next, 0, 3, share) && isEven(next, 1, 2, share)
                       ? std::optional(Patch{left,
                                             top,
                                             right,
                                             next.bottom,
                                             {inverseM[0], inverseM[1], next.inverseM[2], next.inverseM[3]}})
                       : std::nullopt;
        }
        if (top == next.top && bottom == next.bottom && right == next.left) {
            const float share = static_cast<float>(right - left) / static_cast<float>(next.right - left);
            return isEven(next, 0, 1, share) && isEven(next, 3, 2, share)
                       ? std::optional(Patch{left,
                                             top,
                                             next.right,
                                             bottom,
                                             {inverseM[0], next.inverseM[1], next.inverseM[2], inverseM[3]}})
                       : std::nullopt;
        }
        return std::nullopt;
    }

  private:
    /// Whether 1 / distance goes evenly along a side of both, from my first corner to the next one's last.
    /// share: of the way that is mine.
    bool isEven(const Patch& next, std::size_t first, std::size_t last, float share) const {
        constexpr float kUneven = 0.003F;
        const float even = inverseM[first] + share * (next.inverseM[last] - inverseM[first]);
        return std::abs(inverseM[last] - even) <= kUneven * even &&
               std::abs(next.inverseM[first] - even) <= kUneven * even;
    }
};

DepthPatches::DepthPatches(const DepthMesh& mesh) {
    std::vector<Patch> patches;
    for (int block = 0; block < mesh.blocksX() * mesh.blocksY(); ++block) {
        for (int square = 0; square < kSquares * kSquares; ++square) {
            const auto [x, y] = placeInBlock(square);
            const int left = block % mesh.blocksX() * DepthMesh::kBlock + x;
            const int top = block / mesh.blocksX() * DepthMesh::kBlock + y;
            patches.clear();
            addSquare(mesh, left, top, patches);
            keep(mesh, patches);
        }
    }
    m_first.push_back(static_cast<std::uint32_t>(m_cosine[0].size()));
    for (auto* of : {&m_cosine, &m_sine, &m_inverse}) {
        for (std::vector<float>& values : *of) {
            values.resize(values.size() + simd::Quads::kMore); // SIMD reads beyond the end
            values.shrink_to_fit();
        }
    }
}

/// The other way round than orderInBlock().
std::pair<int, int> DepthPatches::placeInBlock(int square) {
    return {(square / 4 % 2 * 2 + square % 2) * kSquare, (square / 8 * 2 + square / 2 % 2) * kSquare};
}

simd::SurfacePatches DepthPatches::at(Range range) const {
    simd::SurfacePatches patches;
    for (std::size_t i = 0; i < 4; ++i) {
        patches.cosine[i] = m_cosine[i].data() + range.begin;
        patches.sine[i] = m_sine[i].data() + range.begin;
        patches.inverseM[i] = m_inverse[i].data() + range.begin;
    }
    patches.count = static_cast<int>(range.end - range.begin);
    return patches;
}

void DepthPatches::addSquare(const DepthMesh& mesh, int left, int top, std::vector<Patch>& patches) {
    for (int y = top; y < std::min(top + kSquare, mesh.height() - 1); y += 2) {
        for (int x = left; x < left + kSquare; x += 2) {
            const int quads = mesh.hasEdge(x, y) ? 2 * std::min(2, mesh.height() - 1 - y) : 0;
            for (int i = 0; i < quads; ++i) {
                addQuad(mesh, x + i % 2, y + i / 2, patches);
            }
        }
    }
}

void DepthPatches::addQuad(const DepthMesh& mesh, int x, int y, std::vector<Patch>& patches) {
    if (!mesh.isSurface(x, y)) {
        addEdge(mesh, x, y, patches);
        return;
    }
    const std::array<float, 4> inverseM{mesh.inverseM(x, y), mesh.inverseM(x + 1, y),
                                        mesh.inverseM(x + 1, y + 1), mesh.inverseM(x, y + 1)};
    add({2 * x, 2 * y, 2 * x + 2, 2 * y + 2, inverseM}, patches);
}

void DepthPatches::addEdge(const DepthMesh& mesh, int x, int y, std::vector<Patch>& patches) {
    const float a = mesh.inverseM(x, y);
    const float b = mesh.inverseM(x + 1, y);
    const float c = mesh.inverseM(x, y + 1);
    const float d = mesh.inverseM(x + 1, y + 1);
    const auto row = [&](int top, float left, float right) {
        if (DepthMesh::isSurface({left, right})) {
            add({2 * x, top, 2 * x + 2, top + 1, {left, right, right, left}}, patches);
        } else {
            add({2 * x, top, 2 * x + 1, top + 1, {left, left, left, left}}, patches);
            add({2 * x + 1, top, 2 * x + 2, top + 1, {right, right, right, right}}, patches);
        }
    };
    const auto column = [&](int left, float top, float bottom) {
        if (DepthMesh::isSurface({top, bottom})) {
            add({left, 2 * y, left + 1, 2 * y + 2, {top, top, bottom, bottom}}, patches);
        } else {
            add({left, 2 * y, left + 1, 2 * y + 1, {top, top, top, top}}, patches);
            add({left, 2 * y + 1, left + 1, 2 * y + 2, {bottom, bottom, bottom, bottom}}, patches);
        }
    };
    if (DepthMesh::isSurface({a, b}) || DepthMesh::isSurface({c, d})) {
        row(2 * y, a, b);
        row(2 * y + 1, c, d);
    } else {
        column(2 * x, a, c);
        column(2 * x + 1, b, d);
    }
}

/// Joined with what is there, as far as it can be.
void DepthPatches::add(Patch patch, std::vector<Patch>& patches) {
    for (std::size_t i = 0; i < patches.size();) {
        auto both = patches[i].with(patch);
        both = both ? both : patch.with(patches[i]);
        if (!both) {
            ++i;
            continue;
        }
        patch = *both;
        patches[i] = patches.back();
        patches.pop_back();
        i = 0; // it may have other neighbours now
    }
    patches.push_back(patch);
}

void DepthPatches::keep(const DepthMesh& mesh, const std::vector<Patch>& patches) {
    m_first.push_back(static_cast<std::uint32_t>(m_cosine[0].size()));
    for (const Patch& patch : patches) {
        const std::array<DepthMesh::Angle, 4> sides{mesh.azimuth(patch.left), mesh.elevation(patch.top),
                                                    mesh.azimuth(patch.right), mesh.elevation(patch.bottom)};
        for (std::size_t i = 0; i < sides.size(); ++i) {
            m_cosine[i].push_back(sides[i].cosine);
            m_sine[i].push_back(sides[i].sine);
            m_inverse[i].push_back(patch.inverseM[i]);
        }
    }
}

} // namespace spherewalk::render
