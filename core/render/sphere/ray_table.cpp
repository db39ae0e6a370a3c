// SPDX-License-Identifier: Apache-2.0
#include "sphere/ray_table.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace spherewalk::render {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr int kFinePerCell = kCell / RayTable::kFineStep;
constexpr int kTablePadding = 16;

/// A cell's rays are interpolated if that changes directions by no more than this: 0.001 pixels of a photo
/// that is 5376 wide.
constexpr double kRayTolerance = 1.2e-6;

/// Measured derivatives of lenses are enlarged by this, since they may be greater between the nodes.
constexpr double kMotionSafety = 2;

/// Bounds of X, in [least, greatest], squared.
struct Squared {
    double least;
    double greatest;
};

Squared squared(double a, double b) {
    const double aa = a * a;
    const double bb = b * b;
    return {(a < 0) != (b < 0) ? 0 : std::min(aa, bb), std::max(aa, bb)};
}

/// Along a line of the image plane the ray turns about one axis by atan(X / D), with D the line's distance
/// from the camera's centre; its derivatives are bounded over the cell, per pixel of 1 / focal.
std::array<double, 3> turning(const Squared& x, const Squared& otherAxis, double focal) {
    const double d2Least = 1 + otherAxis.least;
    const double d2Greatest = 1 + otherAxis.greatest;
    const double d = std::sqrt(d2Greatest);
    const double n = 1 / (d2Least + x.least);
    const double sides = std::max({6 * x.greatest - 2 * d2Least, 2 * d2Greatest - 6 * x.least, 0.0});
    return {d * n / focal, 2 * std::sqrt(x.greatest) * d * n * n / (focal * focal),
            d * sides * n * n * n / (focal * focal * focal)};
}

/// The quadratic through values at -1, 0, 1.
template <class Value>
Value quadratic(const Value& left, const Value& middle, const Value& right, double t) {
    return middle + t * (0.5 * (right - left) + t * (0.5 * (right + left) - middle));
}

} // namespace

RayTable::RayTable(const CameraModel& camera, int samplesPerAxis)
    : m_width(camera.width()),
      m_height(camera.height()),
      m_samples(samplesPerAxis),
      m_cellsX((m_width + kCell - 1) / kCell),
      m_cellsY((m_height + kCell - 1) / kCell),
      m_pitch((m_cellsX + 1 + 2 * kTablePadding - 1) / kTablePadding * kTablePadding),
      m_affine(camera.intrinsics().lens == LensModel::Pinhole),
      m_motion(static_cast<std::size_t>(6 * m_cellsY) * static_cast<std::size_t>(m_pitch) + kTablePadding) {
    if (samplesPerAxis < 1 || samplesPerAxis > 8) {
        throw Error(ErrorKind::InvalidInput, text("A pixel cannot have ", samplesPerAxis, " x ",
                                                  samplesPerAxis, " samples, only 1 x 1 to 8 x 8."));
    }
    m_affine ? tabulateAffine(camera.intrinsics()) : tabulateLens(camera);
}

const double* RayTable::motion(int axis, int order, int cellY) const {
    const int row = (3 * axis + order - 1) * m_cellsY + cellY;
    return m_motion.data() + static_cast<std::ptrdiff_t>(row) * m_pitch;
}

double& RayTable::motionAt(int axis, int order, int cellX, int cellY) {
    return m_motion[static_cast<std::size_t>(motion(axis, order, cellY) - m_motion.data() + cellX)];
}

int RayTable::nodesPitch(int parts) const {
    return (parts * m_cellsX + 1 + 2 * kTablePadding - 1) / kTablePadding * kTablePadding;
}

const double* RayTable::nodes(int parts, int component, bool edge, int nodeY) const {
    const int row = (2 * component + (edge ? 1 : 0)) * (2 * parts * m_cellsY + 1) + nodeY;
    return m_nodes[static_cast<std::size_t>(parts - 1)].data() +
           static_cast<std::ptrdiff_t>(row) * nodesPitch(parts);
}

const RayTable::ExplicitCell* RayTable::explicitCell(int cellX, int cellY) const {
    if (m_explicit.empty()) {
        return nullptr;
    }
    const std::int32_t index = m_explicitIndex[static_cast<std::size_t>(cellY * m_cellsX + cellX)];
    return index < 0 ? nullptr : &m_explicit[static_cast<std::size_t>(index)];
}

