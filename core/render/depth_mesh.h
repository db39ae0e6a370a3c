// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "depth_patches.h"
#include "depth_simd.h"

#include "spherewalk/render/depth_map.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <vector>

namespace spherewalk::render {

/// A photo's depth as a surface: a vertex for each pixel's centre, a quad between each four, and quads of up
/// to kBlock x kBlock of these where the surface is flat. Frames: the photo's. Threads: const, any number.
class DepthMesh {
  public:
    static constexpr int kLevels = 5; ///< quads of 1, 2, 4, 8 and 16 pixels
    static constexpr int kBlock = 1 << (kLevels - 1);

    explicit DepthMesh(const DepthMap& map);

    /// Whether neighbours so far away, seen as 1 / distance, may be of one surface.
    static bool isSurface(std::initializer_list<float> inverseM) {
        constexpr float kJump = 0.08F;
        return std::max(inverseM) - std::min(inverseM) < kJump * std::max(inverseM);
    }

    /// Whether the four pixels from there to the right and down are of one. Range: 0 <= x < width, 0 <= y <
    /// height - 1.
    bool isSurface(int x, int y) const {
        return isSurface({inverseM(x, y), inverseM(x + 1, y), inverseM(x, y + 1), inverseM(x + 1, y + 1)});
    }

    /// Whether some of the two by two quads from there are not: they are made of patches.
    bool hasEdge(int x, int y) const;

    int width() const { return m_width; }

    int height() const { return m_height; }

    int blocksX() const { return m_width / kBlock; }

    int blocksY() const { return (m_height - 1 + kBlock - 1) / kBlock; }

    /// Range: 0 <= x <= width (the first column again), 0 <= y < height.
    float inverseM(int x, int y) const {
        return m_inverse[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width + 1) +
                         static_cast<std::size_t>(x)];
    }

    /// Cosine and sine of a column's azimuth or of a row's elevation, at half pixels as direction() has them.
    struct Angle {
        float cosine, sine;
    };

    Angle azimuth(int halfX) const {
        const auto x = static_cast<std::size_t>(halfX + 1);
        return {m_cosAzimuth[x], m_sinAzimuth[x]};
    }

    Angle elevation(int halfY) const {
        const auto y = static_cast<std::size_t>(halfY + 1);
        return {m_cosElevation[y], m_sinElevation[y]};
    }

    /// Unit vector. Units: half pixels, so that a pixel's corners can be had: (2 x, 2 y) is its centre.
    /// Range: -1 <= halfX <= 2 width, likewise y.
    Eigen::Vector3f direction(int halfX, int halfY) const {
        const auto [cosAzimuth, sinAzimuth] = azimuth(halfX);
        const auto [cosElevation, sinElevation] = elevation(halfY);
        return {cosElevation * cosAzimuth, cosElevation * sinAzimuth, sinElevation};
    }

    /// A block's vertices, as many rows of them as it has.
    simd::SurfacePart block(int blockX, int blockY) const;

    /// Asks for what block() and deviation() read of a block, and does not wait for it.
    void fetch(int blockX, int blockY) const;

    /// By how much 1 / distance is off, at most, if the quad with its upper left vertex at (x, y) of a block
    /// is taken to be flat; infinite at level 1 where it has an edge. Range: level > 0; x and y multiples of
    /// 2^level.
    float deviation(std::size_t block, int level, int x, int y) const {
        const int inBlock =
            kOfLevel[static_cast<std::size_t>(level)] + (y >> level) * (kBlock >> level) + (x >> level);
        return m_deviation[block * kOfBlock + static_cast<std::size_t>(inBlock)];
    }

    const DepthPatches& patches() const { return m_patches; }

    /// All vertices of a block lie in it: directions within `radius` of the centre, and so many per metre.
    struct Bound {
        Eigen::Vector3f centre;
        float radius = 0;
        float least = 0;
        float most = 0;
    };

    const Bound& bound(int blockX, int blockY) const {
        return m_bounds[static_cast<std::size_t>(blockY) * static_cast<std::size_t>(blocksX()) +
                        static_cast<std::size_t>(blockX)];
    }

  private:
    static constexpr std::array<int, kLevels> kOfLevel{-1, 21, 5, 1, 0}; ///< where a block has its quads
    static constexpr std::size_t kOfBlock = 85;

    void measureBlock(int blockX, int blockY);
    float measured(int x, int y, int endX, int endY) const;
    void boundBlocks();

    int m_width;
    int m_height;
    std::vector<float> m_inverse;
    std::vector<float> m_cosAzimuth;
    std::vector<float> m_sinAzimuth;
    std::vector<float> m_cosElevation;
    std::vector<float> m_sinElevation;
    std::array<std::vector<float>, 4> m_centres; ///< every second one of these: at the pixels' centres
    std::vector<float> m_deviation;              ///< block after block
    DepthPatches m_patches;
    std::vector<Bound> m_bounds;
};

} // namespace spherewalk::render
