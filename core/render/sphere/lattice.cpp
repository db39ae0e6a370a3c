// SPDX-License-Identifier: Apache-2.0
#include "sphere/lattice.h"

#include "sphere/exact_view.h"
#include "sphere/lattice_simd.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace spherewalk::render {

using Eigen::Vector3d;

namespace {

constexpr int kLatticePadding = 16;

int paddedNodes(int count) {
    return (count + 2 * kLatticePadding - 1) / kLatticePadding * kLatticePadding;
}

} // namespace

LatticeFrame::LatticeFrame(const RayTable& table, const Rigid3& roomFromCamera, const Rigid3& roomFromPhoto,
                           const EquirectSize& photo, SceneKind scene, double sphereRadiusM, double tolerance)
    : rays(&table),
      photoFromRay{},
      displaced(scene == SceneKind::Sphere),
      width(photo.width),
      height(photo.height),
      tolerancePx(tolerance) {
    const Eigen::Matrix3d matrix =
        (roomFromPhoto.rotation.conjugate() * roomFromCamera.rotation).toRotationMatrix() *
        table.rayFromPixel();
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(photoFromRay.data()) = matrix;
    if (displaced) {
        Vector3d from = roomFromPhoto.rotation.conjugate() *
                        (roomFromCamera.translation - roomFromPhoto.translation) / sphereRadiusM;
        const double length = from.norm();
        if (length > kLargestDisplacement) {
            from *= kLargestDisplacement / length;
        }
        displacement = {from.x(), from.y(), from.z()};
    }
}

LatticeFrame::LatticeFrame(const Eigen::Matrix3d& matrix, const EquirectSize& photo)
    : photoFromRay{}, width(photo.width), height(photo.height) {
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(photoFromRay.data()) = matrix;
}

LatticeRow::Level::Level(int cellsX, int partsOfCell)
    : parts(partsOfCell),
      values(static_cast<std::size_t>((18 + partsOfCell) * paddedNodes(cellsX * partsOfCell + 1))),
      coefficients(static_cast<std::size_t>(18 * partsOfCell * paddedNodes(cellsX * partsOfCell + 1))),
      centres(static_cast<std::size_t>(2 * partsOfCell * paddedNodes(cellsX * partsOfCell + 1))) {
    const int pitch = paddedNodes(cellsX * parts + 1);
    double* value = values.data();
    float* coefficient = coefficients.data();
    std::int32_t* centre = centres.data();
    const auto next = [pitch](auto*& at) { return std::exchange(at, at + pitch); };
    for (NodeRow& row : nodes) {
        row.edges = {next(value), next(value), nullptr, nullptr};
        row.centres = {next(value), next(value), next(value), next(value)};
    }
    for (int i = 0; i < parts; ++i) {
        PatchRow& row = patches[static_cast<std::size_t>(i)];
        std::generate(row.u.begin(), row.u.end(), [&] { return next(coefficient); });
        std::generate(row.v.begin(), row.v.end(), [&] { return next(coefficient); });
        row.centreU = next(centre);
        row.centreV = next(centre);
        row.fromSeam = next(value);
    }
}

LatticeRow::LatticeRow(int cellsX)
    : m_levels{Level(cellsX, 1), Level(cellsX, 2), Level(cellsX, 4)},
      m_bound(static_cast<std::size_t>(paddedNodes(cellsX))),
      m_mode(static_cast<std::size_t>(cellsX)),
      m_rays(static_cast<std::size_t>(3 * paddedNodes(4 * cellsX + 1))),
      m_raysPitch(paddedNodes(4 * cellsX + 1)) {
}

/// Writes the rays of so many pixels to m_rays.
void LatticeRow::interpolateRays(const RayTable& table, const Eigen::Vector2d& first, double step,
                                 int count) {
    for (int i = 0; i < count; ++i) {
        const Vector3d ray = table.ray(Eigen::Vector2d(first.x() + step * i, first.y()));
        for (int c = 0; c < 3; ++c) {
            m_rays[static_cast<std::size_t>(c * m_raysPitch + i)] = ray[c];
        }
    }
}

