// SPDX-License-Identifier: GPL-3.0-or-later
#include "qt_application.h"
#include "ui/plan/plan_editor.h"
#include "ui/plan/plan_panel.h"

#include <QSignalSpy>
#include <gtest/gtest.h>

namespace spherewalk::ui {

using Eigen::Vector2d;

namespace {

/// Waits for the plan of the present draft.
void settle(PlanEditor& editor) {
    QSignalSpy outcomes(&editor, &PlanEditor::outcomeChanged);
    while (!editor.isSettled()) {
        ASSERT_TRUE(outcomes.wait(100'000));
    }
}

} // namespace

TEST(PlanEditor, PlansWhatIsDrawnAsTheCommandLineDoes) {
    PlanEditor editor;
    editor.begin(firstDraft());
    editor.addObstacle({{2, 1}, {3, 1}, {3, 2}, {2, 2}});
    settle(editor);
    const survey::Plan expected = survey::plan(editor.draft().room, editor.draft().options);
    ASSERT_EQ(editor.outcome().plan.stations.size(), expected.stations.size());
    EXPECT_EQ(editor.outcome().report.placements, static_cast<int>(expected.placements.size()));
}

TEST(PlanEditor, SaysWhyARoomHasNoPlan) {
    PlanEditor editor;
    editor.begin(firstDraft());
    editor.setOutline({{0, 0}, {4, 4}, {4, 0}, {0, 4}});
    settle(editor);
    EXPECT_TRUE(editor.outcome().problem.contains("crosses"));
    EXPECT_TRUE(editor.outcome().plan.stations.empty());
}

TEST(PlanEditor, ADragIsOneStepOfUndo) {
    PlanEditor editor;
    editor.begin(firstDraft());
    const Vector2d before = editor.draft().room.outline[2];
    for (const double x : {5.1, 5.2, 5.3}) {
        editor.moveCorner({0, 2}, {x, 4});
    }
    editor.endRun();
    EXPECT_EQ(editor.draft().room.outline[2], Vector2d(5.3, 4));
    editor.undoStack()->undo();
    EXPECT_EQ(editor.draft().room.outline[2], before);
    EXPECT_FALSE(editor.undoStack()->canUndo());
}

TEST(PlanEditor, TwoDragsAreTwoStepsOfUndo) {
    PlanEditor editor;
    editor.begin(firstDraft());
    editor.moveCorner({0, 2}, {5.1, 4});
    editor.endRun();
    editor.moveCorner({0, 2}, {5.2, 4});
    editor.endRun();
    editor.undoStack()->undo();
    EXPECT_EQ(editor.draft().room.outline[2], Vector2d(5.1, 4));
}

TEST(PlanEditor, KeepsThreeCorners) {
    PlanEditor editor;
    editor.begin(firstDraft());
    for (int i = 0; i < 4; ++i) {
        editor.select({PlanPart::kOutline, 0});
        editor.removeSelected();
    }
    EXPECT_EQ(editor.draft().room.outline.size(), 3U);
}

TEST(PlanEditor, SelectsNothingThatUndoTookAway) {
    PlanEditor editor;
    editor.begin(firstDraft());
    editor.addObstacle({{2, 1}, {3, 1}, {3, 2}});
    EXPECT_EQ(editor.selected().polygon, 1);
    editor.undoStack()->undo();
    EXPECT_EQ(editor.selected().polygon, PlanPart::kNone);
}

TEST(PlanEditor, ALockedPlanDoesNotChange) {
    PlanEditor editor;
    editor.begin(firstDraft());
    editor.setLocked(true);
    editor.moveCorner({0, 2}, {9, 9});
    editor.addObstacle({{2, 1}, {3, 1}, {3, 2}});
    editor.insertCorner({0, 0}, {1, 0});
    EXPECT_EQ(editor.draft().room.outline, firstDraft().room.outline);
    EXPECT_TRUE(editor.draft().room.obstacles.empty());
}

TEST(PlanEditor, ShowsThePlanOfAnOutlineWhileItIsDrawn) {
    PlanEditor editor;
    editor.begin(firstDraft());
    settle(editor);
    const std::size_t before = editor.outcome().plan.stations.size();
    QSignalSpy outcomes(&editor, &PlanEditor::outcomeChanged);
    editor.preview({{0, 0}, {2, 0}, {2, 2}, {0, 2}});
    ASSERT_TRUE(outcomes.wait(100'000));
    EXPECT_LT(editor.outcome().plan.stations.size(), before);
    EXPECT_FALSE(editor.isSettled());
    EXPECT_EQ(editor.draft().room.outline, firstDraft().room.outline);
}

TEST(CornerModel, ATypedNumberMovesTheCorner) {
    PlanEditor editor;
    editor.begin(firstDraft());
    CornerModel model(editor);
    ASSERT_TRUE(model.setData(model.index(1, 0), 6.25, Qt::EditRole));
    EXPECT_EQ(editor.draft().room.outline[1], Vector2d(6.25, 0));
    EXPECT_FALSE(model.setData(model.index(1, 0), "far", Qt::EditRole));
    EXPECT_FALSE(model.setData(model.index(1, 0), NAN, Qt::EditRole));
}

TEST(PlanDraft, RailLengthAndStopsAgree) {
    EXPECT_EQ(railStops(1.0, 0.2), 6);
    EXPECT_EQ(railStops(0.99, 0.2), 5);
    EXPECT_EQ(railStops(0.6, 0.2), 4); // although 0.6 / 0.2 is a little less than 3
    for (const double step : {0.1, 0.2, 0.3, 0.7}) {
        for (int stops = 1; stops < 30; ++stops) {
            EXPECT_EQ(railStops(railLengthM(stops, step), step), stops);
        }
    }
}

} // namespace spherewalk::ui
