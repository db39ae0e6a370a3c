// SPDX-License-Identifier: Apache-2.0
#include "depth_raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace spherewalk::render {

using Eigen::Vector3f;

namespace {

constexpr float kNearestM = 0.005F; ///< in front of the camera
constexpr float kJump = 0.08F; ///< of 1 / distance; what differs by more from pixel to pixel is no surface
constexpr float kOverlapPx = 0.25F; ///< triangles reach so far beyond their edges: flat parts leave no cracks
constexpr int kBand = 16;           ///< rows that one worker draws in turn

} // namespace

OpenCells::OpenCells(int width, int height)
    : m_width((width + kCell - 1) / kCell), m_height((height + kCell - 1) / kCell) {
    for (int y = 0; y <= m_height; ++y) {
        for (int x = 0; x <= m_width; ++x) {
            m_sums.push_back(x * y);
        }
    }
}

void OpenCells::update(std::span<const InverseBuffer> buffers, WorkerPool& pool, int threads) {
    std::vector<int> open(static_cast<std::size_t>(m_width * m_height));
    const int width = buffers.front().width();
    const int height = buffers.front().height();
    pool.run(m_height, threads, [&](int row, int) {
        std::vector<float> covered(static_cast<std::size_t>(m_width * kCell), 1.0F);
        int* cells = open.data() + static_cast<std::ptrdiff_t>(row) * m_width;
        for (int y = row * kCell; y < std::min(height, (row + 1) * kCell); ++y) {
            std::copy_n(buffers.front().at(0, y), width, covered.data());
            for (const InverseBuffer& buffer : buffers.subspan(1)) {
                const float* values = buffer.at(0, y);
                for (int x = 0; x < width; ++x) {
                    covered[static_cast<std::size_t>(x)] += values[x];
                }
            }
            for (int column = 0; column < m_width; ++column) {
                const float* values = covered.data() + static_cast<std::ptrdiff_t>(column) * kCell;
                cells[column] |= *std::min_element(values, values + kCell) > 0 ? 0 : 1;
            }
        }
    });
    const std::size_t pitch = static_cast<std::size_t>(m_width) + 1;
    for (std::size_t y = 1; y <= static_cast<std::size_t>(m_height); ++y) {
        for (std::size_t x = 1; x < pitch; ++x) {
            m_sums[y * pitch + x] = open[(y - 1) * (pitch - 1) + x - 1] + m_sums[(y - 1) * pitch + x] +
                                    m_sums[y * pitch + x - 1] - m_sums[(y - 1) * pitch + x - 1];
        }
    }
}

bool OpenCells::anyIn(float left, float top, float right, float bottom) const {
    const auto cell = [](float pixel, int count, int more) {
        const float clamped = std::clamp(pixel / kCell, -1.0F, static_cast<float>(count));
        return static_cast<std::size_t>(std::clamp(static_cast<int>(std::floor(clamped)) + more, 0, count));
    };
    const std::size_t x0 = cell(left, m_width, 0);
    const std::size_t x1 = cell(right, m_width, 1);
    const std::size_t y0 = cell(top, m_height, 0);
    const std::size_t y1 = cell(bottom, m_height, 1);
    const std::size_t pitch = static_cast<std::size_t>(m_width) + 1;
    return x1 > x0 && y1 > y0 &&
           m_sums[y1 * pitch + x1] - m_sums[y0 * pitch + x1] - m_sums[y1 * pitch + x0] +
                   m_sums[y0 * pitch + x0] >
               0;
}

/// From the photo's surface to the view.
class DepthRaster::Projector {
  public:
    Projector(const Rigid3& cameraFromPhoto, const CameraModel& camera)
        : m_rotation(cameraFromPhoto.rotation.toRotationMatrix().cast<float>()),
          m_translation(cameraFromPhoto.translation.cast<float>()),
          m_camera(camera),
          m_isPinhole(camera.intrinsics().lens == LensModel::Pinhole),
          m_fx(static_cast<float>(camera.intrinsics().fx)),
          m_fy(static_cast<float>(camera.intrinsics().fy)),
          m_cx(static_cast<float>(camera.intrinsics().cx)),
          m_cy(static_cast<float>(camera.intrinsics().cy)) {}

