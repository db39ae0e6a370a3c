// SPDX-License-Identifier: Apache-2.0
#include "each_target.h"
#include "expect_error.h"
#include "random.h"
#include "sphere/exact_view.h"
#include "sphere/sphere_view.h"

#include "spherewalk/geometry/rotation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace spherewalk::render {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr std::array kAll{Sampling::Nearest, Sampling::Bilinear, Sampling::Reduced, Sampling::Footprint,
                          Sampling::Bicubic};

/// Noise, the worst that a sampler can meet.
RgbImage noise(int width, unsigned seed) {
    test::Random random(seed);
    RgbImage picture(width, width / 2);
    for (std::uint8_t& value : picture.values()) {
        value = static_cast<std::uint8_t>(random.integer(0, 1) * 255);
    }
    return picture;
}

/// Smooth but for the poles and the seam, where a row that is not taken from across them shows.
RgbImage smooth(int width) {
    RgbImage picture(width, width / 2);
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < width; ++x) {
            const Vector3d d = direction(EquirectSize{width, width / 2}, Vector2d(x, y));
            for (int c = 0; c < 3; ++c) {
                picture.at(x, y)[c] = static_cast<std::uint8_t>(std::lround(127.5 + 120 * d[c]));
            }
        }
    }
    return picture;
}

struct Scene {
    CameraModel camera;
    Rigid3 roomFromCamera;
    Rigid3 roomFromPhoto;
    SceneKind kind;
};

Scene randomScene(test::Random& random) {
    CameraIntrinsics camera =
        CameraIntrinsics::pinhole(random.integer(1, 150), random.integer(1, 110), random.uniform(0.3, 2.6));
    if (random.integer(0, 2) == 0) {
        camera.lens = LensModel::Equidistant;
        camera.fx = camera.fy = random.uniform(10, 120); // some see nothing at the corners
        camera.distortion = {0.02, -0.01, 0, 0};
    }
    const Rigid3 photo{random.rotation(), random.vector(100)};
    return {CameraModel(camera),
            {random.rotation(), photo.translation + 0.7 * random.direction()},
            photo,
            random.integer(0, 1) == 0 ? SceneKind::None : SceneKind::Sphere};
}

RgbImage rendered(const Scene& scene, const PlaneView& plane, Sampling sampling, int threads,
                  WorkerPool& pool) {
    const int n = samplesPerAxis(sampling, minification(scene.camera, plane.size().width));
    const RayTable rays(scene.camera, n);
    Workspace workspace;
    RgbImage picture;
    renderView(rays, scene.roomFromCamera, {plane, scene.roomFromPhoto, scene.kind, 2.0}, sampling, pool,
               threads, workspace, picture);
    return picture;
}

double catmullRom(double x) {
    x = std::abs(x);
    return x < 1 ? 1 - x * x * (2.5 - 1.5 * x) : x < 2 ? 2 - x * (4 - x * (2.5 - 0.5 * x)) : 0;
}

Vector3d bicubic(const PlaneView& plane, const Vector2d& at) {
    const int x = static_cast<int>(std::floor(at.x()));
    const int y = static_cast<int>(std::floor(at.y()));
    Vector3d sum = Vector3d::Zero();
    for (int j = -1; j <= 2; ++j) {
        for (int i = -1; i <= 2; ++i) {
            const double weight = catmullRom(at.x() - x - i) * catmullRom(at.y() - y - j);
            for (int c = 0; c < 3; ++c) {
                sum[c] += weight * (plane.stored(x + i, y + j, c) + 128);
            }
        }
    }
    return sum.cwiseMax(0).cwiseMin(255);
}

/// Grey levels between views and what exact arithmetic gives.
struct Deviation {
    double worst = 0;
    double mean = 0;
};

/// The deviation of views, over all pixels. exact(plane, pixel of the photo): the colour. Pixels that the
/// lens does not see are black.
template <class Exact>
Deviation deviationOf(Sampling sampling, const PhotoPlane& photo, const std::vector<Scene>& scenes,
                      const Exact& exact) {
    const PlaneView plane = photo.view();
    WorkerPool pool(2);
    Deviation deviation;
    double sum = 0;
    long count = 0;
    for (const Scene& scene : scenes) {
        const Projection projection(scene.camera, scene.roomFromCamera, scene.roomFromPhoto, plane.size(),
                                    scene.kind, 2.0);
        const RgbImage view = rendered(scene, plane, sampling, 0, pool);
        for (int y = 0; y < view.height(); ++y) {
            for (int x = 0; x < view.width(); ++x) {
                const auto at = projection.photoPixel(Vector2d(x, y));
                const Vector3d expected = at ? Vector3d(exact(plane, *at)) : Vector3d(0, 0, 0);
                const Vector3d found(view.at(x, y)[0], view.at(x, y)[1], view.at(x, y)[2]);
                const Vector3d apart = (found - expected).cwiseAbs();
                deviation.worst = std::max(deviation.worst, apart.maxCoeff());
                sum += apart.sum() / 3;
                ++count;
            }
        }
    }
    deviation.mean = sum / static_cast<double>(count);
    std::cout << "  worst " << deviation.worst << ", mean " << deviation.mean << " grey levels\n";
    return deviation;
}

