// SPDX-License-Identifier: Apache-2.0
#include "surface/mesh.h"
#include "surface/surface_view.h"
#include "surface/vertices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace spherewalk::render {

using Eigen::Vector3f;
using simd::Piece;
using simd::ProjectedBlock;

namespace {

constexpr int kSubBlock = EdgePatches::kSubBlock; ///< Its quads are left out together if none can show.
constexpr float kNearestM = 0.005F;               ///< Points that are nearer to the camera are not drawn.

/// Projects a photo's surface into a view. Threads: const functions may run on any number at a time.
class SurfaceProjector {
  public:
    /// aheadM: where the photo's lens stands, as in LensPair. camera: it must outlive the projector.
    SurfaceProjector(const Rigid3& cameraFromPhoto, double aheadM, const CameraModel& camera);

    /// Projects patches, and adds the quads. Range: there is room.
    void project(const simd::SurfacePatches& patches, simd::Quads& out) const;

    /// Projects all vertices of a block.
    void project(const simd::SurfaceBlock& block, simd::ProjectedBlock& out) const;

    /// Whether a block may show in cells that are open.
    bool mayShow(const SurfaceMesh::Bound& bound, const OpenCells& open) const;

    /// By how many pixels a point in the middle of the picture moves, about, if its 1 / distance changes by 1
    /// per metre.
    float pixelsPerInverse() const;

    /// The share of the tolerance in the middle of the picture that a block may use, since a very wide
    /// pinhole's picture is stretched away from its middle.
    float toleranceShare(const SurfaceMesh::Bound& bound) const;

    /// Through a lens straight edges are bent: large quads are not drawn as such.
    int largestLevel() const { return m_isPinhole ? SurfaceMesh::kLevels - 1 : 2; }

  private:
    struct Vertex {
        float x = 0, y = 0;
        float value = 0; ///< As in ProjectedBlock.
    };

    Vertex throughLens(const Eigen::Vector3f& direction, float inverseM) const;

    /// The cosine of the largest angle to the axis in the picture. For a lens it is that of the largest angle
    /// at which vertices are projected.
    static float leastCosine(const CameraModel& camera);

