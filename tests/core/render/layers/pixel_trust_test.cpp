// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"
#include "layers/view_geometry.h"
#include "lenses.h"
#include "random.h"
#include "sphere/exact_view.h"
#include "temporary_folder.h"
#include "test_dataset.h"

#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/render/renderer.h"
#include "spherewalk/render/view.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace spherewalk::render {

using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;

namespace {

constexpr EquirectSize kPhoto{5376, 2688};

struct Made {
    PixelRays rays;
    ViewGeometry view;

    Made(const CameraIntrinsics& camera, const Rigid3& roomFromCamera, SceneKind scene, WorkerPool& pool,
         const Rigid3& roomFromPhoto = {}, double radiusM = 2)
        : rays(CameraModel(camera), pool),
          view{rays, roomFromCamera, roomFromPhoto, kPhoto, scene, radiusM} {}

    Made(const Made&) = delete;
    Made& operator=(const Made&) = delete;
};

/// The trust of a view from photos without depths. priorShare: ViewEvidence::priorShare.
PixelTrust trustOf(const Made& made, WorkerPool& pool, const TrustOptions& options = {}, int threads = 0,
                   double priorShare = 1) {
    ViewEvidence evidence;
    evidence.photos.push_back({made.view.roomFromPhoto, nullptr});
    evidence.priorShare = priorShare;
    return pixelTrust(made.view, evidence, options, pool, threads);
}

Rigid3 looking(Radians yaw, Radians pitch, const Vector3d& position = Vector3d::Zero()) {
    return {rotation({yaw, pitch, Radians(0)}) * bodyFromOptical(), position};
}

bool flagged(const PixelTrust& trust, int x, int y, PixelFlag flag) {
    return has(*trust.flags.at(x, y), flag);
}

} // namespace

TEST(PixelTrust, IsWholeAtThePhotosOwnPosition) {
    test::Random random(81);
    SCOPED_TRACE(random.seed());
    WorkerPool pool(2);
    std::vector<CameraIntrinsics> cameras = test::everyLens(40, 30);
    for (const double fovDeg : {1.0, 179.0}) {
        cameras.push_back(CameraIntrinsics::pinhole(40, 30, fovDeg * pi / 180));
    }
    const Rigid3 photo{random.rotation(), {1e6, -1e6, 1e6}};
    for (const CameraIntrinsics& camera : cameras) {
        for (const SceneKind scene : {SceneKind::None, SceneKind::Sphere}) {
            const Made made(camera, {random.rotation(), photo.translation}, scene, pool, photo);
            const PixelTrust result = trustOf(made, pool);
            for (int y = 0; y < 30; ++y) {
                for (int x = 0; x < 40; ++x) {
                    const bool isSeen = made.rays.camera().ray(Vector2d(x, y)).has_value();
                    ASSERT_EQ(*result.errorPx.at(x, y), isSeen ? 0 : HUGE_VALF);
                    ASSERT_EQ(trust(*result.errorPx.at(x, y)), isSeen ? 1 : 0);
                    ASSERT_EQ(flagged(result, x, y, PixelFlag::Unseen), !isSeen);
                }
            }
        }
    }
}

// The whole view's report says what its pixels say: their median.
TEST(PixelTrust, TheReportIsTheMedianOfThePixels) {
    const test::TemporaryFolder folder;
    test::writeTestDataset(folder.path(), {Rigid3{}}, test::smoothWorld, 64, 2.0);
    const Renderer renderer(std::make_shared<const Dataset>(Dataset::open(folder.path())));
    test::Random random(82);
    SCOPED_TRACE(random.seed());
    for (int i = 0; i < 50; ++i) {
        CameraIntrinsics camera = CameraIntrinsics::pinhole(41, 31, random.uniform(0.02, 2.0));
        if (i % 3 == 1) {
            camera.lens = LensModel::Equidistant;
            camera.distortion = {-0.02, 0.004, -0.001, 0.0002};
        }
        const Rigid3 pose{random.rotation(), random.direction() * random.uniform(0, 1.9)};
        for (const SceneKind scene : {SceneKind::None, SceneKind::Sphere}) {
            const View view =
                renderer.render(CameraModel(camera), pose, {.scene = scene, .wantsTrust = true});
            std::vector<float> errors;
            for (const float error : view.trust.errorPx.values()) {
                if (std::isfinite(error)) {
                    errors.push_back(error);
                }
            }
            const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
            std::nth_element(errors.begin(), middle, errors.end());
            EXPECT_NEAR(view.report.parallaxPx, *middle, 0.1 * *middle + 0.01);
            EXPECT_EQ(view.report.trust, 1 / (1 + view.report.parallaxPx));
        }
    }
}