/// The deviation of views of random scenes.
template <class Exact>
Deviation deviationOf(Sampling sampling, const PhotoPlane& photo, int count, test::Random& random,
                      const Exact& exact) {
    std::vector<Scene> scenes;
    for (int i = 0; i < count; ++i) {
        scenes.push_back(randomScene(random));
    }
    std::cout << "  seed " << random.seed() << "\n";
    return deviationOf(sampling, photo, scenes, exact);
}

} // namespace

TEST(SphereView, GivesTheSameBytesForAnyThreadsAndAnySimd) {
    test::Random random(71);
    const PhotoPlane photo(noise(512, 72));
    const PlaneView plane = photo.view();
    std::vector<Scene> scenes;
    std::vector<RgbImage> expected;
    WorkerPool pool(4);
    for (int i = 0; i < 60; ++i) {
        scenes.push_back(randomScene(random));
        expected.push_back(rendered(scenes.back(), plane, kAll.at(static_cast<std::size_t>(i) % 5), 1, pool));
    }
    int targets = 0;
    test::forEachTarget([&](const char* target) {
        ++targets;
        for (std::size_t i = 0; i < scenes.size(); ++i) {
            for (const int threads : {1, 2, 3, 0}) {
                ASSERT_EQ(rendered(scenes[i], plane, kAll.at(i % 5), threads, pool), expected[i])
                    << target << ", " << threads << " threads, " << name(kAll.at(i % 5)) << ", scene " << i
                    << " seed " << random.seed();
            }
        }
        std::cout << "  same bytes: " << target << "\n";
    });
    EXPECT_GE(targets, 1);
}

// The photo is black and white noise: what 0.02 pixels of coordinates cost there is 5 grey levels an axis, on
// top of 1.05 of the sampler's own.
TEST(SphereView, IsTheExactBilinearView) {
    test::Random random(73);
    const RgbImage picture = noise(512, 74);
    const Deviation deviation =
        deviationOf(Sampling::Bilinear, PhotoPlane(picture), 60, random,
                    [&](const PlaneView&, const Vector2d& at) { return bilinear(picture, at); });
    EXPECT_LT(deviation.worst, 6);
    EXPECT_LT(deviation.mean, 0.5);
}

// At a pole a pixel of the view spans many of a row, so that an error across the sphere is many pixels in u.
TEST(SphereView, IsOffByMoreThanRoundingAtThePolesOnly) {
    const RgbImage picture = noise(4096, 78);
    const PhotoPlane photo(picture);
    const auto worst = [&](double fieldDeg, double leastPitchDeg, double mostPitchDeg) {
        test::Random random(79);
        std::vector<Scene> scenes;
        for (int i = 0; i < 8; ++i) {
            const Radians pitch =
                Degrees((i % 2 == 0 ? 1 : -1) * random.uniform(leastPitchDeg, mostPitchDeg));
            const Eigen::Quaterniond turn =
                rotation({Radians(random.uniform(-3, 3)), pitch, Radians(random.uniform(-0.2, 0.2))});
            const double fieldRad = Radians(Degrees(fieldDeg)).value();
            scenes.push_back({CameraModel(CameraIntrinsics::pinhole(320, 240, fieldRad)),
                              {turn * bodyFromOptical(), Vector3d::Zero()},
                              Rigid3{},
                              SceneKind::None});
        }
        std::cout << fieldDeg << " degrees wide, pitch of " << leastPitchDeg << " to " << mostPitchDeg << ':';
        return deviationOf(Sampling::Bilinear, photo, scenes,
                           [&](const PlaneView&, const Vector2d& at) { return bilinear(picture, at); })
            .worst;
    };
    for (const double fieldDeg : {5.0, 20.0, 57.0}) {
        EXPECT_LT(worst(fieldDeg, 0, 45), 3) << fieldDeg;
    }
    const double atPoles = worst(5, 88, 90);
    EXPECT_GT(atPoles, 6);
    EXPECT_LT(atPoles, 100);
}

TEST(SphereView, IsTheExactBicubicView) {
    test::Random random(75);
    EXPECT_LT(deviationOf(Sampling::Bicubic, PhotoPlane(smooth(512)), 30, random, bicubic).worst, 0.8);
}

