// SPDX-License-Identifier: Apache-2.0
#include "surface/mesh.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace spherewalk::render {

/// A rectangle of a photo with 1 / distance at its corners, in turn from the upper left one. Units: half
/// pixels.
struct EdgePatches::Patch {
    int left, top, right, bottom;
    std::array<float, 4> inverseM;

    /// Both patches as one, if they are beside each other and even.
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
    /// Whether 1 / distance goes evenly along a side of both, from this patch's first corner to the next
    /// one's last. share: this patch's share of the way.
    bool isEven(const Patch& next, std::size_t first, std::size_t last, float share) const {
        constexpr float kUneven = 0.003F;
        const float even = inverseM[first] + share * (next.inverseM[last] - inverseM[first]);
        return std::abs(inverseM[last] - even) <= kUneven * even &&
               std::abs(next.inverseM[first] - even) <= kUneven * even;
    }
};

EdgePatches::EdgePatches(const SurfaceMesh& mesh, int blockX, int blockY) {
    std::vector<Patch> all;
    std::vector<Patch> patches;
    for (int subBlock = 0; subBlock < kSubBlocks * kSubBlocks; ++subBlock) {
        const auto [x, y] = cornerInBlock(subBlock);
        patches.clear();
        addSubBlock(mesh, blockX * SurfaceMesh::kBlock + x, blockY * SurfaceMesh::kBlock + y, patches);
        m_first[static_cast<std::size_t>(subBlock)] = static_cast<std::uint32_t>(all.size());
        all.insert(all.end(), patches.begin(), patches.end());
    }
    m_first.back() = static_cast<std::uint32_t>(all.size());
    if (!all.empty()) {
        keep(mesh, all);
    }
}

/// The upper left vertex of a sub-block: the inverse of orderInBlock().
std::pair<int, int> EdgePatches::cornerInBlock(int subBlock) {
    return {(subBlock / 4 % 2 * 2 + subBlock % 2) * kSubBlock,
            (subBlock / 8 * 2 + subBlock / 2 % 2) * kSubBlock};
}

simd::SurfacePatches EdgePatches::at(Range range) const {
    simd::SurfacePatches patches;
    const float* values = m_values.data() + range.begin;
    for (auto* of : {&patches.cosine, &patches.sine, &patches.inverseM}) {
        for (const float*& side : *of) {
            side = values;
            values += m_pitch;
        }
    }
    patches.count = static_cast<int>(range.end - range.begin);
    return patches;
}

void EdgePatches::addSubBlock(const SurfaceMesh& mesh, int left, int top, std::vector<Patch>& patches) {
    for (int y = top; y < std::min(top + kSubBlock, mesh.height() - 1); y += 2) {
        for (int x = left; x < left + kSubBlock; x += 2) {
            const int quads = mesh.hasEdge(x, y) ? 2 * std::min(2, mesh.height() - 1 - y) : 0;
            for (int i = 0; i < quads; ++i) {
                addQuad(mesh, x + i % 2, y + i / 2, patches);
            }
        }
    }
}

void EdgePatches::addQuad(const SurfaceMesh& mesh, int x, int y, std::vector<Patch>& patches) {
    if (!mesh.isSurface(x, y)) {
        addEdge(mesh, x, y, patches);
        return;
    }
    const std::array<float, 4> inverseM{mesh.inverseM(x, y), mesh.inverseM(x + 1, y),
                                        mesh.inverseM(x + 1, y + 1), mesh.inverseM(x, y + 1)};
    add({2 * x, 2 * y, 2 * x + 2, 2 * y + 2, inverseM}, patches);
}

void EdgePatches::addEdge(const SurfaceMesh& mesh, int x, int y, std::vector<Patch>& patches) {
    const float a = mesh.inverseM(x, y);
    const float b = mesh.inverseM(x + 1, y);
    const float c = mesh.inverseM(x, y + 1);
    const float d = mesh.inverseM(x + 1, y + 1);
    const auto row = [&](int top, float left, float right) {
        if (SurfaceMesh::isSurface({left, right})) {
            add({2 * x, top, 2 * x + 2, top + 1, {left, right, right, left}}, patches);
        } else {
            add({2 * x, top, 2 * x + 1, top + 1, {left, left, left, left}}, patches);
            add({2 * x + 1, top, 2 * x + 2, top + 1, {right, right, right, right}}, patches);
        }
    };
    const auto column = [&](int left, float top, float bottom) {
        if (SurfaceMesh::isSurface({top, bottom})) {
            add({left, 2 * y, left + 1, 2 * y + 2, {top, top, bottom, bottom}}, patches);
        } else {
            add({left, 2 * y, left + 1, 2 * y + 1, {top, top, top, top}}, patches);
            add({left, 2 * y + 1, left + 1, 2 * y + 2, {bottom, bottom, bottom, bottom}}, patches);
        }
    };
    if (SurfaceMesh::isSurface({a, b}) || SurfaceMesh::isSurface({c, d})) {
        row(2 * y, a, b);
        row(2 * y + 1, c, d);
    } else {
        column(2 * x, a, c);
        column(2 * x + 1, b, d);
    }
}

/// Adds a patch. It is joined with patches that are there, as far as it can be.
void EdgePatches::add(Patch patch, std::vector<Patch>& patches) {
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

void EdgePatches::keep(const SurfaceMesh& mesh, const std::vector<Patch>& patches) {
    m_pitch = patches.size() + simd::Quads::kMore; // SIMD reads beyond the end
    m_values.resize(12 * m_pitch);
    for (std::size_t i = 0; i < patches.size(); ++i) {
        const Patch& patch = patches[i];
        const std::array<SurfaceMesh::Angle, 4> sides{mesh.azimuth(patch.left), mesh.elevation(patch.top),
                                                      mesh.azimuth(patch.right),
                                                      mesh.elevation(patch.bottom)};
        for (std::size_t side = 0; side < sides.size(); ++side) {
            m_values[side * m_pitch + i] = sides[side].cosine;
            m_values[(4 + side) * m_pitch + i] = sides[side].sine;
            m_values[(8 + side) * m_pitch + i] = patch.inverseM[side];
        }
    }
}

} // namespace spherewalk::render