    /// direction: in the photo's frame.
    Vertex vertex(const Vector3f& direction, float inverseM) const {
        const Vector3f q = m_rotation * direction + inverseM * m_translation; // the point, times inverseM
        if (!m_isPinhole) {
            return throughLens(q, inverseM);
        }
        if (!(q.z() > kNearestM * inverseM)) {
            return {};
        }
        const float scale = 1 / q.z();
        return {m_fx * q.x() * scale + m_cx, m_fy * q.y() * scale + m_cy, inverseM * scale};
    }

    /// Whether a block may show in cells that are open.
    bool mayShow(const DepthMesh::Bound& bound, const OpenCells& open) const {
        const float middle = 0.5F * (bound.least + bound.most);
        const Vector3f q = m_rotation * bound.centre + middle * m_translation;
        const float radius = bound.radius + 0.5F * (bound.most - bound.least) * m_translation.norm();
        if (!m_isPinhole) {
            return true;
        }
        if (q.z() + radius <= 0) {
            return false;
        }
        if (q.z() - radius <= 1e-3F) {
            return true;
        }
        const float near = 1 / (q.z() - radius);
        const float far = 1 / (q.z() + radius);
        const auto least = [&](float value) {
            return std::min((value - radius) * near, (value - radius) * far);
        };
        const auto most = [&](float value) {
            return std::max((value + radius) * near, (value + radius) * far);
        };
        return open.anyIn(m_fx * least(q.x()) + m_cx - 1, m_fy * least(q.y()) + m_cy - 1,
                          m_fx * most(q.x()) + m_cx + 1, m_fy * most(q.y()) + m_cy + 1);
    }

    /// Pixels that a point moves by, about, if its 1 / distance changes by 1 per metre.
    float pixelsPerInverse() const { return m_translation.norm() * std::max(m_fx, m_fy); }

    /// Through a lens straight edges are bent: large quads are not drawn as such.
    int largestLevel() const { return m_isPinhole ? DepthMesh::kLevels - 1 : 2; }

  private:
    Vertex throughLens(const Vector3f& q, float inverseM) const {
        const float length = q.norm();
        if (!(length > kNearestM * inverseM)) {
            return {};
        }
        const auto pixel = m_camera.project(q.cast<double>());
        if (!pixel) {
            return {};
        }
        return {static_cast<float>(pixel->x()), static_cast<float>(pixel->y()), inverseM / length};
    }

    Eigen::Matrix3f m_rotation;
    Vector3f m_translation;
    const CameraModel& m_camera;
    bool m_isPinhole;
    float m_fx, m_fy, m_cx, m_cy;
};

/// Cuts one block into triangles.
class DepthRaster::BlockDrawer {
  public:
    BlockDrawer(const DepthMesh& mesh, const Projector& projector, float tolerance, float width, float height,
                Block& block)
        : m_mesh(mesh),
          m_projector(projector),
          m_tolerance(tolerance),
          m_width(width),
          m_height(height),
          m_block(block) {
        m_block.top = HUGE_VALF;
        m_block.bottom = -HUGE_VALF;
    }

    void draw(int blockX, int blockY) {
        m_x = blockX * DepthMesh::kBlock;
        m_y = blockY * DepthMesh::kBlock;
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
        const bool flat = level <= m_projector.largestLevel() && m_mesh.deviation(level, x, y) < m_tolerance;
        if (flat && surface({vertex(x, y), vertex(x + size, y), vertex(x, endY), vertex(x + size, endY)})) {
            return;
        }
        for (int j = y; j < endY; j += size / 2) {
            for (int i = x; i < x + size; i += size / 2) {
                quad(level - 1, i, j);
            }
        }
    }

