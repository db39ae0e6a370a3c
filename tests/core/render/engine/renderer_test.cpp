// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"
#include "random.h"
#include "temporary_folder.h"
#include "test_dataset.h"

#include "spherewalk/geometry/rotation.h"
#include "spherewalk/render/renderer.h"

#include <atomic>
#include <numbers>
#include <thread>

namespace spherewalk::render {

using Eigen::Vector2d;
using Eigen::Vector3d;
using test::expectError;
using test::TemporaryFolder;

namespace {

std::shared_ptr<const Dataset> opened(const std::filesystem::path& folder) {
    return std::make_shared<const Dataset>(Dataset::open(folder));
}

/// Greatest difference, over all pixels and channels, between a view and what the world looks like from
/// there.
double worstDifference(const View& view, const CameraModel& camera,
                       const Eigen::Quaterniond& roomFromCamera) {
    double worst = 0;
    for (int y = 0; y < camera.height(); ++y) {
        for (int x = 0; x < camera.width(); ++x) {
            const Vector3d expected = test::smoothWorld(roomFromCamera * *camera.ray(Vector2d(x, y)));
            for (int c = 0; c < 3; ++c) {
                worst = std::max(worst, std::abs(view.picture.at(x, y)[c] - expected[c]));
            }
        }
    }
    return worst;
}

} // namespace

// The world differs in every direction, so a mirrored, turned or tilted convention anywhere between camera
// and photo fails.
TEST(Renderer, ShowsTheWorldAsItIsInEveryDirectionFromAnyTurnedPhoto) {
    test::Random random(41);
    const TemporaryFolder folder;
    std::vector<Rigid3> poses;
    for (int i = 0; i < 4; ++i) {
        poses.push_back({random.rotation(), random.vector(100)});
    }
    test::writeTestDataset(folder.path(), poses, test::smoothWorld);
    const Renderer renderer(opened(folder.path()));
    const CameraModel camera(CameraIntrinsics::pinhole(80, 60, 1.5));
    for (int i = 0; i < 40; ++i) {
        const Rigid3& photo = poses[static_cast<std::size_t>(i) % poses.size()];
        const Eigen::Quaterniond roomFromCamera = random.rotation();
        const View view = renderer.render(camera, {roomFromCamera, photo.translation});
        ASSERT_EQ(view.report.photo, static_cast<std::size_t>(i) % poses.size());
        ASSERT_LT(worstDifference(view, camera, roomFromCamera), 4) << i << " seed " << random.seed();
    }
}

TEST(Renderer, HasNoSeamAndNoPole) {
    const TemporaryFolder folder;
    test::writeTestDataset(folder.path(), {Rigid3{}}, test::smoothWorld);
    const Renderer renderer(opened(folder.path()));
    const CameraModel camera(CameraIntrinsics::pinhole(64, 64, 1));
    for (int pitchDeg = -90; pitchDeg <= 90; pitchDeg += 15) {
        const Eigen::Quaterniond roomFromCamera =
            rotation({Radians(std::numbers::pi), Degrees(pitchDeg), Radians(0)}) * bodyFromOptical();
        const View view = renderer.render(camera, {roomFromCamera, Vector3d::Zero()});
        EXPECT_LT(worstDifference(view, camera, roomFromCamera), 4) << pitchDeg;
    }
}

TEST(Renderer, GivesTheSameBytesForAnyNumberOfThreads) {
    test::Random random(42);
    const TemporaryFolder folder;
    test::writeTestDataset(folder.path(), {Rigid3{}}, test::smoothWorld, 512, 2.0);
    const Renderer renderer(opened(folder.path()));
    const CameraModel camera(CameraIntrinsics::pinhole(101, 67, 2));
    const Rigid3 pose{random.rotation(), {0.3, -0.2, 0.1}};
    const View one = renderer.render(camera, pose, {SceneKind::Sphere, 1});
    for (const int threads : {0, 2, 3, 7}) {
        EXPECT_EQ(renderer.render(camera, pose, {SceneKind::Sphere, threads}).picture, one.picture)
            << threads;
    }
}

TEST(Renderer, ReportsPhotoOffsetSceneAndTrust) {
    const TemporaryFolder folder;
    const DatasetInfo info = test::writeTestDataset(
        folder.path(), {Rigid3{}, {Eigen::Quaterniond::Identity(), {1, 0, 0}}}, test::smoothWorld, 64, 2.0);
    const Renderer renderer(opened(folder.path()));
    const CameraModel camera(CameraIntrinsics::pinhole(100, 100, std::numbers::pi / 2)); // focal length 50 px
    const Rigid3 pose{Eigen::Quaterniond::Identity(), {0.9, 0, 0}};
    const ViewReport sphere = renderer.render(camera, pose).report;
    EXPECT_EQ(sphere.file, info.photos[1].file);
    EXPECT_NEAR(sphere.offsetM, 0.1, 1e-12);
    EXPECT_EQ(sphere.scene, SceneKind::Sphere);
    EXPECT_GT(sphere.parallaxPx, 0.75); // 50 px x 0.1 m x 0.3 / 2 m at the centre, more at the edges
    EXPECT_LT(sphere.parallaxPx, 1.5);
    EXPECT_EQ(sphere.trust, 1 / (1 + sphere.parallaxPx));
    EXPECT_GT(sphere.decodeMs, 0);
    const ViewReport again = renderer.render(camera, pose, {SceneKind::None, 0}).report;
    EXPECT_EQ(again.decodeMs, 0);
    EXPECT_GT(again.parallaxPx, 2.5); // 50 px x 0.1 m / 2 m at the centre
    EXPECT_LT(again.parallaxPx, 5);
    EXPECT_EQ(renderer.render(camera, Rigid3{}).report.trust, 1);
}

TEST(Renderer, ServesTheSphereOnlyToDatasetsThatHaveOne) {
    const TemporaryFolder folder;
    test::writeTestDataset(folder.path(), {Rigid3{}}, test::smoothWorld, 64);
    const Renderer renderer(opened(folder.path()));
    const CameraModel camera(CameraIntrinsics::pinhole(4, 4, 1));
    EXPECT_EQ(renderer.render(camera, Rigid3{}).report.scene, SceneKind::None);
    expectError(ErrorKind::InvalidInput, "no sphere scene model", [&] {
        renderer.render(camera, Rigid3{}, {SceneKind::Sphere, 0});
    });
}

TEST(Renderer, RefusesPosesThatAreNone) {
    const TemporaryFolder folder;
    test::writeTestDataset(folder.path(), {Rigid3{}}, test::smoothWorld, 64);
    const Renderer renderer(opened(folder.path()));
    const CameraModel camera(CameraIntrinsics::pinhole(4, 4, 1));
    Rigid3 pose;
    pose.translation.x() = std::nan("");
    expectError(ErrorKind::InvalidInput, "pose", [&] { renderer.render(camera, pose); });
    pose = {Eigen::Quaterniond(0, 0, 0, 0), Vector3d::Zero()};
    expectError(ErrorKind::InvalidInput, "pose", [&] { renderer.render(camera, pose); });
}

TEST(Renderer, LeavesBlackWhereTheLensSeesNothing) {
    const TemporaryFolder folder;
    test::writeTestDataset(folder.path(), {Rigid3{}}, test::smoothWorld, 64);
    const Renderer renderer(opened(folder.path()));
    CameraIntrinsics fisheye = CameraIntrinsics::pinhole(100, 100, 1);
    fisheye.fx = fisheye.fy = 10; // half of the picture's width is 5 rad
    fisheye.lens = LensModel::Equidistant;
    fisheye.distortion = {0, 0, 0, 0};
    const View view = renderer.render(CameraModel(fisheye), Rigid3{});
    EXPECT_EQ(view.picture.at(0, 0)[0] + view.picture.at(0, 0)[1] + view.picture.at(0, 0)[2], 0);
    EXPECT_GT(view.picture.at(50, 50)[2], 100);
}

TEST(Renderer, ServesEveryRungAndTheExactView) {
    const TemporaryFolder folder;
    test::writeTestDataset(folder.path(), {Rigid3{}}, test::smoothWorld, 512, 2.0);
    const Renderer renderer(opened(folder.path()));
    const CameraModel camera(CameraIntrinsics::pinhole(80, 60, 1.2));
    test::Random random(43);
    for (const Sampling sampling : {Sampling::Nearest, Sampling::Bilinear, Sampling::Reduced,
                                    Sampling::Footprint, Sampling::Bicubic, Sampling::Best, Sampling::Auto}) {
        const Eigen::Quaterniond roomFromCamera = random.rotation();
        const View view = renderer.render(camera, {roomFromCamera, Vector3d::Zero()}, {{}, 0, sampling});
        EXPECT_LT(worstDifference(view, camera, roomFromCamera), 5) << name(sampling);
        const bool isAny = sampling == Sampling::Auto || sampling == Sampling::Best;
        EXPECT_TRUE(view.report.sampling == sampling || isAny) << name(view.report.sampling);
        EXPECT_NE(view.report.sampling, Sampling::Auto);
        EXPECT_NE(view.report.sampling, Sampling::Best);
    }
    const Eigen::Quaterniond roomFromCamera = random.rotation();
    ViewOptions options;
    options.exact = true;
    EXPECT_LT(worstDifference(renderer.render(camera, {roomFromCamera, Vector3d::Zero()}, options), camera,
                              roomFromCamera),
              4);
}

TEST(Renderer, GivesTheSameBytesToManyThreadsAtATime) {
    const TemporaryFolder folder;
    test::writeTestDataset(folder.path(), {Rigid3{}}, test::smoothWorld, 512, 2.0);
    const Renderer renderer(opened(folder.path()));
    const CameraModel camera(CameraIntrinsics::pinhole(120, 90, 1.2));
    test::Random random(44);
    std::vector<Rigid3> poses;
    std::vector<RgbImage> expected;
    for (int i = 0; i < 20; ++i) {
        poses.push_back({random.rotation(), random.direction() * 0.5});
        expected.push_back(renderer.render(camera, poses.back()).picture);
    }
    std::atomic<int> different{0};
    {
        std::vector<std::jthread> callers;
        for (int caller = 0; caller < 4; ++caller) {
            callers.emplace_back([&] {
                for (std::size_t i = 0; i < poses.size(); ++i) {
                    different += renderer.render(camera, poses[i]).picture == expected[i] ? 0 : 1;
                }
            });
        }
    }
    EXPECT_EQ(different, 0);
}

TEST(Renderer, KeepsWithinItsBudgetAndStillServesEveryPhoto) {
    const TemporaryFolder folder;
    std::vector<Rigid3> poses;
    for (int i = 0; i < 5; ++i) {
        poses.push_back({Eigen::Quaterniond::Identity(), {static_cast<double>(i), 0, 0}});
    }
    test::writeTestDataset(folder.path(), poses, test::smoothWorld, 64);
    const std::uint64_t unitBytes = 16 << 10; // of memory; a plane of these photos takes two
    const Renderer renderer(opened(folder.path()), {5 * unitBytes});
    const CameraModel camera(CameraIntrinsics::pinhole(4, 4, 1));
    const auto decodes = [&](int photo) {
        return renderer.render(camera, poses[static_cast<std::size_t>(photo)]).report.decodeMs > 0;
    };
    EXPECT_TRUE(decodes(0));
    EXPECT_TRUE(decodes(1));
    EXPECT_FALSE(decodes(0)); // 0 is now used more recently than 1
    EXPECT_TRUE(decodes(2));  // 1 leaves
    EXPECT_FALSE(decodes(0));
    EXPECT_TRUE(decodes(1));
    const Renderer tight(opened(folder.path()), {0});
    EXPECT_GT(tight.render(camera, poses[3]).report.decodeMs, 0);
    EXPECT_GT(tight.render(camera, poses[3]).report.decodeMs, 0);
}

TEST(Renderer, GivesDepthAndTrustWhenTheyAreWanted) {
    const TemporaryFolder folder;
    test::writeTestDataset(folder.path(), {Rigid3{}}, test::smoothWorld, 512, 2.0);
    const Renderer renderer(opened(folder.path()));
    const CameraModel camera(CameraIntrinsics::pinhole(41, 31, 1));
    const Rigid3 pose{bodyFromOptical(), {0, 0.3, 0}};
    const View plain = renderer.render(camera, pose);
    EXPECT_TRUE(plain.depth.empty());
    EXPECT_TRUE(plain.trust.errorPx.empty());
    EXPECT_TRUE(plain.overlaid.empty());
    ViewOptions options;
    options.wantsDepth = options.wantsTrust = true;
    const View view = renderer.render(camera, pose, options);
    EXPECT_EQ(view.picture, plain.picture);
    // Straight ahead of a camera that stands 0.3 m beside the centre of a sphere of 2 m.
    EXPECT_NEAR(view.depth.at(20, 15)[0], std::sqrt(4 - 0.09), 1e-5);
    EXPECT_NEAR(view.trust.errorPx.at(20, 15)[0], view.report.parallaxPx, 0.1 * view.report.parallaxPx);
    options.scene = SceneKind::None;
    EXPECT_TRUE(renderer.render(camera, pose, options).depth.empty());
}

TEST(Renderer, LaysOverlaysInByTheDepthOfItsSceneModel) {
    const TemporaryFolder folder;
    test::writeTestDataset(folder.path(), {Rigid3{}}, test::smoothWorld, 512, 2.0);
    const Renderer renderer(opened(folder.path()));
    const CameraModel camera(CameraIntrinsics::pinhole(40, 30, 1));
    const Rigid3 pose{bodyFromOptical(), {0, 0, 0}};
    Overlay overlay;
    overlay.camera = camera.intrinsics();
    overlay.picture = RgbaImage(40, 30);
    overlay.depth = DepthImage(40, 30);
    for (int y = 0; y < 30; ++y) {
        for (int x = 0; x < 40; ++x) {
            std::fill_n(overlay.picture.at(x, y), 4, std::uint8_t{255});
            overlay.depth.at(x, y)[0] = x < 20 ? 1 : 3; // in front of the sphere, and behind it
        }
    }
    ViewOptions options;
    options.overlays = {&overlay, 1};
    const View view = renderer.render(camera, pose, options);
    const View plain = renderer.render(camera, pose);
    EXPECT_EQ(view.picture.at(5, 15)[1], 255);
    EXPECT_EQ(view.overlaid.at(5, 15)[0], 255);
    EXPECT_EQ(view.overlaid.at(35, 15)[0], 0);
    EXPECT_TRUE(std::equal(view.picture.at(30, 15), view.picture.at(39, 15), plain.picture.at(30, 15)));
    EXPECT_TRUE(view.depth.empty()); // it was not asked for
    overlay.depth = DepthImage(3, 3);
    expectError(ErrorKind::InvalidInput, "3 x 3", [&] { renderer.render(camera, pose, options); });
}

} // namespace spherewalk::render