/// Computes the nodes of the patches [begin, end) on one row of nodes.
void LatticeRow::evaluateRow(const LatticeFrame& frame, const Level& level, int nodeY, int begin, int end,
                             const NodeRow& row) {
    const RayTable& table = *frame.rays;
    const double size = static_cast<double>(kCell) / level.parts;
    for (const bool edge : {true, false}) {
        const NodeValues& to = edge ? row.edges : row.centres;
        const bool bounds = !edge && level.parts == 1;
        const NodeValues out{to.u + begin, to.v + begin, bounds ? to.cosine + begin : nullptr,
                             bounds ? to.along + begin : nullptr};
        const int count = end - begin + (edge ? 1 : 0);
        const Eigen::Vector2d first(size * (begin + (edge ? 0 : 0.5)) - 0.5, size * 0.5 * nodeY - 0.5);
        if (table.affine()) {
            simd::affineCoordinates(frame, {first.x(), first.y(), size}, count, out);
        } else if (level.parts <= RayTable::kFineParts) {
            const auto rays = [&](int c) { return table.nodes(level.parts, c, edge, nodeY) + begin; };
            simd::photoCoordinates(frame, {rays(0), rays(1), rays(2)}, count, out);
        } else {
            interpolateRays(table, first, size, count);
            const double* rays = m_rays.data();
            simd::photoCoordinates(frame, {rays, rays + m_raysPitch, rays + 2 * m_raysPitch}, count, out);
        }
    }
}

void LatticeRow::beginRow(const LatticeFrame& frame, int cellY) {
    Level& coarse = m_levels[0];
    const int cells = frame.rays->cellsX();
    if (m_cellY == cellY - 1) {
        std::swap(coarse.nodes[0], coarse.nodes[2]);
    } else {
        evaluateRow(frame, coarse, 2 * cellY, 0, cells, coarse.nodes[0]);
    }
    evaluateRow(frame, coarse, 2 * cellY + 1, 0, cells, coarse.nodes[1]);
    evaluateRow(frame, coarse, 2 * cellY + 2, 0, cells, coarse.nodes[2]);
    m_cellY = cellY;
    simd::fitPatches(frame, coarse.nodes, 0, cells, coarse.patches[0]);
    simd::errorBounds(frame, cellY, coarse.nodes[1].centres, m_bound.data());
    chooseModes(frame);
    for (int begin = 0, end = 0; begin < cells; begin = end) {
        for (end = begin + 1; end < cells && mode(end) == mode(begin);) {
            ++end;
        }
        if (mode(begin) == CellMode::Fine || mode(begin) == CellMode::Finest) {
            refine(frame, m_levels[static_cast<std::size_t>(mode(begin))], begin, end);
        }
    }
}

void LatticeRow::chooseModes(const LatticeFrame& frame) {
    for (int x = 0; x < frame.rays->cellsX(); ++x) {
        const double bound = boundPx(x) / frame.tolerancePx;
        const bool isExplicit = frame.rays->explicitCell(x, m_cellY) != nullptr;
        // A bound that is no number fails every comparison.
        m_mode[static_cast<std::size_t>(x)] = isExplicit    ? CellMode::Exact
                                              : bound <= 1  ? CellMode::Coarse
                                              : bound <= 8  ? CellMode::Fine
                                              : bound <= 64 ? CellMode::Finest
                                                            : CellMode::Exact;
    }
}

