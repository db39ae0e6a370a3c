// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"
#include "lenses.h"
#include "random.h"
#include "sphere/exact_view.h"
#include "sphere/lattice.h"
#include "sphere/ray_table.h"

#include "spherewalk/geometry/rotation.h"
#include "spherewalk/render/panorama.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

namespace spherewalk::render {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

const EquirectSize kPhotoOfLattice{5376, 2688};

/// A view of the sphere model, as the fast path and the exact one take it.
struct LatticeCase {
    CameraModel camera;
    Rigid3 roomFromCamera;
    SceneKind scene = SceneKind::Sphere;
};

/// The photo's pixel of a sample in fixed point.
Vector2d photoPixelOf(std::int32_t u, std::int32_t v) {
    const Vector2d fixed(static_cast<double>(u) / kFixedOne - kRoundingU, static_cast<double>(v) / kFixedOne);
    return fixed - Vector2d::Constant(PlaneLayout::kGuard);
}

/// The largest angle between the lattice's directions and the exact ones, in pixels of the photo's equator.
double worstErrorPx(const LatticeCase& at) {
    const RayTable rays(at.camera, 1);
    const LatticeFrame frame(rays, at.roomFromCamera, {}, kPhotoOfLattice, at.scene, 1);
    const Projection exact(at.camera, at.roomFromCamera, {}, kPhotoOfLattice, at.scene, 1);
    LatticeRow row(rays.cellsX());
    std::vector<std::int32_t> u(kCell * kCell);
    std::vector<std::int32_t> v(kCell * kCell);
    double worst = 0;
    for (int cell = 0; cell < rays.cellsX() * rays.cellsY(); ++cell) {
        const int left = cell % rays.cellsX() * kCell;
        const int top = cell / rays.cellsX() * kCell;
        if (left == 0) {
            row.beginRow(frame, top / kCell);
        }
        row.coordinates(frame, left / kCell, u.data(), v.data());
        for (std::size_t k = 0; k < u.size(); ++k) {
            const int x = left + static_cast<int>(k) % kCell;
            const int y = top + static_cast<int>(k) / kCell;
            const bool isWithin = x < at.camera.width() && y < at.camera.height();
            const auto expected = isWithin ? exact.photoPixel(Vector2d(x, y)) : std::nullopt;
            if (expected) {
                const double offRad = angleBetween(direction(kPhotoOfLattice, *expected),
                                                   direction(kPhotoOfLattice, photoPixelOf(u[k], v[k])))
                                          .value();
                worst = std::max(worst, offRad * kPhotoOfLattice.width / (2 * std::numbers::pi));
            }
        }
    }
    return worst;
}

Rigid3 looking(double yawDegrees, double pitchDegrees, const Vector3d& fromM = Vector3d::Zero()) {
    return {rotation({Degrees(yawDegrees), Degrees(pitchDegrees), Degrees(0)}) * bodyFromOptical(), fromM};
}

CameraModel pinholeOf(int width, int height, double fieldDegrees) {
    return CameraModel(CameraIntrinsics::pinhole(width, height, Radians(Degrees(fieldDegrees)).value()));
}

/// A picture whose colours change slowly over the whole sphere, seam and poles included.
RgbImage smoothPanorama(int width) {
    RgbImage picture(width, width / 2);
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < width; ++x) {
            const Vector3d at = direction(EquirectSize{width, width / 2}, Vector2d(x, y));
            for (int c = 0; c < 3; ++c) {
                picture.at(x, y)[c] = static_cast<std::uint8_t>(std::lround(128 + 120 * at[c]));
            }
        }
    }
    return picture;
}

} // namespace

TEST(Lattice, KeepsItsBoundAtPolesAndSeam) {
    for (const double pitch : {-90.0, -89.9, -45.0, 0.0, 60.0, 89.99, 90.0}) {
        for (const double yaw : {0.0, 179.9, 180.0, -90.0}) {
            EXPECT_LT(worstErrorPx({pinholeOf(48, 40, 80), looking(yaw, pitch)}), 0.021)
                << "pitch " << pitch << " yaw " << yaw;
        }
    }
}

TEST(Lattice, KeepsItsBoundAtTheNarrowestAndTheWidestField) {
    test::Random random(911);
    SCOPED_TRACE(random.seed());
    for (const double field : {0.01, 1.0, 179.0, 179.9}) {
        for (int i = 0; i < 8; ++i) {
            const Rigid3 pose{random.rotation(), 0.9 * random.direction()};
            EXPECT_LT(worstErrorPx({pinholeOf(50, 34, field), pose}), 0.021) << field << ", pose " << i;
        }
    }
}

TEST(Lattice, KeepsItsBoundBesideTheSpheresSurface) {
    test::Random random(912);
    SCOPED_TRACE(random.seed());
    for (int i = 0; i < 12; ++i) {
        const Rigid3 pose{random.rotation(), random.uniform(0.9, 2) * random.direction()};
        EXPECT_LT(worstErrorPx({pinholeOf(48, 32, 100), pose}), 0.021) << "pose " << i;
    }
}

