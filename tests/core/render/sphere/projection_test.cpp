// SPDX-License-Identifier: Apache-2.0
#include "random.h"
#include "sphere/exact_view.h"

#include "spherewalk/geometry/rotation.h"

#include <gtest/gtest.h>

#include <numbers>

namespace spherewalk::render {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

const EquirectSize kPhoto{5376, 2688};

/// Distance in the photo, round the seam.
double distancePx(Vector2d a, const Vector2d& b) {
    a.x() = std::remainder(a.x() - b.x(), kPhoto.width) + b.x();
    return (a - b).norm();
}

} // namespace

// The photo is level and looks along the room's x axis; the camera stands at the photo and looks left and up:
// its picture's centre shows azimuth 90, elevation 30 degrees, its right edge what lies nearer to the photo's
// centre.
TEST(Projection, ShowsWhereTheCameraLooks) {
    const CameraModel camera(CameraIntrinsics::pinhole(641, 481, 1));
    const Eigen::Quaterniond roomFromBody = rotation({Degrees(90), Degrees(-30), Radians(0)});
    const Rigid3 here{Eigen::Quaterniond::Identity(), {3, 2, 1}};
    const Projection projection(camera, {roomFromBody * bodyFromOptical(), here.translation}, here, kPhoto,
                                SceneKind::None, 0);
    EXPECT_LT(distancePx(*projection.photoPixel({320, 240}), {5376 / 4.0 - 0.5, 2688 / 3.0 - 0.5}), 1e-9);
    EXPECT_GT(projection.photoPixel({640, 240})->x(), 5376 / 4.0);
    EXPECT_LT(projection.photoPixel({320, 0})->y(), 2688 / 3.0);
}

// The point of the sphere that a pixel shows lies on that pixel's ray: for any poses
// and lenses, near and a million metres from the room's origin.
TEST(Projection, AgreesWithProjectingThePointItself) {
    test::Random random(31);
    for (int i = 0; i < 20000; ++i) {
        const double radius = 2.5;
        const Vector3d origin = i % 2 == 0 ? Vector3d::Zero() : Vector3d(1e6, -1e6, 1e3);
        const Rigid3 roomFromPhoto{random.rotation(), origin};
        const Vector3d offset = random.direction() * random.uniform(0, 0.95 * radius);
        const Rigid3 roomFromCamera{random.rotation(), origin + offset};
        CameraIntrinsics intrinsics = CameraIntrinsics::pinhole(640, 480, random.uniform(0.02, 3.12));
        if (i % 3 == 0) {
            intrinsics.lens = LensModel::Equidistant;
            intrinsics.distortion = {0.01, 0, 0, 0};
        }
        const CameraModel camera(intrinsics);
        const Vector2d at(random.uniform(0, 639), random.uniform(0, 479));
        const Projection projection(camera, roomFromCamera, roomFromPhoto, kPhoto, SceneKind::Sphere, radius);
        const auto found = projection.photoPixel(at);
        if (!found) {
            continue;
        }
        const Vector3d pInCamera =
            (roomFromCamera.inverse() * roomFromPhoto) * Vector3d(radius * direction(kPhoto, *found));
        // 1e-9 m of rounding at 10^6 m, seen from no nearer than 5 % of the radius.
        ASSERT_LT(angleBetween(*camera.ray(at), pInCamera).value(), 1e-8) << i << " seed " << random.seed();
    }
}

TEST(Projection, IsContinuousOverPolesAndSeam) {
    // One pixel of view is about one pixel of photo; across the pole the direction, not the pixel, is what
    // must be close.
    const CameraModel camera(CameraIntrinsics::pinhole(101, 101, 0.1));
    const Rigid3 here;
    for (const double pitch : {-std::numbers::pi / 2, std::numbers::pi / 2, 0.0}) {
        const Eigen::Quaterniond roomFromBody =
            rotation({Radians(std::numbers::pi), Radians(pitch), Radians(0)});
        const Projection projection(camera, {roomFromBody * bodyFromOptical(), {0, 0, 0}}, here, kPhoto,
                                    SceneKind::None, 0);
        for (int y = 0; y < 101; ++y) {
            for (int x = 0; x + 1 < 101; ++x) {
                const Vector3d a = direction(kPhoto, *projection.photoPixel(Vector2d(x, y)));
                const Vector3d b = direction(kPhoto, *projection.photoPixel(Vector2d(x + 1, y)));
                ASSERT_NEAR(angleBetween(a, b).value(), 0.1 / 101, 1e-5) << pitch << " " << x << " " << y;
            }
        }
    }
}

} // namespace spherewalk::render
