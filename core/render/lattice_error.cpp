// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/render/lattice_error.h"

#include "lattice.h"
#include "photo_plane.h"
#include "ray_table.h"

#include "spherewalk/base/text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

namespace spherewalk::render {

using Eigen::Vector2d;

namespace {

using Real = long double;
using Vector3r = Eigen::Matrix<Real, 3, 1>;

constexpr EquirectSize kPhoto{5376, 2688};
constexpr Real kPi = std::numbers::pi_v<Real>;
constexpr double kRoundingPx = 0.0015; ///< of fixed point, which the interpolation's bound leaves out

Vector3r turned(const Eigen::Quaterniond& q, const Vector3r& v) {
    return Eigen::Quaternion<Real>(q.cast<Real>()).normalized() * v;
}

/// Straight from the definitions: rays of cameras without distortion too. Those of lenses are CameraModel's.
class Reference {
  public:
    explicit Reference(const LatticeCase& view) : m_view(view) {
        const Eigen::Vector3d apart = view.roomFromCamera.translation - view.roomFromPhoto.translation;
        m_from = turned(view.roomFromPhoto.rotation.conjugate(), apart.cast<Real>()) /
                 static_cast<Real>(view.sphereRadiusM);
        if (m_from.norm() > Real(kLargestDisplacement)) {
            m_from *= Real(kLargestDisplacement) / m_from.norm();
        }
    }

    /// The unit direction in the photo; nothing where the lens sees nothing.
    std::optional<Vector3r> direction(const Vector2d& pixel) const {
        const std::optional<Vector3r> ray = rayInCamera(pixel);
        if (!ray) {
            return std::nullopt;
        }
        const Vector3r inPhoto =
            turned(m_view.roomFromPhoto.rotation.conjugate(), turned(m_view.roomFromCamera.rotation, *ray));
        if (m_view.scene == SceneKind::None) {
            return inPhoto;
        }
        const Real along = m_from.dot(inPhoto);
        const Real t = std::sqrt(along * along + 1 - m_from.squaredNorm()) - along;
        return (m_from + t * inPhoto).normalized();
    }

  private:
    std::optional<Vector3r> rayInCamera(const Vector2d& pixel) const {
        const CameraIntrinsics& k = m_view.camera.intrinsics();
        if (k.lens == LensModel::Pinhole) {
            return Vector3r((Real(pixel.x()) - Real(k.cx)) / Real(k.fx),
                            (Real(pixel.y()) - Real(k.cy)) / Real(k.fy), 1)
                .normalized();
        }
        const std::optional<Eigen::Vector3d> ray = m_view.camera.ray(pixel);
        return ray ? std::optional<Vector3r>(ray->cast<Real>().normalized()) : std::nullopt;
    }

    const LatticeCase& m_view;
    Vector3r m_from;
};

/// Coordinates of a sample in fixed point.
struct Found {
    std::int32_t u;
    std::int32_t v;
};

/// The angle between where the coordinates point and the reference, in photo pixels at the equator.
double angleErrorPx(const Found& found, const Vector3r& expected) {
    constexpr Real kUnit = 1 << kFractionBits;
    const Real x = Real(found.u) / kUnit - Real(PlaneLayout::kGuard) - Real(kRoundingU);
    const Real y = Real(found.v) / kUnit - Real(PlaneLayout::kGuard);
    const Real azimuth = kPi - 2 * kPi * (x + Real(0.5)) / kPhoto.width;
    const Real elevation = kPi / 2 - kPi * (y + Real(0.5)) / kPhoto.height;
    const Vector3r there(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                         std::sin(elevation));
    const auto error = static_cast<double>((there - expected).norm() * kPhoto.width / (2 * kPi));
    return std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
}

bool isInRange(const Found& found) {
    constexpr std::int32_t kUnit = 1 << kFractionBits;
    return found.u >= kUnit && found.u <= kUnit * (kPhoto.width + 2) && found.v >= kUnit &&
           found.v <= kUnit * (kPhoto.height + 2);
}

double boundPx(const LatticeScratch& scratch, int cellX) {
    switch (scratch.mode(cellX)) {
    case CellMode::Coarse:
        return scratch.boundPx(cellX);
    case CellMode::Fine:
        return scratch.boundPx(cellX) / 8;
    case CellMode::Finest:
        return scratch.boundPx(cellX) / 64;
    case CellMode::Exact:
        break;
    }
    return std::numeric_limits<double>::infinity();
}

std::string_view name(CellMode mode) {
    constexpr std::array<std::string_view, 4> kNames{"coarse", "fine", "finest", "exact"};
    return kNames[static_cast<std::size_t>(mode)];
}

class Comparison {
  public:
    explicit Comparison(const LatticeCase& view)
        : m_view(view),
          m_rays(view.camera, view.samplesPerAxis),
          m_lattice(m_rays, view.roomFromCamera, view.roomFromPhoto, kPhoto, view.scene, view.sphereRadiusM,
                    view.tolerancePx),
          m_reference(view),
          m_scratch(m_rays.cellsX()),
          m_u(static_cast<std::size_t>(kCellPixels * view.samplesPerAxis * view.samplesPerAxis)),
          m_v(m_u.size()) {}

