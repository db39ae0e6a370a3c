// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"
#include "random.h"
#include "temporary_folder.h"
#include "test_dataset.h"

#include "spherewalk/render/panorama.h"
#include "spherewalk/render/renderer.h"

#include <limits>

namespace spherewalk::render {

namespace {

/// The decoded first photo of a dataset, and the dataset's renderer.
struct Pair {
    explicit Pair(const Rigid3& pose, double radiusM = 2)
        : renderer(std::make_shared<const Dataset>(
              (test::writeTestDataset(folder.path(), {pose}, test::smoothWorld, 512, radiusM),
               Dataset::open(folder.path())))),
          panorama(jpeg::decode(renderer.dataset().readPhoto(0), "0.jpg")) {}

    test::TemporaryFolder folder;
    Renderer renderer;
    Panorama panorama;
};

} // namespace

TEST(Panorama, ShowsTheSameBytesAsARendererOfADataset) {
    test::Random random(71);
    const Rigid3 pose{random.rotation(), {1, 2, 1.2}};
    const Pair pair(pose);
    PanoramaRenderer renderer;
    const CameraModel camera(CameraIntrinsics::pinhole(96, 64, 1.4));
    RgbImage picture;
    for (const SceneKind scene : {SceneKind::None, SceneKind::Sphere}) {
        for (const Sampling sampling : {Sampling::Bilinear, Sampling::Footprint, Sampling::Bicubic}) {
            ViewOptions options;
            options.scene = scene;
            options.sampling = sampling;
            const Rigid3 from{random.rotation(), pose.translation + Eigen::Vector3d(0.2, 0.1, 0)};
            const std::optional<double> radius =
                scene == SceneKind::Sphere ? std::optional<double>(2) : std::nullopt;
            renderer.render(pair.panorama, {pose, radius}, camera, from, sampling, picture);
            EXPECT_EQ(picture, pair.renderer.render(camera, from, options).picture) << name(sampling);
        }
    }
}

TEST(Panorama, HasTheSizeOfThePhoto) {
    EXPECT_EQ(Panorama(RgbImage(64, 32)).size(), (EquirectSize{64, 32}));
}

TEST(Panorama, RefusesWhatIsNoPanorama) {
    test::expectError(ErrorKind::Unsupported, "", [] { Panorama(RgbImage(64, 64)); });
}

TEST(Panorama, RefusesPosesThatAreNone) {
    const Panorama panorama(RgbImage(64, 32));
    PanoramaRenderer renderer(1);
    const CameraModel camera(CameraIntrinsics::pinhole(32, 16, 1));
    RgbImage picture;
    Rigid3 nowhere;
    nowhere.translation.x() = std::numeric_limits<double>::quiet_NaN();
    test::expectError(ErrorKind::InvalidInput, "cannot be shown",
                      [&] { renderer.render(panorama, {}, camera, nowhere, Sampling::Bilinear, picture); });
    test::expectError(ErrorKind::InvalidInput, "cannot be shown", [&] {
        renderer.render(panorama, {{}, 0.0}, camera, {}, Sampling::Bilinear, picture);
    });
}

} // namespace spherewalk::render
