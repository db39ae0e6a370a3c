// SPDX-License-Identifier: Apache-2.0
#include "surface/mesh.h"

#include "spherewalk/base/error.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace spherewalk::render {

namespace {

/// The weight beside a nearer thing, at a distance of 1, 2 and 3 pixels.
constexpr std::array<std::uint8_t, 3> kRimWeights{1, 8, 64};
/// A thing is nearer if its 1 / distance is larger by this share, and by more than a slanted surface would
/// rise.
constexpr float kNearer = 0.08F;
constexpr float kSlant = 1.5F;

using Values = Image<float, 1>;

/// The extreme of each pixel and its eight neighbours. The first column goes on after the last. pick: the
/// greater or the lesser of two values.
template <class Pick>
Values extremeAround(const Values& of, Pick&& pick) {
    const int width = of.width();
    Values rows(width, of.height());
    for (int y = 0; y < of.height(); ++y) {
        const float* from = of.at(0, y);
        float* to = rows.at(0, y);
        for (int x = 1; x + 1 < width; ++x) {
            to[x] = pick(from[x], pick(from[x - 1], from[x + 1]));
        }
        to[0] = pick(from[0], pick(from[width - 1], from[1]));
        to[width - 1] = pick(from[width - 1], pick(from[width - 2], from[0]));
    }
    Values all(width, of.height());
    for (int y = 0; y < of.height(); ++y) {
        const float* above = rows.at(0, std::max(0, y - 1));
        const float* own = rows.at(0, y);
        const float* below = rows.at(0, std::min(of.height() - 1, y + 1));
        float* to = all.at(0, y);
        for (int x = 0; x < width; ++x) {
            to[x] = pick(own[x], pick(above[x], below[x]));
        }
    }
    return all;
}

} // namespace

MaskImage colourWeights(const DepthMap& map) {
    const std::span<const float> inverse = map.inverseM().values();
    MaskImage weights(map.width(), map.height());
    std::fill(weights.values().begin(), weights.values().end(), std::uint8_t{255});
    Values greatest = map.inverseM();
    Values least = map.inverseM();
    for (const std::uint8_t weight : kRimWeights) {
        greatest = extremeAround(greatest, [](float a, float b) { return std::max(a, b); });
        least = extremeAround(least, [](float a, float b) { return std::min(a, b); });
        const float* most = greatest.values().data();
        const float* fewest = least.values().data();
        for (std::size_t i = 0; i < inverse.size(); ++i) {
            const bool isRim =
                most[i] - inverse[i] > kNearer * inverse[i] + kSlant * (inverse[i] - fewest[i]);
            weights.values()[i] = std::min(weights.values()[i], isRim ? weight : std::uint8_t{255});
        }
    }
    return weights;
}

void SurfaceMesh::markRims() {
    m_rimBlocks = MaskImage((m_width + kRimBlock - 1) / kRimBlock, (m_height + kRimBlock - 1) / kRimBlock);
    for (int y = 0; y < m_height; ++y) {
        for (int x = 0; x < m_width; ++x) {
            if (*m_colourWeights.at(x, y) < 255) {
                *m_rimBlocks.at(x / kRimBlock, y / kRimBlock) = 1;
            }
        }
    }
}

bool SurfaceMesh::hasRims(double left, double top, double right, double bottom) const {
    const auto block = [](double pixel) { return static_cast<int>(std::floor(pixel / kRimBlock)); };
    constexpr double kRounding = 1; // a place may be rounded to the next pixel
    const int beginX = block(left - kRounding);
    const int endX = block(right + kRounding) + 1;
    const int beginY = std::max(0, block(top - kRounding));
    const int endY = std::min(m_rimBlocks.height(), block(bottom + kRounding) + 1);
    const int columns = m_rimBlocks.width();
    for (int y = beginY; y < endY; ++y) {
        for (int x = beginX; x < endX; ++x) {
            if (*m_rimBlocks.at((x + columns) % columns, y) != 0) {
                return true;
            }
        }
    }
    return false;
}

