// SPDX-License-Identifier: Apache-2.0
#include "depth_raster.h"

#include "surface_projector.h"

#include <algorithm>
#include <array>
#include <span>

namespace spherewalk::render {

using simd::Piece;
using simd::ProjectedPart;

namespace {

constexpr int kCulledLevel = 2; ///< quads of this size that cannot show are left out as one

/// A rectangle of a photo with 1 / distance at its corners, in turn from the upper left. Units: half pixels.
struct Facing {
    int left, top, right, bottom;
    std::array<float, 4> inverseM;
};

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
        m_x = blockX * DepthMesh::kBlock;
        m_y = blockY * DepthMesh::kBlock;
        const simd::SurfacePart part = m_mesh.block(blockX, blockY);
        m_projector.project(part, m_part);
        simd::boxes(m_part, part.rows, m_boxes);
        quad(DepthMesh::kLevels - 1, m_x, m_y);
    }

    /// To be called at the end.
    void flush() {
        flushFacings();
        cutAll(m_quads);
        m_quads.count = 0;
    }

  private:
    void cutAll(const simd::Quads& quads) {
        simd::cut(quads, m_width, m_height, m_pieces);
        for (const Piece& piece : m_pieces) {
            if (!m_open.isAllOpen() &&
                !m_open.anyIn(static_cast<float>(piece.left), static_cast<float>(piece.top),
                              static_cast<float>(piece.right), static_cast<float>(piece.bottom))) {
                continue;
            }
            for (int band = piece.top / kBand; band <= piece.bottom / kBand; ++band) {
                m_bands[static_cast<std::size_t>(band)].push_back(piece);
            }
        }
        m_pieces.clear();
    }

    void quad(int level, int x, int y) {
        const int size = 1 << level;
        const int endY = std::min(y + size, m_mesh.height() - 1);
        if (level == 0) {
            smallest(x, y);
            return;
        }
        if (level == kCulledLevel && !mayShow(x, y)) {
            return;
        }
        const bool flat = level <= m_projector.largestLevel() && m_mesh.deviation(level, x, y) < m_tolerance;
        if (flat && add(x, y, x + size, endY)) {
            return;
        }
        for (int j = y; j < endY; j += size / 2) {
            for (int i = x; i < x + size; i += size / 2) {
                quad(level - 1, i, j);
            }
        }
    }

    /// Whether a square of the block may show in cells that are open, or what stands for its pixels does.
    bool mayShow(int x, int y) const {
        constexpr int kSquare = simd::PartBoxes::kSquare;
        const auto i =
            static_cast<std::size_t>((y - m_y) / kSquare * simd::PartBoxes::kSquares + (x - m_x) / kSquare);
        const float beside = 1 + (m_boxes.right[i] - m_boxes.left[i]) / kSquare;
        const float below = 1 + (m_boxes.bottom[i] - m_boxes.top[i]) / kSquare;
        return m_open.anyIn(m_boxes.left[i] - beside, m_boxes.top[i] - below, m_boxes.right[i] + beside,
                            m_boxes.bottom[i] + below);
    }

    /// Four pixels: a surface, unless their distances differ too much. Then each stands by itself or with one
    /// beside it, facing the photo, up to the middle between them and the others.
    void smallest(int x, int y) {
        if (m_mesh.isSurface(x, y)) {
            add(x, y, x + 1, y + 1);
            return;
        }
        const float a = m_mesh.inverseM(x, y);
        const float b = m_mesh.inverseM(x + 1, y);
        const float c = m_mesh.inverseM(x, y + 1);
        const float d = m_mesh.inverseM(x + 1, y + 1);
        const auto row = [&](int top, float left, float right) {
            if (DepthMesh::isSurface({left, right})) {
                add({2 * x, top, 2 * x + 2, top + 1, {left, right, right, left}});
            } else {
                add({2 * x, top, 2 * x + 1, top + 1, {left, left, left, left}});
                add({2 * x + 1, top, 2 * x + 2, top + 1, {right, right, right, right}});
            }
        };
        const auto column = [&](int left, float top, float bottom) {
            if (DepthMesh::isSurface({top, bottom})) {
                add({left, 2 * y, left + 1, 2 * y + 2, {top, top, bottom, bottom}});
            } else {
                add({left, 2 * y, left + 1, 2 * y + 1, {top, top, top, top}});
                add({left, 2 * y + 1, left + 1, 2 * y + 2, {bottom, bottom, bottom, bottom}});
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

    void add(const Facing& part) {
        if (m_facings.count == simd::Quads::kMost) {
            flushFacings();
        }
        const std::array<DepthMesh::Angle, 2> across{m_mesh.azimuth(part.left), m_mesh.azimuth(part.right)};
        const std::array<DepthMesh::Angle, 2> up{m_mesh.elevation(part.top), m_mesh.elevation(part.bottom)};
        const auto to = static_cast<std::size_t>(m_facings.count++);
        for (std::size_t i = 0; i < 4; ++i) {
            const DepthMesh::Angle& azimuth = across[i == 1 || i == 2 ? 1 : 0];
            const DepthMesh::Angle& elevation = up[i / 2];
            m_facings.x[i][to] = elevation.cosine * azimuth.cosine;
            m_facings.y[i][to] = elevation.cosine * azimuth.sine;
            m_facings.z[i][to] = elevation.sine;
            m_facings.inverseM[i][to] = part.inverseM[i];
        }
    }

    void flushFacings() {
        simd::Quads quads;
        m_projector.project(m_facings, quads);
        m_facings.count = 0;
        cutAll(quads);
    }

    /// A quad of the block between these vertices. False if not all of it is in front of the camera.
    bool add(int left, int top, int right, int bottom) {
        const auto index = [&](int x, int y) {
            return static_cast<std::size_t>((y - m_y) * ProjectedPart::kPitch + x - m_x);
        };
        const std::array<std::size_t, 4> corners{index(left, top), index(right, top), index(right, bottom),
                                                 index(left, bottom)};
        if (!std::ranges::all_of(corners, [&](std::size_t corner) { return m_part.value[corner] > 0; })) {
            return false;
        }
        if (m_quads.count == simd::Quads::kMost) {
            cutAll(m_quads);
            m_quads.count = 0;
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
    std::vector<Piece> m_pieces;
    int m_x = 0;
    int m_y = 0;
    simd::Quads m_quads;          ///< that are yet to be cut
    simd::SurfaceQuads m_facings; ///< that are yet to be projected
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
        for (int column = 0; column < mesh.blocksX(); ++column) {
            if (projector.mayShow(mesh.bound(column, row), open)) {
                cutter.cut(column, row);
            }
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
