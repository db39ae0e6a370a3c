// SPDX-License-Identifier: Apache-2.0
#include "each_target.h"
#include "random.h"
#include "sphere/sphere_view.h"
#include "surface/surface_view.h"
#include "test_dataset.h"

#include "spherewalk/geometry/rotation.h"
#include "spherewalk/render/scene_depth.h"

#include <gtest/gtest.h>

#include <cmath>

namespace spherewalk::render {

namespace {

constexpr int kPhotoWidth = 512;

std::shared_ptr<const SurfaceMesh> sphereMesh(double radiusM) {
    Image<float, 1> inverse(256, 128);
    std::fill(inverse.values().begin(), inverse.values().end(), static_cast<float>(1 / radiusM));
    return std::make_shared<const SurfaceMesh>(DepthMap(std::move(inverse)));
}

/// A photo of the smooth world with a surface about it.
struct Scene {
    explicit Scene(std::shared_ptr<const SurfaceMesh> surface, const Rigid3& roomFromPhoto = {})
        : picture(test::panorama(test::smoothWorld, roomFromPhoto.rotation, kPhotoWidth)),
          plane(picture),
          photo{0, std::move(surface), roomFromPhoto, TileGrid({kPhotoWidth, kPhotoWidth / 2})} {}

    RgbImage view(const CameraModel& camera, const Rigid3& pose, int threads = 1, int samples = 1) {
        const PixelRays rays(camera, pool);
        surfaceView.prepare(rays, pose, {&photo, 1}, 2, samples, pool, threads);
        const PlaneView planeView = plane.view();
        RgbImage result;
        surfaceView.sample(rays, {&planeView, 1}, samples > 1 ? Sampling::Footprint : Sampling::Bilinear,
                           pool, threads, result);
        return result;
    }

