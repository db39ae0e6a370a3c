// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/parallel.h"
#include "spherewalk/place/surface.h"

#include <algorithm>

namespace spherewalk::place {

namespace {

using Eigen::Vector3i;

constexpr int kSide = Volume::kSide;
constexpr int kCorners = kSide + 1;
constexpr std::uint32_t kNoVertex = UINT32_MAX;
constexpr int kNetsAGrain = 16;

/// Voxels of a block and the first layer of the blocks after it.
class Neighbourhood {
  public:
    Neighbourhood(const Volume& volume, std::size_t block) {
        const Vector3i corner = volume.corner(block);
        for (int part = 0; part < 8; ++part) {
            const Vector3i side(part & 1, part >> 1 & 1, part >> 2 & 1);
            const std::size_t from = part == 0 ? block : volume.blockOf(corner + kSide * side);
            if (from < volume.blockCount()) {
                copy(volume.block(from), side);
            }
        }
    }

    const Voxel& at(const Vector3i& p) const { return m_voxels[index(p)]; }

  private:
    static std::size_t index(const Vector3i& p) {
        return static_cast<std::size_t>((p.z() * kCorners + p.y()) * kCorners + p.x());
    }

    void copy(const Volume::Block& block, const Vector3i& side) {
        const Vector3i size = Vector3i::Constant(kSide) - (kSide - 1) * side;
        for (int z = 0; z < size.z(); ++z) {
            for (int y = 0; y < size.y(); ++y) {
                for (int x = 0; x < size.x(); ++x) {
                    m_voxels[index(Vector3i(x, y, z) + kSide * side)] =
                        block[static_cast<std::size_t>((z * kSide + y) * kSide + x)];
                }
            }
        }
    }

    std::array<Voxel, kCorners * kCorners * kCorners> m_voxels;
};

/// Calls visit(cell) for each cell of a block, x fastest.
template <class Visit>
void forEachCell(const Visit& visit) {
    for (int z = 0; z < kSide; ++z) {
        for (int y = 0; y < kSide; ++y) {
            for (int x = 0; x < kSide; ++x) {
                visit(Vector3i(x, y, z));
            }
        }
    }
}

std::size_t cellIndex(const Vector3i& cell) {
    return static_cast<std::size_t>((cell.z() * kSide + cell.y()) * kSide + cell.x());
}

/// Vertices and quads of a block.
struct BlockSurface {
    std::vector<SurfaceVertex> vertices;
    std::array<std::uint32_t, kSide * kSide * kSide> vertexOfCell;
    std::vector<Surface::Triangle> triangles;
};

class SurfaceNets {
  public:
    SurfaceNets(const Volume& volume, int threads, const std::stop_token& stop)
        : m_volume(volume), m_threads(threads), m_stop(stop) {}

    Surface run() {
        m_blocks.resize(m_volume.blockCount());
        forEachBlock([&](std::size_t i) { findVertices(i); });
        Surface surface;
        for (BlockSurface& block : m_blocks) {
            const auto first = static_cast<std::uint32_t>(surface.vertices.size());
            for (std::uint32_t& vertex : block.vertexOfCell) {
                vertex += vertex == kNoVertex ? 0 : first;
            }
            surface.vertices.insert(surface.vertices.end(), block.vertices.begin(), block.vertices.end());
        }
        forEachBlock([&](std::size_t i) { findTriangles(i); });
        for (const BlockSurface& block : m_blocks) {
            surface.triangles.insert(surface.triangles.end(), block.triangles.begin(), block.triangles.end());
        }
        return surface;
    }

  private:
    void forEachBlock(const std::function<void(std::size_t)>& body) const {
        parallelFor(static_cast<int>(m_blocks.size()), kNetsAGrain, m_threads, [&](int begin, int end) {
            throwIfStopped(m_stop);
            for (int i = begin; i < end; ++i) {
                body(static_cast<std::size_t>(i));
            }
        });
    }

    void findVertices(std::size_t i) {
        const Neighbourhood voxels(m_volume, i);
        BlockSurface& block = m_blocks[i];
        block.vertexOfCell.fill(kNoVertex);
        forEachCell([&](const Vector3i& cell) {
            if (isCrossed(voxels, cell)) {
                block.vertexOfCell[cellIndex(cell)] = static_cast<std::uint32_t>(block.vertices.size());
                block.vertices.push_back(vertexIn(voxels, cell, m_volume.corner(i)));
            }
        });
    }

