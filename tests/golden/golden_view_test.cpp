// SPDX-License-Identifier: GPL-3.0-or-later
#include "golden_picture.h"
#include "practice_dataset.h"

#include "spherewalk/geometry/rotation.h"
#include "spherewalk/render/renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace spherewalk {

namespace {

/// A camera in the middle of four photos of the practice room.
Rigid3 cameraPose(double yawDeg, double pitchDeg) {
    const YawPitchRoll angles{Degrees(yawDeg), Degrees(pitchDeg), Degrees(3)};
    return {rotation(angles) * bodyFromOptical(), {1.97, 1.83, 1.15}};
}

CameraModel pinhole() {
    return CameraModel(CameraIntrinsics::pinhole(320, 240, 1.2));
}

CameraModel fisheye() {
    CameraIntrinsics camera = CameraIntrinsics::pinhole(240, 240, 1);
    camera.lens = LensModel::Equidistant;
    camera.fx = camera.fy = 78; // 88 degrees from the axis at the picture's edges
    camera.distortion = {0.01, -0.004, 0.001, 0};
    return CameraModel(camera);
}

/// Nearer is brighter: 25 m are black, as is nothing.
RgbImage greyOf(const DepthImage& depth) {
    RgbImage picture(depth.width(), depth.height());
    for (int y = 0; y < depth.height(); ++y) {
        for (int x = 0; x < depth.width(); ++x) {
            const float metres = *depth.at(x, y);
            const double grey = std::isfinite(metres) ? std::clamp(255 - 40.0 * metres, 0.0, 255.0) : 0;
            std::fill_n(picture.at(x, y), 3, static_cast<std::uint8_t>(std::lround(grey)));
        }
    }
    return picture;
}

/// A red disc whose rim is half covered. It stands at an angle, so that the room hides a part of it.
render::Overlay slantedDisc(const CameraModel& camera) {
    render::Overlay overlay;
    overlay.camera = camera.intrinsics();
    overlay.picture = RgbaImage(camera.width(), camera.height());
    overlay.depth = DepthImage(camera.width(), camera.height());
    std::fill(overlay.depth.values().begin(), overlay.depth.values().end(), HUGE_VALF);
    for (int y = 0; y < camera.height(); ++y) {
        for (int x = 0; x < camera.width(); ++x) {
            const double radius = std::hypot(x - 160, y - 120);
            if (radius < 91) {
                const std::uint8_t colour[] = {210, static_cast<std::uint8_t>(40 + x / 4), 40, 255};
                std::copy_n(colour, 4, overlay.picture.at(x, y));
                overlay.picture.at(x, y)[3] = radius < 90 ? 255 : 128;
                *overlay.depth.at(x, y) = static_cast<float>(0.8 + 0.012 * x);
            }
        }
    }
    return overlay;
}

class GoldenView : public testing::Test {
  protected:
    static void SetUpTestSuite() { s_dataset = std::make_unique<test::PracticeDataset>(2); }

    static void TearDownTestSuite() { s_dataset.reset(); }

    static render::View view(const CameraModel& camera, const Rigid3& pose, render::ViewOptions options) {
        options.sampling = render::Sampling::Footprint;
        return s_dataset->renderer().render(camera, pose, options);
    }

    static render::View view(render::SceneKind scene) {
        render::ViewOptions options;
        options.scene = scene;
        return view(pinhole(), cameraPose(35, 12), options);
    }

  private:
    static std::unique_ptr<test::PracticeDataset> s_dataset;
};

std::unique_ptr<test::PracticeDataset> GoldenView::s_dataset;

} // namespace

TEST_F(GoldenView, Sphere) {
    test::expectGolden(view(render::SceneKind::Sphere).picture, "sphere");
}

TEST_F(GoldenView, Room) {
    test::expectGolden(view(render::SceneKind::Room).picture, "room", {.share = 0.004, .hardLimit = 96});
}

TEST_F(GoldenView, Depth) {
    render::ViewOptions options;
    options.scene = render::SceneKind::Depth;
    options.wantsDepth = true;
    const render::View made = view(pinhole(), cameraPose(35, 12), options);
    // At the edges of things a pixel may come from either side.
    const test::GoldenLimits limits{.share = 0.006, .hardLimit = 128};
    test::expectGolden(made.picture, "depth", limits);
    test::expectGolden(greyOf(made.depth), "depth_distances", limits);
}

TEST_F(GoldenView, Overlay) {
    const CameraModel camera = pinhole();
    const render::Overlay disc = slantedDisc(camera);
    render::ViewOptions options;
    options.scene = render::SceneKind::Depth;
    options.overlays = {&disc, 1};
    test::expectGolden(view(camera, cameraPose(35, 12), options).picture, "overlay",
                       {.share = 0.006, .hardLimit = 160});
}

TEST_F(GoldenView, Fisheye) {
    render::ViewOptions options;
    options.scene = render::SceneKind::Sphere;
    test::expectGolden(view(fisheye(), cameraPose(-60, 30), options).picture, "fisheye");
}

// The comparison itself can fail: each of the three numbers is the reason of one failure.
TEST(GoldenPicture, EachOfItsThreeNumbersCanFail) {
    const test::GoldenLimits limits{.threshold = 4, .share = 0.01, .hardLimit = 40};
    const RgbImage golden(40, 10);
    RgbImage picture = golden;
    for (std::uint8_t& value : picture.values()) {
        value = 4;
    }
    EXPECT_TRUE(test::goldenDifference(picture, golden, limits.threshold).isWithin(limits));
    for (int x = 0; x < 4; ++x) {
        picture.at(x, 3)[1] = 40;
    }
    EXPECT_TRUE(test::goldenDifference(picture, golden, limits.threshold).isWithin(limits));
    picture.at(0, 0)[2] = 5; // one pixel more than the share
    EXPECT_FALSE(test::goldenDifference(picture, golden, limits.threshold).isWithin(limits));
    picture.at(0, 0)[2] = 4;
    picture.at(0, 3)[1] = 41; // past the hard limit
    const test::GoldenDifference difference = test::goldenDifference(picture, golden, limits.threshold);
    EXPECT_FALSE(difference.isWithin(limits));
    EXPECT_EQ(difference.worst, 41);
    EXPECT_EQ(difference.picture.at(0, 3)[1], 255);
    EXPECT_EQ(difference.picture.at(5, 5)[0], 32);
}

} // namespace spherewalk