// Sums at their greatest: overshoots of both signs are cut to black and white. 0.02 pixels of coordinates
// cost up to 6 grey levels an axis there, and positions are multiples of 1/256 pixel.
TEST(SphereView, IsTheExactBicubicViewOfNoise) {
    test::Random random(76);
    const Deviation deviation =
        deviationOf(Sampling::Bicubic, PhotoPlane(noise(512, 77)), 30, random, bicubic);
    EXPECT_LT(deviation.worst, 8);
    EXPECT_LT(deviation.mean, 0.5);
}

TEST(SphereView, ShowsASmoothWorldWithEveryRungAcrossPolesAndSeam) {
    const PhotoPlane photo(smooth(1024));
    const PlaneView plane = photo.view();
    const PhotoPlane half(smooth(512));
    const CameraModel camera(CameraIntrinsics::pinhole(80, 60, 1.2));
    WorkerPool pool(2);
    for (int pitch = -90; pitch <= 90; pitch += 15) {
        for (const double yaw : {0.0, 90.0, 180.0}) {
            const Rigid3 pose{rotation({Degrees(yaw), Degrees(pitch), Degrees(20)}) * bodyFromOptical(),
                              Vector3d::Zero()};
            for (const Sampling sampling : kAll) {
                const RgbImage view =
                    rendered({camera, pose, Rigid3{}, SceneKind::None},
                             sampling == Sampling::Reduced ? half.view() : plane, sampling, 0, pool);
                for (int y = 0; y < 60; ++y) {
                    for (int x = 0; x < 80; ++x) {
                        const Vector3d d = pose.rotation * *camera.ray(Vector2d(x, y));
                        for (int c = 0; c < 3; ++c) {
                            ASSERT_NEAR(view.at(x, y)[c], 127.5 + 120 * d[c], 2)
                                << name(sampling) << " pitch " << pitch << " yaw " << yaw << " at " << x
                                << " " << y;
                        }
                    }
                }
            }
        }
    }
}

TEST(SphereView, NeedsTheRaysOfItsSampling) {
    const PhotoPlane photo(smooth(64));
    const PlaneView plane = photo.view();
    const CameraModel camera(CameraIntrinsics::pinhole(8, 8, 1));
    WorkerPool pool(1);
    Workspace workspace;
    RgbImage picture;
    test::expectError(ErrorKind::InvalidInput, "one sample a pixel", [&] {
        renderView(RayTable(camera, 2), Rigid3{}, {plane, Rigid3{}}, Sampling::Bilinear, pool, 1, workspace,
                   picture);
    });
    test::expectError(ErrorKind::InvalidInput, "1 x 1 to 8 x 8", [&] { RayTable(camera, 9); });
}

TEST(SphereView, TakesAsManySamplesAsThePhotoIsMinified) {
    const CameraModel vga(CameraIntrinsics::pinhole(640, 480, std::numbers::pi / 2));
    EXPECT_NEAR(minification(vga, 5376), 2.674, 1e-3);
    EXPECT_EQ(samplesPerAxis(Sampling::Bilinear, 2.674), 1);
    EXPECT_EQ(samplesPerAxis(Sampling::Footprint, 0.1), 2);
    EXPECT_EQ(samplesPerAxis(Sampling::Footprint, 2.674), 2);
    EXPECT_EQ(samplesPerAxis(Sampling::Footprint, 3.1), 3);
    EXPECT_EQ(samplesPerAxis(Sampling::Footprint, 100), 8);
}

TEST(Sampling, HasNamesThatParse) {
    for (const Sampling value : {Sampling::Nearest, Sampling::Bilinear, Sampling::Reduced,
                                 Sampling::Footprint, Sampling::Bicubic, Sampling::Best, Sampling::Auto}) {
        EXPECT_EQ(sampling(name(value)), value);
    }
    test::expectError(ErrorKind::InvalidInput, "nearest, bilinear, reduced", [] { sampling("lanczos"); });
}

TEST(Sampling, AutoIsTheCheapestThatIsExpectedToBeGoodEnough) {
    EXPECT_EQ(chosenSampling(Sampling::Nearest, 2, 40), Sampling::Nearest);
    EXPECT_EQ(chosenSampling(Sampling::Auto, 2.24, 37), Sampling::Reduced);
    EXPECT_EQ(chosenSampling(Sampling::Auto, 2.24, 40), Sampling::Footprint);
    EXPECT_EQ(chosenSampling(Sampling::Auto, 0.6, 40), Sampling::Bilinear);
    EXPECT_EQ(chosenSampling(Sampling::Auto, 2.24, 99), Sampling::Footprint);
    for (double ratio = 0.1; ratio < 6; ratio += 0.1) {
        for (double db = 30; db < 50; db += 1) {
            const Sampling chosen = chosenSampling(Sampling::Auto, ratio, db);
            EXPECT_TRUE(chosen == Sampling::Footprint || expectedDb(chosen, ratio) >= db)
                << ratio << " " << db;
        }
    }
}

} // namespace spherewalk::render
