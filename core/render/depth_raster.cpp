// SPDX-License-Identifier: Apache-2.0
#include "depth_raster.h"

#include "surface_projector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace spherewalk::render {

using simd::Piece;
using simd::ProjectedPart;

namespace {

constexpr int kSquare = DepthPatches::kSquare; ///< quads of a square that cannot show are left out as one

} // namespace

/// Cuts one block of a surface into flat pieces.
class DepthRaster::BlockCutter {
  public:
    BlockCutter(const DepthMesh& mesh, const SurfaceProjector& projector, const OpenCells& open,
                float tolerance, int width, int height, std::span<std::vector<Piece>> bands)
        : m_mesh(mesh),
          m_projector(projector),
          m_open(open),
          m_tolerance(tolerance),
          m_width(width),
          m_height(height),
          m_bands(bands) {}

    void cut(int blockX, int blockY) {
        m_block = static_cast<std::size_t>(blockY * m_mesh.blocksX() + blockX);
        const simd::SurfacePart part = m_mesh.block(blockX, blockY);
        m_projector.project(part, m_part);
        simd::boxes(m_part, part.rows, m_boxes);
        m_endY = part.rows - 1;
        quad(DepthMesh::kLevels - 1, 0, 0);
        addPatches();
    }

    /// Makes pieces of the quads. To be called at the end.
    void flush() {
        simd::cut(m_quads, m_width, m_height, m_cut);
        const bool isAllOpen = m_open.isAllOpen();
        for (std::size_t i = 0; i < static_cast<std::size_t>(m_quads.count); ++i) {
            const Piece::Box box = m_cut.boxOf(i);
            if (box.left > box.right || box.top > box.bottom ||
                (!isAllOpen && !m_open.anyIn(box.left, box.top, box.right, box.bottom))) {
                continue;
            }
            for (int band = box.top / kBand; band <= box.bottom / kBand; ++band) {
                simd::add(m_quads, m_cut, i, m_bands[static_cast<std::size_t>(band)]);
            }
        }
        m_quads.count = 0;
    }

  private:
    /// x, y: in the block.
    void quad(int level, int x, int y) {
        const int size = 1 << level;
        const int endY = std::min(y + size, m_endY);
        if (level == 0) {
            add(x, y, x + 1, y + 1);
            return;
        }
        const auto square = static_cast<std::size_t>(y / kSquare * DepthPatches::kSquares + x / kSquare);
        if (size == kSquare && !mayShow(square)) {
            return;
        }
        const float deviation = m_mesh.deviation(m_block, level, x, y);
        if (level == 1 && std::isinf(deviation)) {
            return; // it is made of patches
        }
        const bool flat = level <= m_projector.largestLevel() && deviation < m_tolerance;
        if (flat && add(x, y, x + size, endY)) {
            return;
        }
        if (size == kSquare) {
            addPatchesOf(DepthPatches::orderInBlock(x, y));
        }
        for (int j = y; j < endY; j += size / 2) {
            for (int i = x; i < x + size; i += size / 2) {
                quad(level - 1, i, j);
            }
        }
    }

    /// Whether a square of the block may show in cells that are open, or what stands for its pixels does.
    bool mayShow(std::size_t square) const {
        const float beside = 1 + (m_boxes.right[square] - m_boxes.left[square]) / kSquare;
        const float below = 1 + (m_boxes.bottom[square] - m_boxes.top[square]) / kSquare;
        return m_open.anyIn(m_boxes.left[square] - beside, m_boxes.top[square] - below,
                            m_boxes.right[square] + beside, m_boxes.bottom[square] + below);
    }

    /// Those of squares that follow each other go together.
    void addPatchesOf(int square) {
        const DepthPatches::Range range = m_mesh.patches().ofSquare(m_block, square);
        if (range.begin != m_patches.end) {
            addPatches();
            m_patches.begin = range.begin;
        }
        m_patches.end = range.end;
    }

    void addPatches() {
        const simd::SurfacePatches patches = m_mesh.patches().at(m_patches);
        m_patches.begin = m_patches.end;
        for (int first = 0; first < patches.count;) {
            if (m_quads.count == simd::Quads::kMost) {
                flush();
            }
            const int many = std::min(patches.count - first, simd::Quads::kMost - m_quads.count);
            m_projector.project(patches.part(first, many), m_quads);
            first += many;
        }
    }