    /// Four pixels: a surface, unless their distances differ too much. Then each stands by itself, facing the
    /// photo, up to the middle between them.
    void smallest(int x, int y) {
        const std::array<float, 4> values{m_mesh.inverseM(x, y), m_mesh.inverseM(x + 1, y),
                                          m_mesh.inverseM(x, y + 1), m_mesh.inverseM(x + 1, y + 1)};
        const auto [least, most] = std::minmax_element(values.begin(), values.end());
        if (*most - *least < kJump * *most) {
            surface({vertex(x, y), vertex(x + 1, y), vertex(x, y + 1), vertex(x + 1, y + 1)});
            return;
        }
        for (int i = 0; i < 4; ++i) {
            const int left = 2 * x + i % 2;
            const int top = 2 * y + i / 2;
            const float value = values[static_cast<std::size_t>(i)];
            surface({corner(left, top, value), corner(left + 1, top, value), corner(left, top + 1, value),
                     corner(left + 1, top + 1, value)});
        }
    }

    Vertex corner(int halfX, int halfY, float value) const {
        return m_projector.vertex(m_mesh.direction(halfX, halfY), value);
    }

    /// A block's vertices are asked for up to four times.
    const Vertex& vertex(int x, int y) {
        const auto i = static_cast<std::size_t>((y - m_y) * (DepthMesh::kBlock + 1) + x - m_x);
        if (!m_known[i]) {
            m_known[i] = true;
            m_vertices[i] = corner(2 * x, 2 * y, m_mesh.inverseM(x, y));
        }
        return m_vertices[i];
    }

    /// False if not all of it is in front of the camera.
    bool surface(const std::array<Vertex, 4>& v) {
        if (!(v[0].value > 0 && v[1].value > 0 && v[2].value > 0 && v[3].value > 0)) {
            return false;
        }
        triangle(v[0], v[1], v[2]);
        triangle(v[1], v[3], v[2]);
        return true;
    }

    void triangle(const Vertex& a, const Vertex& b, const Vertex& c) {
        const float left = std::min({a.x, b.x, c.x});
        const float right = std::max({a.x, b.x, c.x});
        const float top = std::min({a.y, b.y, c.y});
        const float bottom = std::max({a.y, b.y, c.y});
        if (!(right > -1 && left < m_width && bottom > -1 && top < m_height)) {
            return;
        }
        const float area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
        if (!(std::abs(area) > 1e-4F)) {
            return;
        }
        const Vertex& second = area > 0 ? b : c; // all turn the same way
        const Vertex& third = area > 0 ? c : b;
        const float share = 1 / std::abs(area);
        const float up = second.value - a.value;
        const float across = third.value - a.value;
        const float slopeX = (up * (third.y - a.y) - across * (second.y - a.y)) * share;
        const float slopeY = (across * (second.x - a.x) - up * (third.x - a.x)) * share;
        m_block.triangles.push_back({{a.x, second.x, third.x},
                                     {a.y, second.y, third.y},
                                     slopeX,
                                     slopeY,
                                     a.value - slopeX * a.x - slopeY * a.y,
                                     std::min({a.value, b.value, c.value}),
                                     std::max({a.value, b.value, c.value})});
        m_block.top = std::min(m_block.top, top);
        m_block.bottom = std::max(m_block.bottom, bottom);
    }

    static constexpr std::size_t kVertices = std::size_t{DepthMesh::kBlock + 1} * (DepthMesh::kBlock + 1);

    const DepthMesh& m_mesh;
    const Projector& m_projector;
    float m_tolerance;
    float m_width;
    float m_height;
    Block& m_block;
    int m_x = 0;
    int m_y = 0;
    std::array<Vertex, kVertices> m_vertices;
    std::array<bool, kVertices> m_known{};
};