void RayTable::tabulateAffine(const CameraIntrinsics& camera) {
    m_rayFromPixel << 1 / camera.fx, 0, -camera.cx / camera.fx, //
        0, 1 / camera.fy, -camera.cy / camera.fy,               //
        0, 0, 1;
    for (int cellY = 0; cellY < m_cellsY; ++cellY) {
        const double top = (kCell * cellY - 0.5 - camera.cy) / camera.fy;
        const Squared y = squared(top, top + kCell / camera.fy);
        for (int cellX = 0; cellX < m_cellsX; ++cellX) {
            const double left = (kCell * cellX - 0.5 - camera.cx) / camera.fx;
            const Squared x = squared(left, left + kCell / camera.fx);
            const std::array<double, 3> alongX = turning(x, y, camera.fx);
            const std::array<double, 3> alongY = turning(y, x, camera.fy);
            for (int order = 1; order <= 3; ++order) {
                motionAt(0, order, cellX, cellY) = alongX[static_cast<std::size_t>(order - 1)];
                motionAt(1, order, cellX, cellY) = alongY[static_cast<std::size_t>(order - 1)];
            }
        }
    }
}

Vector3d RayTable::fineRay(int fineX, int fineY) const {
    const auto at = [&](int c) { return nodes(kFineParts, c, fineX % 2 == 0, fineY)[fineX / 2]; };
    return {at(0), at(1), at(2)};
}

/// The nodes of cells that are cut into parts x parts.
void RayTable::tabulateNodes(const CameraModel& camera, int parts) {
    const int rows = 2 * parts * m_cellsY + 1;
    AlignedBuffer<double>& values = m_nodes[static_cast<std::size_t>(parts - 1)];
    values = AlignedBuffer<double>(
        6 * static_cast<std::size_t>(rows) * static_cast<std::size_t>(nodesPitch(parts)) + kTablePadding);
    const double step = static_cast<double>(kNodeStep) / parts;
    parallelFor(rows, 4, 0, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            for (int x = 0; x <= 2 * parts * m_cellsX; ++x) {
                const Vector3d ray =
                    camera.ray(Vector2d(step * x - 0.5, step * y - 0.5)).value_or(Vector3d::Zero());
                for (int c = 0; c < 3; ++c) {
                    values[static_cast<std::size_t>(nodes(parts, c, x % 2 == 0, y) - values.data() + x / 2)] =
                        ray[c];
                }
            }
        }
    });
}

void RayTable::tabulateLens(const CameraModel& camera) {
    tabulateNodes(camera, 1);
    tabulateNodes(camera, kFineParts);
    m_explicitIndex.assign(static_cast<std::size_t>(m_cellsX * m_cellsY), -1);
    std::vector<std::uint8_t> isExplicit(m_explicitIndex.size());
    parallelFor(m_cellsY, 1, 0, [&](int cellY, int) {
        for (int cellX = 0; cellX < m_cellsX; ++cellX) {
            if (interpolates(camera, cellX, cellY)) {
                measureMotion(cellX, cellY);
            } else {
                isExplicit[static_cast<std::size_t>(cellY * m_cellsX + cellX)] = 1;
            }
        }
    });
    for (std::size_t cell = 0; cell < isExplicit.size(); ++cell) {
        if (isExplicit[cell] != 0) {
            m_explicitIndex[cell] = static_cast<std::int32_t>(m_explicit.size());
            m_explicit.emplace_back();
        }
    }
    parallelFor(static_cast<int>(isExplicit.size()), 1, 0, [&](int cell, int) {
        const std::int32_t index = m_explicitIndex[static_cast<std::size_t>(cell)];
        if (index >= 0) {
            m_explicit[static_cast<std::size_t>(index)] =
                madeExplicit(camera, cell % m_cellsX, cell / m_cellsX);
        }
    });
}

/// Whether all of a cell's nodes have rays, and interpolating between them agrees with the lens where the
/// error of a biquadratic is near its greatest.
bool RayTable::interpolates(const CameraModel& camera, int cellX, int cellY) const {
    for (int y = 0; y <= kFinePerCell; ++y) {
        for (int x = 0; x <= kFinePerCell; ++x) {
            if (fineRay(kFinePerCell * cellX + x, kFinePerCell * cellY + y).isZero()) {
                return false;
            }
        }
    }
    constexpr std::array<double, 4> kTested{0.125 * kCell, 0.375 * kCell, 0.625 * kCell, 0.875 * kCell};
    for (const double y : kTested) {
        for (const double x : kTested) {
            const Vector2d pixel(kCell * cellX - 0.5 + x, kCell * cellY - 0.5 + y);
            const std::optional<Vector3d> exact = camera.ray(pixel);
            if (!exact || !((ray(pixel).normalized() - *exact).norm() < kRayTolerance)) {
                return false;
            }
        }
    }
    return true;
}