SurfaceMesh::SurfaceMesh(const DepthMap& map)
    : m_width(map.width()), m_height(map.height()), m_colourWeights(render::colourWeights(map)) {
    if (m_width % kBlock != 0) {
        throw Error(ErrorKind::InvalidInput, "A depth's width must be a multiple of 16 pixels.");
    }
    m_inverse.reserve(static_cast<std::size_t>(m_width + 1) * static_cast<std::size_t>(m_height));
    for (int y = 0; y < m_height; ++y) {
        const auto row = map.inverseM().row(y);
        m_inverse.insert(m_inverse.end(), row.begin(), row.end());
        m_inverse.push_back(row.front());
    }
    const double half = std::numbers::pi / m_width; // half a pixel
    for (int i = -1; i <= 2 * m_width; ++i) {
        m_cosAzimuth.push_back(static_cast<float>(std::cos(std::numbers::pi - half * (i + 1))));
        m_sinAzimuth.push_back(static_cast<float>(std::sin(std::numbers::pi - half * (i + 1))));
    }
    for (int i = -1; i <= 2 * m_height; ++i) {
        m_cosElevation.push_back(static_cast<float>(std::cos(std::numbers::pi / 2 - half * (i + 1))));
        m_sinElevation.push_back(static_cast<float>(std::sin(std::numbers::pi / 2 - half * (i + 1))));
    }
    const std::array<const std::vector<float>*, 4> halves{&m_cosAzimuth, &m_sinAzimuth, &m_cosElevation,
                                                          &m_sinElevation};
    for (std::size_t k = 0; k < halves.size(); ++k) {
        for (std::size_t i = 1; i < halves[k]->size(); i += 2) {
            m_centres[k].push_back((*halves[k])[i]);
        }
        m_centres[k].resize(m_centres[k].size() + simd::ProjectedBlock::kPitch);
    }
    for (int block = 0; block < blocksX() * blocksY(); ++block) {
        measureBlock(block % blocksX(), block / blocksX());
    }
    boundBlocks();
    markRims();
    m_patches = EdgePatches(*this);
    m_inverse.resize(m_inverse.size() + simd::ProjectedBlock::kPitch);
}

simd::SurfaceBlock SurfaceMesh::block(int blockX, int blockY) const {
    static_assert(simd::ProjectedBlock::kRows == kBlock + 1 && simd::ProjectedBlock::kPitch > kBlock);
    const int x = blockX * kBlock;
    const int y = blockY * kBlock;
    return {m_centres[0].data() + x,
            m_centres[1].data() + x,
            m_centres[2].data() + y,
            m_centres[3].data() + y,
            m_inverse.data() + static_cast<std::ptrdiff_t>(y) * (m_width + 1) + x,
            m_width + 1,
            std::min(kBlock, m_height - 1 - y) + 1};
}

void SurfaceMesh::fetch(int blockX, int blockY) const {
    constexpr std::size_t kPerLine = 64 / sizeof(float);
    const simd::SurfaceBlock part = block(blockX, blockY);
    for (int row = 0; row < part.rows; ++row) {
        hwy::Prefetch(part.inverseM + row * part.pitch);
        hwy::Prefetch(part.inverseM + row * part.pitch + kBlock);
    }
    const auto index = static_cast<std::size_t>(blockY * blocksX() + blockX);
    for (std::size_t i = 0; i < kOfBlock; i += kPerLine) {
        hwy::Prefetch(m_deviation.data() + index * kOfBlock + i);
    }
}

bool SurfaceMesh::hasEdge(int x, int y) const {
    for (int j = y; j < std::min(y + 2, m_height - 1); ++j) {
        if (!isSurface(x, j) || !isSurface(x + 1, j)) {
            return true;
        }
    }
    return false;
}

void SurfaceMesh::measureBlock(int blockX, int blockY) {
    for (int level = kLevels - 1; level > 0; --level) {
        const int size = 1 << level;
        for (int j = 0; j < kBlock; j += size) {
            for (int i = 0; i < kBlock; i += size) {
                const int x = blockX * kBlock + i;
                const int y = blockY * kBlock + j;
                const bool isTorn = y >= m_height - 1 || (level == 1 && hasEdge(x, y));
                m_deviation.push_back(isTorn ? HUGE_VALF
                                             : measured(x, y, x + size, std::min(y + size, m_height - 1)));
            }
        }
    }
}