TEST(Lattice, KeepsItsBoundThroughEveryLens) {
    test::Random random(913);
    SCOPED_TRACE(random.seed());
    for (const CameraIntrinsics& lens : test::everyLens(60, 45)) {
        for (const SceneKind scene : {SceneKind::None, SceneKind::Sphere}) {
            const Rigid3 pose{random.rotation(), 0.3 * random.direction()};
            EXPECT_LT(worstErrorPx({CameraModel(lens), pose, scene}), 0.025) << name(lens.lens);
        }
    }
}

TEST(Lattice, OfOnePixelIsThatPixel) {
    test::Random random(914);
    SCOPED_TRACE(random.seed());
    for (const double field : {0.1, 60.0, 179.0}) {
        const Rigid3 pose{random.rotation(), 0.5 * random.direction()};
        EXPECT_LT(worstErrorPx({pinholeOf(1, 1, field), pose}), 0.021) << field;
        EXPECT_LT(worstErrorPx({pinholeOf(1, 37, field / 40), pose}), 0.021) << field;
        EXPECT_LT(worstErrorPx({pinholeOf(37, 1, field), pose}), 0.021) << field;
    }
}

TEST(RayTable, HasTheRaysOfItsCamera) {
    for (const CameraIntrinsics& lens : test::everyLens(90, 70)) {
        const CameraModel camera(lens);
        const RayTable table(camera, 1);
        for (int y = 0; y < 70; ++y) {
            for (int x = 0; x < 90; ++x) {
                const auto exact = camera.ray(Vector2d(x, y));
                const RayTable::ExplicitCell* cell = table.explicitCell(x / kCell, y / kCell);
                const int inCell = y % kCell * kCell + x % kCell;
                if (cell != nullptr) {
                    EXPECT_EQ(cell->seen[static_cast<std::size_t>(inCell)] != 0, exact.has_value())
                        << name(lens.lens) << " " << x << ", " << y;
                    continue;
                }
                ASSERT_TRUE(exact) << name(lens.lens) << " " << x << ", " << y;
                const Vector3d ray = table.affine() ? Vector3d(table.rayFromPixel() * Vector3d(x, y, 1))
                                                    : table.ray(Vector2d(x, y));
                EXPECT_LT(angleBetween(ray, *exact).value(), 2e-6)
                    << name(lens.lens) << " " << x << ", " << y;
            }
        }
    }
}

TEST(RayTable, BoundsHowFastItsRaysTurn) {
    for (const CameraIntrinsics& lens : test::everyLens(96, 64)) {
        const CameraModel camera(lens);
        const RayTable table(camera, 1);
        for (int y = 0; y + 1 < 64; ++y) {
            for (int x = 0; x + 1 < 96; ++x) {
                const auto here = camera.ray(Vector2d(x, y));
                const auto right = camera.ray(Vector2d(x + 0.01, y));
                const auto down = camera.ray(Vector2d(x, y + 0.01));
                if (table.explicitCell(x / kCell, y / kCell) != nullptr || !here || !right || !down) {
                    continue;
                }
                EXPECT_LE(angleBetween(*here, *right).value() / 0.01,
                          1.0001 * table.motion(0, 1, y / kCell)[x / kCell]);
                EXPECT_LE(angleBetween(*here, *down).value() / 0.01,
                          1.0001 * table.motion(1, 1, y / kCell)[x / kCell]);
            }
        }
    }
}

TEST(RayTable, RefusesOtherThanOneToEightSamples) {
    const CameraModel camera = pinholeOf(16, 16, 60);
    for (const int samples : {0, -1, 9}) {
        test::expectError(ErrorKind::InvalidInput, "8", [&] { RayTable(camera, samples); });
    }
}

TEST(PanoramaRenderer, ShowsOnePixelAsItIsThroughAnyField) {
    test::Random random(915);
    SCOPED_TRACE(random.seed());
    const RgbImage photo = smoothPanorama(1024);
    const Panorama panorama(photo);
    PanoramaRenderer renderer(1);
    RgbImage picture;
    for (const double field : {0.01, 1.0, 60.0}) {
        for (int i = 0; i < 20; ++i) {
            const Rigid3 pose{random.rotation(), Vector3d::Zero()};
            for (const Sampling sampling : {Sampling::Nearest, Sampling::Bilinear, Sampling::Bicubic}) {
                renderer.render(panorama, {}, pinholeOf(1, 1, field), pose, sampling, picture);
                const Vector3d seen = pose.rotation * Vector3d::UnitZ();
                for (int c = 0; c < 3; ++c) {
                    EXPECT_NEAR(picture.at(0, 0)[c], 128 + 120 * seen[c], 2.5) << name(sampling) << field;
                }
            }
        }
    }
}

TEST(PanoramaRenderer, RefusesARadiusThatIsNone) {
    const Panorama panorama(smoothPanorama(64));
    PanoramaRenderer renderer(1);
    RgbImage picture;
    for (const double radiusM : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        test::expectError(ErrorKind::InvalidInput, "radius is none", [&] {
            renderer.render(panorama, {{}, radiusM}, pinholeOf(4, 4, 60), {}, Sampling::Bilinear, picture);
        });
    }
}

} // namespace spherewalk::render