Vector3d RayTable::ray(const Vector2d& pixel) const {
    // Quads of two by two fine steps, each with nine nodes.
    const auto quad = [](double at, int cells) {
        return std::clamp(static_cast<int>((at + 0.5) / kNodeStep), 0, 2 * cells - 1);
    };
    const int quadX = quad(pixel.x(), m_cellsX);
    const int quadY = quad(pixel.y(), m_cellsY);
    const double s = (pixel.x() + 0.5) / kFineStep - 2 * quadX - 1;
    const double t = (pixel.y() + 0.5) / kFineStep - 2 * quadY - 1;
    std::array<Vector3d, 3> rows;
    for (int y = 0; y < 3; ++y) {
        rows[static_cast<std::size_t>(y)] =
            quadratic<Vector3d>(fineRay(2 * quadX, 2 * quadY + y), fineRay(2 * quadX + 1, 2 * quadY + y),
                                fineRay(2 * quadX + 2, 2 * quadY + y), s);
    }
    return quadratic<Vector3d>(rows[0], rows[1], rows[2], t);
}

void RayTable::measureMotion(int cellX, int cellY) {
    constexpr double kStep = kFineStep;
    for (int axis = 0; axis < 2; ++axis) {
        std::array<double, 3> most{};
        for (int line = 0; line <= kFinePerCell; ++line) {
            std::array<Vector3d, kFinePerCell + 1> s;
            for (int i = 0; i <= kFinePerCell; ++i) {
                s[static_cast<std::size_t>(i)] = fineRay(kFinePerCell * cellX + (axis == 0 ? i : line),
                                                         kFinePerCell * cellY + (axis == 0 ? line : i));
            }
            for (std::size_t i = 0; i < kFinePerCell; ++i) {
                most[0] = std::max(most[0], (s[i + 1] - s[i]).norm() / kStep);
            }
            for (std::size_t i = 1; i < kFinePerCell; ++i) {
                const Vector3d second = (s[i + 1] - 2 * s[i] + s[i - 1]) / (kStep * kStep);
                most[1] = std::max(most[1], (second - second.dot(s[i]) * s[i]).norm());
            }
            const Vector3d first = (s[3] - s[1]) / (2 * kStep);
            const Vector3d third = (s[4] - 2 * s[3] + 2 * s[1] - s[0]) / (2 * kStep * kStep * kStep);
            const Vector3d tangential = third - third.dot(s[2]) * s[2];
            most[2] = std::max(most[2], (tangential + first.squaredNorm() * first).norm());
        }
        for (int order = 1; order <= 3; ++order) {
            motionAt(axis, order, cellX, cellY) = kMotionSafety * most[static_cast<std::size_t>(order - 1)];
        }
        motionAt(axis, 1, cellX, cellY) = 1.1 * most[0];
    }
}

RayTable::ExplicitCell RayTable::madeExplicit(const CameraModel& camera, int cellX, int cellY) const {
    const int n = m_samples;
    const std::size_t count = static_cast<std::size_t>(kCell * kCell * n * n);
    ExplicitCell cell{std::vector<double>(3 * count), std::vector<std::uint8_t>(kCell * kCell)};
    for (int y = 0; y < kCell; ++y) {
        for (int x = 0; x < kCell; ++x) {
            const Vector2d pixel(kCell * cellX + x, kCell * cellY + y);
            const std::optional<Vector3d> centre = camera.ray(pixel);
            cell.seen[static_cast<std::size_t>(kCell * y + x)] = centre ? 1 : 0;
            for (int part = 0; part < n * n; ++part) {
                const Vector2d offset((part % n + 0.5) / n - 0.5, (part / n + 0.5) / n - 0.5);
                // Where only the pixel's centre is in the field, all of it shows what the centre does.
                const Vector3d ray = n == 1 || !centre ? centre.value_or(Vector3d::UnitZ())
                                                       : camera.ray(pixel + offset).value_or(*centre);
                const std::size_t at = static_cast<std::size_t>((y * n * n + part) * kCell + x);
                for (std::size_t c = 0; c < 3; ++c) {
                    cell.rays[c * count + at] = ray[static_cast<Eigen::Index>(c)];
                }
            }
        }
    }
    return cell;
}

} // namespace spherewalk::render
