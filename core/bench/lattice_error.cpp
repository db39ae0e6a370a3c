// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/bench/lattice_error.h"

#include "pixels/fixed_point.h"
#include "pixels/photo_plane.h"
#include "sphere/exact_view.h"
#include "sphere/lattice.h"
#include "sphere/ray_table.h"

#include "spherewalk/base/parallel.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

namespace spherewalk::bench {

using Eigen::Vector2d;
using Eigen::Vector3d;
using render::CellMode;
using render::kCell;
using render::LatticeFrame;
using render::RayTable;
using render::SceneKind;

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
class LatticeReference {
  public:
    explicit LatticeReference(const LatticeCase& view) : m_view(view) {
        const Vector3d apart = view.roomFromCamera.translation - view.roomFromPhoto.translation;
        m_from = turned(view.roomFromPhoto.rotation.conjugate(), apart.cast<Real>()) /
                 static_cast<Real>(view.sphereRadiusM);
        if (m_from.norm() > Real(render::kLargestDisplacement)) {
            m_from *= Real(render::kLargestDisplacement) / m_from.norm();
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
        const std::optional<Vector3d> ray = m_view.camera.ray(pixel);
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
    constexpr Real kUnit = render::kFixedOne;
    const Real x = Real(found.u) / kUnit - Real(render::PlaneLayout::kGuard) - Real(render::kRoundingU);
    const Real y = Real(found.v) / kUnit - Real(render::PlaneLayout::kGuard);
    const Real azimuth = kPi - 2 * kPi * (x + Real(0.5)) / kPhoto.width;
    const Real elevation = kPi / 2 - kPi * (y + Real(0.5)) / kPhoto.height;
    const Vector3r there(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                         std::sin(elevation));
    const auto error = static_cast<double>((there - expected).norm() * kPhoto.width / (2 * kPi));
    return std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
}

bool isInRange(const Found& found) {
    constexpr std::int32_t kUnit = render::kFixedOne;
    return found.u >= kUnit && found.u <= kUnit * (kPhoto.width + 2) && found.v >= kUnit &&
           found.v <= kUnit * (kPhoto.height + 2);
}

double boundPx(const render::LatticeRow& row, int cellX) {
    switch (row.mode(cellX)) {
    case CellMode::Coarse:
        return row.boundPx(cellX);
    case CellMode::Fine:
        return row.boundPx(cellX) / 8;
    case CellMode::Finest:
        return row.boundPx(cellX) / 64;
    case CellMode::Exact:
        break;
    }
    return std::numeric_limits<double>::infinity();
}

std::string_view name(CellMode mode) {
    constexpr std::array<std::string_view, 4> kModeNames{"coarse", "fine", "finest", "exact"};
    return kModeNames[static_cast<std::size_t>(mode)];
}

class Comparison {
  public:
    explicit Comparison(const LatticeCase& view)
        : m_view(view),
          m_rays(view.camera, view.samplesPerAxis),
          m_lattice(m_rays, view.roomFromCamera, view.roomFromPhoto, kPhoto, view.scene, view.sphereRadiusM,
                    view.tolerancePx),
          m_reference(view),
          m_row(m_rays.cellsX()),
          m_u(static_cast<std::size_t>(kCellPixels * view.samplesPerAxis * view.samplesPerAxis)),
          m_v(m_u.size()) {}

    LatticeError run() {
        for (int cellY = 0; cellY < m_rays.cellsY(); ++cellY) {
            m_row.beginRow(m_lattice, cellY);
            for (int cellX = 0; cellX < m_rays.cellsX(); ++cellX) {
                compareCell(cellX, cellY);
            }
        }
        return std::move(m_error);
    }

  private:
    static constexpr int kCellPixels = kCell * kCell;
    static constexpr std::size_t kEvery = 7; // has no factor in common with a cell

    void compareCell(int cellX, int cellY) {
        m_row.coordinates(m_lattice, cellX, m_u.data(), m_v.data());
        ++m_error.cells[static_cast<std::size_t>(m_row.mode(cellX))];
        const int n = m_view.samplesPerAxis;
        for (std::size_t i = 0; i < m_u.size(); i += kEvery) {
            const int at = static_cast<int>(i);
            const int part = at / kCell % (n * n);
            const int row = at / (kCell * n * n);
            const int partRow = part / n;
            const Vector2d pixel(kCell * cellX + at % kCell, kCell * cellY + row);
            const Vector2d offset((part % n + 0.5) / n - 0.5, (partRow + 0.5) / n - 0.5);
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
            std::max(m_error.worstToBound, (errorPx - kRoundingPx) / boundPx(m_row, cellX));
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
                    fixed(elevation, 1), " deg, ", name(m_row.mode(cellX)), " cell");
    }

    const LatticeCase& m_view;
    RayTable m_rays;
    LatticeFrame m_lattice;
    LatticeReference m_reference;
    render::LatticeRow m_row;
    std::vector<std::int32_t> m_u;
    std::vector<std::int32_t> m_v;
    LatticeError m_error;
};

using Cases = std::vector<LatticeCase>;

class CaseRandom {
  public:
    explicit CaseRandom(unsigned seed) : m_engine(seed) {}

    double uniform(double least, double greatest) {
        return std::uniform_real_distribution<double>(least, greatest)(m_engine);
    }

    Eigen::Quaterniond rotation() {
        const double w = normal();
        const Vector3d axis = vector();
        return Eigen::Quaterniond(w, axis.x(), axis.y(), axis.z()).normalized();
    }

    Vector3d direction() { return vector().normalized(); }

  private:
    double normal() { return std::normal_distribution<double>(0, 1)(m_engine); }

    Vector3d vector() {
        const double x = normal();
        const double y = normal();
        return {x, y, normal()};
    }

    std::mt19937 m_engine;
};

CameraModel pinhole(int width, int height, double fieldDeg) {
    return CameraModel(CameraIntrinsics::pinhole(width, height, Radians(Degrees(fieldDeg)).value()));
}

Cases inAnyDirection() {
    CaseRandom random(51);
    Cases cases;
    for (int i = 0; i < 150; ++i) {
        const double field = i % 3 == 0   ? random.uniform(1, 40)
                             : i % 3 == 1 ? random.uniform(40, 120)
                                          : random.uniform(120, 179);
        const Rigid3 camera{random.rotation(), Vector3d::Zero()};
        const Rigid3 photo{random.rotation(), Vector3d::Zero()};
        cases.push_back({pinhole(320, 240, field), camera, photo, SceneKind::None, 1, 1 + i % 2});
    }
    return cases;
}

Cases overPolesAndSeam() {
    Cases cases;
    for (const double field : {1.0, 20.0, 57.0, 90.0, 120.0, 160.0, 179.0}) {
        for (const double pitch : {-90.0, -89.999, -85.0, -60.0, 0.0, 45.0, 75.0, 89.9, 90.0}) {
            for (const double yaw : {0.0, 180.0, 179.99}) {
                for (const double roll : {0.0, 30.0}) {
                    const YawPitchRoll angles{Degrees(yaw), Degrees(pitch), Degrees(roll)};
                    const Rigid3 camera{rotation(angles) * bodyFromOptical(), Vector3d::Zero()};
                    cases.push_back({pinhole(160, 120, field), camera, {}});
                }
            }
        }
    }
    return cases;
}

Cases displacedCases() {
    CaseRandom random(52);
    Cases cases;
    for (int i = 0; i < 150; ++i) {
        const double share = i % 3 == 0   ? render::kLargestDisplacement
                             : i % 3 == 1 ? random.uniform(0, 0.2)
                                          : random.uniform(0, 1.2);
        const Vector3d room = i % 2 == 0 ? Vector3d::Zero() : Vector3d(1e6, -1e6, 1e6);
        const double radius = random.uniform(0.5, 8);
        const Rigid3 photo{random.rotation(), room};
        const Rigid3 camera{random.rotation(), room + share * radius * random.direction()};
        cases.push_back(
            {pinhole(240, 180, random.uniform(1, 179)), camera, photo, SceneKind::Sphere, radius, 1 + i % 2});
    }
    return cases;
}

CameraIntrinsics withLens(CameraIntrinsics k, int which, CaseRandom& random) {
    if (which == 0) {
        k.lens = LensModel::PlumbBob;
        k.distortion = {random.uniform(-0.35, 0.2), random.uniform(-0.1, 0.15), random.uniform(-2e-3, 2e-3),
                        random.uniform(-2e-3, 2e-3), random.uniform(-0.02, 0.02)};
    } else if (which == 1) {
        k.lens = LensModel::RationalPolynomial;
        k.distortion = {random.uniform(0, 1),
                        random.uniform(-0.1, 0.3),
                        1e-3,
                        -1e-3,
                        0.01,
                        random.uniform(0, 1),
                        0.1,
                        0.02};
    } else {
        k.lens = LensModel::Equidistant;
        k.fx = k.fy = random.uniform(60, 200);
        k.distortion = {random.uniform(-0.05, 0.05), random.uniform(-0.02, 0.02), 0.002, -0.001};
    }
    return k;
}

Cases throughEveryLens() {
    CaseRandom random(53);
    Cases cases;
    for (int i = 0; i < 60; ++i) {
        CameraIntrinsics k = CameraIntrinsics::pinhole(320, 240, random.uniform(0.5, 1.9));
        k.cx += random.uniform(-20, 20);
        k.fy *= random.uniform(0.8, 1.2);
        k = withLens(k, i % 3, random);
        const Rigid3 photo{random.rotation(), Vector3d::Zero()};
        const Vector3d aside = random.direction();
        const Rigid3 camera{random.rotation(), aside * random.uniform(0, 1.9)};
        cases.push_back(
            {CameraModel(k), camera, photo, i % 2 == 0 ? SceneKind::None : SceneKind::Sphere, 2, 1 + i % 2});
    }
    return cases;
}

Cases casesOf(LatticeSearch search) {
    switch (search) {
    case LatticeSearch::AnyDirection:
        return inAnyDirection();
    case LatticeSearch::PolesAndSeam:
        return overPolesAndSeam();
    case LatticeSearch::Displaced:
        return displacedCases();
    case LatticeSearch::EveryLens:
        break;
    }
    return throughEveryLens();
}

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

std::string_view name(LatticeSearch search) {
    constexpr std::array<std::string_view, kLatticeSearches.size()> kSearchNames{
        "any direction", "poles and seam", "displaced", "every lens"};
    return kSearchNames[static_cast<std::size_t>(search)];
}

LatticeError searchLattice(LatticeSearch search, int everyNth, ProgressSink& progress,
                           const std::stop_token& stop) {
    const Cases cases = casesOf(search);
    const int count = (static_cast<int>(cases.size()) + everyNth - 1) / everyNth;
    std::vector<LatticeError> errors(static_cast<std::size_t>(count));
    std::mutex mutex;
    int done = 0;
    parallelFor(count, 1, 0, [&](int i, int /*end*/) {
        throwIfStopped(stop);
        errors[static_cast<std::size_t>(i)] =
            latticeError(cases[static_cast<std::size_t>(i) * static_cast<std::size_t>(everyNth)]);
        const std::scoped_lock lock(mutex);
        progress.progress(static_cast<double>(++done) / count,
                          text("Looking for the worst coordinates, ", name(search)));
    });
    LatticeError worst;
    for (const LatticeError& error : errors) { // in their order: the same report on every run
        worst.add(error);
    }
    return worst;
}

} // namespace spherewalk::bench
