// SPDX-License-Identifier: Apache-2.0
#include "depth_raster.h"

#include "surface_projector.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace spherewalk::render {

using simd::Piece;
using simd::ProjectedPart;

namespace {

/// As ProjectedPart has them.
struct Vertex {
    float x, y, value;
};

constexpr float kJump = 0.08F; ///< of 1 / distance; what differs by more from pixel to pixel is no surface
constexpr float kOverlapPx = 0.25F; ///< pieces reach so far beyond their edges: flat parts leave no cracks
constexpr float kLeastTurn = 1e-4F; ///< of a corner; what is thinner is drawn as triangles, if at all
constexpr int kCulledLevel = 2;     ///< quads of this size that cannot show are left out as one
constexpr int kBand = OpenCells::kCell; ///< rows that one worker draws in turn

/// The first pixel that is not before it, at most one beyond the last.
int firstAt(float begin, float last) {
    const float inView = std::min(std::max(begin, 0.0F), last + 1);
    const int cut = static_cast<int>(inView);
    return cut + (static_cast<float>(cut) < inView ? 1 : 0);
}

/// The last pixel that is not after it, -1 if there is none.
int lastAt(float end, float last) {
    return static_cast<int>(std::min(std::max(end, -1.0F), last) + 1) - 1;
}

/// Twice the area of the triangle, negative if it turns the other way.
float turn(const Vertex& a, const Vertex& b, const Vertex& c) {
    return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
}

} // namespace

/// Cuts one block of a surface into flat pieces.
class DepthRaster::BlockCutter {
  public:
    BlockCutter(const DepthMesh& mesh, const SurfaceProjector& projector, const OpenCells& open,
                float tolerance, int width, int height, Block& block)
        : m_mesh(mesh),
          m_projector(projector),
          m_open(open),
          m_tolerance(tolerance),
          m_lastX(static_cast<float>(width - 1)),
          m_lastY(static_cast<float>(height - 1)),
          m_block(block) {
        m_block.top = height;
        m_block.bottom = -1;
    }

    void cut(int blockX, int blockY) {
        m_x = blockX * DepthMesh::kBlock;
        m_y = blockY * DepthMesh::kBlock;
        const simd::SurfacePart block = m_mesh.block(blockX, blockY);
        m_projector.project(block, m_part);
        simd::boxes(m_part, block.rows, m_boxes);
        quad(DepthMesh::kLevels - 1, m_x, m_y);
    }

  private:
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
        if (flat && surface({vertex(x, y), vertex(x + size, y), vertex(x + size, endY), vertex(x, endY)})) {
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

    /// Four pixels: a surface, unless their distances differ too much. Then each stands by itself, facing the
    /// photo, up to the middle between them.
    void smallest(int x, int y) {
        const std::array<float, 4> values{m_mesh.inverseM(x, y), m_mesh.inverseM(x + 1, y),
                                          m_mesh.inverseM(x, y + 1), m_mesh.inverseM(x + 1, y + 1)};
        const float least = std::min(std::min(values[0], values[1]), std::min(values[2], values[3]));
        const float most = std::max(std::max(values[0], values[1]), std::max(values[2], values[3]));
        if (most - least < kJump * most) {
            surface({vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1), vertex(x, y + 1)});
            return;
        }
        simd::SixteenPoints points;
        for (int i = 0; i < 16; ++i) { // four corners of each pixel's quarter
            const auto to = static_cast<std::size_t>(i);
            const int right = i / 4 % 2 + (i % 4 == 1 || i % 4 == 2 ? 1 : 0);
            const int down = i / 8 + (i % 4 >= 2 ? 1 : 0);
            const Eigen::Vector3f direction = m_mesh.direction(2 * x + right, 2 * y + down);
            points.x[to] = direction.x();
            points.y[to] = direction.y();
            points.z[to] = direction.z();
            points.inverseM[to] = values[to / 4];
        }
        simd::SixteenVertices v;
        m_projector.project(points, v);
        const auto corner = [&](std::size_t i) { return Vertex{v.x[i], v.y[i], v.value[i]}; };
        for (std::size_t i = 0; i < 16; i += 4) {
            surface({corner(i), corner(i + 1), corner(i + 2), corner(i + 3)});
        }
    }