    /// A quad of the block between these vertices. False if not all of it is in front of the camera.
    bool add(int left, int top, int right, int bottom) {
        const auto index = [&](int x, int y) {
            return static_cast<std::size_t>(y * ProjectedPart::kPitch + x);
        };
        const std::array<std::size_t, 4> corners{index(left, top), index(right, top), index(right, bottom),
                                                 index(left, bottom)};
        if (!std::ranges::all_of(corners, [&](std::size_t corner) { return m_part.value[corner] > 0; })) {
            return false;
        }
        if (m_quads.count == simd::Quads::kMost) {
            flush();
        }
        const auto to = static_cast<std::size_t>(m_quads.count++);
        for (std::size_t i = 0; i < 4; ++i) {
            m_quads.x[i][to] = m_part.x[corners[i]];
            m_quads.y[i][to] = m_part.y[corners[i]];
            m_quads.value[i][to] = m_part.value[corners[i]];
        }
        return true;
    }

    const DepthMesh& m_mesh;
    const SurfaceProjector& m_projector;
    const OpenCells& m_open;
    float m_tolerance;
    int m_width;
    int m_height;
    std::span<std::vector<Piece>> m_bands; ///< where the pieces go
    simd::CutQuads m_cut;
    std::size_t m_block = 0;
    int m_endY = 0;                ///< of the block's quads
    simd::Quads m_quads;           ///< that are yet to be cut
    DepthPatches::Range m_patches; ///< that are yet to be projected
    ProjectedPart m_part;
    simd::PartBoxes m_boxes;
};

void DepthRaster::draw(const DepthMesh& mesh, const Rigid3& cameraFromPhoto, const CameraModel& camera,
                       const OpenCells& open, double tolerancePx, WorkerPool& pool, int threads,
                       InverseBuffer& out) {
    fit(out, camera.width(), camera.height());
    const SurfaceProjector projector(cameraFromPhoto, camera);
    const float tolerance = static_cast<float>(tolerancePx) / std::max(1e-6F, projector.pixelsPerInverse());
    const int bands = out.height() / kBand;
    m_pieces.resize(static_cast<std::size_t>(mesh.blocksY()) * static_cast<std::size_t>(bands));
    pool.run(mesh.blocksY(), threads, [&](int row, int) {
        const std::span<std::vector<Piece>> pieces(m_pieces.data() + static_cast<std::ptrdiff_t>(row) * bands,
                                                   static_cast<std::size_t>(bands));
        for (std::vector<Piece>& of : pieces) {
            of.clear();
        }
        BlockCutter cutter(mesh, projector, open, tolerance, camera.width(), camera.height(), pieces);
        // A block is on its way from memory while the one before it is cut.
        int found = -1;
        for (int column = 0; column < mesh.blocksX(); ++column) {
            if (projector.mayShow(mesh.bound(column, row), open)) {
                mesh.fetch(column, row);
                if (found >= 0) {
                    cutter.cut(found, row);
                }
                found = column;
            }
        }
        if (found >= 0) {
            cutter.cut(found, row);
        }
        cutter.flush();
    });
    pool.run(bands, threads, [&](int band, int) {
        const int begin = band * kBand;
        const int end = begin + kBand;
        clear(band, open, out);
        for (int row = 0; row < mesh.blocksY(); ++row) {
            simd::draw(m_pieces[static_cast<std::size_t>(row * bands + band)], begin, end, out.at(0, 0),
                       out.width());
        }
        for (int y = begin; y < end; ++y) { // beyond the view
            std::fill(out.at(0, y) + (y < camera.height() ? camera.width() : 0), out.at(0, y) + out.width(),
                      1.0F);
        }
    });
}

/// Makes the open cells of a row zero: the others are not looked at.
void DepthRaster::clear(int row, const OpenCells& open, InverseBuffer& out) {
    constexpr int kCell = OpenCells::kCell;
    if (open.isAllOpen()) {
        std::fill_n(out.at(0, row * kCell), static_cast<std::ptrdiff_t>(out.width()) * kCell, 0.0F);
        return;
    }
    for (int column = 0; column < out.width() / kCell; ++column) {
        for (int y = 0; y < kCell && open.isOpen(column, row); ++y) {
            std::fill_n(out.at(column * kCell, row * kCell + y), kCell, 0.0F);
        }
    }
}

} // namespace spherewalk::render
