// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dataset/depth_steps.h"
#include "surface/vertices.h"

#include "spherewalk/render/scene_depth.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

namespace spherewalk::render {

/// How much the colour of each of a photo's pixels counts where other photos show the same: from 1 for the
/// rim behind a nearer thing, where pixels mix both, to 255. Shape: the map's.
MaskImage colourWeights(const DepthMap& map);

class SurfaceMesh;

/// The patches of a block of a photo's surface at the edges of things, where it is torn. A patch is a
/// rectangle of the photo with 1 / distance at its corners. Where distances of four pixels jump too much, the
/// pixels are not joined into one surface. Each pixel then gets patches, alone or with one neighbour, that
/// end halfway to the others. If one of two by two quads has such an edge, each quad without an edge becomes
/// one patch. Patches side by side are joined where 1 / distance goes on evenly. Threads: const functions may
/// run on any number at a time.
class EdgePatches {
  public:
    static constexpr int kSubBlock = simd::BlockBoxes::kSubBlock;   ///< Quads along an axis of a sub-block.
    static constexpr int kSubBlocks = simd::BlockBoxes::kSubBlocks; ///< Sub-blocks along an axis of a block.

    /// The patches at all edges of a block. Only the mesh's vertices are read.
    EdgePatches(const SurfaceMesh& mesh, int blockX, int blockY);

    struct Range {
        std::uint32_t begin = 0, end = 0;
    };

    /// The patches of a sub-block. Where one range ends the next begins, in the order of orderInBlock().
    Range ofSubBlock(int subBlock) const {
        const auto index = static_cast<std::size_t>(subBlock);
        return {m_first[index], m_first[index + 1]};
    }

    /// The number of the sub-block at these vertices of a block. The order is that of a quadtree's leaves.
    /// Range: multiples of kSubBlock.
    static int orderInBlock(int x, int y) {
        const int column = x / kSubBlock;
        const int row = y / kSubBlock;
        return row / 2 * 8 + column / 2 * 4 + row % 2 * 2 + column % 2;
    }

    /// The patches of a range. The ranges of sub-blocks that follow each other may be joined. Owner: this
    /// object must outlive the pointers.
    simd::SurfacePatches at(Range range) const;

  private:
    struct Patch;

    static std::pair<int, int> cornerInBlock(int subBlock);
    static void addSubBlock(const SurfaceMesh& mesh, int left, int top, std::vector<Patch>& patches);
    static void addQuad(const SurfaceMesh& mesh, int x, int y, std::vector<Patch>& patches);
    static void addEdge(const SurfaceMesh& mesh, int x, int y, std::vector<Patch>& patches);
    static void add(Patch patch, std::vector<Patch>& patches);
    void keep(const SurfaceMesh& mesh, const std::vector<Patch>& patches);

    /// The first patch of each sub-block, and the end.
    std::array<std::uint32_t, std::size_t{kSubBlocks} * kSubBlocks + 1> m_first{};
    std::size_t m_pitch = 0;     ///< Values from one array to the next.
    std::vector<float> m_values; ///< The arrays of SurfacePatches.
};

/// Values that are made when they are first asked for. Threads: any. Two that ask for a value at the same
/// time may both make it; one of the two is kept.
template <class Value>
class Later {
  public:
    explicit Later(std::size_t count)
        : m_count(count), m_values(std::make_unique<std::atomic<const Value*>[]>(count)) {}

    Later(Later&&) noexcept = default;
    Later& operator=(Later&&) = delete;
    Later(const Later&) = delete;
    Later& operator=(const Later&) = delete;

    ~Later() {
        for (std::size_t i = 0; m_values && i < m_count; ++i) {
            delete m_values[i].load();
        }
    }

    /// The value, or null if it was not made yet.
    const Value* made(std::size_t i) const { return m_values[i].load(std::memory_order_acquire); }

    template <class Make>
    const Value& get(std::size_t i, Make&& make) const {
        if (const Value* value = made(i)) {
            return *value;
        }
        auto own = std::make_unique<const Value>(make());
        const Value* other = nullptr;
        if (m_values[i].compare_exchange_strong(other, own.get(), std::memory_order_acq_rel)) {
            return *own.release();
        }
        return *other;
    }

  private:
    std::size_t m_count;
    std::unique_ptr<std::atomic<const Value*>[]> m_values;
};

/// A photo's depth as a surface. Each pixel's centre is a vertex, and each four vertices make a quad. Where
/// the surface is flat, up to kBlock x kBlock of these quads are drawn as one. What is needed to draw a block
/// is computed when the block is first drawn: a view shows a small part of a photo. Frames: the photo's.
/// Threads: const functions may run on any number at a time.
class SurfaceMesh {
  public:
    static constexpr int kLevels = 5; ///< Quads have 1, 2, 4, 8 or 16 pixels along an axis.
    static constexpr int kBlock = 1 << (kLevels - 1);

    /// Errors: InvalidInput for a map whose width is no multiple of 16.
    explicit SurfaceMesh(std::shared_ptr<const DepthSteps> depth);

    explicit SurfaceMesh(const DepthMap& map) : SurfaceMesh(std::make_shared<const DepthSteps>(map)) {}

    /// Whether neighbours with these 1 / distances may belong to one surface.
    static bool isSurface(std::initializer_list<float> inverseM) {
        constexpr float kJump = 0.08F;
        return std::max(inverseM) - std::min(inverseM) < kJump * std::max(inverseM);
    }