// What the error claims, done: a thing at half of the distance that the model assumes, seen by the photo
// where the model's thing is, is that many pixels off in the view.
TEST(PixelTrust, IsHowFarAThingAtHalfOfTheDistanceIsOffItsPlace) {
    test::Random random(83);
    SCOPED_TRACE(random.seed());
    WorkerPool pool(2);
    double worst = 0;
    for (int i = 0; i < 10; ++i) {
        for (const CameraIntrinsics& intrinsics : test::everyLens(40, 30)) {
            const Rigid3 photo{random.rotation(), random.vector(10)};
            const Rigid3 pose{random.rotation(), photo.translation + random.direction() * 1e-4};
            const Made made(intrinsics, pose, SceneKind::Sphere, pool, photo);
            const CameraModel& camera = made.rays.camera();
            const PixelTrust result = trustOf(made, pool);
            for (int y = 0; y < 30; ++y) {
                for (int x = 0; x < 40; ++x) {
                    const auto ray = camera.ray(Vector2d(x, y));
                    if (!ray) {
                        continue;
                    }
                    const Vector3d offset =
                        pose.rotation.conjugate() * (pose.translation - photo.translation);
                    const Vector3d thing = 0.5 * directionOnSphere(offset, *ray, 2).normalized() * 2 - offset;
                    const auto seen = camera.project(thing);
                    if (!seen) {
                        continue; // it left the lens's field
                    }
                    const double off = (*seen - Vector2d(x, y)).norm();
                    worst = std::max(worst, std::abs(*result.errorPx.at(x, y) - off) / std::max(off, 1e-4));
                }
            }
        }
    }
    RecordProperty("worst_relative", text(worst));
    EXPECT_LT(worst, 0.01);
}

TEST(PixelTrust, AnOffsetAlongTheRayDisplacesNothing) {
    WorkerPool pool(1);
    const Made made(CameraIntrinsics::pinhole(41, 31, 1), looking(Radians(0), Radians(0), {0.5, 0, 0}),
                    SceneKind::Sphere, pool);
    const PixelTrust result = trustOf(made, pool);
    EXPECT_NEAR(*result.errorPx.at(20, 15), 0, 1e-6);
    EXPECT_GT(*result.errorPx.at(0, 15), 1);
}

TEST(PixelTrust, ErrorGrowsWithTheSpreadOfTheDistances) {
    WorkerPool pool(1);
    const Made made(CameraIntrinsics::pinhole(41, 31, 1), looking(Radians(0.2), Radians(0.1), {0, 0.5, 0.1}),
                    SceneKind::Sphere, pool);
    const float whole = *trustOf(made, pool).errorPx.at(7, 9);
    EXPECT_FLOAT_EQ(*trustOf(made, pool, {}, 0, 0.25).errorPx.at(7, 9), 0.25F * whole);
    EXPECT_EQ(*trustOf(made, pool, {}, 0, 0).errorPx.at(7, 9), 0);
}

TEST(PixelTrust, ACoarserPictureIsABlurWhereTheViewWouldShowMore) {
    WorkerPool pool(1);
    for (const double fovDeg : {10.0, 40.0, 90.0}) {
        const Made made(CameraIntrinsics::pinhole(641, 481, fovDeg * pi / 180), {}, SceneKind::None, pool);
        const double full = 2 * pi / kPhoto.width * made.rays.camera().intrinsics().fx;
        for (const double coarseness : {1.0, 2.0, 8.0}) {
            TrustOptions options;
            options.coarseness = coarseness;
            const PixelTrust result = trustOf(made, pool, options);
            const double expected = 0.5 * std::max(0.0, coarseness * full - std::max(1.0, full));
            EXPECT_NEAR(*result.errorPx.at(320, 240), expected, 1e-4 * (1 + expected)) << fovDeg;
            EXPECT_EQ(flagged(result, 320, 240, PixelFlag::Coarse), expected > 0) << fovDeg;
        }
    }
}

