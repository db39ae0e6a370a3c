// SPDX-License-Identifier: GPL-3.0-or-later
// Rails that are laid by hand, with pointer, keys and buttons.
#include "made_survey.h"
#include "qt_application.h"
#include "temporary_folder.h"
#include "ui/plan/plan_editor_view.h"
#include "ui/plan/plan_storage.h"
#include "ui/plan/rail_panel.h"

#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <gtest/gtest.h>

namespace spherewalk::ui {

using Eigen::Vector2d;
using survey::RailPlacement;

namespace {

constexpr double kTightM = 1e-9;

/// A room of 5 x 4 m with the rails that the program laid, and the tool for them.
class RailToolTest : public testing::Test {
  protected:
    RailToolTest() {
        editor.begin(firstDraft());
        view.resize(900, 700);
        view.show();
        view.fitRoom();
        view.setTool(PlanEditorView::Tool::Rails);
        settle();
    }

    void settle() {
        ASSERT_TRUE(QTest::qWaitFor([&] { return editor.isSettled(); }));
        ASSERT_EQ(editor.outcome().problem, QString());
    }

    QPoint at(const Vector2d& place) {
        return view.widgetFromRoom().map(QPointF(place.x(), place.y())).toPoint();
    }

    void drag(const Vector2d& from, const Vector2d& to, Qt::KeyboardModifiers modifiers = {}) {
        QTest::mousePress(&view, Qt::LeftButton, modifiers, at(from));
        QMouseEvent move(QEvent::MouseMove, at(to), view.mapToGlobal(at(to)), Qt::NoButton, Qt::LeftButton,
                         modifiers);
        QCoreApplication::sendEvent(&view, &move);
        QTest::mouseRelease(&view, Qt::LeftButton, modifiers, at(to));
    }

    void click(const Vector2d& place) { QTest::mouseClick(&view, Qt::LeftButton, {}, at(place)); }

    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) { QTest::keyClick(&view, key, modifiers); }

    QPushButton* button(const char* name) { return panel.findChild<QPushButton*>(name); }

    /// One rail alone, from (1, 1) along x.
    void layOne(int stops) {
        editor.changeRails("lay", [&](std::vector<RailPlacement>& rails) {
            rails = {{{1, 1}, Radians(0), stops, editor.draft().options.stepM}};
        });
        settle();
    }

    const RailPlacement& rail(std::size_t index = 0) { return editor.rails()[index]; }

    PlanEditor editor;
    PlanEditorView view{editor};
    RailPanel panel{editor};
};

} // namespace

TEST_F(RailToolTest, ADraggedRailMovesAloneAndIsOneStepOfUndo) {
    const std::vector<RailPlacement> before = editor.rails();
    ASSERT_GT(before[1].stops, 2);
    const Vector2d middle = 0.5 * (before[1].stop(0) + before[1].stop(1));
    drag(middle, middle + Vector2d(0.1, -0.2), Qt::AltModifier);
    settle();
    ASSERT_EQ(editor.rails().size(), before.size());
    EXPECT_LT((rail(1).origin - before[1].origin - Vector2d(0.1, -0.2)).norm(), 0.02);
    EXPECT_EQ(rail(1).heading, before[1].heading);
    EXPECT_EQ(rail(0).origin, before[0].origin);
    EXPECT_EQ(editor.outcome().plan.placements[1].origin, rail(1).origin);
    editor.undoStack()->undo();
    EXPECT_TRUE(editor.draft().rails.empty());
    EXPECT_FALSE(editor.undoStack()->canUndo());
}

TEST_F(RailToolTest, ADraggedEndTurnsAndLengthensAndWithShiftOnlyLengthens) {
    layOne(3);
    drag(rail().stop(2), {1, 3});
    EXPECT_EQ(rail().stops, 6);
    EXPECT_LT((rail().stop(5) - Vector2d(1, 3)).norm(), kTightM);
    layOne(3);
    drag(rail().stop(2), {2.6, 3}, Qt::ShiftModifier);
    EXPECT_EQ(rail().stops, 5);
    EXPECT_LT((rail().stop(4) - Vector2d(2.6, 1)).norm(), kTightM);
    drag(rail().stop(0), {1.8, 1});
    EXPECT_EQ(rail().stops, 3);
    EXPECT_LT((rail().stop(2) - Vector2d(2.6, 1)).norm(), kTightM) << "the other end stays";
}

TEST_F(RailToolTest, ADragOverFreeFloorLaysARailAndAClickNone) {
    layOne(2);
    click({3, 3});
    EXPECT_EQ(editor.rails().size(), 1U);
    drag({1, 2}, {3, 2});
    ASSERT_EQ(editor.rails().size(), 2U);
    EXPECT_EQ(rail(1).stops, 6);
    EXPECT_LT((rail(1).origin - Vector2d(1, 2)).norm(), kTightM);
    settle();
    EXPECT_EQ(editor.outcome().report.stations, 8);
}