    Eigen::Matrix3f m_rotation;
    Eigen::Vector3f m_translation;
    const CameraModel& m_camera;
    bool m_isPinhole;
    float m_leastCosine;
    simd::SurfaceCamera m_pinhole;
    /// Inward normals of the sides of what the pinhole sees, with a pixel more.
    std::array<Eigen::Vector3f, 5> m_sides;
};

SurfaceProjector::SurfaceProjector(const Rigid3& cameraFromPhoto, double aheadM, const CameraModel& camera)
    : m_rotation(cameraFromPhoto.rotation.toRotationMatrix().cast<float>()),
      m_translation((cameraFromPhoto * Eigen::Vector3d(aheadM, 0, 0)).cast<float>()),
      m_camera(camera),
      m_isPinhole(camera.intrinsics().lens == LensModel::Pinhole),
      m_leastCosine(leastCosine(camera)) {
    const CameraIntrinsics& k = camera.intrinsics();
    Eigen::Map<Eigen::Matrix<float, 3, 3, Eigen::RowMajor>>(m_pinhole.rotation.data()) = m_rotation;
    Vector3f::Map(m_pinhole.translation.data()) = m_translation;
    m_pinhole.fx = static_cast<float>(k.fx);
    m_pinhole.fy = static_cast<float>(k.fy);
    m_pinhole.cx = static_cast<float>(k.cx);
    m_pinhole.cy = static_cast<float>(k.cy);
    m_pinhole.nearestM = kNearestM;
    const auto width = static_cast<float>(k.width);
    const auto height = static_cast<float>(k.height);
    m_sides = {Vector3f(0, 0, 1), Vector3f(m_pinhole.fx, 0, m_pinhole.cx + 1).normalized(),
               Vector3f(-m_pinhole.fx, 0, width - m_pinhole.cx).normalized(),
               Vector3f(0, m_pinhole.fy, m_pinhole.cy + 1).normalized(),
               Vector3f(0, -m_pinhole.fy, height - m_pinhole.cy).normalized()};
}

/// A lens may project directions far beyond its picture, up to the one straight behind it. The corners of the
/// quad there lie all around the picture, so that the quad would cover all of it.
float SurfaceProjector::leastCosine(const CameraModel& camera) {
    constexpr int kSteps = 8; // along each side of the picture
    // More than a quad spans, so that quads at the border are whole.
    const double marginRad = camera.intrinsics().lens == LensModel::Pinhole ? 0 : 0.2;
    constexpr double kMostRad = 3.05;
    double most = 0;
    const auto see = [&](double x, double y) {
        const auto ray = camera.ray({x, y});
        most = std::max(most, ray ? std::atan2(ray->head<2>().norm(), ray->z()) : kMostRad);
    };
    for (int i = 0; i <= kSteps; ++i) {
        const double share = static_cast<double>(i) / kSteps;
        for (const int side : {0, 1}) {
            see(share * camera.width() - 0.5, side * camera.height() - 0.5);
            see(side * camera.width() - 0.5, share * camera.height() - 0.5);
        }
    }
    return static_cast<float>(std::cos(std::min(most + marginRad, kMostRad)));
}

SurfaceProjector::Vertex SurfaceProjector::throughLens(const Vector3f& direction, float inverseM) const {
    const Vector3f q = m_rotation * direction + inverseM * m_translation; // the point, times inverseM
    const float length = q.norm();
    const bool isAhead = length > kNearestM * inverseM && q.z() >= m_leastCosine * length;
    const auto pixel = isAhead ? m_camera.project(q.cast<double>()) : std::nullopt;
    if (!pixel) {
        return {};
    }
    const Vertex at{static_cast<float>(pixel->x()), static_cast<float>(pixel->y()), inverseM / length};
    const bool isNear =
        std::abs(at.x) < ProjectedBlock::kFarthestPx && std::abs(at.y) < ProjectedBlock::kFarthestPx;
    return isNear ? at : Vertex{};
}

void SurfaceProjector::project(const simd::SurfacePatches& patches, simd::Quads& out) const {
    if (m_isPinhole) {
        simd::project(m_pinhole, patches, out);
        return;
    }
    for (int i = 0; i < patches.count; ++i, ++out.count) {
        const auto to = static_cast<std::size_t>(out.count);
        for (std::size_t corner = 0; corner < 4; ++corner) {
            const std::size_t across = corner == 1 || corner == 2 ? 2 : 0;
            const std::size_t up = corner < 2 ? 1 : 3;
            const Vector3f direction(patches.cosine[up][i] * patches.cosine[across][i],
                                     patches.cosine[up][i] * patches.sine[across][i], patches.sine[up][i]);
            const Vertex at = throughLens(direction, patches.inverseM[corner][i]);
            out.x[corner][to] = at.x;
            out.y[corner][to] = at.y;
            out.value[corner][to] = at.value;
        }
    }
}

void SurfaceProjector::project(const simd::SurfaceBlock& block, ProjectedBlock& out) const {
    if (m_isPinhole) {
        simd::project(m_pinhole, block, out);
        return;
    }
    for (int row = 0; row < block.rows; ++row) {
        for (int column = 0; column <= SurfaceMesh::kBlock; ++column) {
            const Vector3f direction(block.cosElevation[row] * block.cosAzimuth[column],
                                     block.cosElevation[row] * block.sinAzimuth[column],
                                     block.sinElevation[row]);
            const Vertex at = throughLens(direction, block.inverseM[row * block.pitch + column]);
            const auto to = static_cast<std::size_t>(row * ProjectedBlock::kPitch + column);
            out.x[to] = at.x;
            out.y[to] = at.y;
            out.value[to] = at.value;
        }
    }
}

bool SurfaceProjector::mayShow(const SurfaceMesh::Bound& bound, const OpenCells& open) const {
    if (!m_isPinhole) {
        return true;
    }
    // In the view a point moves along a line as it comes nearer: all points of the block lie between the
    // ends.
    const Vector3f turned = m_rotation * bound.centre;
    const std::array<Vector3f, 2> ends{turned + bound.least * m_translation,
                                       turned + bound.most * m_translation};
    const float radius = bound.radius;
    for (const Vector3f& inward : m_sides) {
        if (inward.dot(ends[0]) < -radius && inward.dot(ends[1]) < -radius) {
            return false;
        }
    }
    if (std::min(ends[0].z(), ends[1].z()) - radius <= 1e-3F) {
        return true;
    }
    float left = HUGE_VALF;
    float right = -HUGE_VALF;
    float top = HUGE_VALF;
    float bottom = -HUGE_VALF;
    for (const Vector3f& q : ends) {
        const float near = 1 / (q.z() - radius);
        const float far = 1 / (q.z() + radius);
        left = std::min(left, (q.x() - radius) * (q.x() > radius ? far : near));
        right = std::max(right, (q.x() + radius) * (q.x() > -radius ? near : far));
        top = std::min(top, (q.y() - radius) * (q.y() > radius ? far : near));
        bottom = std::max(bottom, (q.y() + radius) * (q.y() > -radius ? near : far));
    }
    return open.anyIn(m_pinhole.fx * left + m_pinhole.cx - 1, m_pinhole.fy * top + m_pinhole.cy - 1,
                      m_pinhole.fx * right + m_pinhole.cx + 1, m_pinhole.fy * bottom + m_pinhole.cy + 1);
}

float SurfaceProjector::pixelsPerInverse() const {
    return m_translation.norm() * std::max(m_pinhole.fx, m_pinhole.fy);
}

float SurfaceProjector::toleranceShare(const SurfaceMesh::Bound& bound) const {
    // At the angle a from the axis, things move 1 / cos^2(a) times as far as in the middle. Up to this much,
    // which is that at 55 degrees, the colours are stretched as well, and nobody sees it.
    constexpr float kUnseen = 3;
    if (!m_isPinhole || kUnseen * m_leastCosine * m_leastCosine >= 1) {
        return 1;
    }
    const Vector3f turned = m_rotation * bound.centre;
    float cosine = 1;
    for (const float inverseM : {bound.least, bound.most}) {
        const Vector3f q = turned + inverseM * m_translation;
        cosine = std::min(cosine, (q.z() - bound.radius) / (q.norm() + bound.radius));
    }
    cosine = std::max(cosine, m_leastCosine);
    return std::min(1.0F, kUnseen * cosine * cosine);
}

/// One for the photo's front lens and one for its back lens.
using LensProjectors = std::array<SurfaceProjector, 2>;

/// The seam of the lenses is a border of blocks wherever the depth's width is a multiple of four blocks.
const SurfaceProjector& projectorOf(const LensProjectors& lenses, const SurfaceMesh::Bound& block) {
    return lenses[block.centre.x() < 0 ? 1 : 0];
}

} // namespace

