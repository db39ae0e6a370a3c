// SPDX-License-Identifier: GPL-3.0-or-later
#include "qt_application.h"
#include "temporary_folder.h"
#include "ui/plan/plan_editor_view.h"

#include <QSignalSpy>
#include <QTest>
#include <gtest/gtest.h>

#include <algorithm>

namespace spherewalk::ui {

using Eigen::Vector2d;

namespace {

using Tool = PlanEditorView::Tool;

/// The drawing of a room of 5 x 4 m with an obstacle of 1 x 1 m.
class PlanEditorViewTest : public testing::Test {
  protected:
    PlanEditorViewTest() {
        PlanDraft draft = firstDraft();
        draft.room.obstacles = {{{2, 1}, {3, 1}, {3, 2}, {2, 2}}};
        editor.begin(draft);
        view.resize(900, 700);
        view.show();
        view.fitRoom();
    }

    QPoint at(double x, double y) { return view.widgetFromRoom().map(QPointF(x, y)).toPoint(); }

    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) { QTest::keyClick(&view, key, modifiers); }

    void drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers = {}) {
        QTest::mousePress(&view, Qt::LeftButton, modifiers, from);
        QTest::mouseMove(&view, to);
        QTest::mouseRelease(&view, Qt::LeftButton, modifiers, to);
    }

    const survey::Room& room() const { return editor.draft().room; }

    PlanEditor editor;
    PlanEditorView view{editor};
};

} // namespace

TEST_F(PlanEditorViewTest, TheWholeRoomIsInSight) {
    for (const Vector2d& corner : room().outline) {
        EXPECT_TRUE(view.rect().contains(at(corner.x(), corner.y())));
    }
}

TEST_F(PlanEditorViewTest, AClickSelectsTheCornerElseTheObstacleElseTheWall) {
    QTest::mouseClick(&view, Qt::LeftButton, {}, at(3, 2));
    EXPECT_EQ(editor.selected(), (PlanPart{1, 2}));
    QTest::mouseClick(&view, Qt::LeftButton, {}, at(2.5, 1.5));
    EXPECT_EQ(editor.selected(), (PlanPart{1, PlanPart::kNone}));
    QTest::mouseClick(&view, Qt::LeftButton, {}, at(5, 2));
    EXPECT_EQ(editor.selected(), (PlanPart{PlanPart::kOutline, PlanPart::kNone}));
    QTest::mouseClick(&view, Qt::LeftButton, {}, at(1, 3));
    EXPECT_EQ(editor.selected(), PlanPart{});
}

TEST_F(PlanEditorViewTest, ADraggedObstacleKeepsItsShapeAndIsOneStepOfUndo) {
    drag(at(2.5, 1.5), at(3.5, 2));
    EXPECT_LT((room().obstacles[0][0] - Vector2d(3, 1.5)).norm(), 1e-9);
    EXPECT_LT((room().obstacles[0][2] - Vector2d(4, 2.5)).norm(), 1e-9);
    editor.undoStack()->undo();
    EXPECT_EQ(room().obstacles[0][0], Vector2d(2, 1));
    EXPECT_FALSE(editor.undoStack()->canUndo());
}

TEST_F(PlanEditorViewTest, TheRoomItselfCannotBeDraggedAway) {
    drag(at(5, 2), at(4, 2));
    EXPECT_EQ(room().outline, firstDraft().room.outline);
}

TEST_F(PlanEditorViewTest, ADoubleClickOnAWallAddsACorner) {
    QTest::mouseDClick(&view, Qt::LeftButton, {}, at(2.5, 0));
    ASSERT_EQ(room().outline.size(), 5U);
    EXPECT_LT((room().outline[1] - Vector2d(2.5, 0)).norm(), 1e-9);
    EXPECT_EQ(editor.selected(), (PlanPart{PlanPart::kOutline, 1}));
}