TEST_F(RailToolTest, KeysMoveTurnLengthenAndGoFromRailToRail) {
    layOne(3);
    view.setGrid(0.1);
    press(Qt::Key_Return);
    EXPECT_EQ(editor.selected(), PlanPart{.rail = 0});
    press(Qt::Key_Up);
    press(Qt::Key_Right, Qt::ShiftModifier);
    EXPECT_LT((rail().origin - Vector2d(2, 1.1)).norm(), kTightM);
    press(Qt::Key_Right, Qt::ControlModifier);
    EXPECT_EQ(rail().stops, 4);
    press(Qt::Key_Up, Qt::ControlModifier);
    EXPECT_NEAR(Degrees(rail().heading).value(), 1, 1e-9);
    for (int i = 0; i < 5; ++i) {
        press(Qt::Key_Left, Qt::ControlModifier);
    }
    EXPECT_EQ(rail().stops, 1);
    drag({1, 2}, {3, 2});
    press(Qt::Key_Tab);
    EXPECT_EQ(editor.selected(), PlanPart{.rail = 0});
    press(Qt::Key_Delete);
    ASSERT_EQ(editor.rails().size(), 1U);
    EXPECT_EQ(rail().stops, 6);
}

TEST_F(RailToolTest, ARemovedStopSplitsARailAndTheLastRailBringsBackTheProgramsPlan) {
    const std::vector<RailPlacement> planned = editor.rails();
    layOne(5);
    click(rail().stop(2));
    EXPECT_EQ(editor.selected(), (PlanPart{.rail = 0, .stop = 2}));
    button("removeRail")->click();
    ASSERT_EQ(editor.rails().size(), 2U);
    EXPECT_EQ(rail(1).stops, 2);
    click(rail(0).stop(1));
    button("splitRail")->click();
    EXPECT_EQ(editor.rails().size(), 3U);
    for (int left = 3; left > 0; --left) {
        ASSERT_EQ(editor.draft().rails.size(), static_cast<std::size_t>(left));
        press(Qt::Key_Return);
        press(Qt::Key_Delete);
    }
    settle();
    ASSERT_EQ(editor.rails().size(), planned.size());
    EXPECT_EQ(rail(0).origin, planned[0].origin);
}

TEST_F(RailToolTest, LockedRailsStayAndTheOthersAreLaidAroundThem) {
    layOne(5);
    click(0.5 * (rail().stop(1) + rail().stop(2)));
    EXPECT_TRUE(panel.findChild<QLabel*>("selectedRail")->text().startsWith("Rail 1: 5 "));
    button("lockRail")->click();
    press(Qt::Key_Up);
    press(Qt::Key_Delete);
    drag(rail().stop(4), {3, 3});
    ASSERT_EQ(editor.rails().size(), 1U);
    EXPECT_EQ(rail().origin, Vector2d(1, 1));
    EXPECT_EQ(rail().stops, 5);
    button("layAnew")->click();
    settle();
    EXPECT_GT(editor.rails().size(), 5U);
    EXPECT_EQ(std::ranges::count_if(editor.rails(), [](const RailPlacement& one) { return one.isLocked; }),
              1);
    editor.change("step", [](PlanDraft& draft) { draft.options.clearanceM = 0.5; });
    settle();
    EXPECT_EQ(std::ranges::count_if(editor.rails(), [](const RailPlacement& one) { return one.isLocked; }), 1)
        << "it follows other edits";
}

TEST_F(RailToolTest, ARailThatCannotLieThereIsSaidWithItsNumber) {
    layOne(3);
    drag(rail().stop(2), {5.5, 1});
    ASSERT_TRUE(QTest::qWaitFor([&] { return editor.isSettled(); }));
    EXPECT_TRUE(editor.outcome().problem.startsWith("Rail 1 cannot lie there"));
    EXPECT_EQ(editor.rails().size(), 1U) << "it is still there to be moved";
}

TEST_F(RailToolTest, WhatWasLaidByHandIsThereWhenTheSurveyIsOpenedAgain) {
    const test::TemporaryFolder folder;
    const std::filesystem::path path = test::makeSurvey(folder / "room.spherewalk");
    std::vector<RailPlacement> laid;
    for (const bool isFirst : {true, false}) {
        const auto session = SurveySession::open(QString::fromStdString(path.string()));
        PlanEditor planEditor;
        PlanStorage storage{planEditor};
        storage.setSession(session.get());
        if (isFirst) {
            planEditor.changeRails("lay", [](std::vector<RailPlacement>& rails) {
                rails = {{{2, 1}, Radians(0.3), 3, 0.4, true}, {{1, 2}, Radians(0), 2, 0.4}};
            });
            laid = planEditor.rails();
        } else {
            ASSERT_EQ(planEditor.draft().rails.size(), 2U);
            EXPECT_TRUE(planEditor.rails()[0].isLocked);
            EXPECT_FALSE(planEditor.rails()[1].isLocked);
            EXPECT_EQ(planEditor.rails()[0].origin, laid[0].origin);
            EXPECT_EQ(planEditor.rails()[0].heading, laid[0].heading);
        }
        storage.setSession(nullptr); // stores
    }
}

} // namespace spherewalk::ui