float SurfaceMesh::measured(int x, int y, int endX, int endY) const {
    const float a = inverseM(x, y);
    const float b = inverseM(endX, y);
    const float c = inverseM(x, endY);
    const float d = inverseM(endX, endY);
    float worst = 0;
    float most = 0;
    for (int j = y; j <= endY; ++j) {
        const float down = static_cast<float>(j - y) / static_cast<float>(endY - y);
        for (int i = x; i <= endX; ++i) {
            const float right = static_cast<float>(i - x) / static_cast<float>(endX - x);
            const float upper = a + right * (b - a);
            const float flat = upper + down * (c + right * (d - c) - upper);
            worst = std::max(worst, std::abs(inverseM(i, j) - flat));
            most = std::max(most, inverseM(i, j));
        }
    }
    // On a plane 1 / distance goes with the direction's chord, not with its angles.
    const auto angle = static_cast<float>((endX - x) * 2 * std::numbers::pi / m_width);
    return worst + most * angle * angle / 8;
}

void SurfaceMesh::boundBlocks() {
    for (int blockY = 0; blockY < blocksY(); ++blockY) {
        for (int blockX = 0; blockX < blocksX(); ++blockX) {
            const int endX = (blockX + 1) * kBlock;
            const int endY = std::min((blockY + 1) * kBlock, m_height - 1);
            Bound bound;
            bound.centre = direction(2 * blockX * kBlock + kBlock, blockY * kBlock + endY);
            bound.least = HUGE_VALF;
            for (int y = blockY * kBlock; y <= endY; ++y) {
                for (int x = blockX * kBlock; x <= endX; ++x) {
                    const float chord =
                        (direction(std::min(2 * x, 2 * m_width), 2 * y) - bound.centre).norm();
                    bound.radius = std::max(bound.radius, chord);
                    bound.least = std::min(bound.least, inverseM(x, y));
                    bound.most = std::max(bound.most, inverseM(x, y));
                }
            }
            bound.radius += static_cast<float>(2 * std::numbers::pi / m_width); // a pixel, for its corners
            m_bounds.push_back(bound);
        }
    }
}

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

EdgePatches::EdgePatches(const SurfaceMesh& mesh) {
    std::vector<Patch> patches;
    for (int block = 0; block < mesh.blocksX() * mesh.blocksY(); ++block) {
        for (int subBlock = 0; subBlock < kSubBlocks * kSubBlocks; ++subBlock) {
            const auto [x, y] = cornerInBlock(subBlock);
            const int left = block % mesh.blocksX() * SurfaceMesh::kBlock + x;
            const int top = block / mesh.blocksX() * SurfaceMesh::kBlock + y;
            patches.clear();
            addSubBlock(mesh, left, top, patches);
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

/// The upper left vertex of a sub-block: the inverse of orderInBlock().
std::pair<int, int> EdgePatches::cornerInBlock(int subBlock) {
    return {(subBlock / 4 % 2 * 2 + subBlock % 2) * kSubBlock,
            (subBlock / 8 * 2 + subBlock / 2 % 2) * kSubBlock};
}

simd::SurfacePatches EdgePatches::at(Range range) const {
    simd::SurfacePatches patches;
    for (std::size_t i = 0; i < 4; ++i) {
        patches.cosine[i] = m_cosine[i].data() + range.begin;
        patches.sine[i] = m_sine[i].data() + range.begin;
        patches.inverseM[i] = m_inverse[i].data() + range.begin;
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
    m_first.push_back(static_cast<std::uint32_t>(m_cosine[0].size()));
    for (const Patch& patch : patches) {
        const std::array<SurfaceMesh::Angle, 4> sides{mesh.azimuth(patch.left), mesh.elevation(patch.top),
                                                      mesh.azimuth(patch.right),
                                                      mesh.elevation(patch.bottom)};
        for (std::size_t i = 0; i < sides.size(); ++i) {
            m_cosine[i].push_back(sides[i].cosine);
            m_sine[i].push_back(sides[i].sine);
            m_inverse[i].push_back(patch.inverseM[i]);
        }
    }
}

} // namespace spherewalk::render