    Vertex vertex(int x, int y) const {
        const auto i = static_cast<std::size_t>((y - m_y) * ProjectedPart::kPitch + x - m_x);
        return {m_part.x[i], m_part.y[i], m_part.value[i]};
    }

    /// Vertices in turn. False if not all of it is in front of the camera.
    bool surface(const std::array<Vertex, 4>& v) {
        if (!(v[0].value > 0 && v[1].value > 0 && v[2].value > 0 && v[3].value > 0)) {
            return false;
        }
        const float left = std::min(std::min(v[0].x, v[1].x), std::min(v[2].x, v[3].x)) - kOverlapPx;
        const float right = std::max(std::max(v[0].x, v[1].x), std::max(v[2].x, v[3].x)) + kOverlapPx;
        const float top = std::min(std::min(v[0].y, v[1].y), std::min(v[2].y, v[3].y)) - kOverlapPx;
        const float bottom = std::max(std::max(v[0].y, v[1].y), std::max(v[2].y, v[3].y)) + kOverlapPx;
        Piece piece;
        piece.left = firstAt(left, m_lastX);
        piece.right = lastAt(right, m_lastX);
        piece.top = firstAt(top, m_lastY);
        piece.bottom = lastAt(bottom, m_lastY);
        if (piece.left > piece.right || piece.top > piece.bottom || !m_open.anyIn(left, top, right, bottom)) {
            return true;
        }
        const std::array<float, 4> turns{turn(v[0], v[1], v[2]), turn(v[1], v[2], v[3]),
                                         turn(v[2], v[3], v[0]), turn(v[3], v[0], v[1])};
        const float smallestTurn = std::min(std::min(turns[0], turns[1]), std::min(turns[2], turns[3]));
        const float largestTurn = std::max(std::max(turns[0], turns[1]), std::max(turns[2], turns[3]));
        if (smallestTurn > kLeastTurn || largestTurn < -kLeastTurn) {
            whole(v, smallestTurn > 0 ? 1.0F : -1.0F, piece);
            return true;
        }
        half({v[0], v[1], v[3]}, turns[3], piece);
        half({v[1], v[2], v[3]}, turns[1], piece);
        return true;
    }

    static void edge(const Vertex& from, const Vertex& to, float sign, std::size_t i, Piece& piece) {
        const float a = sign * (from.y - to.y);
        const float b = sign * (to.x - from.x);
        piece.a[i] = a;
        piece.b[i] = b;
        piece.c[i] = -(a * from.x + b * from.y) + kOverlapPx * (std::abs(a) + std::abs(b));
    }

    /// A convex quad. Its values are the plane's through the middle that rises as the diagonals do.
    void whole(const std::array<Vertex, 4>& v, float sign, Piece& piece) {
        for (std::size_t i = 0; i < 4; ++i) {
            edge(v[i], v[(i + 1) % 4], sign, i, piece);
        }
        slope(v[2].x - v[0].x, v[2].y - v[0].y, v[2].value - v[0].value, v[3].x - v[1].x, v[3].y - v[1].y,
              v[3].value - v[1].value, piece);
        piece.base = 0.25F * (v[0].value + v[1].value + v[2].value + v[3].value -
                              piece.slopeX * (v[0].x + v[1].x + v[2].x + v[3].x) -
                              piece.slopeY * (v[0].y + v[1].y + v[2].y + v[3].y));
        piece.least = std::min(std::min(v[0].value, v[1].value), std::min(v[2].value, v[3].value));
        piece.most = std::max(std::max(v[0].value, v[1].value), std::max(v[2].value, v[3].value));
        add(piece);
    }