    /// Whether all corners of a cell are known, and some of them lie behind the surface.
    static bool isCrossed(const Neighbourhood& voxels, const Vector3i& cell) {
        int behind = 0;
        for (int i = 0; i < 8; ++i) {
            const Voxel& voxel = voxels.at(cell + cornerOf(i));
            if (voxel.weight == 0) {
                return false;
            }
            behind += voxel.distanceM <= 0 ? 1 : 0;
        }
        return behind > 0 && behind < 8;
    }

    static Vector3i cornerOf(int i) { return {i & 1, i >> 1 & 1, i >> 2 & 1}; }

    SurfaceVertex vertexIn(const Neighbourhood& voxels, const Vector3i& cell, const Vector3i& corner) const {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        int crossings = 0;
        SurfaceVertex vertex;
        for (int i = 0; i < 8; ++i) {
            const Voxel& voxel = voxels.at(cell + cornerOf(i));
            for (int axis = 0; axis < 3; ++axis) {
                if ((i >> axis & 1) == 1) {
                    continue;
                }
                const Voxel& other = voxels.at(cell + cornerOf(i | 1 << axis));
                if ((voxel.distanceM <= 0) != (other.distanceM <= 0)) {
                    const double share = crossing(voxel.distanceM, other.distanceM);
                    sum += cornerOf(i).cast<double>() + share * Eigen::Vector3d::Unit(axis);
                    ++crossings;
                }
            }
        }
        vertex.pInRoom = m_volume.originM() +
                         m_volume.voxelM() * ((corner + cell).cast<double>() + sum / std::max(crossings, 1));
        return vertex;
    }

    /// Where along an edge the surface lies. Distances are along photos' rays. Beside a thing they jump to
    /// that of what stands behind it, and then say only that the border of the thing is on the edge.
    double crossing(double from, double to) const {
        constexpr double kSteepest = 3; // seen at 19 degrees, a surface changes its distance by three edges
        const double edgeM = m_volume.voxelM();
        if (std::abs(from - to) <= kSteepest * edgeM) {
            return from / (from - to);
        }
        const double begin = std::clamp(from, -edgeM, edgeM);
        return begin / (begin - std::clamp(to, -edgeM, edgeM));
    }

    /// Two triangles for each edge along an axis that meets the surface, between the four cells about it.
    void findTriangles(std::size_t i) {
        const Neighbourhood voxels(m_volume, i);
        forEachCell([&](const Vector3i& voxel) {
            for (int axis = 0; axis < 3; ++axis) {
                const Voxel& from = voxels.at(voxel);
                const Voxel& to = voxels.at(voxel + Vector3i::Unit(axis));
                if (from.weight > 0 && to.weight > 0 && (from.distanceM <= 0) != (to.distanceM <= 0)) {
                    addQuad(i, voxel, axis, from.distanceM <= 0);
                }
            }
        });
    }

    void addQuad(std::size_t block, const Vector3i& voxel, int axis, bool facesAlongAxis) {
        const Vector3i across = Vector3i::Unit((axis + 1) % 3);
        const Vector3i up = Vector3i::Unit((axis + 2) % 3);
        std::array<std::uint32_t, 4> corners = {vertexAt(block, voxel), vertexAt(block, voxel - across),
                                                vertexAt(block, voxel - across - up),
                                                vertexAt(block, voxel - up)};
        if (std::find(corners.begin(), corners.end(), kNoVertex) != corners.end()) {
            return;
        }
        if (!facesAlongAxis) {
            std::swap(corners[1], corners[3]);
        }
        m_blocks[block].triangles.push_back({corners[0], corners[1], corners[2]});
        m_blocks[block].triangles.push_back({corners[0], corners[2], corners[3]});
    }

    /// The vertex of a cell of this block or of one before it.
    std::uint32_t vertexAt(std::size_t block, const Vector3i& cell) const {
        if (cell.minCoeff() >= 0) {
            return m_blocks[block].vertexOfCell[cellIndex(cell)];
        }
        const Vector3i absolute = m_volume.corner(block) + cell;
        const std::size_t other = m_volume.blockOf(absolute);
        return other < m_blocks.size()
                   ? m_blocks[other].vertexOfCell[cellIndex(absolute - m_volume.corner(other))]
                   : kNoVertex;
    }

    const Volume& m_volume;
    int m_threads;
    std::stop_token m_stop;
    std::vector<BlockSurface> m_blocks;
};

} // namespace

Surface surfaceOf(const Volume& volume, int threads, const std::stop_token& stop) {
    Surface surface = SurfaceNets(volume, threads, stop).run();
    surface.keepTriangles([](std::size_t) { return true; });
    surface.estimateNormals();
    return surface;
}

} // namespace spherewalk::place
