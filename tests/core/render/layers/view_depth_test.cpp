// SPDX-License-Identifier: Apache-2.0
#include "each_target.h"
#include "expect_error.h"
#include "layers/view_geometry.h"
#include "lenses.h"
#include "random.h"
#include "sphere/exact_view.h"

#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace spherewalk::render {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Vector3l = Eigen::Matrix<long double, 3, 1>;

namespace {

constexpr float kEndlessM = std::numeric_limits<float>::infinity();

/// The textbook formula: z of where the ray leaves the sphere.
long double exactDepth(const ViewGeometry& view, const Vector3d& ray) {
    Vector3l offset = view.roomFromCamera.translation.cast<long double>() -
                      view.roomFromPhoto.translation.cast<long double>();
    const long double radius = view.sphereRadiusM;
    const long double most = static_cast<long double>(kLargestDisplacement) * radius;
    if (offset.norm() > most) {
        offset *= most / offset.norm();
    }
    const Vector3l inCamera = ray.cast<long double>().normalized();
    const Vector3l inRoom = view.roomFromCamera.rotation.cast<long double>() * inCamera;
    const long double b = offset.dot(inRoom);
    return (-b + std::sqrt(b * b + radius * radius - offset.squaredNorm())) * inCamera.z();
}

struct MadeDepth {
    PixelRays rays;
    ViewGeometry view;

    MadeDepth(const CameraIntrinsics& camera, const Rigid3& roomFromCamera, const Rigid3& roomFromPhoto,
              double radiusM, WorkerPool& pool)
        : rays(CameraModel(camera), pool), view{rays,         roomFromCamera,    roomFromPhoto,
                                                {5376, 2688}, SceneKind::Sphere, radiusM} {}

    MadeDepth(const MadeDepth&) = delete;
    MadeDepth& operator=(const MadeDepth&) = delete;
};

/// The greatest relative error of all pixels that are less than 90 degrees off the axis.
double worstError(const ViewGeometry& view, const DepthImage& depth) {
    double worst = 0;
    for (int y = 0; y < depth.height(); ++y) {
        for (int x = 0; x < depth.width(); ++x) {
            const auto ray = view.rays.camera().ray(Vector2d(x, y));
            if (!ray || ray->z() <= 0) {
                EXPECT_EQ(*depth.at(x, y), kEndlessM);
                continue;
            }
            const long double exact = exactDepth(view, *ray);
            worst = std::max(worst, static_cast<double>(std::abs(*depth.at(x, y) - exact) / exact));
        }
    }
    return worst;
}

} // namespace

TEST(ViewDepth, AgreesWithLongDoubleFromAnywhereInTheSphereThroughAnyLens) {
    test::Random random(61);
    SCOPED_TRACE(random.seed());
    WorkerPool pool(2);
    double worst = 0;
    for (int i = 0; i < 40; ++i) {
        for (const CameraIntrinsics& camera : test::everyLens(40, 30)) {
            const Vector3d far = i % 2 == 0 ? Vector3d(1e6, -2e6, 1e6) : Vector3d::Zero();
            const double radius = random.uniform(0.5, 8);
            const double share = i % 4 == 0 ? kLargestDisplacement : random.uniform(0, 1.2);
            const Rigid3 photo{random.rotation(), far + random.vector(3)};
            const Rigid3 pose{random.rotation(), photo.translation + random.direction() * (share * radius)};
            const MadeDepth made(camera, pose, photo, radius, pool);
            worst = std::max(worst, worstError(made.view, viewDepth(made.view, pool)));
        }
    }
    RecordProperty("worst_relative", text(worst));
    EXPECT_LT(worst, 1e-6); // rays of lenses are kept as floats
}

TEST(ViewDepth, AgreesWithLongDoubleAtTheNarrowestAndTheWidestView) {
    test::Random random(62);
    SCOPED_TRACE(random.seed());
    WorkerPool pool(2);
    for (const double fovDeg : {1.0, 60.0, 179.0}) {
        for (const int side : {1, 2, 101}) {
            const CameraIntrinsics camera =
                CameraIntrinsics::pinhole(side, side, fovDeg * std::numbers::pi / 180);
            const Vector3d position(1e6, 1e6, -1e6);
            for (const double share : {0.0, 0.5, kLargestDisplacement}) {
                const MadeDepth made(camera, {random.rotation(), position + random.direction() * share * 3},
                                     {random.rotation(), position}, 3, pool);
                EXPECT_LT(worstError(made.view, viewDepth(made.view, pool)), 1e-7) << fovDeg << " " << share;
            }
        }
    }
}

