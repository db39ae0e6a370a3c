// SPDX-License-Identifier: GPL-3.0-or-later
#include "parts/practice_dataset.h"
#include "qt_application.h"
#include "ui/fields/scene_fields.h"
#include "ui/preview/drive_view.h"
#include "ui/preview/preview_mode.h"
#include "ui/preview/preview_presenter.h"

#include <QCheckBox>
#include <QComboBox>
#include <QStandardItemModel>
#include <QTest>

namespace spherewalk::ui {

using render::Sampling;
using render::SceneKind;

namespace {

render::DatasetInfo measuredInfo() {
    render::DatasetInfo info;
    info.photos.resize(2);
    info.sphereRadiusM = 2;
    info.choice = render::ViewChoice{SceneKind::Sphere, Sampling::Bilinear, 4, 3, 500, ""};
    return info;
}

CameraIntrinsics cameraWith(double focalPx) {
    CameraIntrinsics camera = CameraIntrinsics::pinhole(640, 480, 1);
    camera.fx = camera.fy = focalPx;
    return camera;
}

class RungsTest : public testing::Test {
  protected:
    QComboBox& box(const char* name) { return *mode.findChild<QComboBox*>(name); }

    void choose(const char* name, int data) { box(name).setCurrentIndex(box(name).findData(data)); }

    bool isOffered(const char* name, SceneKind scene) {
        const int item = box(name).findData(static_cast<int>(scene));
        return qobject_cast<QStandardItemModel*>(box(name).model())->item(item)->isEnabled();
    }

    void open(const test::PracticeDataset& dataset) {
        mode.show();
        mode.presenter().openDataset(QString::fromStdString(dataset.path().string()));
        ASSERT_TRUE(QTest::qWaitFor([&] { return !mode.presenter().views().empty(); }, 100'000));
    }

    TaskList tasks;
    PreviewMode mode{tasks};
};

} // namespace

TEST(RungWords, SayWhatLeavingTheChoiceToTheDatasetMeans) {
    render::DatasetInfo info = measuredInfo();
    EXPECT_EQ(autoSceneWords(nullptr, {}), "Best there is");
    EXPECT_EQ(autoSceneWords(&info, cameraWith(500)), "As measured: sphere");
    EXPECT_EQ(autoSamplingWords(&info, cameraWith(500)), "As measured: bilinear");
    EXPECT_EQ(autoSceneWords(&info, cameraWith(2000)), "Best there is: sphere"); // another camera
    EXPECT_EQ(autoSamplingWords(&info, cameraWith(2000)), "As needed");
    info.photos[1].scene = SceneKind::None;
    EXPECT_EQ(autoSceneWords(&info, cameraWith(500)), "As measured: sphere, cheaper where enough");
}

TEST(RungWords, SayOfADatasetThatWasNotMeasuredWhatItHas) {
    render::DatasetInfo info = measuredInfo();
    info.choice.reset();
    EXPECT_EQ(autoSceneWords(&info, cameraWith(500)), "Best there is: sphere");
    EXPECT_EQ(autoSamplingWords(&info, cameraWith(500)), "As needed");
    info.sphereRadiusM.reset();
    EXPECT_EQ(autoSceneWords(&info, cameraWith(500)), "Best there is: none");
}

TEST_F(RungsTest, OfADatasetWithDepthStandBesideEachOther) {
    const test::PracticeDataset dataset(2);
    open(dataset);
    EXPECT_TRUE(isOffered("sceneA", SceneKind::Depth));
    EXPECT_TRUE(isOffered("sceneA", SceneKind::Blend));
    EXPECT_EQ(box("sceneA").itemText(0), "Best there is: depth");
    choose("sceneB", static_cast<int>(SceneKind::Room));
    choose("samplingB", static_cast<int>(Sampling::Bilinear));
    mode.findChild<QCheckBox*>("split")->setChecked(true);
    const auto& views = mode.presenter().views();
    ASSERT_TRUE(QTest::qWaitFor([&] { return views.size() == 2; }, 100'000));
    EXPECT_EQ(views[0].report.scene, SceneKind::Depth);
    EXPECT_EQ(views[1].report.scene, SceneKind::Room);
    const QString words = DriveView::reportText(views[1].report);
    for (const char* part : {"scene model room", "sampling bilinear", "error", "ms"}) {
        EXPECT_TRUE(words.contains(part)) << words.toStdString();
    }
}

TEST_F(RungsTest, AreNotOfferedWhereTheDatasetLacksThem) {
    const test::PracticeDataset dataset(1, false);
    choose("sceneA", static_cast<int>(SceneKind::Depth));
    open(dataset);
    EXPECT_FALSE(isOffered("sceneA", SceneKind::Depth));
    EXPECT_TRUE(isOffered("sceneA", SceneKind::Room));
    EXPECT_EQ(box("sceneA").currentIndex(), 0);
    EXPECT_EQ(box("sceneA").itemText(0), "Best there is: room");
    EXPECT_EQ(mode.presenter().views().front().report.scene, SceneKind::Room);
}

} // namespace spherewalk::ui