TEST_F(PlanEditorViewTest, TabGoesRoundAllCorners) {
    editor.select({PlanPart::kOutline, 3});
    press(Qt::Key_Tab);
    EXPECT_EQ(editor.selected(), (PlanPart{1, 0}));
    press(Qt::Key_Backtab);
    EXPECT_EQ(editor.selected(), (PlanPart{PlanPart::kOutline, 3}));
    for (int i = 0; i < 8; ++i) {
        press(Qt::Key_Tab);
    }
    EXPECT_EQ(editor.selected(), (PlanPart{PlanPart::kOutline, 3}));
}

TEST_F(PlanEditorViewTest, ArrowsMoveTheCornerByTheGridAndWithShiftTenTimes) {
    view.setGrid(0.1);
    editor.select({PlanPart::kOutline, 2});
    press(Qt::Key_Left);
    EXPECT_LT((room().outline[2] - Vector2d(4.9, 4)).norm(), 1e-9);
    press(Qt::Key_Up, Qt::ShiftModifier);
    EXPECT_LT((room().outline[2] - Vector2d(4.9, 5)).norm(), 1e-9);
}

TEST_F(PlanEditorViewTest, DeleteRemovesTheSelectedObstacle) {
    editor.select({1, PlanPart::kNone});
    press(Qt::Key_Delete);
    EXPECT_TRUE(room().obstacles.empty());
    EXPECT_EQ(editor.selected(), PlanPart{});
}

TEST_F(PlanEditorViewTest, AnObstacleIsDrawnWithThePen) {
    view.setTool(Tool::Obstacle);
    for (const auto& [x, y] : {std::pair{0.5, 2.5}, {1.5, 2.5}, {1.5, 3.5}}) {
        QTest::mouseMove(&view, at(x, y));
        QTest::mouseClick(&view, Qt::LeftButton, {}, at(x, y));
    }
    press(Qt::Key_Return);
    ASSERT_EQ(room().obstacles.size(), 2U);
    EXPECT_EQ(room().obstacles[1].size(), 3U);
    EXPECT_EQ(view.tool(), Tool::Select);
}

TEST_F(PlanEditorViewTest, EscapeEndsThePenWithoutAnEdit) {
    view.setTool(Tool::Outline);
    QTest::mouseClick(&view, Qt::LeftButton, {}, at(1, 1));
    press(Qt::Key_Escape);
    EXPECT_EQ(view.tool(), Tool::Select);
    EXPECT_EQ(editor.undoStack()->count(), 0);
}

TEST_F(PlanEditorViewTest, SaysWhatThePenWants) {
    QSignalSpy hints(&view, &PlanEditorView::hint);
    view.setTool(Tool::Outline);
    view.setTool(Tool::Select);
    ASSERT_EQ(hints.size(), 2);
    EXPECT_FALSE(hints[0][0].toString().isEmpty());
    EXPECT_TRUE(hints[1][0].toString().isEmpty());
}

TEST_F(PlanEditorViewTest, ALineForTheScaleIsToldInMetresOfTheRoom) {
    view.setTool(Tool::Scale);
    QSignalSpy lines(&view, &PlanEditorView::scaleDrawn);
    drag(at(1, 3), at(4, 3));
    ASSERT_EQ(lines.size(), 1);
    EXPECT_NEAR(lines[0][0].toLineF().length(), 3, 2 / view.pixelsPerMetre());
    EXPECT_EQ(editor.undoStack()->count(), 0);
}

TEST_F(PlanEditorViewTest, ALockedPlanHasNoPen) {
    editor.setLocked(true);
    view.setTool(Tool::Outline);
    EXPECT_EQ(view.tool(), Tool::Select);
    drag(at(3, 2), at(4, 3));
    EXPECT_EQ(editor.undoStack()->count(), 0);
}

TEST_F(PlanEditorViewTest, AltDrawsOffTheGrid) {
    view.setGrid(1);
    drag(at(3, 2), at(3.3, 2.4), Qt::AltModifier);
    EXPECT_EQ(room().obstacles[0][2], Vector2d(3, 2)); // the pointer moved without Alt snaps back
    QTest::mousePress(&view, Qt::LeftButton, Qt::AltModifier, at(3, 2));
    QMouseEvent move(QEvent::MouseMove, QPointF(at(3.3, 2.4)), view.mapToGlobal(QPointF(at(3.3, 2.4))),
                     Qt::NoButton, Qt::LeftButton, Qt::AltModifier);
    QApplication::sendEvent(&view, &move);
    EXPECT_LT((room().obstacles[0][2] - Vector2d(3.3, 2.4)).norm(), 0.05);
}