TEST(ViewDepth, IsWhereThePhotoSeesWhatTheViewShows) {
    test::Random random(63);
    SCOPED_TRACE(random.seed());
    WorkerPool pool(2);
    for (const CameraIntrinsics& camera : test::everyLens(40, 30)) {
        const Rigid3 photo{random.rotation(), random.vector(2)};
        const Rigid3 pose{random.rotation(), photo.translation + random.direction() * 1.1};
        const MadeDepth made(camera, pose, photo, 2, pool);
        const DepthImage depth = viewDepth(made.view, pool);
        const Projection projection(made.rays.camera(), pose, photo, made.view.photo, SceneKind::Sphere, 2);
        for (int y = 0; y < 30; ++y) {
            for (int x = 0; x < 40; ++x) {
                const auto ray = made.rays.camera().ray(Vector2d(x, y));
                if (!ray || ray->z() < 0.01) { // beyond, z hardly tells how far the ray goes
                    continue;
                }
                const Vector3d pInRoom = pose * Vector3d(*ray * (*depth.at(x, y) / ray->z()));
                const Vector3d shown = direction(made.view.photo, *projection.photoPixel(Vector2d(x, y)));
                const Vector3d met = photo.rotation.conjugate() * (pInRoom - photo.translation);
                ASSERT_NEAR(met.norm(), 2, 1e-4);
                ASSERT_LT(angleBetween(met, shown).value(), 1e-5); // 0.01 pixels of the photo
            }
        }
    }
}

TEST(ViewDepth, OfADisplacedCameraIsKnownByHand) {
    // 1 m ahead of the photo in a sphere of 2 m: 1 m to the front, sqrt(3) m to the side.
    WorkerPool pool(1);
    const Rigid3 ahead{bodyFromOptical(), {1, 0, 0}};
    const MadeDepth front(CameraIntrinsics::pinhole(1, 1, 1), ahead, {}, 2, pool);
    EXPECT_FLOAT_EQ(*viewDepth(front.view, pool).at(0, 0), 1.0F);
    const Rigid3 left{yawRotation(Degrees(90)) * bodyFromOptical(), {1, 0, 0}};
    const MadeDepth side(CameraIntrinsics::pinhole(1, 1, 1), left, {}, 2, pool);
    EXPECT_FLOAT_EQ(*viewDepth(side.view, pool).at(0, 0), std::sqrt(3.0F));
    // Outside of the sphere it is treated as standing at 1.9 m.
    const MadeDepth outside(CameraIntrinsics::pinhole(1, 1, 1), {bodyFromOptical(), {50, 0, 0}}, {}, 2, pool);
    EXPECT_NEAR(*viewDepth(outside.view, pool).at(0, 0), 0.1, 1e-6);
}

TEST(ViewDepth, IsEmptyWithoutASceneModel) {
    WorkerPool pool(1);
    MadeDepth made(CameraIntrinsics::pinhole(4, 3, 1), {}, {}, 2, pool);
    made.view.scene = SceneKind::None;
    EXPECT_TRUE(viewDepth(made.view, pool).empty());
}

TEST(ViewDepth, IsInfiniteBesideAndBehindTheCamera) {
    WorkerPool pool(1);
    CameraIntrinsics fisheye = CameraIntrinsics::pinhole(101, 101, 1);
    fisheye.lens = LensModel::Equidistant;
    fisheye.distortion = {0, 0, 0, 0};
    fisheye.fx = fisheye.fy = 20; // 2.5 rad from the centre to the border
    const MadeDepth made(fisheye, {}, {}, 2, pool);
    const DepthImage depth = viewDepth(made.view, pool);
    for (int x = 0; x < 101; ++x) {
        const double angle = std::abs(x - 50) / 20.0;
        EXPECT_EQ(std::isinf(*depth.at(x, 50)), angle >= std::numbers::pi / 2) << x;
        EXPECT_GT(*depth.at(x, 50), 0);
    }
}

TEST(ViewDepth, IsTheSameForAnyNumberOfThreads) {
    test::Random random(64);
    WorkerPool pool(4);
    const MadeDepth made(test::everyLens(67, 51)[3], {random.rotation(), {0.3, 0.2, -0.4}},
                         {random.rotation(), Eigen::Vector3d::Zero()}, 2, pool);
    const DepthImage one = viewDepth(made.view, pool, 1);
    for (const int threads : {0, 2, 3}) {
        EXPECT_EQ(viewDepth(made.view, pool, threads), one) << threads;
    }
}

TEST(ViewDepth, IsTheSameOnEachProcessor) {
    test::Random random(88);
    SCOPED_TRACE(random.seed());
    WorkerPool pool(1);
    for (const int width : {1, 7, 64, 101}) {
        const MadeDepth made(CameraIntrinsics::pinhole(width, 9, 1.9), {random.rotation(), random.vector()},
                             {random.rotation(), random.vector()}, 3, pool);
        const DepthImage expected = viewDepth(made.view, pool);
        test::forEachTarget(
            [&](const char* target) { EXPECT_EQ(viewDepth(made.view, pool), expected) << target; });
    }
}

TEST(ViewGeometry, RefusesWhatIsNone) {
    WorkerPool pool(1);
    const MadeDepth made(CameraIntrinsics::pinhole(4, 3, 1), {}, {}, 2, pool);
    const auto refused = [&](const std::string& part, auto&& change) {
        ViewGeometry view = made.view;
        change(view);
        test::expectError(ErrorKind::InvalidInput, part, [&] { viewDepth(view, pool); });
    };
    refused("pose", [](ViewGeometry& view) { view.roomFromCamera.translation.x() = std::nan(""); });
    refused("pose", [](ViewGeometry& view) { view.roomFromPhoto.rotation.coeffs().setZero(); });
    refused("0 x 2688 pixels", [](ViewGeometry& view) { view.photo.width = 0; });
    for (const double radius : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
        refused("radius", [&](ViewGeometry& view) { view.sphereRadiusM = radius; });
    }
}

} // namespace spherewalk::render
