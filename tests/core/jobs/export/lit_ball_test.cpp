// SPDX-License-Identifier: GPL-3.0-or-later
// A ball on the practice table in the light of the photos, beside the ray-cast truth of the same ball.
#include "../parts/practice_dataset.h"
#include "expect_error.h"
#include "temporary_folder.h"

#include "spherewalk/base/statistics.h"
#include "spherewalk/jobs/object_overlay.h"
#include "spherewalk/jobs/walk.h"
#include "spherewalk/photo/picture_file.h"
#include "spherewalk/render/colour_correction.h"
#include "spherewalk/render/light_probe.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace spherewalk::jobs {

using Eigen::Vector3d;

namespace {

Rigid3 lookingAt(const Vector3d& place, const Vector3d& from) {
    const Vector3d ahead = (place - from).normalized();
    const Vector3d right = ahead.cross(Vector3d::UnitZ()).normalized();
    Eigen::Matrix3d columns;
    columns << right, ahead.cross(right), ahead;
    return {Eigen::Quaterniond(columns), from};
}

Ball onTheTable() {
    Ball ball;
    ball.centreM = {3.67, 1.23, 0.83}; // the table's top is at 0.75
    ball.radiusM = 0.08;
    return ball;
}

practice::PracticeRoomOptions withBall(const Ball& ball) {
    practice::PracticeObject object;
    object.centreM = ball.centreM;
    object.halfSizeM = Vector3d::Constant(ball.radiusM);
    object.colour = ball.colour;
    object.castsShadow = true;
    practice::PracticeRoomOptions options;
    options.objects = {object};
    return options;
}

/// In decibels, over the pixels where the mask is not 0.
double psnr(const RgbImage& a, const RgbImage& b, const MaskImage& where) {
    double sum = 0;
    double count = 0;
    for (std::size_t i = 0; i < a.values().size(); ++i) {
        if (where.values()[i / 3] != 0) {
            sum += std::pow(a.values()[i] - b.values()[i], 2);
            ++count;
        }
    }
    return 10 * std::log10(255.0 * 255.0 * count / sum);
}

/// Where the ball changes the room: itself and its shadow.
MaskImage changed(const RgbImage& with, const RgbImage& without) {
    constexpr int kVisible = 3;
    MaskImage mask(with.width(), with.height());
    for (std::size_t i = 0; i < with.values().size(); ++i) {
        if (std::abs(with.values()[i] - without.values()[i]) >= kVisible) {
            mask.values()[i / 3] = 255;
        }
    }
    return mask;
}

render::LightProbe even(double light) {
    render::LightProbe probe;
    probe.radiance = render::RadianceImage(64, 32);
    std::fill(probe.radiance.values().begin(), probe.radiance.values().end(), static_cast<float>(light));
    return probe;
}

} // namespace

TEST(LitBall, IsNearerToItsRayCastTruthThanAFlatOneByFiveDecibels) {
    const Ball ball = onTheTable();
    const test::PracticeDataset dataset(2, true, {}, {2.8, 1.8}, 1024);
    const CameraModel camera(CameraIntrinsics::pinhole(120, 90, 0.7));
    const Rigid3 pose = lookingAt(ball.centreM, {2.9, 1.9, 1.25});
    const RgbImage truth = practice::PracticeRoom(withBall(ball)).view(camera, pose);
    const MaskImage region = changed(truth, dataset.room().view(camera, pose));

    const render::Renderer renderer = dataset.renderer();
    render::ViewOptions options;
    options.wantsDepth = true;
    const DepthImage depth = renderer.render(camera, pose, options).depth;
    const render::LightProbe probe = render::lightProbe(renderer, ball.centreM);
    const auto seen = [&](const render::Overlay& overlay) {
        options.overlays = {&overlay, 1};
        return renderer.render(camera, pose, options).picture;
    };
    const RgbImage flat = seen(ballOverlay(ball, camera, pose));
    const RgbImage lit = seen(litBallOverlay(ball, camera, pose, BallLight(probe), depth));
    std::printf("flat %.2f dB, lit %.2f dB over %d pixels of %d\n", psnr(flat, truth, region),
                psnr(lit, truth, region),
                static_cast<int>(std::count(region.values().begin(), region.values().end(), 255)),
                camera.width() * camera.height());
    const std::filesystem::path folder(SPHEREWALK_TEST_PICTURES);
    std::filesystem::create_directories(folder);
    photo::writePng(folder / "truth.png", truth);
    photo::writePng(folder / "flat.png", flat);
    photo::writePng(folder / "lit.png", lit);
    EXPECT_GT(psnr(lit, truth, region), psnr(flat, truth, region) + 5);
}

