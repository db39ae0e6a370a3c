// SPDX-License-Identifier: Apache-2.0
#include "surface/mesh.h"

#include "spherewalk/base/error.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

namespace spherewalk::render {

using Eigen::Vector3f;

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

SurfaceMesh::Rims::Rims(const DepthSteps& depth)
    : colourWeights(render::colourWeights(DepthMap(depth))),
      blocks((depth.width() + kBlock - 1) / kBlock, (depth.height() + kBlock - 1) / kBlock) {
    for (int y = 0; y < depth.height(); ++y) {
        for (int x = 0; x < depth.width(); ++x) {
            if (*colourWeights.at(x, y) < 255) {
                *blocks.at(x / kBlock, y / kBlock) = 1;
            }
        }
    }
}

const SurfaceMesh::Rims& SurfaceMesh::rims() const {
    return m_rims.get(0, [&] { return Rims(*m_depth); });
}

bool SurfaceMesh::hasRims(double left, double top, double right, double bottom) const {
    const auto block = [](double pixel) { return static_cast<int>(std::floor(pixel / Rims::kBlock)); };
    const MaskImage& blocks = rims().blocks;
    constexpr double kRounding = 1; // a place may be rounded to the next pixel
    const int beginX = block(left - kRounding);
    const int endX = block(right + kRounding) + 1;
    const int beginY = std::max(0, block(top - kRounding));
    const int endY = std::min(blocks.height(), block(bottom + kRounding) + 1);
    const int columns = blocks.width();
    for (int y = beginY; y < endY; ++y) {
        for (int x = beginX; x < endX; ++x) {
            if (*blocks.at((x + columns) % columns, y) != 0) {
                return true;
            }
        }
    }
    return false;
}

SurfaceMesh::SurfaceMesh(std::shared_ptr<const DepthSteps> depth)
    : m_depth(std::move(depth)),
      m_width(m_depth->width()),
      m_height(m_depth->height()),
      m_details(static_cast<std::size_t>(blocksX()) * static_cast<std::size_t>(blocksY())),
      m_rims(1) {
    if (m_width % kBlock != 0) {
        throw Error(ErrorKind::InvalidInput, "A depth's width must be a multiple of 16 pixels.");
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
    boundBlocks();
}

simd::SurfaceBlock SurfaceMesh::Detail::block() const {
    return {m_angles[0], m_angles[1],      m_angles[2],
            m_angles[3], m_inverse.data(), simd::ProjectedBlock::kPitch,
            m_rows};
}

void SurfaceMesh::fetch(int blockX, int blockY) const {
    if (const Detail* detail = m_details.made(index(blockX, blockY))) {
        detail->fetch();
    }
}

const SurfaceMesh::Detail& SurfaceMesh::detail(int blockX, int blockY) const {
    return m_details.get(index(blockX, blockY), [&] { return Detail(*this, blockX, blockY); });
}

bool SurfaceMesh::hasEdge(int x, int y) const {
    for (int j = y; j < std::min(y + 2, m_height - 1); ++j) {
        if (!isSurface(x, j) || !isSurface(x + 1, j)) {
            return true;
        }
    }
    return false;
}

SurfaceMesh::Detail::Detail(const SurfaceMesh& mesh, int blockX, int blockY)
    : m_angles{mesh.m_centres[0].data() + blockX * kBlock, mesh.m_centres[1].data() + blockX * kBlock,
               mesh.m_centres[2].data() + blockY * kBlock, mesh.m_centres[3].data() + blockY * kBlock},
      m_rows(std::min(kBlock, mesh.height() - 1 - blockY * kBlock) + 1),
      m_width(mesh.width()),
      m_patches(mesh, blockX, blockY) {
    static_assert(simd::ProjectedBlock::kRows == kBlock + 1 && simd::ProjectedBlock::kPitch > kBlock);
    for (int y = 0; y < m_rows; ++y) {
        float* row = m_inverse.data() + std::ptrdiff_t{y} * simd::ProjectedBlock::kPitch;
        for (int x = 0; x < simd::ProjectedBlock::kPitch; ++x) {
            row[x] = mesh.inverseM(blockX * kBlock + std::min(x, kBlock), blockY * kBlock + y);
        }
    }
    std::size_t quad = 0;
    for (int level = kLevels - 1; level > 0; --level) {
        const int size = 1 << level;
        for (int y = 0; y < kBlock; y += size) {
            for (int x = 0; x < kBlock; x += size) {
                const bool isTorn =
                    y >= m_rows - 1 || (level == 1 && mesh.hasEdge(blockX * kBlock + x, blockY * kBlock + y));
                m_deviation[quad++] =
                    isTorn ? HUGE_VALF : measured(x, y, x + size, std::min(y + size, m_rows - 1));
            }
        }
    }
}

void SurfaceMesh::Detail::fetch() const {
    constexpr std::size_t kPerLine = 64 / sizeof(float);
    for (std::size_t i = 0; i < kVertices; i += kPerLine) {
        hwy::Prefetch(m_inverse.data() + i);
    }
    for (std::size_t i = 0; i < kOfBlock; i += kPerLine) {
        hwy::Prefetch(m_deviation.data() + i);
    }
}

float SurfaceMesh::Detail::measured(int x, int y, int endX, int endY) const {
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

/// How far a block's directions are from its middle at most. It is the same for all blocks of a row.
float SurfaceMesh::radiusOfRow(int blockY) const {
    const int endY = std::min((blockY + 1) * kBlock, m_height - 1);
    const Vector3f centre = direction(kBlock, blockY * kBlock + endY);
    float radius = 0;
    for (int y = blockY * kBlock; y <= endY; ++y) {
        for (int x = 0; x <= kBlock; ++x) {
            radius = std::max(radius, (direction(2 * x, 2 * y) - centre).norm());
        }
    }
    return radius + static_cast<float>(2 * std::numbers::pi / m_width); // a pixel, for its corners
}

void SurfaceMesh::boundBlocks() {
    for (int blockY = 0; blockY < blocksY(); ++blockY) {
        const int endY = std::min((blockY + 1) * kBlock, m_height - 1);
        const float radius = radiusOfRow(blockY);
        for (int blockX = 0; blockX < blocksX(); ++blockX) {
            const int begin = blockX * kBlock;
            const int beyond = begin + kBlock == m_width ? 0 : begin + kBlock;
            std::array<std::int16_t, kBlock> least; // of steps, for each column
            std::array<std::int16_t, kBlock> most{};
            least.fill(std::numeric_limits<std::int16_t>::max());
            for (int y = blockY * kBlock; y <= endY; ++y) {
                const std::uint16_t* row = m_depth->row(y);
                const auto last = static_cast<std::int16_t>(row[beyond] >> 1);
                least.front() = std::min(least.front(), last);
                most.front() = std::max(most.front(), last);
                for (std::size_t x = 0; x < kBlock; ++x) {
                    const auto steps =
                        static_cast<std::int16_t>(row[static_cast<std::size_t>(begin) + x] >> 1);
                    least[x] = std::min(least[x], steps);
                    most[x] = std::max(most[x], steps);
                }
            }
            const auto inverse = [](int steps) {
                return DepthSteps::inverseM(2 * static_cast<unsigned>(steps));
            };
            m_bounds.push_back({direction(2 * begin + kBlock, blockY * kBlock + endY), radius,
                                inverse(*std::min_element(least.begin(), least.end())),
                                inverse(*std::max_element(most.begin(), most.end()))});
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
