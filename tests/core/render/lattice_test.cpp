// SPDX-License-Identifier: Apache-2.0
#include "lattice.h"
#include "photo_plane.h"
#include "random.h"
#include "ray_table.h"

#include "spherewalk/geometry/equirect.h"
#include "spherewalk/geometry/rotation.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <sstream>

namespace spherewalk::render {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

using Real = long double;
using Vector3r = Eigen::Matrix<Real, 3, 1>;

constexpr EquirectSize kPhoto{5376, 2688};
constexpr Real kPi = std::numbers::pi_v<Real>;

struct Pose {
    Rigid3 roomFromCamera;
    Rigid3 roomFromPhoto;
    SceneKind scene;
    double radiusM;
};

Vector3r turned(const Eigen::Quaterniond& q, const Vector3r& v) {
    return Eigen::Quaternion<Real>(q.cast<Real>()).normalized() * v;
}

/// The same as the fast path, straight from the definitions, in long double: rays of cameras without
/// distortion too.
class Reference {
  public:
    Reference(const CameraModel& camera, const Pose& pose) : m_camera(camera), m_pose(pose) {
        const Eigen::Vector3d apart = pose.roomFromCamera.translation - pose.roomFromPhoto.translation;
        m_from = turned(pose.roomFromPhoto.rotation.conjugate(), apart.cast<Real>()) / Real(pose.radiusM);
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
            turned(m_pose.roomFromPhoto.rotation.conjugate(), turned(m_pose.roomFromCamera.rotation, *ray));
        if (m_pose.scene == SceneKind::None) {
            return inPhoto;
        }
        const Real along = m_from.dot(inPhoto);
        const Real t = std::sqrt(along * along + 1 - m_from.squaredNorm()) - along;
        return (m_from + t * inPhoto).normalized();
    }

  private:
    std::optional<Vector3r> rayInCamera(const Vector2d& pixel) const {
        const CameraIntrinsics& k = m_camera.intrinsics();
        if (k.lens == LensModel::Pinhole) {
            return Vector3r((Real(pixel.x()) - Real(k.cx)) / Real(k.fx),
                            (Real(pixel.y()) - Real(k.cy)) / Real(k.fy), 1)
                .normalized();
        }
        const std::optional<Vector3d> ray = m_camera.ray(pixel);
        return ray ? std::optional<Vector3r>(ray->cast<Real>().normalized()) : std::nullopt;
    }

    const CameraModel& m_camera;
    Pose m_pose;
    Vector3r m_from;
};

/// The angle between where fast coordinates point and the reference, in photo pixels at the equator.
double errorPx(std::int32_t u, std::int32_t v, const Vector3r& expected) {
    const Real x = Real(u) / 65536 - Real(PlaneLayout::kGuard) - Real(kRoundingU);
    const Real y = Real(v) / 65536 - Real(PlaneLayout::kGuard);
    const Real azimuth = kPi - 2 * kPi * (x + Real(0.5)) / kPhoto.width;
    const Real elevation = kPi / 2 - kPi * (y + Real(0.5)) / kPhoto.height;
    const Vector3r found(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                         std::sin(elevation));
    return static_cast<double>((found - expected).norm() * kPhoto.width / (2 * kPi));
}

struct Worst {
    double errorPx = 0;
    double coarseToBound = 0; ///< error of interpolation, per bound
    std::array<long, 4> cells{};
    long samples = 0;
    std::string where;
    bool inRange = true;
};

void compare(const CameraModel& camera, const Pose& pose, int samplesPerAxis, Worst& worst) {
    const RayTable rays(camera, samplesPerAxis);
    const Reference reference(camera, pose);
    const Lattice lattice(rays, pose.roomFromCamera, pose.roomFromPhoto, kPhoto, pose.scene, pose.radiusM);
    LatticeScratch scratch(rays.cellsX());
    const int n = samplesPerAxis;
    std::vector<std::int32_t> u(static_cast<std::size_t>(256 * n * n));
    std::vector<std::int32_t> v(u.size());
    for (int cellY = 0; cellY < rays.cellsY(); ++cellY) {
        scratch.beginRow(lattice, cellY);
        for (int cellX = 0; cellX < rays.cellsX(); ++cellX) {
            scratch.coordinates(lattice, cellX, u.data(), v.data());
            const CellMode mode = scratch.mode(cellX);
            ++worst.cells[static_cast<std::size_t>(mode)];
            for (int i = 0; i < 256 * n * n; i += 7) {
                const int x = 16 * cellX + i % 16;
                const int part = i / 16 % (n * n);
                const int y = 16 * cellY + i / (16 * n * n);
                if (x >= camera.width() || y >= camera.height() || !camera.ray(Vector2d(x, y))) {
                    continue;
                }
                const auto expected = reference.direction(
                    Vector2d(x + (part % n + 0.5) / n - 0.5, y + (part / n + 0.5) / n - 0.5));
                if (!expected) {
                    continue;
                }
                const auto at = static_cast<std::size_t>(i);
                worst.inRange = worst.inRange && u[at] >= 65536 && u[at] <= 65536 * (kPhoto.width + 2) &&
                                v[at] >= 65536 && v[at] <= 65536 * (kPhoto.height + 2);
                const double error = errorPx(u[at], v[at], *expected);
                ++worst.samples;
                if (mode != CellMode::Exact) {
                    const double bound = scratch.boundPx(cellX) / (mode == CellMode::Coarse ? 1
                                                                   : mode == CellMode::Fine ? 8
                                                                                            : 64);
                    worst.coarseToBound = std::max(worst.coarseToBound, (error - 0.0015) / bound);
                }
                if (!(error <= worst.errorPx)) {
                    worst.errorPx = error;
                    std::ostringstream where;
                    where << "pixel " << x << " " << y << " of " << camera.width() << " x " << camera.height()
                          << ", " << name(camera.intrinsics().lens) << " f " << camera.intrinsics().fx
                          << ", mode " << static_cast<int>(mode) << ", elevation "
                          << static_cast<double>(std::asin(expected->z()) * 180 / kPi) << " deg";
                    worst.where = where.str();
                }
            }
        }
    }
}

CameraModel pinhole(int width, int height, double fieldDeg) {
    return CameraModel(CameraIntrinsics::pinhole(width, height, fieldDeg * std::numbers::pi / 180));
}

Rigid3 looking(double yawDeg, double pitchDeg, double rollDeg, const Vector3d& at) {
    return {rotation({Degrees(yawDeg), Degrees(pitchDeg), Degrees(rollDeg)}) * bodyFromOptical(), at};
}

void report(const char* law, const Worst& worst) {
    std::cout << "  " << law << ": worst " << worst.errorPx << " px at " << worst.where << "; error/bound "
              << worst.coarseToBound << "; cells coarse " << worst.cells[0] << " fine " << worst.cells[1]
              << " finest " << worst.cells[2] << " exact " << worst.cells[3] << "; " << worst.samples
              << " samples\n";
    testing::Test::RecordProperty("worst_px", std::to_string(worst.errorPx));
    testing::Test::RecordProperty("where", worst.where);
}

void expectExact(const char* law, const Worst& worst) {
    report(law, worst);
    EXPECT_LE(worst.errorPx, 0.02);
    EXPECT_LE(worst.coarseToBound, 1);
    EXPECT_TRUE(worst.inRange);
    EXPECT_GT(worst.samples, 1000);
}

} // namespace

