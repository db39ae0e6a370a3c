// SPDX-License-Identifier: Apache-2.0
#include "c/c_test.h"
#include "expect_error.h"
#include "temporary_folder.h"
#include "test_dataset.h"

#include "spherewalk/geometry/rotation.h"
#include "spherewalk/render/renderer.h"
#include "spherewalk/render/scene_depth.h"
#include "spherewalk/render/view_stream.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <vector>

namespace spherewalk::render {

namespace {

const CameraModel kCamera(CameraIntrinsics::pinhole(64, 48, 1));
const RoomShape kRoom{{{-2, -2}, {2, -2}, {2, 2}, {-2, 2}}, -1, 1.5};

/// Two photos, both with the room's depth in files.
class DepthDataset {
  public:
    DepthDataset() {
        m_info =
            test::writeTestDataset(m_folder.path(), {Rigid3{}, {Eigen::Quaterniond::Identity(), {0.4, 0, 0}}},
                                   test::smoothWorld, 256, 2.0);
        std::filesystem::create_directories(m_folder.path() / "depth");
        for (std::size_t i = 0; i < 2; ++i) {
            DatasetPhoto& photo = m_info.photos[i];
            test::mark(m_folder.path(), photo, 4);
            photo.depth = "depth/" + std::to_string(i) + ".pgm";
            writeFile(m_folder.path() / photo.depth, roomDepth(kRoom, photo.roomFromPhoto, 256).serialised());
        }
        m_info.roomShape = kRoom;
        test::rewriteInfo(m_folder.path(), m_info);
    }

    const std::filesystem::path& folder() const { return m_folder.path(); }

    Renderer renderer() const {
        return Renderer(std::make_shared<const Dataset>(Dataset::open(m_folder.path())));
    }

  private:
    test::TemporaryFolder m_folder;
    DatasetInfo m_info;
};

/// An upright strip, one metre before a wall of a square room without floor and ceiling. A camera beside the
/// first photo looks past the strip. Of what the strip hides from the first photo, the second one, behind it,
/// sees the left half.
class Strip {
  public:
    Strip() {
        DatasetInfo info = test::writeTestDataset(folder.path(), photos, test::smoothWorld, 512);
        std::filesystem::create_directories(folder / "depth");
        for (std::size_t i = 0; i < photos.size(); ++i) {
            Image<float, 1> inverse(kSize.width, kSize.height);
            for (int v = 0; v < kSize.height; ++v) {
                for (int u = 0; u < kSize.width; ++u) {
                    *inverse.at(u, v) = static_cast<float>(
                        1 / distanceM(photos[i].translation, direction(kSize, Eigen::Vector2d(u, v))));
                }
            }
            info.photos[i].depth = "depth/" + std::to_string(i) + ".pgm";
            writeFile(folder / info.photos[i].depth, DepthMap(std::move(inverse)).serialised());
        }
        test::rewriteInfo(folder.path(), info);
    }

    /// Whether what a column of the view shows is seen by a photo.
    bool isSeenBy(std::size_t photo, int column) const {
        const Eigen::Vector3d way = (pose.rotation * *camera.ray({column, camera.height() / 2})).normalized();
        const Eigen::Vector3d thing = pose.translation + distanceM(pose.translation, way) * way;
        const Eigen::Vector3d fromPhoto = thing - photos[photo].translation;
        return std::abs(distanceM(photos[photo].translation, fromPhoto.normalized()) - fromPhoto.norm()) <
               0.01;
    }

    /// The first photo that sees what a column shows.
    std::optional<std::size_t> sourceOf(int column) const {
        return isSeenBy(0, column)   ? std::optional<std::size_t>(0)
               : isSeenBy(1, column) ? std::optional<std::size_t>(1)
                                     : std::nullopt;
    }

    /// The share of the columns for which that holds.
    template <class Holds>
    double share(const Holds& holds) const {
        int count = 0;
        for (int x = 0; x < camera.width(); ++x) {
            count += holds(x) ? 1 : 0;
        }
        return static_cast<double>(count) / camera.width();
    }

    const CameraModel camera{CameraIntrinsics::pinhole(160, 24, 0.6)};
    const Rigid3 pose{bodyFromOptical(), {0, 0.3, 0}};
    const std::vector<Rigid3> photos{Rigid3{}, {Eigen::Quaterniond::Identity(), {-1, 0.05, 0}}};
    test::TemporaryFolder folder;

  private:
    static constexpr EquirectSize kSize{1024, 512};