    /// Whether the four pixels from (x, y) to the right and down may belong to one surface. Range:
    /// 0 <= x < width, 0 <= y < height - 1.
    bool isSurface(int x, int y) const {
        return isSurface({inverseM(x, y), inverseM(x + 1, y), inverseM(x, y + 1), inverseM(x + 1, y + 1)});
    }

    /// Whether one of the two by two quads from (x, y) has an edge. All four are then made of patches. Range:
    /// 0 <= x < width - 1, y >= 0; there are no quads below the last row.
    bool hasEdge(int x, int y) const;

    int width() const { return m_width; }

    int height() const { return m_height; }

    int blocksX() const { return m_width / kBlock; }

    int blocksY() const { return (m_height - 1 + kBlock - 1) / kBlock; }

    /// 1 / distance of a vertex, in 1/m. Range: 0 <= x <= width (the first column again), 0 <= y < height.
    float inverseM(int x, int y) const { return DepthSteps::inverseM(m_depth->row(y)[x == m_width ? 0 : x]); }

    /// The cosine and sine of a column's azimuth or of a row's elevation, at half pixels as in direction().
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

    /// A unit vector of the photo's frame. Units: half pixels, so that a pixel's corners have integers;
    /// (2 x, 2 y) is its centre. Range: -1 <= halfX <= 2 width, -1 <= halfY <= 2 height.
    Eigen::Vector3f direction(int halfX, int halfY) const {
        const auto [cosAzimuth, sinAzimuth] = azimuth(halfX);
        const auto [cosElevation, sinElevation] = elevation(halfY);
        return {cosElevation * cosAzimuth, cosElevation * sinAzimuth, sinElevation};
    }

    /// Asks memory for what detail() of a block gives, and does not wait for it.
    void fetch(int blockX, int blockY) const;

    /// How a block is drawn.
    class Detail {
      public:
        Detail(const SurfaceMesh& mesh, int blockX, int blockY);

        /// The block's vertices, in up to 17 rows. Owner: the mesh must outlive the pointers.
        simd::SurfaceBlock block() const;

        /// How far 1 / distance is off at most, in 1/m, if a quad of 2^level pixels is drawn flat. It is
        /// infinite where a quad of level 1 has an edge, and for quads below the last row. x, y: the quad's
        /// upper left vertex in the block. Range: level > 0; x and y are multiples of 2^level.
        float deviation(int level, int x, int y) const {
            const int inBlock =
                kOfLevel[static_cast<std::size_t>(level)] + (y >> level) * (kBlock >> level) + (x >> level);
            return m_deviation[static_cast<std::size_t>(inBlock)];
        }

        const EdgePatches& patches() const { return m_patches; }

        void fetch() const;

      private:
        float measured(int x, int y, int endX, int endY) const;

        float inverseM(int x, int y) const {
            return m_inverse[static_cast<std::size_t>(y * simd::ProjectedBlock::kPitch + x)];
        }

        /// The first quad of each level in a block.
        static constexpr std::array<int, kLevels> kOfLevel{-1, 21, 5, 1, 0};
        static constexpr std::size_t kOfBlock = 85;

        static constexpr std::size_t kVertices =
            std::size_t{simd::ProjectedBlock::kRows} * simd::ProjectedBlock::kPitch;

        std::array<float, kVertices> m_inverse;
        std::array<float, kOfBlock> m_deviation;
        /// The cosines and sines of the block's columns and rows, as in SurfaceBlock.
        std::array<const float*, 4> m_angles;
        int m_rows;
        int m_width; ///< The mesh's.
        EdgePatches m_patches;
    };

    /// Cost: some ten microseconds when it is first asked for, else nothing.
    const Detail& detail(int blockX, int blockY) const;

    /// colourWeights() of the map. Cost: milliseconds when it is first asked for, else nothing.
    const MaskImage& colourWeights() const { return rims().colourWeights; }

    /// Whether the rim of a thing may lie in this part of the map. Units: the map's pixels. Range: at most
    /// half a pixel beyond the map.
    bool hasRims(double left, double top, double right, double bottom) const;

    /// The bound of a block's vertices. Their directions end within the chord `radius` of the unit vector
    /// `centre`. Their 1 / distance, in 1/m, lies between `least` and `most`.
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
    /// What tells where the rims of things are.
    struct Rims {
        explicit Rims(const DepthSteps& depth);

        static constexpr int kBlock = 4; ///< Pixels along an axis.
        MaskImage colourWeights;
        MaskImage blocks; ///< 1 where a block has a rim.
    };

    float radiusOfRow(int blockY) const;
    void boundBlocks();
    const Rims& rims() const;

    std::size_t index(int blockX, int blockY) const {
        return static_cast<std::size_t>(blockY) * static_cast<std::size_t>(blocksX()) +
               static_cast<std::size_t>(blockX);
    }

    std::shared_ptr<const DepthSteps> m_depth;
    int m_width;
    int m_height;
    std::vector<float> m_cosAzimuth;
    std::vector<float> m_sinAzimuth;
    std::vector<float> m_cosElevation;
    std::vector<float> m_sinElevation;
    std::array<std::vector<float>, 4>
        m_centres; ///< Every second one of these four, which is at the pixels' centres.
    std::vector<Bound> m_bounds;
    Later<Detail> m_details; ///< One a block.
    Later<Rims> m_rims;      ///< One.
};

} // namespace spherewalk::render
