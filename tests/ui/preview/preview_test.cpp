// SPDX-License-Identifier: GPL-3.0-or-later
#include "preview_fixture.h"
#include "ui/fields/camera_box.h"
#include "ui/map/plan_view.h"
#include "ui/preview/drive_view.h"

#include "spherewalk/jobs/export_dataset.h"
#include "spherewalk/render/camera_info.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>

namespace spherewalk::ui {

namespace fs = std::filesystem;

TEST_F(PreviewTest, ShowsTheSurveyWithItsReport) {
    preview();
    const MadeView& view = presenter().views().front();
    EXPECT_EQ(view.picture.size(), QSize(640, 480));
    EXPECT_GT(view.report.trust, 0.9); // it begins at a photo
    EXPECT_TRUE(DriveView::reportText(view.report).contains("expected error 0.0 px"));
    EXPECT_TRUE(widget<QLabel>("what").text().contains("4 photo"));
    EXPECT_EQ(widget<PlanView>("map").stations().size(), 4U);
    // Ahead is the room's x axis, where the world is red.
    const QColor ahead = view.picture.pixelColor(320, 240);
    EXPECT_GT(ahead.red(), ahead.blue() + 30);
}

TEST_F(PreviewTest, DepthFollowsWhereTheRobotIsByThen) {
    widget<QCheckBox>("withDepth").setChecked(true);
    preview();
    ASSERT_TRUE(presenter().isDeepening());
    EXPECT_TRUE(widget<QLabel>("what").text().contains("depth follows"));
    presenter().setRobot({{1, 1}, Radians(0.5)});
    ASSERT_TRUE(QTest::qWaitFor([&] { return !tasks.hasRunning(); }, 100'000));
    const std::vector<render::SceneKind> scenes = render::scenesOf(presenter().dataset()->info());
    EXPECT_NE(std::find(scenes.begin(), scenes.end(), render::SceneKind::Depth), scenes.end());
    EXPECT_EQ(presenter().robot().pInRoom, Eigen::Vector2d(1, 1));
    EXPECT_FALSE(widget<QLabel>("what").text().contains("depth follows"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return hasSharpViews(1); }, 100'000));
}

TEST_F(PreviewTest, DepthOfASurveyThatWasClosedIsNotShown) {
    widget<QCheckBox>("withDepth").setChecked(true);
    preview();
    mode.setSession(nullptr);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !tasks.hasRunning(); }, 100'000));
    QCoreApplication::processEvents();
    EXPECT_EQ(presenter().dataset(), nullptr);
}

TEST_F(PreviewTest, DrawsTheRobotOnThePlanWhereItStands) {
    auto& map = widget<PlanView>("map");
    preview();
    const QPoint at = map.widgetFromRoom().map(QPointF(1, 1)).toPoint();
    presenter().setRobot({{3, 2}, Radians(0)});
    const QImage away = map.grab().toImage();
    presenter().setRobot({{1, 1}, Radians(0)});
    EXPECT_NE(map.grab().toImage().pixel(at), away.pixel(at));
}

TEST_F(PreviewTest, ThePlanIsEmptyWithoutADataset) {
    EXPECT_TRUE(widget<PlanView>("map").stations().empty());
    EXPECT_TRUE(widget<PlanView>("map").room().outline.empty());
    EXPECT_EQ(widget<PlanView>("map").words(), "Nothing is previewed yet");
    EXPECT_EQ(widget<QLabel>("what").text(), "Nothing is previewed yet.");
    mode.setSession(nullptr);
    EXPECT_EQ(widget<PlanView>("map").words(), "No dataset is open");
    EXPECT_EQ(widget<QLabel>("what").text(), "No dataset is open.");
}

TEST_F(PreviewTest, OpensADatasetThatWasExportedBefore) {
    jobs::exportDataset(session->store(), survey / "d", {}, noProgress(), {});
    mode.setSession(nullptr);
    presenter().openDataset(QString::fromStdString((survey / "d").string()));
    ASSERT_TRUE(QTest::qWaitFor([&] { return hasSharpViews(1); }, 100'000));
    EXPECT_EQ(presenter().dataset()->info().photos.size(), 4U);
}

TEST_F(PreviewTest, DrivesWithTheKeys) {
    preview();
    auto& view = widget<DriveView>("view");
    view.setFocus();
    const RobotPlace begin = presenter().robot();
    QTest::keyPress(&view, Qt::Key_A);
    ASSERT_TRUE(QTest::qWaitFor([&] { return presenter().robot().yaw > begin.yaw; }));
    QTest::keyRelease(&view, Qt::Key_A);
    const RobotPlace turned = presenter().robot();
    QTest::keyPress(&view, Qt::Key_W);
    ASSERT_TRUE(QTest::qWaitFor([&] { return presenter().robot().pInRoom != turned.pInRoom; }));
    QTest::keyRelease(&view, Qt::Key_W);
    EXPECT_EQ(presenter().robot().yaw.value(), turned.yaw.value());
    QTest::keyPress(&view, Qt::Key_Up);
    EXPECT_TRUE(presenter().isDriving());
    widget<QPushButton>("make").setFocus(); // where the key's release goes
    EXPECT_FALSE(presenter().isDriving());
}

TEST_F(PreviewTest, PutsAndTurnsTheRobotOnThePlan) {
    preview();
    auto& map = widget<PlanView>("map");
    const QPointF at = map.widgetFromRoom().map(QPointF(2.5, 1.5));
    const QPointF towards = map.widgetFromRoom().map(QPointF(2.5, 2.5));
    QTest::mousePress(&map, Qt::LeftButton, {}, at.toPoint());
    QTest::mouseMove(&map, towards.toPoint());
    QTest::mouseRelease(&map, Qt::LeftButton, {}, towards.toPoint());
    EXPECT_NEAR((presenter().robot().pInRoom - Eigen::Vector2d(2.5, 1.5)).norm(), 0, 0.02);
    EXPECT_NEAR(Degrees(presenter().robot().yaw).value(), 90, 3);
}

TEST_F(PreviewTest, ComparesTwoWaysBesideEachOther) {
    preview();
    widget<QCheckBox>("split").setChecked(true);
    auto& sampling = widget<QComboBox>("samplingB");
    sampling.setCurrentIndex(sampling.findData(static_cast<int>(render::Sampling::Nearest)));
    ASSERT_TRUE(QTest::qWaitFor([&] {
        const auto& views = presenter().views();
        return views.size() == 2 && views[1].report.sampling == render::Sampling::Nearest;
    }));
    EXPECT_EQ(presenter().views()[0].report.sampling, render::Sampling::Footprint);
    EXPECT_EQ(presenter().views()[0].report.scene, render::SceneKind::Sphere);
    EXPECT_EQ(presenter().views()[1].report.scene, render::SceneKind::None);
    EXPECT_NE(presenter().views()[0].picture, presenter().views()[1].picture);
}

TEST_F(PreviewTest, ChangesTheCameraAndHowItIsCarried) {
    preview();
    auto& camera = widget<QComboBox>("camera");
    camera.setCurrentIndex(0);
    ASSERT_TRUE(QTest::qWaitFor([&] {
        return !presenter().views().empty() && presenter().views()[0].picture.size() == QSize(1280, 720);
    }));
    widget<QDoubleSpinBox>("height").setValue(0.5);
    widget<QDoubleSpinBox>("pitch").setValue(20);
    EXPECT_EQ(presenter().mount().heightM, 0.5);
    EXPECT_NEAR(Degrees(presenter().mount().down).value(), 20, 1e-9);
}

TEST_F(PreviewTest, ReadsACameraFromARosFile) {
    CameraIntrinsics own = CameraIntrinsics::pinhole(320, 200, 1);
    writeFile(survey / "own.yaml", bytesOf(render::cameraInfoYaml(own, "own")));
    auto& camera = widget<CameraBox>("camera");
    EXPECT_TRUE(camera.readCamera(QString::fromStdString((survey / "own.yaml").string())));
    EXPECT_EQ(camera.currentText(), "own.yaml");
    EXPECT_EQ(presenter().camera().width, 320);
    QSignalSpy message(&mode, &Mode::message);
    EXPECT_FALSE(camera.readCamera("nothing.yaml"));
    EXPECT_TRUE(message.first().first().value<Told>().text.contains("nothing.yaml"));
    EXPECT_EQ(presenter().camera().width, 320);
}

TEST_F(PreviewTest, RecordsAPathAndSavesItsFrames) {
    preview();
    QTest::mouseClick(&widget<QPushButton>("record"), Qt::LeftButton);
    EXPECT_TRUE(presenter().isRecording());
    ASSERT_TRUE(QTest::qWaitFor([&] {
        RobotPlace robot = presenter().robot();
        robot.yaw = robot.yaw + Degrees(1);
        presenter().setRobot(robot);
        return presenter().path().size() >= 3;
    }));
    QTest::mouseClick(&widget<QPushButton>("record"), Qt::LeftButton);
    EXPECT_TRUE(widget<QPushButton>("save").isEnabled());
    presenter().saveFrames(QString::fromStdString((survey / "walk").string()));
    ASSERT_TRUE(QTest::qWaitFor([&] { return !tasks.hasRunning(); }, 100'000));
    for (const char* file : {"000000.png", "000002.png", "index.csv", "path.tum", "robot.yaml"}) {
        EXPECT_TRUE(fs::exists(survey / "walk" / file)) << file;
    }
    EXPECT_EQ(readTum(survey / "walk" / "path.tum").size(), presenter().path().size());
}

TEST_F(PreviewTest, PlaysThePathAndGoesToAnyPlaceOfIt) {
    preview();
    auto& slider = widget<QSlider>("pathPosition");
    EXPECT_FALSE(slider.isVisible());
    presenter().setRecording(true);
    ASSERT_TRUE(QTest::qWaitFor([&] {
        presenter().setRobot({{1 + 0.1 * static_cast<double>(presenter().path().size()), 1}, Radians(0.4)});
        return presenter().path().size() >= 5;
    }));
    presenter().setRecording(false);
    ASSERT_TRUE(slider.isVisible());
    const std::vector<TimedPose> path = presenter().path();
    slider.setValue(1);
    EXPECT_NEAR(presenter().robot().pInRoom.x(), path[1].roomFromCamera.translation.x(), 1e-9);
    EXPECT_NEAR(presenter().robot().yaw.value(), 0.4, 1e-6);
    QTest::mouseClick(&widget<QPushButton>("playPath"), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return slider.value() == slider.maximum(); }, 100'000));
    EXPECT_TRUE(QTest::qWaitFor([&] { return !widget<QPushButton>("playPath").isChecked(); }));
    EXPECT_NEAR(presenter().robot().pInRoom.x(), path.back().roomFromCamera.translation.x(), 1e-9);
    EXPECT_EQ(presenter().path().size(), path.size()); // playing records nothing
}

TEST_F(PreviewTest, TintsWhatIsDisplaced) {
    preview();
    presenter().setRobot({{1.3, 1.2}, Radians(0)});
    waitForView();
    waitForView(); // The first one may have been asked for earlier.
    const QImage plain = presenter().views().front().picture;
    const auto isPlain = [&] { return presenter().views().front().picture == plain; };
    widget<QCheckBox>("showError").setChecked(true);
    EXPECT_TRUE(QTest::qWaitFor([&] { return !isPlain(); }));
    widget<QCheckBox>("showError").setChecked(false);
    EXPECT_TRUE(QTest::qWaitFor(isPlain));
}

TEST_F(PreviewTest, SaysWhatTheTintsMean) {
    preview();
    auto& view = widget<DriveView>("view");
    const QImage plain = view.grab().toImage();
    widget<QCheckBox>("showError").setChecked(true);
    waitForView();
    const QImage tinted = view.grab().toImage();
    const QRect corner(view.width() - 60, 0, 60, 40); // there the legend is
    EXPECT_NE(tinted.copy(corner), plain.copy(corner));
}

TEST_F(PreviewTest, GivesTheSecondViewACameraOfItsOwn) {
    preview();
    widget<QCheckBox>("split").setChecked(true);
    ASSERT_TRUE(QTest::qWaitFor([&] { return presenter().views().size() == 2; }));
    EXPECT_EQ(presenter().views()[1].picture.size(), QSize(640, 480)); // as the first
    EXPECT_FALSE(widget<CameraBox>("cameraB").isEnabled());
    widget<QCheckBox>("otherCamera").setChecked(true);
    widget<CameraBox>("cameraB").setCurrentIndex(0);
    ASSERT_TRUE(QTest::qWaitFor([&] { return presenter().views()[1].picture.size() == QSize(1280, 720); }));
    EXPECT_EQ(presenter().views()[0].picture.size(), QSize(640, 480));
    widget<QCheckBox>("otherCamera").setChecked(false);
    ASSERT_TRUE(QTest::qWaitFor([&] { return presenter().views()[1].picture.size() == QSize(640, 480); }));
}

TEST_F(PreviewTest, ShowsWhatTheRobotsCameraTookBesideTheView) {
    preview();
    QImage own(640, 480, QImage::Format_RGB32);
    own.fill(QColor(10, 200, 30));
    own.save(QString::fromStdString((survey / "one.png").string()));
    own.fill(QColor(200, 20, 30));
    own.save(QString::fromStdString((survey / "two.png").string()));
    writeFile(survey / "robot.csv", bytesOf("file,x_m,y_m,z_m,qw,qx,qy,qz\n"
                                            "one.png,1,1,0.9,0.5,-0.5,0.5,-0.5\n"
                                            "two.png,2,1,0.9,0.5,-0.5,0.5,-0.5\n"));
    presenter().openRobotPictures(QString::fromStdString((survey / "robot.csv").string()));
    ASSERT_TRUE(QTest::qWaitFor([&] { return hasSharpViews(2); }));
    EXPECT_EQ(presenter().views()[1].picture.pixelColor(5, 5), QColor(10, 200, 30));
    EXPECT_EQ(presenter().views()[1].caption, "one.png");
    auto& slider = widget<QSlider>("pathPosition");
    ASSERT_TRUE(slider.isVisible());
    slider.setValue(1);
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return hasSharpViews(2) && presenter().views()[1].caption == "two.png"; }));
    EXPECT_NEAR(presenter().robot().pInRoom.x(), 2, 1e-9);
    presenter().setRobot({{1.5, 1}, Radians(0)}); // driven away, there is no picture
    ASSERT_TRUE(QTest::qWaitFor([&] { return presenter().views().size() == 1; }));
}

TEST_F(PreviewTest, SaysWhyAPictureOfTheRobotsCannotBeShown) {
    preview();
    QImage(320, 200, QImage::Format_RGB32).save(QString::fromStdString((survey / "small.png").string()));
    writeFile(survey / "robot.csv",
              bytesOf("file,x_m,y_m,z_m,qw,qx,qy,qz\nsmall.png,1,1,0.9,0.5,-0.5,0.5,-0.5\n"));
    presenter().openRobotPictures(QString::fromStdString((survey / "robot.csv").string()));
    ASSERT_TRUE(QTest::qWaitFor([&] { return hasSharpViews(2); }));
    EXPECT_TRUE(presenter().views()[1].caption.contains("320 x 200"));
    QSignalSpy message(&mode, &Mode::message);
    presenter().openRobotPictures("no such file.csv");
    ASSERT_EQ(message.size(), 1);
    EXPECT_TRUE(message.first().first().value<Told>().text.contains("no such file.csv"));
}

TEST(ErrorTint, LeavesWhatIsRightAndDarkensWhatIsOff) {
    QImage picture(3, 1, QImage::Format_RGB32);
    picture.fill(Qt::white);
    render::PixelTrust trust{Image<float, 1>(3, 1), MaskImage(3, 1)};
    trust.errorPx.at(0, 0)[0] = 0;
    trust.errorPx.at(1, 0)[0] = 3;
    trust.errorPx.at(2, 0)[0] = INFINITY;
    tintByError(picture, trust);
    EXPECT_EQ(picture.pixelColor(0, 0), QColor(Qt::white));
    EXPECT_LT(picture.pixelColor(1, 0).lightness(), 255);
    EXPECT_LT(picture.pixelColor(2, 0).lightness(), picture.pixelColor(1, 0).lightness());
}

TEST(DriveViewWords, TellTheExpectedErrorOrWhyNobodyKnows) {
    render::ViewReport report;
    report.parallaxPx = 1.26;
    report.trust = 0.44;
    EXPECT_EQ(DriveView::errorText(report), "expected error 1.3 px");
    report.seesPlace = false;
    EXPECT_EQ(DriveView::errorText(report), "no photo sees this place");
    report.isOutside = true;
    EXPECT_EQ(DriveView::errorText(report), "outside of what was scanned");
}

TEST_F(PreviewTest, SaysThatTheSurveyHasChangedSince) {
    preview();
    session->write(SurveySession::Reviews, [](store::SurveyStore& store) {
        store.setReview({store.photos().front().id, store::Decision::Rejected, ""});
    });
    EXPECT_TRUE(presenter().isOutdated());
    EXPECT_TRUE(widget<QLabel>("what").text().contains("changed since"));
}

TEST_F(PreviewTest, ForgetsTheDatasetOfASurveyThatIsClosed) {
    preview();
    const fs::path folder = presenter().dataset()->folder();
    EXPECT_TRUE(fs::exists(folder));
    mode.setSession(nullptr);
    EXPECT_EQ(presenter().dataset(), nullptr);
    EXPECT_TRUE(QTest::qWaitFor([&] { return !fs::exists(folder); }));
}

} // namespace spherewalk::ui
