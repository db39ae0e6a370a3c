// SPDX-License-Identifier: Apache-2.0
#include "depth_mesh.h"

#include "spherewalk/base/error.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spherewalk::render {

DepthMesh::DepthMesh(const DepthMap& map) : m_width(map.width()), m_height(map.height()) {
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
        m_centres[k].resize(m_centres[k].size() + simd::ProjectedPart::kPitch);
    }
    for (int block = 0; block < blocksX() * blocksY(); ++block) {
        measureBlock(block % blocksX(), block / blocksX());
    }
    boundBlocks();
    m_patches = DepthPatches(*this);
    m_inverse.resize(m_inverse.size() + simd::ProjectedPart::kPitch);
}

simd::SurfacePart DepthMesh::block(int blockX, int blockY) const {
    static_assert(simd::ProjectedPart::kRows == kBlock + 1 && simd::ProjectedPart::kPitch > kBlock);
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

void DepthMesh::fetch(int blockX, int blockY) const {
    constexpr std::size_t kPerLine = 64 / sizeof(float);
    const simd::SurfacePart part = block(blockX, blockY);
    for (int row = 0; row < part.rows; ++row) {
        hwy::Prefetch(part.inverseM + row * part.pitch);
        hwy::Prefetch(part.inverseM + row * part.pitch + kBlock);
    }
    const auto index = static_cast<std::size_t>(blockY * blocksX() + blockX);
    for (std::size_t i = 0; i < kOfBlock; i += kPerLine) {
        hwy::Prefetch(m_deviation.data() + index * kOfBlock + i);
    }
}

bool DepthMesh::hasEdge(int x, int y) const {
    for (int j = y; j < std::min(y + 2, m_height - 1); ++j) {
        if (!isSurface(x, j) || !isSurface(x + 1, j)) {
            return true;
        }
    }
    return false;
}

void DepthMesh::measureBlock(int blockX, int blockY) {
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

float DepthMesh::measured(int x, int y, int endX, int endY) const {
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

void DepthMesh::boundBlocks() {
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

} // namespace spherewalk::render