    void half(const std::array<Vertex, 3>& v, float area, Piece& piece) {
        if (!(std::abs(area) > kLeastTurn)) {
            return;
        }
        for (std::size_t i = 0; i < 3; ++i) {
            edge(v[i], v[(i + 1) % 3], area > 0 ? 1.0F : -1.0F, i, piece);
        }
        piece.a[3] = 0;
        piece.b[3] = 0;
        piece.c[3] = 1;
        slope(v[1].x - v[0].x, v[1].y - v[0].y, v[1].value - v[0].value, v[2].x - v[0].x, v[2].y - v[0].y,
              v[2].value - v[0].value, piece);
        piece.base = v[0].value - piece.slopeX * v[0].x - piece.slopeY * v[0].y;
        piece.least = std::min(v[0].value, std::min(v[1].value, v[2].value));
        piece.most = std::max(v[0].value, std::max(v[1].value, v[2].value));
        add(piece);
    }

    /// From how much the value rises along two directions.
    static void slope(float x1, float y1, float rise1, float x2, float y2, float rise2, Piece& piece) {
        const float scale = 1 / (x1 * y2 - x2 * y1);
        piece.slopeX = (rise1 * y2 - rise2 * y1) * scale;
        piece.slopeY = (x1 * rise2 - x2 * rise1) * scale;
    }

    void add(const Piece& piece) {
        m_block.pieces.push_back(piece);
        m_block.top = std::min(m_block.top, piece.top);
        m_block.bottom = std::max(m_block.bottom, piece.bottom);
    }

    const DepthMesh& m_mesh;
    const SurfaceProjector& m_projector;
    const OpenCells& m_open;
    float m_tolerance;
    float m_lastX;
    float m_lastY;
    Block& m_block;
    int m_x = 0;
    int m_y = 0;
    ProjectedPart m_part;
    simd::PartBoxes m_boxes;
};

void DepthRaster::draw(const DepthMesh& mesh, const Rigid3& cameraFromPhoto, const CameraModel& camera,
                       const OpenCells& open, double tolerancePx, WorkerPool& pool, int threads,
                       InverseBuffer& out) {
    fit(out, camera.width(), camera.height());
    const SurfaceProjector projector(cameraFromPhoto, camera);
    const float tolerance = static_cast<float>(tolerancePx) / std::max(1e-6F, projector.pixelsPerInverse());
    const int columns = mesh.blocksX();
    m_blocks.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(mesh.blocksY()));
    pool.run(mesh.blocksY(), threads, [&](int row, int) {
        for (int column = 0; column < columns; ++column) {
            Block& block = m_blocks[static_cast<std::size_t>(row * columns + column)];
            block.pieces.clear();
            if (projector.mayShow(mesh.bound(column, row), open)) {
                BlockCutter(mesh, projector, open, tolerance, camera.width(), camera.height(), block)
                    .cut(column, row);
            }
        }
    });
    m_drawn.clear();
    for (const Block& block : m_blocks) {
        if (!block.pieces.empty()) {
            m_drawn.push_back(&block);
        }
    }
    pool.run(out.height() / kBand, threads, [&](int band, int) {
        const int begin = band * kBand;
        const int end = begin + kBand;
        clear(band, open, out);
        for (const Block* block : m_drawn) {
            if (block->bottom >= begin && block->top < end) {
                simd::draw(block->pieces, begin, end, out.at(0, 0), out.width());
            }
        }
        for (int y = begin; y < end; ++y) { // beyond the view
            std::fill(out.at(0, y) + (y < camera.height() ? camera.width() : 0), out.at(0, y) + out.width(),
                      1.0F);
        }
    });
}

/// Makes the open cells of a row zero: the others are not looked at.
void DepthRaster::clear(int row, const OpenCells& open, InverseBuffer& out) {
    for (int column = 0; column < out.width() / OpenCells::kCell; ++column) {
        for (int y = 0; y < OpenCells::kCell && open.isOpen(column, row); ++y) {
            std::fill_n(out.at(column * OpenCells::kCell, row * OpenCells::kCell + y), OpenCells::kCell,
                        0.0F);
        }
    }
}

} // namespace spherewalk::render