    RgbImage picture;
    PhotoPlane plane;
    SurfacePhoto photo;
    SurfaceView surfaceView;
    WorkerPool pool{3};
};

double worstDifference(const RgbImage& a, const RgbImage& b) {
    int worst = 0;
    for (std::size_t i = 0; i < a.values().size(); ++i) {
        worst = std::max(worst, std::abs(int{a.values()[i]} - int{b.values()[i]}));
    }
    return worst;
}

Rigid3 lookingFrom(const Eigen::Vector3d& place, double yaw, double pitch) {
    return {(rotation({Radians(yaw), Radians(pitch), Radians(0.1)}) * bodyFromOptical()).normalized(), place};
}

const CameraModel kCamera(CameraIntrinsics::pinhole(161, 121, 1.1));

} // namespace

TEST(SurfaceView, OfASphereIsTheSphereModelsView) {
    constexpr double kRadiusM = 2;
    Scene scene(sphereMesh(kRadiusM));
    const RayTable table(kCamera, 1);
    Workspace workspace;
    test::Random random(1);
    for (int i = 0; i < 20; ++i) {
        const Rigid3 pose =
            lookingFrom(0.3 * random.direction(), random.uniform(-3, 3), random.uniform(-1.5, 1.5));
        RgbImage expected;
        renderView(table, pose, {scene.plane.view(), {}, SceneKind::Sphere, kRadiusM}, Sampling::Bilinear,
                   scene.pool, 1, workspace, expected);
        EXPECT_LE(worstDifference(scene.view(kCamera, pose), expected), 6) << i;
    }
}

TEST(SurfaceView, HasTheSameBytesForAnyNumberOfThreads) {
    Scene scene(sphereMesh(1.5));
    const Rigid3 pose = lookingFrom({0.2, 0.1, -0.1}, 3.1, 0.2);
    const RgbImage one = scene.view(kCamera, pose, 1, 2);
    EXPECT_EQ(scene.view(kCamera, pose, 2, 2), one);
    EXPECT_EQ(scene.view(kCamera, pose, 3, 2), one);
}

TEST(SurfaceView, HasTheSameBytesOnAnySimd) {
    Image<float, 1> inverse(512, 256);
    test::Random random(8);
    for (float& value : inverse.values()) { // jumps and slants everywhere
        value = static_cast<float>(random.uniform(0.3, 0.5));
    }
    Scene scene(std::make_shared<const SurfaceMesh>(DepthMap(std::move(inverse))));
    const Rigid3 pose = lookingFrom({0.2, 0.1, -0.1}, 3.1, 0.2);
    const RgbImage expected = scene.view(kCamera, pose);
    test::forEachTarget(
        [&](const char* target) { EXPECT_EQ(scene.view(kCamera, pose), expected) << target; });
}

TEST(SurfaceView, ShowsTheDepthOfTheRoomThatItWasGiven) {
    const RoomShape room{{{-2, -2}, {2, -2}, {2, 2}, {-2, 2}}, -1, 1.5};
    Scene scene(std::make_shared<const SurfaceMesh>(roomDepth(room, {}, 512)));
    const Rigid3 pose = lookingFrom({0.4, -0.3, 0.2}, 0.6, 0.2);
    scene.view(kCamera, pose);
    const PixelRays rays(kCamera, scene.pool);
    const DepthImage depth = scene.surfaceView.depth(rays, scene.pool, 0);
    for (int y = 0; y < depth.height(); y += 7) {
        for (int x = 0; x < depth.width(); x += 7) {
            const Eigen::Vector3d ray = rays.ray(x, y);
            const double expected = ray.z() / inverseDistance(room, pose.translation, pose.rotation * ray);
            EXPECT_NEAR(*depth.at(x, y), expected, 0.02 * expected) << x << ", " << y;
        }
    }
}

TEST(SurfaceView, ClosesTheStripBetweenTheTwoLensesOfASphericalCamera) {
    const RoomShape room{{{-2, -2}, {2, -2}, {2, 2}, {-2, 2}}, -1, 1.5};
    for (const double aheadM : {0.005, -0.005, 0.02}) {
        const LensPair lenses{aheadM};
        Scene scene(std::make_shared<const SurfaceMesh>(roomDepth(room, {}, 512, lenses)));
        scene.photo.lenses = lenses;
        for (const double yaw : {1.3, -1.7}) { // to either side, where the seam is
            for (const double pitch : {-0.9, 0.1, 0.8}) {
                const Rigid3 pose = lookingFrom({0.3, 0.1, 0.1}, yaw, pitch);
                scene.view(kCamera, pose);
                EXPECT_EQ(scene.surfaceView.filledShare(), 0) << aheadM << ", " << yaw << ", " << pitch;
                const PixelRays rays(kCamera, scene.pool);
                const DepthImage depth = scene.surfaceView.depth(rays, scene.pool, 0);
                for (int y = 0; y < depth.height(); y += 3) {
                    for (int x = 0; x < depth.width(); ++x) {
                        const Eigen::Vector3d ray = rays.ray(x, y);
                        const double expected =
                            ray.z() / inverseDistance(room, pose.translation, pose.rotation * ray);
                        EXPECT_NEAR(*depth.at(x, y), expected, 0.04 * expected) << x << ", " << y;
                    }
                }
            }
        }
    }
}

/// A fisheye of this field with its edge at the left and the right of the picture.
CameraModel fisheye(double fieldDeg, const std::vector<double>& distortion) {
    CameraIntrinsics camera = CameraIntrinsics::pinhole(161, 121, 1.1);
    camera.lens = LensModel::Equidistant;
    camera.fx = camera.fy = 80 / Radians(Degrees(fieldDeg / 2)).value();
    camera.distortion = distortion;
    return CameraModel(camera);
}

TEST(SurfaceView, AFisheyeSeesTheDepthAheadAndNotThatBehind) {
    // What lies behind the camera is near, what lies ahead is far.
    const RoomShape room{{{-0.6, -2}, {5, -2}, {5, 2}, {-0.6, 2}}, -1, 1.5};
    Scene scene(std::make_shared<const SurfaceMesh>(roomDepth(room, {}, 512)));
    const std::vector<std::vector<double>> lenses = {
        {0, 0, 0, 0}, {-0.0062, 0.0445, -0.0420, 0.0081}, {-0.013, -0.02, 0.017, -0.0046}};
    for (const double fieldDeg : {100.0, 180.0, 220.0}) {
        for (const std::vector<double>& lens : lenses) {
            const CameraModel camera = fisheye(fieldDeg, lens);
            const PixelRays rays(camera, scene.pool);
            for (const double pitch : {-1.5, 0.0, 0.9}) {
                const Rigid3 pose = lookingFrom({0.1, 0.2, 0.1}, 0.2, pitch);
                scene.view(camera, pose);
                const DepthImage depth = scene.surfaceView.depth(rays, scene.pool, 0);
                int wrong = 0;
                int seen = 0;
                for (int y = 0; y < depth.height(); y += 3) {
                    for (int x = 0; x < depth.width(); x += 3) {
                        const Eigen::Vector3d ray = rays.ray(x, y);
                        if (ray.z() > 0.1) {
                            const double expected =
                                ray.z() / inverseDistance(room, pose.translation, pose.rotation * ray);
                            wrong += std::abs(*depth.at(x, y) / expected - 1) < 0.05 ? 0 : 1;
                            ++seen;
                        }
                    }
                }
                EXPECT_LE(wrong, 0.01 * seen)
                    << fieldDeg << " degrees, pitch " << pitch << ", k1 " << lens[0];
            }
        }
    }
}

TEST(SurfaceView, HidesWhatLiesBehindFromTheCamera) {
    // A wall at 3 m, and before it a strip at 1 m, from 0.1 rad to the left to 0.1 rad to the right.
    Image<float, 1> inverse(512, 256);
    for (int y = 0; y < 256; ++y) {
        for (int x = 0; x < 512; ++x) {
            *inverse.at(x, y) = std::abs(x - 255.5) < 8.2 ? 1.0F : 1 / 3.0F;
        }
    }
    Scene scene(std::make_shared<const SurfaceMesh>(DepthMap(std::move(inverse))));
    scene.view(kCamera, lookingFrom({0, 0.5, 0}, 0, 0));
    const PixelRays rays(kCamera, scene.pool);
    const DepthImage depth = scene.surfaceView.depth(rays, scene.pool, 0);
    // From half a metre to the left, the strip lies half a metre to the right of the middle.
    const auto column = static_cast<int>(80 + 0.5 * kCamera.intrinsics().fx);
    EXPECT_NEAR(*depth.at(column, 60), 1, 0.1);
    EXPECT_GT(*depth.at(20, 60), 2);
}

TEST(SurfaceView, TakesAHoleAtItsRightEdgeToBeAsFarAsWhatIsToItsLeft) {
    // A wall at 0.6 m, and before it a strip at 0.2 m. From 0.1 m to the left, the wall has a hole.
    Image<float, 1> inverse(512, 256);
    for (int y = 0; y < 256; ++y) {
        for (int x = 0; x < 512; ++x) {
            *inverse.at(x, y) = std::abs(x - 255.5) < 8.2 ? 1 / 0.2F : 1 / 0.6F;
        }
    }
    Scene scene(std::make_shared<const SurfaceMesh>(DepthMap(std::move(inverse))));
    const auto depthOfView = [&](int width) {
        CameraIntrinsics intrinsics = kCamera.intrinsics();
        intrinsics.width = width;
        intrinsics.cx = 50; // so that the hole goes on beyond column 80
        const CameraModel camera(intrinsics);
        scene.view(camera, lookingFrom({0, 0.1, 0}, 0, 0));
        EXPECT_GT(scene.surfaceView.filledShare(), 0);
        return scene.surfaceView.depth(PixelRays(camera, scene.pool), scene.pool, 0);
    };
    const DepthImage wider = depthOfView(80); // whole cells
    for (const int width : {65, 70, 79}) {
        const DepthImage depth = depthOfView(width);
        for (int y = 0; y < depth.height(); ++y) {
            for (int x = 0; x < width; ++x) {
                ASSERT_NEAR(*depth.at(x, y), *wider.at(x, y), 1e-4) << width << ": " << x << ", " << y;
            }
        }
    }
}

TEST(SurfaceView, OfNothingIsAsFarAsUsual) {
    constexpr double kUsualDistanceM = 3;
    Scene scene(sphereMesh(2));
    for (const int width : {160, 161}) {
        const CameraModel camera(CameraIntrinsics::pinhole(width, 121, 1.1));
        const PixelRays rays(camera, scene.pool);
        // From outside of the sphere, away from it.
        scene.surfaceView.prepare(rays, lookingFrom({10, 0, 0}, 0, 0), {&scene.photo, 1}, kUsualDistanceM, 1,
                                  scene.pool, 1);
        EXPECT_EQ(scene.surfaceView.filledShare(), 1);
        const DepthImage depth = scene.surfaceView.depth(rays, scene.pool, 0);
        for (const float z : depth.values()) {
            ASSERT_NEAR(z, kUsualDistanceM, 1e-5) << width;
        }
    }
}

TEST(SurfaceView, IsWholeFromAnywhere) {
    const RoomShape room{{{-2, -2}, {2, -2}, {2, 2}, {-2, 2}}, -1, 1.5};
    Scene scene(std::make_shared<const SurfaceMesh>(roomDepth(room, {}, 256)));
    // At a wall, in a corner, on the floor, outside, far away, at the photo, and a kilometre off.
    for (const Eigen::Vector3d& place :
         {Eigen::Vector3d(2, 0, 0), Eigen::Vector3d(2, 2, 1.5), Eigen::Vector3d(0, 0, -1),
          Eigen::Vector3d(5, 1, 0), Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1000, 0, 0)}) {
        for (const double yaw : {0.0, 2.0, 4.0}) {
            scene.view(kCamera, lookingFrom(place, yaw, 0.3));
            const DepthImage depth = scene.surfaceView.depth(PixelRays(kCamera, scene.pool), scene.pool, 0);
            EXPECT_TRUE(std::all_of(depth.values().begin(), depth.values().end(),
                                    [](float z) { return std::isfinite(z) && z > 0; }));
        }
    }
}