/// Computes the patches of the cells [begin, end) of the row.
void LatticeRow::refine(const LatticeFrame& frame, Level& level, int begin, int end) {
    const int first = begin * level.parts;
    const int last = end * level.parts;
    const int nodeY = 2 * level.parts * m_cellY;
    evaluateRow(frame, level, nodeY, first, last, level.nodes[0]);
    for (int i = 0; i < level.parts; ++i) {
        evaluateRow(frame, level, nodeY + 2 * i + 1, first, last, level.nodes[1]);
        evaluateRow(frame, level, nodeY + 2 * i + 2, first, last, level.nodes[2]);
        simd::fitPatches(frame, level.nodes, first, last, level.patches[static_cast<std::size_t>(i)]);
        std::swap(level.nodes[0], level.nodes[2]);
    }
}

/// Whether a sample of the cell may lie beyond the seam. Range: not CellMode::Exact.
bool LatticeRow::crossesSeam(int cellX) const {
    const Level& level = levelOf(cellX);
    for (int i = 0; i < level.parts * level.parts; ++i) {
        const PatchRow& row = level.patches[static_cast<std::size_t>(i / level.parts)];
        if (row.fromSeam[level.parts * cellX + i % level.parts] < 0) {
            return true;
        }
    }
    return false;
}

void LatticeRow::coordinates(const LatticeFrame& frame, int cellX, std::int32_t* u, std::int32_t* v) {
    if (mode(cellX) == CellMode::Exact) {
        return exact(frame, cellX, u, v);
    }
    const int n = frame.rays->samplesPerAxis();
    simd::fillCoordinates(levelOf(cellX).patches.data(), levelOf(cellX).parts, cellX, n, u, v);
    if (crossesSeam(cellX)) {
        const auto least = static_cast<std::int32_t>((simd::kOffsetU - 0.5) * kFixedOne + 0.5);
        simd::wrapFixed(u, kCell * kCell * n * n, least, static_cast<std::int32_t>(frame.width * kFixedOne));
    }
}

void LatticeRow::places(const LatticeFrame& frame, int cellX, const Placing& placing, std::int32_t* places,
                        std::int32_t* fractions) {
    const int n = frame.rays->samplesPerAxis();
    if (mode(cellX) == CellMode::Exact || crossesSeam(cellX)) {
        coordinates(frame, cellX, places, fractions);
        simd::locate(placing, kCell * kCell * n * n, places, fractions);
    } else {
        simd::fillPlaces(levelOf(cellX).patches.data(), levelOf(cellX).parts, cellX, n, placing, places,
                         fractions);
    }
}

void LatticeRow::exact(const LatticeFrame& frame, int cellX, std::int32_t* u, std::int32_t* v) {
    const RayTable& table = *frame.rays;
    const int n = table.samplesPerAxis();
    const RayTable::ExplicitCell* given = table.explicitCell(cellX, m_cellY);
    alignas(64) std::array<double, 2 * kLatticePadding> atU;
    alignas(64) std::array<double, 2 * kLatticePadding> atV;
    const NodeValues out{atU.data(), atV.data(), nullptr, nullptr};
    for (int part = 0; part < kCell * n * n; ++part) { // each has sixteen samples
        const Eigen::Vector2d first(kCell * cellX + (part % n + 0.5) / n - 0.5,
                                    kCell * m_cellY + part / (n * n) + (part / n % n + 0.5) / n - 0.5);
        if (given != nullptr) {
            const std::ptrdiff_t count = kCell * kCell * n * n;
            const double* rays = given->rays.data() + part * kCell;
            simd::photoCoordinates(frame, {rays, rays + count, rays + 2 * count}, kCell, out);
        } else if (table.affine()) {
            simd::affineCoordinates(frame, {first.x(), first.y(), 1}, kCell, out);
        } else {
            interpolateRays(table, first, 1, kCell);
            const double* rays = m_rays.data();
            simd::photoCoordinates(frame, {rays, rays + m_raysPitch, rays + 2 * m_raysPitch}, kCell, out);
        }
        simd::toFixed(atU.data(), kCell, simd::kOffsetU, u + part * kCell);
        simd::toFixed(atV.data(), kCell, simd::kOffsetV, v + part * kCell);
    }
}

} // namespace spherewalk::render
