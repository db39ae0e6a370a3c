// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "object_overlay.h"

#include "spherewalk/geometry/rotation.h"
#include "spherewalk/simulator/frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>

namespace spherewalk::simulator {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// A camera in the middle of a room of 4 x 4 m, which looks at the wall 2 m before it.
class Objects : public testing::Test {
  protected:
    Objects() {
        dataset.outline = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
        dataset.ceilingM = 2.5;
        parts.colour = RgbImage(camera.width, camera.height);
        parts.depth = DepthImage(camera.width, camera.height);
        std::fill(parts.depth.values().begin(), parts.depth.values().end(), 2.0F);
        parts.labels = MaskImage(camera.width, camera.height);
        std::fill(parts.labels.values().begin(), parts.labels.values().end(), std::uint8_t{1});
    }

    void put(int x, int y, float depth, std::uint8_t label) {
        *parts.depth.at(x, y) = depth;
        *parts.labels.at(x, y) = label;
        std::fill_n(parts.colour.at(x, y), 3, std::uint8_t{200});
    }

    /// How many pixels are shown, all of which have the picture's colour.
    int shown(const OverlayOptions& options) {
        ObjectOverlay objects(options, false, dataset, camera, 1);
        const render::Overlay overlay = objects.overlay(parts, pose, render::SceneKind::Sphere);
        int count = 0;
        for (int y = 0; y < camera.height; ++y) {
            for (int x = 0; x < camera.width; ++x) {
                const std::uint8_t* rgba = overlay.picture.at(x, y);
                EXPECT_TRUE(rgba[3] == 0 || (rgba[3] == 255 && rgba[0] == *parts.colour.at(x, y)))
                    << x << " " << y;
                count += rgba[3] != 0 ? 1 : 0;
            }
        }
        return count;
    }