void DepthRaster::draw(const DepthMesh& mesh, const Rigid3& cameraFromPhoto, const CameraModel& camera,
                       const OpenCells& open, double tolerancePx, WorkerPool& pool, int threads,
                       InverseBuffer& out) {
    if (out.width() != camera.width() || out.height() != camera.height()) {
        out = InverseBuffer(camera.width(), camera.height());
    }
    const Projector projector(cameraFromPhoto, camera);
    const float tolerance = static_cast<float>(tolerancePx) / std::max(1e-6F, projector.pixelsPerInverse());
    const int columns = mesh.blocksX();
    m_blocks.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(mesh.blocksY()));
    pool.run(mesh.blocksY(), threads, [&](int row, int) {
        for (int column = 0; column < columns; ++column) {
            Block& block = m_blocks[static_cast<std::size_t>(row * columns + column)];
            block.triangles.clear();
            if (projector.mayShow(mesh.bound(column, row), open)) {
                BlockDrawer(mesh, projector, tolerance, static_cast<float>(camera.width()),
                            static_cast<float>(camera.height()), block)
                    .draw(column, row);
            }
        }
    });
    pool.run((camera.height() + kBand - 1) / kBand, threads, [&](int band, int) {
        const int end = std::min(camera.height(), (band + 1) * kBand);
        drawBand(m_blocks, band * kBand, end, out);
    });
}

void DepthRaster::drawBand(std::span<const Block> blocks, int begin, int end, InverseBuffer& out) {
    for (int y = begin; y < end; ++y) {
        std::fill(out.row(y).begin(), out.row(y).end(), 0.0F);
    }
    for (const Block& block : blocks) {
        if (block.triangles.empty() || block.bottom < static_cast<float>(begin - 1) ||
            block.top > static_cast<float>(end)) {
            continue;
        }
        for (const Triangle& triangle : block.triangles) {
            drawTriangle(triangle, begin, end, out);
        }
    }
}

void DepthRaster::drawTriangle(const Triangle& t, int begin, int end, InverseBuffer& out) {
    const float top = std::min({t.y[0], t.y[1], t.y[2]}) - kOverlapPx;
    const float bottom = std::max({t.y[0], t.y[1], t.y[2]}) + kOverlapPx;
    const int first = std::max(begin, static_cast<int>(std::ceil(std::max(top, -1.0F))));
    const int last = std::min(end - 1, static_cast<int>(std::floor(std::min(bottom, 65536.0F))));
    if (first > last) {
        return;
    }
    const auto width = static_cast<float>(out.width());
    const float left = std::max(0.0F, std::min({t.x[0], t.x[1], t.x[2]}) - kOverlapPx);
    const float right = std::min(width - 1, std::max({t.x[0], t.x[1], t.x[2]}) + kOverlapPx);

    // Inside of the edge from a to b: normalX x + normalY y + distance >= 0, once it was moved outwards.
    struct Edge {
        float normalX, normalY, distance, inverse;
    };

    std::array<Edge, 3> edges;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const float normalX = t.y[i] - t.y[j];
        const float normalY = t.x[j] - t.x[i];
        const float overlap = kOverlapPx * (std::abs(normalX) + std::abs(normalY));
        edges[i] = {normalX, normalY, -(normalX * t.x[i] + normalY * t.y[i]) + overlap,
                    normalX != 0 ? 1 / normalX : 0};
    }
    for (int y = first; y <= last; ++y) {
        const auto at = static_cast<float>(y);
        float from = left;
        float to = right;
        for (const Edge& edge : edges) {
            const float rest = edge.normalY * at + edge.distance;
            const float bound = -rest * edge.inverse;
            from = edge.normalX > 0 ? std::max(from, bound) : from;
            to = edge.normalX < 0 ? std::min(to, bound) : to;
            to = edge.normalX == 0 && rest < 0 ? -1 : to;
        }
        if (!(from <= to)) {
            continue;
        }
        const float base = t.slopeY * at + t.base;
        float* row = out.at(0, y);
        const int stop = static_cast<int>(to);
        for (int x = static_cast<int>(std::ceil(from)); x <= stop; ++x) {
            float value = t.slopeX * static_cast<float>(x) + base;
            value = value < t.least ? t.least : value;
            value = value > t.most ? t.most : value;
            row[x] = row[x] < value ? value : row[x];
        }
    }
}

} // namespace spherewalk::render