TEST(Lattice, IsExactAtAnyFieldOfViewInAnyDirection) {
    test::Random random(51);
    Worst worst;
    for (int i = 0; i < 150; ++i) {
        const double field = i % 3 == 0   ? random.uniform(1, 40)
                             : i % 3 == 1 ? random.uniform(40, 120)
                                          : random.uniform(120, 179);
        compare(pinhole(320, 240, field),
                {{random.rotation(), Vector3d::Zero()},
                 {random.rotation(), Vector3d::Zero()},
                 SceneKind::None,
                 1},
                1 + i % 2, worst);
    }
    expectExact("any field of view", worst);
}

TEST(Lattice, IsExactOverPolesAndSeam) {
    Worst worst;
    for (const double field : {1.0, 20.0, 57.0, 90.0, 120.0, 160.0, 179.0}) {
        for (const double pitch : {-90.0, -89.999, -85.0, -60.0, 0.0, 45.0, 75.0, 89.9, 90.0}) {
            for (const double yaw : {0.0, 180.0, 179.99}) {
                for (const double roll : {0.0, 30.0}) {
                    compare(pinhole(160, 120, field),
                            {looking(yaw, pitch, roll, Vector3d::Zero()), {}, SceneKind::None, 1}, 1, worst);
                }
            }
        }
    }
    expectExact("poles and seam", worst);
}

TEST(Lattice, IsExactForDisplacedCamerasUpToTheSphere) {
    test::Random random(52);
    Worst worst;
    for (int i = 0; i < 150; ++i) {
        const double share = i % 3 == 0 ? 0.95 : i % 3 == 1 ? random.uniform(0, 0.2) : random.uniform(0, 1.2);
        const Vector3d room = i % 2 == 0 ? Vector3d::Zero() : Vector3d(1e6, -1e6, 1e6);
        const Rigid3 photo{random.rotation(), room};
        const double radius = random.uniform(0.5, 8);
        const Rigid3 camera{random.rotation(), room + share * radius * random.direction()};
        compare(pinhole(240, 180, random.uniform(1, 179)), {camera, photo, SceneKind::Sphere, radius},
                1 + i % 2, worst);
    }
    expectExact("displaced to 0.95, half of them 10^6 m from the origin", worst);
}

TEST(Lattice, IsExactForEveryLens) {
    test::Random random(53);
    Worst worst;
    for (int i = 0; i < 60; ++i) {
        CameraIntrinsics k = CameraIntrinsics::pinhole(320, 240, random.uniform(0.5, 1.9));
        k.cx += random.uniform(-20, 20);
        k.fy *= random.uniform(0.8, 1.2);
        if (i % 3 == 0) {
            k.lens = LensModel::PlumbBob;
            k.distortion = {random.uniform(-0.35, 0.2), random.uniform(-0.1, 0.15),
                            random.uniform(-2e-3, 2e-3), random.uniform(-2e-3, 2e-3),
                            random.uniform(-0.02, 0.02)};
        } else if (i % 3 == 1) {
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
        const Rigid3 photo{random.rotation(), Vector3d::Zero()};
        const Rigid3 camera{random.rotation(), random.direction() * random.uniform(0, 1.9)};
        compare(CameraModel(k), {camera, photo, i % 2 == 0 ? SceneKind::None : SceneKind::Sphere, 2},
                1 + i % 2, worst);
    }
    expectExact("every lens", worst);
}

} // namespace spherewalk::render