/// Cuts one block of a surface into flat pieces.
class SurfaceRaster::BlockCutter {
  public:
    BlockCutter(const SurfaceMesh& mesh, const LensProjectors& projectors, const OpenCells& open,
                float tolerance, int width, int height, std::span<std::vector<Piece>> bands)
        : m_mesh(mesh),
          m_projectors(projectors),
          m_open(open),
          m_tolerance(tolerance),
          m_width(width),
          m_height(height),
          m_bands(bands) {}

    void cut(int blockX, int blockY) {
        m_detail = &m_mesh.detail(blockX, blockY);
        m_patches = {};
        m_projector = &projectorOf(m_projectors, m_mesh.bound(blockX, blockY));
        m_toleranceOfBlock = m_tolerance * m_projector->toleranceShare(m_mesh.bound(blockX, blockY));
        const simd::SurfaceBlock part = m_detail->block();
        m_projector->project(part, m_part);
        projectSeam(m_mesh.bound((blockX + 1) % m_mesh.blocksX(), blockY), part);
        simd::boxes(m_part, part.rows, m_boxes);
        m_endY = part.rows - 1;
        quad(SurfaceMesh::kLevels - 1, 0, 0);
        addPatches();
    }

    /// Turns the collected quads into pieces. Call it at the end, too.
    void flush() {
        simd::cut(m_quads, m_width, m_height, m_cut);
        const bool isAllOpen = m_open.isAllOpen();
        for (std::size_t i = 0; i < static_cast<std::size_t>(m_quads.count); ++i) {
            const Piece::Box box = m_cut.boxOf(i);
            if (box.left > box.right || box.top > box.bottom ||
                (!isAllOpen && !m_open.anyIn(box.left, box.top, box.right, box.bottom))) {
                continue;
            }
            for (int band = box.top / kCell; band <= box.bottom / kCell; ++band) {
                simd::add(m_quads, m_cut, i, m_bands[static_cast<std::size_t>(band)]);
            }
        }
        m_quads.count = 0;
    }

