// SPDX-License-Identifier: Apache-2.0
#include "lattice.h"

#include "lattice_simd.h"
#include "photo_plane.h"

#include <algorithm>
#include <cmath>

namespace spherewalk::render {

using Eigen::Vector3d;

namespace {

constexpr int kCell = RayTable::kCell;
constexpr double kUnit = 1 << kFractionBits;
constexpr double kOffsetU = PlaneLayout::kGuard + kRoundingU;
constexpr double kOffsetV = PlaneLayout::kGuard;
constexpr int kMostNodes = 96; // of a cell at its densest, 9 x 9, padded

std::int32_t fixedPoint(double value, double offset) {
    return static_cast<std::int32_t>((value + offset) * kUnit + 0.5);
}

/// The biquadratic through 3 x 3 of the values, relative to the middle one, in fixed point.
std::array<float, 9> patch(const double* middle, int pitch, double period) {
    std::array<std::array<double, 3>, 3> rows{};
    for (int y = 0; y < 3; ++y) {
        std::array<double, 3> f{};
        for (int x = 0; x < 3; ++x) {
            double difference = middle[(y - 1) * pitch + x - 1] - *middle;
            difference -= difference > period / 2 ? period : difference < -period / 2 ? -period : 0;
            f[static_cast<std::size_t>(x)] = difference;
        }
        rows[static_cast<std::size_t>(y)] = {f[1], 0.5 * (f[2] - f[0]), 0.5 * (f[2] + f[0]) - f[1]};
    }
    std::array<float, 9> result{};
    for (std::size_t i = 0; i < 3; ++i) {
        result[3 * i] = static_cast<float>(kUnit * rows[1][i]);
        result[3 * i + 1] = static_cast<float>(kUnit * 0.5 * (rows[2][i] - rows[0][i]));
        result[3 * i + 2] = static_cast<float>(kUnit * (0.5 * (rows[2][i] + rows[0][i]) - rows[1][i]));
    }
    return result;
}

/// Whether a patch about u may reach over the seam.
bool crossesSeam(double u, const std::array<float, 9>& coefficients, double width) {
    double reach = 2 * kUnit;
    for (const float c : coefficients) {
        reach += std::abs(c);
    }
    reach *= 2 / kUnit; // samples lie within the nodes; twice that is safe, and cells at the seam are few
    return u - reach < -0.5 || u + reach > width - 0.5;
}

} // namespace

Lattice::Lattice(const RayTable& table, const Rigid3& roomFromCamera, const Rigid3& roomFromPhoto,
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

LatticeScratch::LatticeScratch(int cellsX)
    : m_pitch((cellsX + 1 + 31) / 16 * 16),
      m_nodes(static_cast<std::size_t>(21 * m_pitch)),
      m_coefficients(static_cast<std::size_t>(18 * m_pitch)),
      m_bound(static_cast<std::size_t>(m_pitch)),
      m_mode(static_cast<std::size_t>(m_pitch)),
      m_rays(5 * kMostNodes + 64) {
    double* at = m_nodes.data();
    const auto next = [&] {
        at += m_pitch;
        return at - m_pitch;
    };
    for (NodeRow& row : m_rows) {
        row = {next(), next(), next(), next(), next(), next()};
    }
    for (int i = 0; i < 9; ++i) {
        m_quadratics.u[i] = m_coefficients.data() + i * m_pitch;
        m_quadratics.v[i] = m_coefficients.data() + (9 + i) * m_pitch;
    }
}

void LatticeScratch::evaluateRow(const Lattice& lattice, int nodeY, const NodeRow& row) {
    const RayTable& table = *lattice.rays;
    if (!table.affine()) {
        const auto rays = [&](bool edge) {
            return simd::RayArrays{table.nodes(0, edge, nodeY), table.nodes(1, edge, nodeY),
                                   table.nodes(2, edge, nodeY)};
        };
        simd::photoCoordinates(lattice, rays(true), table.cellsX() + 1, row.edgeU, row.edgeV, nullptr,
                               nullptr);
        simd::photoCoordinates(lattice, rays(false), table.cellsX(), row.centreU, row.centreV, row.centreCos,
                               row.centreAlong);
        return;
    }
    simd::affineCoordinates(lattice, {-0.5, RayTable::kNodeStep * nodeY - 0.5, kCell}, table.cellsX() + 1,
                            row.edgeU, row.edgeV, nullptr, nullptr);
    simd::affineCoordinates(lattice, {RayTable::kNodeStep - 0.5, RayTable::kNodeStep * nodeY - 0.5, kCell},
                            table.cellsX(), row.centreU, row.centreV, row.centreCos, row.centreAlong);
}

void LatticeScratch::beginRow(const Lattice& lattice, int cellY) {
    if (m_cellY == cellY - 1) {
        std::swap(m_rows[0], m_rows[2]);
    } else {
        evaluateRow(lattice, 2 * cellY, m_rows[0]);
    }
    evaluateRow(lattice, 2 * cellY + 1, m_rows[1]);
    evaluateRow(lattice, 2 * cellY + 2, m_rows[2]);
    m_cellY = cellY;
    simd::biquadratics(lattice, cellY, m_rows, m_quadratics, m_bound.data());
    for (int x = 0; x < lattice.rays->cellsX(); ++x) {
        const double bound = m_bound[static_cast<std::size_t>(x)] / lattice.tolerancePx;
        const bool isExplicit = lattice.rays->explicitCell(x, cellY) != nullptr;
        // A bound that is no number fails every comparison.
        m_mode[static_cast<std::size_t>(x)] = isExplicit    ? CellMode::Exact
                                              : bound <= 1  ? CellMode::Coarse
                                              : bound <= 8  ? CellMode::Fine
                                              : bound <= 64 ? CellMode::Finest
                                                            : CellMode::Exact;
    }
}

void LatticeScratch::coordinates(const Lattice& lattice, int cellX, std::int32_t* u, std::int32_t* v) {
    switch (mode(cellX)) {
    case CellMode::Fine:
        return subdivided(lattice, cellX, 2, u, v);
    case CellMode::Finest:
        return subdivided(lattice, cellX, 4, u, v);
    case CellMode::Exact:
        return exact(lattice, cellX, u, v);
    case CellMode::Coarse:
        break;
    }
    std::array<float, 9> inU{};
    std::array<float, 9> inV{};
    for (std::size_t i = 0; i < 9; ++i) {
        inU[i] = m_quadratics.u[i][cellX];
        inV[i] = m_quadratics.v[i][cellX];
    }
    const int n = lattice.rays->samplesPerAxis();
    const double centreU = m_rows[1].centreU[cellX];
    simd::fillPatch({kCell, n}, inU, fixedPoint(centreU, kOffsetU), u);
    simd::fillPatch({kCell, n}, inV, fixedPoint(m_rows[1].centreV[cellX], kOffsetV), v);
    if (crossesSeam(centreU, inU, lattice.width)) {
        simd::wrapFixed(u, kCell * kCell * n * n, fixedPoint(-0.5, kOffsetU), fixedPoint(lattice.width, 0));
    }
}

void LatticeScratch::subdivided(const Lattice& lattice, int cellX, int parts, std::int32_t* u,
                                std::int32_t* v) {
    const RayTable& table = *lattice.rays;
    const int nodes = 2 * parts + 1;
    const double step = static_cast<double>(kCell) / (2 * parts);
    double* x = m_rays.data();
    double* y = x + kMostNodes;
    double* z = y + kMostNodes;
    double* atU = z + kMostNodes;
    double* atV = atU + kMostNodes;
    for (int i = 0; i < nodes * nodes; ++i) {
        const Eigen::Vector2d pixel(kCell * cellX - 0.5 + step * (i % nodes),
                                    kCell * m_cellY - 0.5 + step * (i / nodes));
        const Vector3d ray = table.affine() ? Vector3d(pixel.x(), pixel.y(), 1) : table.ray(pixel);
        x[i] = ray.x();
        y[i] = ray.y();
        z[i] = ray.z();
    }
    simd::photoCoordinates(lattice, {x, y, z}, nodes * nodes, atU, atV, nullptr, nullptr);
    const int n = table.samplesPerAxis();
    const int size = kCell / parts;
    bool seam = false;
    for (int part = 0; part < parts * parts; ++part) {
        const int middle = (2 * (part / parts) + 1) * nodes + 2 * (part % parts) + 1;
        const std::array<float, 9> inU = patch(atU + middle, nodes, lattice.width);
        const std::array<float, 9> inV = patch(atV + middle, nodes, 4 * lattice.height);
        const int at = (part / parts) * size * n * n * kCell + (part % parts) * size;
        simd::fillPatch({size, n}, inU, fixedPoint(atU[middle], kOffsetU), u + at);
        simd::fillPatch({size, n}, inV, fixedPoint(atV[middle], kOffsetV), v + at);
        seam = seam || crossesSeam(atU[middle], inU, lattice.width);
    }
    if (seam) {
        simd::wrapFixed(u, kCell * kCell * n * n, fixedPoint(-0.5, kOffsetU), fixedPoint(lattice.width, 0));
    }
}

void LatticeScratch::exact(const Lattice& lattice, int cellX, std::int32_t* u, std::int32_t* v) {
    const RayTable& table = *lattice.rays;
    const int n = table.samplesPerAxis();
    const RayTable::ExplicitCell* given = table.explicitCell(cellX, m_cellY);
    double* x = m_rays.data();
    double* y = x + kCell;
    double* z = y + kCell;
    double* atU = z + kCell;
    double* atV = atU + kCell;
    for (int part = 0; part < kCell * n * n; ++part) { // sixteen samples each
        const std::size_t count = static_cast<std::size_t>(kCell * kCell * n * n);
        simd::RayArrays rays{x, y, z};
        if (given != nullptr) {
            const double* stored = given->rays.data() + part * kCell;
            rays = {stored, stored + count, stored + 2 * count};
        } else {
            const double offsetX = (part % n + 0.5) / n - 0.5;
            const double offsetY = (part / n % n + 0.5) / n - 0.5;
            for (int i = 0; i < kCell; ++i) {
                const Eigen::Vector2d pixel(kCell * cellX + i + offsetX,
                                            kCell * m_cellY + part / (n * n) + offsetY);
                const Vector3d ray = table.affine() ? Vector3d(pixel.x(), pixel.y(), 1) : table.ray(pixel);
                x[i] = ray.x();
                y[i] = ray.y();
                z[i] = ray.z();
            }
        }
        simd::photoCoordinates(lattice, rays, kCell, atU, atV, nullptr, nullptr);
        simd::toFixed(atU, kCell, kOffsetU, u + part * kCell);
        simd::toFixed(atV, kCell, kOffsetV, v + part * kCell);
    }
}

} // namespace spherewalk::render
