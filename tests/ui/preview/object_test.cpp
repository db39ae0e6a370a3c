// SPDX-License-Identifier: GPL-3.0-or-later
// Objects that a person lays into the preview.
#include "preview_fixture.h"
#include "ui/map/plan_view.h"
#include "ui/preview/drive_view.h"

#include "spherewalk/base/file.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QTimer>

namespace spherewalk::ui {

namespace {

using Shape = LaidObject::Shape;

class ObjectTest : public PreviewTest {
  protected:
    ObjectTest() {
        preview();
        presenter().setMount({0.2, Radians(0)});
        presenter().setSides({{render::SceneKind::None, render::Sampling::Bilinear}}); // nothing hides it
        waitForView();
    }

    const std::optional<LaidObject>& object() { return presenter().objects().object(); }

    /// Chooses by the keyboard, as a person does.
    void choose(Shape shape) {
        auto& box = widget<QComboBox>("object");
        box.setFocus();
        while (box.currentData() != QVariant(static_cast<int>(shape))) {
            QTest::keyClick(&box,
                            box.currentIndex() < static_cast<int>(shape) + 1 ? Qt::Key_Down : Qt::Key_Up);
        }
    }

    /// Answers the question for a mesh.
    void answer(const fs::path& file) {
        QTimer::singleShot(0, &mode, [this, file] {
            auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
            if (dialog == nullptr) {
                return answer(file);
            }
            dialog->selectFile(QString::fromStdString(file.string()));
            QMetaObject::invokeMethod(dialog, "accept", Qt::QueuedConnection);
        });
    }