TEST(PixelTrust, FlagsThePolesAndTheStitchingOfTheTurnedPhoto) {
    test::Random random(84);
    SCOPED_TRACE(random.seed());
    WorkerPool pool(2);
    TrustOptions options;
    options.poleRadius = Degrees(15);
    options.stitchingHalfWidth = Degrees(4);
    int poles = 0;
    int stitching = 0;
    for (int i = 0; i < 30; ++i) {
        const Rigid3 photo{random.rotation(), Vector3d::Zero()};
        const Made made(CameraIntrinsics::pinhole(40, 30, 1.5), {random.rotation(), Vector3d::Zero()},
                        SceneKind::None, pool, photo);
        const PixelTrust result = trustOf(made, pool, options);
        for (int y = 0; y < 30; ++y) {
            for (int x = 0; x < 40; ++x) {
                const Vector3d inPhoto =
                    photo.rotation.conjugate() * (made.view.roomFromCamera.rotation * made.rays.ray(x, y));
                const double toPole = std::min(angleBetween(inPhoto, Vector3d::UnitZ()).value(),
                                               angleBetween(inPhoto, -Vector3d::UnitZ()).value());
                const double toCircle = std::abs(angleBetween(inPhoto, Vector3d::UnitX()).value() - pi / 2);
                const bool isPole = toPole < Radians(options.poleRadius).value();
                const bool isStitching = toCircle < Radians(options.stitchingHalfWidth).value();
                ASSERT_EQ(flagged(result, x, y, PixelFlag::Pole), isPole);
                ASSERT_EQ(flagged(result, x, y, PixelFlag::Stitching), isStitching);
                poles += isPole ? 1 : 0;
                stitching += isStitching ? 1 : 0;
            }
        }
    }
    EXPECT_GT(poles, 100);
    EXPECT_GT(stitching, 100);
    options.poleRadius = options.stitchingHalfWidth = Degrees(0);
    const Made made(CameraIntrinsics::pinhole(41, 31, 1), looking(Radians(0), Radians(pi / 2)),
                    SceneKind::None, pool);
    const PixelTrust none = trustOf(made, pool, options);
    for (const std::uint8_t flags : none.flags.values()) {
        EXPECT_FALSE(has(flags, PixelFlag::Pole) || has(flags, PixelFlag::Stitching));
    }
}

// A pixel whose neighbour comes from the other border of the photo is at most a pixel away from the seam.
TEST(PixelTrust, FlagsTheSeamOnBothOfItsSidesAndNothingElse) {
    test::Random random(85);
    SCOPED_TRACE(random.seed());
    WorkerPool pool(2);
    int across = 0;
    for (int i = 0; i < 30; ++i) {
        const CameraIntrinsics camera = test::everyLens(64, 48)[static_cast<std::size_t>(i % 4)];
        const SceneKind scene = i % 2 == 0 ? SceneKind::Sphere : SceneKind::None;
        const Rigid3 pose = looking(Radians(pi + random.uniform(-0.3, 0.3)),
                                    Radians(random.uniform(-0.8, 0.8)), random.direction() * 0.8);
        const Made made(camera, pose, scene, pool);
        const PixelTrust result = trustOf(made, pool);
        const Projection projection(made.rays.camera(), pose, {}, kPhoto, scene, 2);
        for (int y = 0; y < 48; ++y) {
            for (int x = 0; x + 1 < 64; ++x) {
                const auto here = projection.photoPixel(Vector2d(x, y));
                const auto next = projection.photoPixel(Vector2d(x + 1, y));
                if (!here || !next) {
                    continue;
                }
                const double step = std::abs(here->x() - next->x());
                if (step > kPhoto.width / 2.0 && std::abs(here->y() - kPhoto.height / 2.0) < 900) {
                    ++across;
                    EXPECT_TRUE(flagged(result, x, y, PixelFlag::Seam) ||
                                flagged(result, x + 1, y, PixelFlag::Seam));
                }
                if (flagged(result, x, y, PixelFlag::Seam)) {
                    const double toSeam = std::min(here->x() + 0.5, kPhoto.width - 0.5 - here->x());
                    const double level = std::cos(pi * (0.5 - (here->y() + 0.5) / kPhoto.height));
                    EXPECT_LT(toSeam * level, 0.5 * level + 300) << "view pixels span up to 200 photo pixels";
                }
            }
        }
    }
    EXPECT_GT(across, 300);
}

// Squares of pixels are flagged together. A picture that is coarser by next to nothing makes each pixel be
// flagged by itself.
TEST(PixelTrust, FlagsSquaresAsItFlagsPixels) {
    test::Random random(86);
    SCOPED_TRACE(random.seed());
    WorkerPool pool(2);
    for (int i = 0; i < 12; ++i) {
        std::vector<CameraIntrinsics> cameras = test::everyLens(161, 121);
        cameras.push_back(CameraIntrinsics::pinhole(161, 121, random.uniform(0.05, 2.8)));
        for (const CameraIntrinsics& camera : cameras) {
            for (const SceneKind scene : {SceneKind::None, SceneKind::Sphere}) {
                const Rigid3 photo{random.rotation(), random.vector(10)};
                const Rigid3 pose{random.rotation(),
                                  photo.translation + random.direction() * random.uniform(0, 2.5)};
                const Made made(camera, pose, scene, pool, photo);
                TrustOptions options;
                options.poleRadius = Degrees(random.uniform(0, 80));
                options.stitchingHalfWidth = Degrees(random.uniform(0, 30));
                const PixelTrust together = trustOf(made, pool, options);
                options.coarseness = 1 + 1e-12;
                const PixelTrust alone = trustOf(made, pool, options);
                for (int y = 0; y < camera.height; ++y) {
                    for (int x = 0; x < camera.width; ++x) {
                        const int flags = *alone.flags.at(x, y) & ~static_cast<int>(PixelFlag::Coarse);
                        ASSERT_EQ(*together.flags.at(x, y), flags) << x << ", " << y;
                        ASSERT_EQ(*together.errorPx.at(x, y), *alone.errorPx.at(x, y));
                    }
                }
            }
        }
    }
}

