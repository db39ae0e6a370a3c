// SPDX-License-Identifier: Apache-2.0
#include "expect_error.h"
#include "temporary_folder.h"
#include "test_dataset.h"

#include "spherewalk/geometry/rotation.h"
#include "spherewalk/render/renderer.h"
#include "spherewalk/render/scene_depth.h"
#include "spherewalk/render/view_stream.h"

#include <gtest/gtest.h>

#include <cmath>

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

} // namespace spherewalk::render