TEST(SurfaceView, TakesDepthsOfFiveCentimetresAndOfAHundredMetres) {
    for (const double radiusM : {0.05, 100.0}) {
        Scene scene(sphereMesh(radiusM));
        scene.view(kCamera, lookingFrom({0, 0, 0}, 1, 0));
        const DepthImage depth = scene.surfaceView.depth(PixelRays(kCamera, scene.pool), scene.pool, 0);
        EXPECT_NEAR(*depth.at(80, 60), radiusM, 0.04 * radiusM);
    }
}

TEST(SurfaceView, SeesThroughALensWhatItSeesWithoutOne) {
    CameraIntrinsics lens = kCamera.intrinsics();
    lens.lens = LensModel::PlumbBob;
    lens.distortion = {0, 0, 0, 0, 0};
    Scene scene(sphereMesh(2));
    const Rigid3 pose = lookingFrom({0.2, 0.2, 0.1}, 1, 0.1);
    const RgbImage pinhole = scene.view(kCamera, pose);
    EXPECT_LE(worstDifference(scene.view(CameraModel(lens), pose), pinhole), 6);
}

TEST(SurfaceView, TakesWhatTheFirstPhotoDoesNotSeeFromTheNext) {
    // The first photo's surface is a near strip and nothing else that the camera sees behind it.
    Scene scene(sphereMesh(2));
    Scene far(sphereMesh(2), {Eigen::Quaterniond::Identity(), {0.1, 0, 0}});
    const std::array<SurfacePhoto, 2> photos{scene.photo, far.photo};
    const PixelRays rays(kCamera, scene.pool);
    const auto needs =
        scene.surfaceView.prepare(rays, lookingFrom({0, 0, 0}, 0, 0), photos, 2, 1, scene.pool, 1);
    ASSERT_EQ(needs.size(), 2U);
    EXPECT_FALSE(needs[0].empty());
    EXPECT_TRUE(needs[1].empty()); // a sphere has no holes
    EXPECT_EQ(scene.surfaceView.filledShare(), 0);
}

} // namespace spherewalk::render