    fs::path mesh(const std::string& words) {
        writeFile(survey / "mesh.obj", bytesOf(words));
        return survey / "mesh.obj";
    }
};

constexpr auto kPyramid =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.5 2\nf 1 2 3 4\nf 1 2 5\nf 2 3 5\nf 3 4 5\n"
    "f 4 1 5\n";

} // namespace

TEST_F(ObjectTest, ABallAndABoxStandBeforeTheRobotAndLookDifferent) {
    const QImage before = presenter().views()[0].picture.copy();
    choose(Shape::Ball);
    ASSERT_TRUE(QTest::qWaitFor([&] { return presenter().views()[0].picture != before; }));
    const QImage ball = presenter().views()[0].picture.copy();
    EXPECT_NEAR((object()->footM.head<2>() - presenter().robot().pInRoom).norm(), 1.2, 1e-9);
    choose(Shape::Box);
    EXPECT_TRUE(QTest::qWaitFor(
        [&] { return presenter().views()[0].picture != ball && presenter().views()[0].picture != before; }));
    widget<QComboBox>("object").setFocus();
    QTest::keyClick(&widget<QComboBox>("object"), Qt::Key_Home);
    EXPECT_TRUE(QTest::qWaitFor([&] { return presenter().views()[0].picture == before; }));
}

TEST_F(ObjectTest, TheKeysLayTurnGrowAndMoveIt) {
    auto& view = widget<DriveView>("view");
    view.setFocus();
    QTest::keyClick(&view, Qt::Key_O);
    ASSERT_TRUE(object());
    presenter().objects().lay(Shape::Box, presenter().beforeRobot());
    const LaidObject before = *object();
    QTest::keyClick(&view, Qt::Key_Plus);
    EXPECT_NEAR(object()->sizeM, 1.1 * before.sizeM, 1e-9);
    EXPECT_NEAR(widget<QDoubleSpinBox>("objectSize").value(), 0.44, 1e-9);
    QTest::keyClick(&view, Qt::Key_Minus);
    EXPECT_NEAR(object()->sizeM, before.sizeM, 1e-9);
    QTest::keyClick(&view, Qt::Key_Comma);
    EXPECT_NEAR(Degrees(object()->yaw).value(), Degrees(before.yaw).value() + 15, 1e-9);
    QTest::keyClick(&view, Qt::Key_Up, Qt::ShiftModifier);
    EXPECT_NEAR((object()->footM - before.footM).norm(), 0.05, 1e-9);
    EXPECT_FALSE(presenter().isDriving());
    QTest::keyClick(&view, Qt::Key_O);
    EXPECT_FALSE(object());
    QTest::keyClick(&view, Qt::Key_Plus); // nothing is there to grow
    EXPECT_FALSE(object());
    QTest::keyClick(&view, Qt::Key_O);
    EXPECT_EQ(object()->shape, Shape::Box);
}

TEST_F(ObjectTest, ASizeIsTypedAndHasBounds) {
    choose(Shape::Box);
    widget<QDoubleSpinBox>("objectSize").setValue(0.8);
    EXPECT_NEAR(object()->sizeM, 0.8, 1e-9);
    presenter().objects().setSize(1e9);
    EXPECT_EQ(object()->sizeM, LaidObject::kLargestM);
    presenter().objects().setSize(0);
    EXPECT_EQ(object()->sizeM, LaidObject::kSmallestM);
}

TEST_F(ObjectTest, AMeshIsReadInItsOwnSize) {
    const QImage before = presenter().views()[0].picture.copy();
    answer(mesh(kPyramid));
    auto& box = widget<QComboBox>("object");
    emit box.activated(box.findData(static_cast<int>(Shape::Mesh)));
    ASSERT_TRUE(QTest::qWaitFor([&] { return object().has_value(); }, 100'000));
    EXPECT_EQ(object()->shape, Shape::Mesh);
    EXPECT_NEAR(object()->sizeM, 2, 1e-6);
    EXPECT_TRUE(object()->sidesM().isApprox(Eigen::Vector3d(1, 1, 2), 1e-6));
    EXPECT_EQ(box.currentData(), QVariant(static_cast<int>(Shape::Mesh)));
    EXPECT_TRUE(QTest::qWaitFor([&] { return presenter().views()[0].picture != before; }));
}

TEST_F(ObjectTest, AHostileMeshIsOneSentenceAndLeavesWhatStands) {
    choose(Shape::Box);
    const LaidObject before = *object();
    for (const char* words : {"", "v 1 2\n", "v 0 0 0\nf 1 2 3\n", "\x7f\x45LF\x02\x01"}) {
        presenter().objects().readMesh(QString::fromStdString(mesh(words).string()), {0, 0, 0});
        ASSERT_TRUE(QTest::qWaitFor([&] { return !tasks.hasRunning(); }, 100'000));
        const Task* task = tasks.tasks().last();
        EXPECT_EQ(task->state(), Task::State::Failed);
        EXPECT_TRUE(task->sentence().contains("mesh.obj")) << task->sentence().toStdString();
        EXPECT_EQ(object()->shape, Shape::Box);
        EXPECT_EQ(object()->sizeM, before.sizeM);
        EXPECT_EQ(widget<QComboBox>("object").currentData(), QVariant(static_cast<int>(Shape::Box)));
    }
}

TEST_F(ObjectTest, AClickOnThePlanPutsItThere) {
    choose(Shape::Box);
    auto& map = widget<PlanView>("map");
    const QPoint at = map.widgetFromRoom().map(QPointF(2.5, 1.5)).toPoint();
    QTest::mouseClick(&map, Qt::LeftButton, Qt::ShiftModifier, at);
    EXPECT_NEAR((object()->footM.head<2>() - Eigen::Vector2d(2.5, 1.5)).norm(), 0, 0.03);
}

TEST_F(ObjectTest, AClickInTheViewStandsItOnTheSurfaceThere) {
    choose(Shape::Box);
    presenter().setMount({1, Radians(Degrees(60))}); // down to the floor
    waitForView();
    auto& view = widget<DriveView>("view");
    QTest::mouseClick(&view, Qt::LeftButton, Qt::ShiftModifier, view.rect().center());
    const Eigen::Vector3d before = object()->footM;
    ASSERT_TRUE(QTest::qWaitFor([&] { return object()->footM != before; }, 100'000));
    const CameraModel camera(presenter().camera());
    const Rigid3 pose = roomFromOptical(presenter().robot(), presenter().mount());
    const Eigen::Vector3d middle = object()->footM + Eigen::Vector3d(0, 0, 0.5 * object()->sizeM);
    const auto pixel = camera.project(pose.inverse() * middle);
    ASSERT_TRUE(pixel); // it is where the click was
    EXPECT_NEAR(pixel->x(), 320, 120);
}

TEST_F(ObjectTest, IsSavedWithTheFrames) {
    for (const Shape shape : {Shape::Ball, Shape::Box}) {
        presenter().setRecording(true);
        presenter().setRecording(false);
        choose(shape);
        const fs::path folder = survey / ("walk" + std::to_string(static_cast<int>(shape)));
        presenter().saveFrames(QString::fromStdString(folder.string()));
        ASSERT_TRUE(QTest::qWaitFor([&] { return !tasks.hasRunning(); }, 100'000));
        const QImage frame(QString::fromStdString((folder / "000000.png").string()));
        const QImage saved = frame.convertToFormat(QImage::Format_RGB32);
        EXPECT_TRUE(QTest::qWaitFor([&] { return presenter().views()[0].picture == saved; }));
    }
}

TEST(SurfaceSpot, OfAFloorIsLevelAndOfAWallUpright) {
    const CameraModel camera(CameraIntrinsics::pinhole(200, 160, 1.2));
    const Rigid3 pose = roomFromOptical({{0, 0}, Radians(0)}, {1, Radians(Degrees(20))});
    DepthImage depth(200, 160); // of a floor, and of a wall 3 m ahead
    for (int y = 0; y < 160; ++y) {
        for (int x = 0; x < 200; ++x) {
            const Eigen::Vector3d ray = *camera.ray(Eigen::Vector2d(x, y));
            const Eigen::Vector3d inRoom = pose.rotation * ray;
            const double toFloor = inRoom.z() < 0 ? -1 / inRoom.z() : INFINITY;
            const double toWall = inRoom.x() > 0 ? 3 / inRoom.x() : INFINITY;
            *depth.at(x, y) = static_cast<float>(std::min(toFloor, toWall) * ray.z());
        }
    }
    const auto floor = spotAt(depth, camera, pose, {100, 140});
    ASSERT_TRUE(floor);
    EXPECT_EQ(floor->normal, Eigen::Vector3d::UnitZ());
    EXPECT_NEAR(floor->pInRoom.z(), 0, 1e-5);
    LaidObject box{Shape::Box, 0.5, {0, 0, 0}, Radians(0)};
    standOn(*floor, box);
    EXPECT_NEAR((box.footM - floor->pInRoom).norm(), 0, 1e-9);
    const auto wall = spotAt(depth, camera, pose, {100, 20});
    ASSERT_TRUE(wall);
    EXPECT_NEAR((wall->normal + Eigen::Vector3d::UnitX()).norm(), 0, 1e-3);
    standOn(*wall, box);
    EXPECT_NEAR(box.footM.x(), 3 - 0.25, 1e-3); // it touches the wall
    *depth.at(100, 20) = INFINITY;
    EXPECT_FALSE(spotAt(depth, camera, pose, {100, 20}));
    EXPECT_FALSE(spotAt(depth, camera, pose, {-1, 500}));
}

} // namespace spherewalk::ui