TEST_F(PlanEditorViewTest, ARoomThatIsStillBeingDrawnIsNoProblem) {
    press(Qt::Key_O);
    for (const Vector2d& corner : Polygon{{0, 0}, {2, 0}, {2, 3}, {2.3, 3}, {2.3, 0}, {4, 0}}) {
        QTest::mouseMove(&view, at(corner.x(), corner.y()));
        QTest::mouseClick(&view, Qt::LeftButton, {}, at(corner.x(), corner.y()));
        ASSERT_TRUE(QTest::qWaitFor([&] { return editor.isSettled(); }, 100'000));
        EXPECT_TRUE(editor.outcome().problem.isEmpty()) << editor.outcome().problem.toStdString();
    }
}

TEST_F(PlanEditorViewTest, LengthsStandOutsideOfTheRoom) {
    const std::vector<LengthLabel> labels = view.lengthLabels();
    ASSERT_EQ(labels.size(), 4U);
    const QRectF floor(view.widgetFromRoom().mapRect(QRectF(0, 0, 5, 4)));
    for (const LengthLabel& label : labels) {
        EXPECT_FALSE(label.box.intersects(floor)) << label.words.toStdString();
        EXPECT_TRUE(QRectF(view.rect()).contains(label.box)) << label.words.toStdString();
    }
    EXPECT_EQ(labels[0].words, "5.00 m");
    EXPECT_TRUE(labels[1].isUpright);
}

TEST_F(PlanEditorViewTest, LengthsOfAThinWallsSidesStandApart) {
    editor.setOutline({{0, 0}, {3, 0}, {3, 3}, {3.1, 3}, {3.1, 0}, {6, 0}, {6, 4}, {0, 4}});
    view.fitRoom();
    const std::vector<LengthLabel> labels = view.lengthLabels();
    const auto in = [](double x, double y) { return QRectF(x, 0, y - x, 3); };
    const auto onFloor = [&](const QRectF& place) {
        return std::count_if(labels.begin(), labels.end(), [&](const LengthLabel& label) {
            return label.words == "3.00 m" && label.isUpright &&
                   view.widgetFromRoom().mapRect(place).contains(label.box);
        });
    };
    EXPECT_EQ(onFloor(in(0, 3)), 1);
    EXPECT_EQ(onFloor(in(3.1, 6)), 1);
    for (std::size_t i = 0; i < labels.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            EXPECT_FALSE(labels[i].box.intersects(labels[k].box)) << i << ' ' << k;
        }
    }
}

TEST_F(PlanEditorViewTest, TwoDragsLayAPictureOntoTwoCorners) {
    const test::TemporaryFolder folder;
    const QString file = QString::fromStdString((folder / "plan.png").string());
    ASSERT_TRUE(QImage(100, 80, QImage::Format_RGB32).save(file));
    view.picture().load(file);
    view.setTool(Tool::Place);
    QStringList hints;
    QObject::connect(&view, &PlanEditorView::hint, [&](const QString& sentence) { hints << sentence; });
    drag(at(1, 1), at(0, 0)); // a corner of the picture belongs to the corner of the room
    const QPointF pinned = view.picture().roomFromPicture().inverted().map(QPointF(0, 0));
    ASSERT_EQ(hints.size(), 1);
    EXPECT_EQ(view.tool(), Tool::Place);
    drag(at(2, 0.5), at(5, 0));
    const QTransform room = view.picture().roomFromPicture();
    const double pixel = 1.5 / view.widgetFromRoom().m11();
    EXPECT_LT(QLineF(room.map(pinned), QPointF(0, 0)).length(), pixel);
    EXPECT_GT(view.picture().yaw().value(), -0.3);
    EXPECT_LT(view.picture().yaw().value(), -0.2); // atan(0.5 / 2) clockwise
    EXPECT_EQ(view.tool(), Tool::Select);
}

} // namespace spherewalk::ui