TEST(PixelTrust, UsesTheMemoryOfTheViewBefore) {
    WorkerPool pool(1);
    const Made made(test::everyLens(67, 51)[3], looking(Radians(3), Radians(0.3), {0.3, 0.2, 0.1}),
                    SceneKind::Sphere, pool);
    ViewEvidence evidence;
    evidence.photos.push_back({made.view.roomFromPhoto, nullptr});
    const PixelTrust fresh = pixelTrust(made.view, evidence, {}, pool);
    PixelTrust used{Image<float, 1>(67, 51), MaskImage(67, 51)};
    std::fill(used.errorPx.values().begin(), used.errorPx.values().end(), 17.0F);
    std::fill(used.flags.values().begin(), used.flags.values().end(), std::uint8_t{255});
    const float* memory = used.errorPx.values().data();
    const PixelTrust again = pixelTrust(made.view, evidence, {}, pool, 0, std::move(used));
    EXPECT_EQ(again.errorPx.values().data(), memory);
    EXPECT_EQ(again.errorPx, fresh.errorPx);
    EXPECT_EQ(again.flags, fresh.flags);
}

TEST(PixelTrust, FlagsOverlays) {
    WorkerPool pool(1);
    const Made made(CameraIntrinsics::pinhole(5, 4, 1), {}, SceneKind::None, pool);
    MaskImage shown(5, 4);
    *shown.at(3, 2) = 1;
    TrustOptions options;
    options.overlays = &shown;
    const PixelTrust result = trustOf(made, pool, options);
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 5; ++x) {
            EXPECT_EQ(flagged(result, x, y, PixelFlag::Overlay), x == 3 && y == 2);
        }
    }
}

TEST(PixelTrust, IsFiniteAtPolesAtTheSpheresEdgeAndForAnyField) {
    WorkerPool pool(2);
    for (const double fovDeg : {1.0, 90.0, 179.0}) {
        for (const int side : {1, 2, 51}) {
            for (const double pitch : {-pi / 2, 0.0, pi / 2}) {
                for (const Vector3d& offset :
                     {Vector3d(0, 0, 1.9), Vector3d(1.9, 0, 0), Vector3d(30, 40, 0)}) {
                    const Made made(CameraIntrinsics::pinhole(side, side, fovDeg * pi / 180),
                                    looking(Radians(pi), Radians(pitch), offset), SceneKind::Sphere, pool);
                    const PixelTrust result = trustOf(made, pool);
                    for (const float error : result.errorPx.values()) {
                        ASSERT_TRUE(std::isfinite(error) && error >= 0) << fovDeg << " " << side;
                    }
                }
            }
        }
    }
}

TEST(PixelTrust, IsTheSameForAnyNumberOfThreads) {
    WorkerPool pool(4);
    for (const CameraIntrinsics& camera : test::everyLens(67, 51)) {
        const Made made(camera, looking(Radians(3), Radians(0.3), {0.3, 0.2, 0.1}), SceneKind::Sphere, pool);
        const PixelTrust one = trustOf(made, pool, {}, 1);
        for (const int threads : {0, 2, 3}) {
            const PixelTrust many = trustOf(made, pool, {}, threads);
            EXPECT_EQ(many.errorPx, one.errorPx) << threads;
            EXPECT_EQ(many.flags, one.flags) << threads;
        }
    }
}

TEST(PixelTrust, RefusesOptionsThatAreNone) {
    WorkerPool pool(1);
    const Made made(CameraIntrinsics::pinhole(5, 4, 1), {}, SceneKind::None, pool);
    const auto refused = [&](const std::string& part, auto&& change) {
        TrustOptions options;
        change(options);
        test::expectError(ErrorKind::InvalidInput, part, [&] { trustOf(made, pool, options); });
    };
    refused("pole", [](TrustOptions& options) { options.poleRadius = Degrees(std::nan("")); });
    refused("stitching", [](TrustOptions& options) { options.stitchingHalfWidth = Degrees(-1); });
    refused("coarseness", [](TrustOptions& options) { options.coarseness = 0.5; });
    const MaskImage other(4, 5);
    refused("4 x 5 pixels", [&](TrustOptions& options) { options.overlays = &other; });
}

} // namespace spherewalk::render