// What an even light throws on a matt ball, and what the ball takes from a floor, are known exactly.
TEST(LitBall, InAnEvenLightIsEvenAndTakesItsFormFactor) {
    Ball ball;
    ball.centreM = {0, 0, 0.5};
    ball.radiusM = 0.2;
    const CameraModel camera(CameraIntrinsics::pinhole(120, 90, 1.2));
    const Rigid3 pose = lookingAt({0.4, 0, 0}, {2, 0, 1.5});
    DepthImage floor(camera.width(), camera.height());
    for (int y = 0; y < camera.height(); ++y) {
        for (int x = 0; x < camera.width(); ++x) {
            const Vector3d ray = pose.rotation * *camera.ray({x, y});
            *floor.at(x, y) = ray.z() < 0 ? static_cast<float>(-1.5 / ray.z() * camera.ray({x, y})->z())
                                          : std::numeric_limits<float>::infinity();
        }
    }
    const render::Overlay overlay = litBallOverlay(ball, camera, pose, BallLight(even(0.5)), floor);
    std::vector<double> errors;
    for (int y = 0; y < camera.height(); ++y) {
        for (int x = 0; x < camera.width(); ++x) {
            const float z = *floor.at(x, y);
            const float share = *overlay.shadow.at(x, y);
            if (!std::isfinite(z)) {
                ASSERT_EQ(share, 1);
                continue;
            }
            const Vector3d ray = *camera.ray({x, y});
            const Vector3d to = ball.centreM - pose * Vector3d(ray * (z / ray.z()));
            const double factor = 0.04 / to.squaredNorm() * (to.z() / to.norm());
            ASSERT_NEAR(share, 1 - factor, 0.035) << x << " " << y; // 512 lights stand for all
            errors.push_back(std::abs(share - (1 - factor)));
            if (overlay.picture.at(x, y)[3] != 0) {
                ASSERT_NEAR(overlay.picture.at(x, y)[0],
                            255 * render::storedValue(0.5 * render::linearLight(ball.colour[0] / 255.0)),
                            1.01);
            }
        }
    }
    EXPECT_LT(median(errors), 0.008);
    EXPECT_TRUE(litBallOverlay(ball, camera, pose, BallLight(even(0.5)), {}).shadow.empty());
    test::expectError(ErrorKind::InvalidInput, "The room's depth has 3 x 2 pixels",
                      [&] { litBallOverlay(ball, camera, pose, BallLight(even(1)), DepthImage(3, 2)); });
}

TEST(LitBall, WalksInItsLightWithItsShadow) {
    const Ball ball = onTheTable();
    const test::PracticeDataset dataset(2, true, {}, {2.8, 1.8}, 512);
    const CameraModel camera(CameraIntrinsics::pinhole(120, 90, 0.7));
    std::vector<TimedPose> path;
    for (int i = 0; i < 3; ++i) {
        path.push_back({0.1 * i, lookingAt(ball.centreM, {2.9, 1.9 - 0.05 * i, 1.25})});
    }
    const render::Renderer renderer = dataset.renderer();
    const test::TemporaryFolder folder;
    WalkOptions options;
    options.balls = {ball};
    const auto frames = [&](const std::string& out) {
        walk(renderer, camera, path, options, folder / out, noProgress(), {});
        std::vector<RgbImage> pictures;
        for (const char* file : {"000000.png", "000001.png", "000002.png"}) {
            pictures.push_back(photo::readPicture(folder / out / file));
        }
        return pictures;
    };
    const std::vector<RgbImage> flat = frames("flat");
    options.lightsBalls = true;
    const std::vector<RgbImage> lit = frames("lit");

    // The first frame is what `view --ball --light` makes.
    const render::LightProbe probe = render::lightProbe(renderer, ball.centreM);
    render::ViewOptions view;
    view.wantsDepth = true;
    const DepthImage depth = renderer.render(camera, path[0].roomFromCamera, view).depth;
    const render::Overlay overlay =
        litBallOverlay(ball, camera, path[0].roomFromCamera, BallLight(probe), depth);
    view.overlays = {&overlay, 1};
    EXPECT_EQ(lit[0], renderer.render(camera, path[0].roomFromCamera, view).picture);

    for (std::size_t i = 0; i < lit.size(); ++i) {
        const MaskImage mask = ballMask(ball, camera, path[i].roomFromCamera);
        int shadowed = 0;
        for (std::size_t p = 0; p < mask.values().size(); ++p) {
            const bool isBeside = mask.values()[p] == 0;
            shadowed += isBeside && lit[i].values()[3 * p] + 3 < flat[i].values()[3 * p] ? 1 : 0;
        }
        EXPECT_GT(shadowed, 100) << i << ": the table about the ball is darker";
    }
    // Frames in another light are another walk's: none is taken over.
    options.lightsBalls = false;
    EXPECT_EQ(frames("lit"), flat);
}

} // namespace spherewalk::jobs