    LatticeError run() {
        for (int cellY = 0; cellY < m_rays.cellsY(); ++cellY) {
            m_scratch.beginRow(m_lattice, cellY);
            for (int cellX = 0; cellX < m_rays.cellsX(); ++cellX) {
                compareCell(cellX, cellY);
            }
        }
        return std::move(m_error);
    }

  private:
    static constexpr int kCell = RayTable::kCell;
    static constexpr int kCellPixels = kCell * kCell;
    static constexpr std::size_t kEvery = 7; // has no factor in common with a cell

    void compareCell(int cellX, int cellY) {
        m_scratch.coordinates(m_lattice, cellX, m_u.data(), m_v.data());
        ++m_error.cells[static_cast<std::size_t>(m_scratch.mode(cellX))];
        const int n = m_view.samplesPerAxis;
        for (std::size_t i = 0; i < m_u.size(); i += kEvery) {
            const int at = static_cast<int>(i);
            const int part = at / kCell % (n * n);
            const Vector2d pixel(kCell * cellX + at % kCell, kCell * cellY + at / (kCell * n * n));
            const Vector2d offset((part % n + 0.5) / n - 0.5, (part / n + 0.5) / n - 0.5);
            if (pixel.x() < m_view.camera.width() && pixel.y() < m_view.camera.height() &&
                m_view.camera.ray(pixel)) {
                compare(cellX, pixel, offset, {m_u[i], m_v[i]});
            }
        }
    }

    void compare(int cellX, const Vector2d& pixel, const Vector2d& offset, const Found& found) {
        const std::optional<Vector3r> expected = m_reference.direction(pixel + offset);
        if (!expected) {
            return;
        }
        const double errorPx = angleErrorPx(found, *expected);
        ++m_error.samples;
        m_error.isInRange = m_error.isInRange && isInRange(found);
        m_error.worstToBound =
            std::max(m_error.worstToBound, (errorPx - kRoundingPx) / boundPx(m_scratch, cellX));
        if (errorPx > m_error.worstPx) {
            m_error.worstPx = errorPx;
            m_error.where = described(cellX, pixel, *expected);
        }
    }

    std::string described(int cellX, const Vector2d& pixel, const Vector3r& direction) const {
        const CameraIntrinsics& k = m_view.camera.intrinsics();
        const std::string lens = k.lens == LensModel::Pinhole ? "" : text(" ", name(k.lens));
        const auto elevation = static_cast<double>(std::asin(direction.z()) * 180 / kPi);
        return text("pixel (", static_cast<int>(pixel.x()), ", ", static_cast<int>(pixel.y()), ") of ",
                    k.width, " x ", k.height, lens, ", focal length ", fixed(k.fx, 1), " px, elevation ",
                    fixed(elevation, 1), " deg, ", name(m_scratch.mode(cellX)), " cell");
    }

    const LatticeCase& m_view;
    RayTable m_rays;
    Lattice m_lattice;
    Reference m_reference;
    LatticeScratch m_scratch;
    std::vector<std::int32_t> m_u;
    std::vector<std::int32_t> m_v;
    LatticeError m_error;
};

} // namespace

void LatticeError::add(const LatticeError& other) {
    if (other.worstPx > worstPx) {
        worstPx = other.worstPx;
        where = other.where;
    }
    worstToBound = std::max(worstToBound, other.worstToBound);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        cells[i] += other.cells[i];
    }
    samples += other.samples;
    isInRange = isInRange && other.isInRange;
}

LatticeError latticeError(const LatticeCase& view) {
    return Comparison(view).run();
}

} // namespace spherewalk::render