  private:
    /// The block's last column is the next one's first. If the other lens sees it, the strip that neither
    /// lens sees is closed between them.
    void projectSeam(const SurfaceMesh::Bound& next, const simd::SurfaceBlock& part) {
        const SurfaceProjector& other = projectorOf(m_projectors, next);
        if (&other == m_projector) {
            return;
        }
        other.project(part, m_seam);
        for (std::size_t at = SurfaceMesh::kBlock; at < m_part.x.size(); at += ProjectedBlock::kPitch) {
            m_part.x[at] = m_seam.x[at];
            m_part.y[at] = m_seam.y[at];
            m_part.value[at] = m_seam.value[at];
        }
    }

    /// Adds a quad of a level or its parts. x, y: its upper left vertex in the block.
    void quad(int level, int x, int y) {
        const int size = 1 << level;
        const int endY = std::min(y + size, m_endY);
        if (level == 0) {
            add(x, y, x + 1, y + 1);
            return;
        }
        const auto subBlock =
            static_cast<std::size_t>(y / kSubBlock * EdgePatches::kSubBlocks + x / kSubBlock);
        if (size == kSubBlock && !mayShow(subBlock)) {
            return;
        }
        const float deviation = m_detail->deviation(level, x, y);
        if (level == 1 && std::isinf(deviation)) {
            return; // it is made of patches
        }
        const bool flat = level <= m_projector->largestLevel() && deviation < m_toleranceOfBlock;
        if (flat && add(x, y, x + size, endY)) {
            return;
        }
        if (size == kSubBlock) {
            addPatchesOf(EdgePatches::orderInBlock(x, y));
        }
        for (int j = y; j < endY; j += size / 2) {
            for (int i = x; i < x + size; i += size / 2) {
                quad(level - 1, i, j);
            }
        }
    }

    /// Whether a sub-block, or the patches of its pixels, may show in cells that are open.
    bool mayShow(std::size_t subBlock) const {
        const float beside = 1 + (m_boxes.right[subBlock] - m_boxes.left[subBlock]) / kSubBlock;
        const float below = 1 + (m_boxes.bottom[subBlock] - m_boxes.top[subBlock]) / kSubBlock;
        return m_open.anyIn(m_boxes.left[subBlock] - beside, m_boxes.top[subBlock] - below,
                            m_boxes.right[subBlock] + beside, m_boxes.bottom[subBlock] + below);
    }

    /// Adds the patches of a sub-block. Patches of sub-blocks that follow each other go together.
    void addPatchesOf(int subBlock) {
        const EdgePatches::Range range = m_detail->patches().ofSubBlock(subBlock);
        if (range.begin != m_patches.end) {
            addPatches();
            m_patches.begin = range.begin;
        }
        m_patches.end = range.end;
    }