    static double distanceM(const Eigen::Vector3d& from, const Eigen::Vector3d& way) {
        constexpr double kWallM = 3; // from the middle of the room
        constexpr double kStripM = 1;
        constexpr double kHalfWidthM = 0.25;
        const double toStripM = (kStripM - from.x()) / way.x();
        if (toStripM > 0 && std::abs(from.y() + toStripM * way.y()) < kHalfWidthM) {
            return toStripM;
        }
        return std::min((std::copysign(kWallM, way.x()) - from.x()) / way.x(),
                        (std::copysign(kWallM, way.y()) - from.y()) / way.y());
    }
};

Rigid3 pose() {
    return {bodyFromOptical(), {0.1, 0.1, 0.1}};
}

ViewOptions with(SceneKind scene) {
    ViewOptions options;
    options.scene = scene;
    options.wantsDepth = true;
    return options;
}

} // namespace

TEST(Surfaces, AreUsedWhereTheDatasetHasThem) {
    const DepthDataset dataset;
    EXPECT_EQ(dataset.renderer().render(kCamera, pose()).report.scene, SceneKind::Depth);
}

TEST(Surfaces, OfTheRoomAndOfItsDepthGiveTheSameView) {
    const DepthDataset dataset;
    const Renderer renderer = dataset.renderer();
    const View depth = renderer.render(kCamera, pose(), with(SceneKind::Depth));
    const View room = renderer.render(kCamera, pose(), with(SceneKind::Room));
    for (std::size_t i = 0; i < depth.picture.values().size(); ++i) {
        ASSERT_NEAR(depth.picture.values()[i], room.picture.values()[i], 4) << i;
    }
    EXPECT_NEAR(*depth.depth.at(32, 24), 1.9, 0.03);
    EXPECT_NEAR(*room.depth.at(32, 24), 1.9, 0.03);
}

TEST(Surfaces, AreLeftOutWithTheirPhoto) {
    const DepthDataset dataset;
    ViewOptions options = with(SceneKind::Depth);
    options.without = 0;
    EXPECT_EQ(dataset.renderer().render(kCamera, pose(), options).report.photo, 1U);
}

TEST(Surfaces, ServeStreamsAndCountTheirViews) {
    const DepthDataset dataset;
    const Renderer renderer = dataset.renderer();
    ViewStream stream(renderer, kCamera);
    const View first = stream.next(pose(), 0, with(SceneKind::Depth));
    EXPECT_EQ(first.picture, renderer.render(kCamera, pose(), with(SceneKind::Depth)).picture);
    EXPECT_EQ(stream.counters().views, 1U);
    EXPECT_EQ(stream.counters().late, 1U);
}

TEST(Surfaces, AreRefusedWhereADatasetHasNone) {
    const test::TemporaryFolder folder;
    test::writeTestDataset(folder.path(), {Rigid3{}}, test::smoothWorld, 64);
    const Renderer renderer(std::make_shared<const Dataset>(Dataset::open(folder.path())));
    for (const SceneKind kind : {SceneKind::Room, SceneKind::Depth, SceneKind::Blend}) {
        test::expectError(ErrorKind::InvalidInput, "no " + std::string(name(kind)) + " scene model",
                          [&] { renderer.render(kCamera, pose(), with(kind)); });
    }
}

TEST(Surfaces, RefuseADepthThatIsDamaged) {
    const DepthDataset dataset;
    writeFile(dataset.folder() / "depth/0.pgm", bytesOf("P5\n"));
    test::expectError(ErrorKind::Corrupt, "0.pgm",
                      [&] { dataset.renderer().render(kCamera, pose(), with(SceneKind::Depth)); });
}

TEST(Surfaces, RefuseADepthWhoseWidthIsNoMultipleOfSixteen) {
    const DepthDataset dataset;
    writeFile(dataset.folder() / "depth/0.pgm", roomDepth(kRoom, {}, 18).serialised());
    test::expectError(ErrorKind::Corrupt, "0.pgm",
                      [&] { dataset.renderer().render(kCamera, pose(), with(SceneKind::Depth)); });
}

TEST(Surfaces, RefuseADatasetWhoseDepthIsMissing) {
    const DepthDataset dataset;
    std::filesystem::remove(dataset.folder() / "depth/1.pgm");
    test::expectError(ErrorKind::NotFound, "1.pgm", [&] { Dataset::open(dataset.folder()); });
}

TEST(Surfaces, TellWhatAnotherPhotoShowsFromWhatNoneShows) {
    const Strip strip;
    constexpr int kEdge = 3; // so many columns beside an edge may be either
    const int width = strip.camera.width();
    const double ofSecond = strip.share([&](int x) { return strip.sourceOf(x) == 1U; });
    const double ofNone = strip.share([&](int x) { return !strip.sourceOf(x); });
    ASSERT_GT(ofSecond, 0.15);
    ASSERT_GT(ofNone, 0.15);

    const Renderer renderer(std::make_shared<const Dataset>(Dataset::open(strip.folder.path())));
    ViewOptions options = with(SceneKind::Depth);
    options.wantsTrust = true;
    const View view = renderer.render(strip.camera, strip.pose, options);
    ASSERT_EQ(view.report.photo, 0U);
    const double atEdge = 2. * kEdge / width;
    EXPECT_NEAR(view.report.filledShare, ofSecond + ofNone, atEdge);
    constexpr double kAsked = 1. / 16; // the report asks about pixels in so many columns
    EXPECT_LT(view.report.seenShare, 1 - ofNone + kAsked);
    for (int x = kEdge; x < width - kEdge; ++x) {
        const auto source = strip.sourceOf(x);
        const bool isInside = strip.sourceOf(x - kEdge) == source && strip.sourceOf(x + kEdge) == source;
        for (int y = 0; y < strip.camera.height() && isInside; ++y) {
            ASSERT_EQ(has(*view.trust.flags.at(x, y), PixelFlag::Filled), !source) << x << ", " << y;
        }
    }
    const auto flags = view.trust.flags.values();
    const auto doubtful = std::ranges::count_if(flags, [](std::uint8_t flag) {
        return has(flag, PixelFlag::Filled) || has(flag, PixelFlag::Unsure);
    });
    EXPECT_NEAR(view.report.seenShare, 1 - static_cast<double>(doubtful) / static_cast<double>(flags.size()),
                kAsked);
}

TEST(Surfaces, TellTheSameByC) {
    const Strip strip;
    const Renderer renderer(std::make_shared<const Dataset>(Dataset::open(strip.folder.path())));
    ViewOptions options = with(SceneKind::Depth);
    options.wantsTrust = true;
    const View expected = renderer.render(strip.camera, strip.pose, options);

    spherewalk_dataset* opened = nullptr;
    ASSERT_EQ(spherewalk_dataset_open(strip.folder.path().c_str(), SPHEREWALK_VERIFY_SIZES, nullptr, nullptr,
                                      &opened),
              SPHEREWALK_OK)
        << spherewalk_last_error();
    const test::DatasetHandle dataset(opened);
    auto rendererOptions = test::ready(spherewalk_renderer_options_init);
    spherewalk_renderer* made = nullptr;
    ASSERT_EQ(spherewalk_renderer_create(dataset.get(), &rendererOptions, &made), SPHEREWALK_OK);
    const test::RendererHandle cRenderer(made);
    auto intrinsics = test::ready(spherewalk_intrinsics_init);
    ASSERT_EQ(spherewalk_intrinsics_pinhole(160, 24, 0.6, &intrinsics), SPHEREWALK_OK);
    spherewalk_camera* lens = nullptr;
    ASSERT_EQ(spherewalk_camera_create(&intrinsics, &lens), SPHEREWALK_OK);
    const test::CameraHandle camera(lens);
    std::vector<std::uint8_t> flags(expected.trust.flags.values().size());
    std::vector<std::uint8_t> rgb(3 * flags.size());
    auto into = test::ready(spherewalk_view_init);
    into.rgb = {rgb.data(), rgb.size(), 3 * 160};
    into.flags = {flags.data(), flags.size(), 160};
    auto wanted = test::ready(spherewalk_view_options_init);
    wanted.scene = SPHEREWALK_SCENE_DEPTH;
    auto report = test::ready(spherewalk_report_init);
    const spherewalk_pose at = test::cPose(strip.pose);
    ASSERT_EQ(spherewalk_renderer_render(cRenderer.get(), camera.get(), &at, &wanted, &into, &report),
              SPHEREWALK_OK)
        << spherewalk_last_error();
    const auto isFilled = [](int flag) { return (flag & SPHEREWALK_PIXEL_FILLED) != 0; };
    EXPECT_GT(std::ranges::count_if(flags, isFilled), 0);
    EXPECT_TRUE(std::ranges::equal(flags, expected.trust.flags.values()));
    EXPECT_EQ(report.filled_share, expected.report.filledShare);
    EXPECT_EQ(report.seen_share, expected.report.seenShare);
}

} // namespace spherewalk::render