    CameraIntrinsics camera = CameraIntrinsics::pinhole(8, 6, 0.6); // sees the wall alone
    render::DatasetInfo dataset;
    Rigid3 pose{bodyFromOptical(), Eigen::Vector3d(2, 2, 1.2)};
    OverlayParts parts;
};

TEST_F(Objects, AreWhatHasALabelThatIsNotTheRooms) {
    put(3, 3, 1.5F, 10);
    put(4, 3, 1.5F, 0);
    put(5, 3, 1.5F, 1);
    EXPECT_EQ(shown({}), 1);
    std::fill(parts.colour.values().begin(), parts.colour.values().end(), std::uint8_t{90});
    OverlayOptions options;
    options.roomLabels = {10};
    put(6, 3, kInfinity, 0);
    EXPECT_EQ(shown(options), 8 * 6 - 2); // nothing has no depth
}

TEST_F(Objects, WithoutALabelAreWhatTheColourCameraSees) {
    put(2, 3, 1.5F, 0); // a model that nobody gave a label
    put(3, 3, 1.5F, 0); // the robot's own arm, which is hidden from the colour camera
    std::fill_n(parts.colour.at(3, 3), 3, std::uint8_t{0});
    put(4, 3, kInfinity, 0);
    put(5, 3, 1.5F, 7); // black, and named
    std::fill_n(parts.colour.at(5, 3), 3, std::uint8_t{0});
    OverlayOptions options;
    options.roomLabels = {1};
    EXPECT_EQ(shown(options), 2);
    options.roomLabels = {0, 1};
    EXPECT_EQ(shown(options), 1);
}

TEST_F(Objects, ByDepthAreNotWhatTheColourCameraDoesNotSee) {
    put(2, 3, 1.5F, 1);
    put(3, 3, 1.5F, 1); // furniture that the outline lacks
    std::fill_n(parts.colour.at(3, 3), 3, std::uint8_t{0});
    OverlayOptions options;
    options.by = ObjectsBy::Depth;
    EXPECT_EQ(shown(options), 1);
}

TEST_F(Objects, AreNearerThanTheRoomOfTheOutline) {
    put(0, 0, 1.5F, 1);
    put(4, 3, 1.97F, 1);
    put(5, 3, 1.99F, 1); // of the wall, inexactly
    put(6, 3, kInfinity, 10);
    put(7, 3, std::numeric_limits<float>::quiet_NaN(), 10);
    parts.labels = {}; // not needed
    OverlayOptions options;
    options.by = ObjectsBy::Depth;
    EXPECT_EQ(shown(options), 2);
}

TEST_F(Objects, AreAllThatADepthCameraSeesThatSeesThemAlone) {
    std::fill(parts.depth.values().begin(), parts.depth.values().end(), kInfinity);
    put(0, 0, 3.5F, 1);
    put(1, 0, -1, 1);
    OverlayOptions options;
    options.by = ObjectsBy::Alone;
    EXPECT_EQ(shown(options), 1);
}

TEST_F(Objects, AreHiddenByTheScenesSurfacesAndElseByTheSimulatorsRoomAlone) {
    const auto hasOwnRoom = [this](ObjectsBy by, render::SceneKind scene) {
        OverlayOptions options;
        options.by = by;
        return !ObjectOverlay(options, false, dataset, camera, 1)
                    .overlay(parts, pose, scene)
                    .roomDepth.empty();
    };
    EXPECT_TRUE(hasOwnRoom(ObjectsBy::Labels, render::SceneKind::Sphere));
    EXPECT_TRUE(hasOwnRoom(ObjectsBy::Depth, render::SceneKind::None));
    EXPECT_FALSE(hasOwnRoom(ObjectsBy::Labels, render::SceneKind::Depth));
    EXPECT_FALSE(hasOwnRoom(ObjectsBy::Depth, render::SceneKind::Room));
    EXPECT_FALSE(hasOwnRoom(ObjectsBy::Alone, render::SceneKind::Sphere));
}

TEST_F(Objects, KeepTheSimulatorsLabelsAndHaveOneWithout) {
    put(2, 3, 1.5F, 10);
    put(3, 3, 1.5F, 0); // a model that nobody gave a label
    OverlayOptions options;
    options.roomLabels = {1};
    const auto labelsOf = [&] {
        const render::LabelImage labels =
            ObjectOverlay(options, true, dataset, camera, 2).overlay(parts, pose, {}).labels;
        return std::array{*labels.at(2, 3), *labels.at(3, 3), *labels.at(4, 3)};
    };
    EXPECT_EQ(labelsOf(), (std::array<std::uint16_t, 3>{10, kUnlabelled, 0}));
    parts.labels = {};
    options.by = ObjectsBy::Depth;
    EXPECT_EQ(labelsOf(), (std::array<std::uint16_t, 3>{kUnlabelled, kUnlabelled, 0}));
}

TEST_F(Objects, CannotBeToldByDepthWithoutAnOutline) {
    dataset.outline.clear();
    OverlayOptions options;
    options.by = ObjectsBy::Depth;
    test::expectError(ErrorKind::InvalidInput, "by labels", [&] { shown(options); });
}

TEST(LabelBoxes, AreTheOutermostPixelsOfEachLabelAndNoneOfTheRoom) {
    render::LabelImage labels(8, 6);
    EXPECT_TRUE(labelBoxes(labels).empty());
    EXPECT_TRUE(labelBoxes({}).empty());
    *labels.at(3, 2) = kUnlabelled; // a single pixel
    *labels.at(0, 5) = 9;           // apart from each other, at the picture's edges
    *labels.at(7, 5) = 9;
    *labels.at(4, 0) = 9;
    *labels.at(4, 2) = 2; // a row of two beside another label
    *labels.at(5, 2) = 2;
    const std::vector<LabelBox> expected{{2, 4, 2, 5, 2}, {9, 0, 0, 7, 5}, {kUnlabelled, 3, 2, 3, 2}};
    EXPECT_EQ(labelBoxes(labels), expected);
}

} // namespace
} // namespace spherewalk::simulator
