// SPDX-License-Identifier: Apache-2.0
#include "temporary_folder.h"
#include "test_dataset.h"

#include "spherewalk/geometry/rotation.h"
#include "spherewalk/render/renderer.h"
#include "spherewalk/render/scene_depth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace spherewalk::render {

namespace {

using Eigen::Vector3d;

const CameraModel kHardCamera(CameraIntrinsics::pinhole(64, 48, 1));

/// L-shaped, so that there is a corner that stands out into it.
const RoomShape kRoom{{{-2, -2}, {3, -2}, {3, 1}, {1, 1}, {1, 3}, {-2, 3}}, 0, 2.5};

struct Place {
    const char* name;
    Vector3d at;
};

const std::vector<Place> kPlaces{{"a wall", {3, 0, 1.2}},
                                 {"a corner of the floor", {-2, -2, 0}},
                                 {"the corner that stands out", {1, 1, 1.2}},
                                 {"an obstacle's face", {-1, 0, 0.8}},
                                 {"inside of an obstacle", {-1.5, 0, 0.5}},
                                 {"outside of the outline", {2, 2, 1.2}},
                                 {"far outside", {60, -40, 1.2}},
                                 {"beyond all rooms", {-6e8, 7e8, 1e8}},
                                 {"above the ceiling", {0, 0, 4}},
                                 {"a photo's own place", {0, 0, 1.2}}};

/// Two photos of a room with an obstacle; by depth, the obstacle's face lies five centimetres from the first
/// photo's left, and to its right the room goes on for a hundred metres.
class HardPlaces : public testing::TestWithParam<SceneKind> {
  protected:
    static void SetUpTestSuite() {
        s_folder = std::make_unique<test::TemporaryFolder>();
        const std::vector<Rigid3> poses{{Eigen::Quaterniond::Identity(), {0, 0, 1.2}},
                                        {Eigen::Quaterniond::Identity(), {0.4, 0, 1.2}}};
        DatasetInfo info = test::writeTestDataset(s_folder->path(), poses, test::smoothWorld, 256, 2.0);
        info.outline = kRoom.outline;
        info.obstacles = {{{-2, -0.5}, {-1, -0.5}, {-1, 0.5}, {-2, 0.5}}};
        info.roomShape = kRoom;
        std::filesystem::create_directories(s_folder->path() / "depth");
        for (DatasetPhoto& photo : info.photos) {
            Image<float, 1> inverse = roomDepth(kRoom, photo.roomFromPhoto, 256).inverseM();
            for (int y = 40; y < 90; ++y) {
                std::fill_n(inverse.at(20, y), 40, 1 / 0.05F);
                std::fill_n(inverse.at(180, y), 40, 1 / 100.0F);
            }
            photo.depth = "depth/" + std::filesystem::path(photo.file).stem().string() + ".pgm";
            writeFile(s_folder->path() / photo.depth, DepthMap(std::move(inverse)).serialised());
        }
        test::rewriteInfo(s_folder->path(), info);
        s_renderer =
            std::make_unique<Renderer>(std::make_shared<const Dataset>(Dataset::open(s_folder->path())));
    }

    static void TearDownTestSuite() {
        s_renderer.reset();
        s_folder.reset();
    }

    static View view(const Vector3d& at, double yaw) {
        ViewOptions options;
        options.scene = GetParam();
        options.wantsDepth = true;
        options.wantsTrust = true;
        const Rigid3 pose{
            (rotation({Radians(yaw), Radians(0.2), Radians(0)}) * bodyFromOptical()).normalized(), at};
        return s_renderer->render(kHardCamera, pose, options);
    }

    static std::unique_ptr<test::TemporaryFolder> s_folder;
    static std::unique_ptr<Renderer> s_renderer;
};

std::unique_ptr<test::TemporaryFolder> HardPlaces::s_folder;
std::unique_ptr<Renderer> HardPlaces::s_renderer;

/// No colour of the world is as dark.
bool hasHoles(const RgbImage& picture) {
    for (std::size_t i = 0; i < picture.values().size(); i += 3) {
        if (picture.values()[i] + picture.values()[i + 1] + picture.values()[i + 2] < 30) {
            return true;
        }
    }
    return false;
}

} // namespace

TEST_P(HardPlaces, GiveWholeViewsWithDepthAndTrust) {
    for (const Place& place : kPlaces) {
        for (const double yaw : {0.0, 1.6, 3.1, -1.6}) {
            SCOPED_TRACE(place.name);
            const View seen = view(place.at, yaw);
            EXPECT_FALSE(hasHoles(seen.picture));
            EXPECT_TRUE(std::all_of(seen.depth.values().begin(), seen.depth.values().end(),
                                    [](float z) { return std::isfinite(z) && z > 0; }));
            EXPECT_TRUE(std::all_of(seen.trust.errorPx.values().begin(), seen.trust.errorPx.values().end(),
                                    [](float error) { return error >= 0; })); // NaN is not
            EXPECT_EQ(seen.report.trust > 0, seen.report.seesPlace && !seen.report.isOutside);
            EXPECT_LE(seen.report.trust, 1);
            EXPECT_TRUE(std::isfinite(seen.report.parallaxPx));
        }
    }
}

TEST_P(HardPlaces, GiveTheSameViewAHairBeside) {
    for (const Place& place : kPlaces) {
        SCOPED_TRACE(place.name);
        const RgbImage here = view(place.at, 0.3).picture;
        const RgbImage there = view(place.at + Vector3d(1e-9, -1e-9, 1e-9), 0.3).picture;
        int different = 0;
        for (std::size_t i = 0; i < here.values().size(); ++i) {
            different += std::abs(int{here.values()[i]} - int{there.values()[i]}) > 8 ? 1 : 0;
        }
        EXPECT_LT(different, static_cast<int>(here.values().size() / 20));
    }
}

INSTANTIATE_TEST_SUITE_P(Scene, HardPlaces,
                         testing::Values(SceneKind::None, SceneKind::Sphere, SceneKind::Room,
                                         SceneKind::Depth),
                         [](const auto& of) { return std::string(name(of.param)); });

} // namespace spherewalk::render
