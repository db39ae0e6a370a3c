// SPDX-License-Identifier: GPL-3.0-or-later
#include "qt_application.h"
#include "temporary_folder.h"
#include "ui/fields/camera_box.h"
#include "ui/fields/scene_fields.h"

#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/render/camera_info.h"

#include <QSignalSpy>
#include <gtest/gtest.h>

#include <set>

namespace spherewalk::ui {

namespace {

CameraIntrinsics smallCamera() {
    return CameraIntrinsics::pinhole(160, 120, 1);
}

QString yamlIn(const test::TemporaryFolder& folder, const std::string& content) {
    writeFile(folder / "robot.yaml", bytesOf(content));
    return QString::fromStdString((folder / "robot.yaml").string());
}

} // namespace

TEST(CameraPresets, AreCamerasThatCanBe) {
    for (const CameraPreset& preset : cameraPresets()) {
        EXPECT_NO_THROW(preset.intrinsics.validate()) << preset.name.toStdString();
    }
}

TEST(CameraPresets, EachSeesStraightAhead) {
    for (const CameraPreset& preset : cameraPresets()) {
        const CameraModel model(preset.intrinsics);
        const Eigen::Vector2d middle(0.5 * (preset.intrinsics.width - 1),
                                     0.5 * (preset.intrinsics.height - 1));
        const auto ray = model.ray(middle);
        ASSERT_TRUE(ray) << preset.name.toStdString();
        EXPECT_NEAR(ray->normalized().z(), 1, 1e-9) << preset.name.toStdString();
    }
}

TEST(CameraBox, BeginsWithTheUsualCamera) {
    const CameraBox box;
    EXPECT_EQ(box.camera(), cameraPresets()[kUsualCamera].intrinsics);
}

TEST(CameraBox, TellsOnlyOfAnotherCamera) {
    CameraBox box;
    QSignalSpy changes(&box, &CameraBox::cameraChanged);
    box.setCurrentIndex(kUsualCamera);
    EXPECT_EQ(changes.size(), 0);
    box.setCurrentIndex(0);
    EXPECT_EQ(changes.size(), 1);
    EXPECT_EQ(box.camera(), cameraPresets()[0].intrinsics);
}

TEST(CameraBox, OffersTheCameraOfAFileFromThenOn) {
    const test::TemporaryFolder folder;
    CameraBox box;
    const int before = box.count();
    ASSERT_TRUE(box.readCamera(yamlIn(folder, render::cameraInfoYaml(smallCamera(), "small"))));
    EXPECT_EQ(box.camera().width, 160);
    EXPECT_EQ(box.count(), before + 1);
    EXPECT_EQ(box.currentText(), "robot.yaml");
}

TEST(CameraBox, KeepsItsCameraAndSaysWhyIfAFileCannotBeRead) {
    const test::TemporaryFolder folder;
    CameraBox box;
    const CameraIntrinsics before = box.camera();
    QSignalSpy messages(&box, &CameraBox::message);
    EXPECT_FALSE(box.readCamera(yamlIn(folder, "no camera")));
    ASSERT_EQ(messages.size(), 1);
    EXPECT_FALSE(messages[0][0].toString().isEmpty());
    EXPECT_EQ(box.camera(), before);
}

TEST(SceneFields, EachSceneModelAndSamplingHasAWordOfItsOwn) {
    std::set<QString> scenes;
    for (const auto scene : {render::SceneKind::None, render::SceneKind::Sphere, render::SceneKind::Room,
                             render::SceneKind::Depth, render::SceneKind::Blend}) {
        scenes.insert(sceneWord(scene));
    }
    EXPECT_EQ(scenes.size(), 5U);
    std::set<QString> samplings;
    for (const auto sampling : {render::Sampling::Nearest, render::Sampling::Bilinear,
                                render::Sampling::Reduced, render::Sampling::Footprint,
                                render::Sampling::Bicubic, render::Sampling::Best, render::Sampling::Auto}) {
        samplings.insert(samplingWord(sampling));
    }
    EXPECT_EQ(samplings.size(), 7U);
}

TEST(SceneFields, PromiseNothingMeasuredWithoutAMeasurement) {
    EXPECT_EQ(autoSceneWords(nullptr, smallCamera()), "Best there is");
    EXPECT_EQ(autoSamplingWords(nullptr, smallCamera()), "As needed");
    render::DatasetInfo info;
    EXPECT_TRUE(autoSceneWords(&info, smallCamera()).startsWith("Best there is: "));
    EXPECT_EQ(autoSamplingWords(&info, smallCamera()), "As needed");
}

TEST(ToleranceBox, AsksForPixels) {
    const ToleranceBox box("tolerance");
    EXPECT_EQ(box.objectName(), "tolerance");
    EXPECT_EQ(box.value(), 2);
    EXPECT_GT(box.minimum(), 0);
    EXPECT_EQ(box.suffix(), " px");
}

} // namespace spherewalk::ui