    void addPatches() {
        const simd::SurfacePatches patches = m_detail->patches().at(m_patches);
        m_patches.begin = m_patches.end;
        for (int first = 0; first < patches.count;) {
            if (m_quads.count == simd::Quads::kMost) {
                flush();
            }
            const int many = std::min(patches.count - first, simd::Quads::kMost - m_quads.count);
            m_projector->project(patches.part(first, many), m_quads);
            first += many;
        }
    }

    /// Adds the quad between these vertices of the block. Returns false if not all of it is in front of the
    /// camera.
    bool add(int left, int top, int right, int bottom) {
        const auto index = [&](int x, int y) {
            return static_cast<std::size_t>(y * ProjectedBlock::kPitch + x);
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

    const SurfaceMesh& m_mesh;
    const LensProjectors& m_projectors;
    const SurfaceProjector* m_projector = nullptr; ///< The block's.
    const OpenCells& m_open;
    float m_tolerance; ///< In 1/m, in the middle of the picture.
    float m_toleranceOfBlock = 0;
    int m_width;
    int m_height;
    std::span<std::vector<Piece>> m_bands; ///< The pieces go here.
    simd::CutQuads m_cut;
    const SurfaceMesh::Detail* m_detail = nullptr; ///< Of the block.
    int m_endY = 0;                                ///< The last row of the block's vertices.
    simd::Quads m_quads;                           ///< These are yet to be cut.
    EdgePatches::Range m_patches;                  ///< These are yet to be projected.
    ProjectedBlock m_part;
    ProjectedBlock m_seam; ///< The same through the other lens.
    simd::BlockBoxes m_boxes;
};

void SurfaceRaster::draw(const SurfaceMesh& mesh, const Rigid3& cameraFromPhoto, const LensPair& lenses,
                         const CameraModel& camera, const OpenCells& open, double tolerancePx,
                         WorkerPool& pool, int threads, InverseBuffer& out) {
    fit(out, camera.width(), camera.height());
    const LensProjectors projectors{SurfaceProjector(cameraFromPhoto, lenses.aheadM, camera),
                                    SurfaceProjector(cameraFromPhoto, -lenses.aheadM, camera)};
    const float tolerance =
        static_cast<float>(tolerancePx) /
        std::max({1e-6F, projectors[0].pixelsPerInverse(), projectors[1].pixelsPerInverse()});
    const int bands = out.height() / kCell;
    m_pieces.resize(static_cast<std::size_t>(mesh.blocksY()) * static_cast<std::size_t>(bands));
    pool.run(mesh.blocksY(), threads, [&](int row, int) {
        const std::span<std::vector<Piece>> pieces(m_pieces.data() + static_cast<std::ptrdiff_t>(row) * bands,
                                                   static_cast<std::size_t>(bands));
        for (std::vector<Piece>& of : pieces) {
            of.clear();
        }
        BlockCutter cutter(mesh, projectors, open, tolerance, camera.width(), camera.height(), pieces);
        // A block is on its way from memory while the one before it is cut.
        int found = -1;
        for (int column = 0; column < mesh.blocksX(); ++column) {
            const SurfaceMesh::Bound& bound = mesh.bound(column, row);
            if (projectorOf(projectors, bound).mayShow(bound, open)) {
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
        const int begin = band * kCell;
        const int end = begin + kCell;
        open.clear(band, out);
        for (int row = 0; row < mesh.blocksY(); ++row) {
            simd::draw(m_pieces[static_cast<std::size_t>(row * bands + band)], begin, end, out.at(0, 0),
                       out.width());
        }
        for (int y = begin; y < end; ++y) {
            const int width = y < camera.height() ? camera.width() : 0;
            std::fill(out.at(0, y) + width, out.at(0, y) + out.width(), 1.0F); // beyond the view
        }
    });
}

} // namespace spherewalk::render
