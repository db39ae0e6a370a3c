// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plan/outline_pen.h"
#include "ui/plan/plan_draft.h"

#include <gtest/gtest.h>

namespace spherewalk::ui {

using Eigen::Vector2d;

TEST(Snapping, PrefersACornerToItsNeighboursAndThemToTheGrid) {
    Snapping snapping;
    snapping.gridM = 0.5;
    snapping.reachM = 0.1;
    snapping.corners = {{1.03, 2.04}};
    snapping.neighbours = {{3.07, 9}};
    EXPECT_EQ(snapped({1, 2}, snapping), Vector2d(1.03, 2.04));
    EXPECT_EQ(snapped({3, 4.4}, snapping), Vector2d(3.07, 4.5));
    EXPECT_EQ(snapped({5.2, 4.4}, snapping), Vector2d(5, 4.5));
}

TEST(Snapping, LeavesThePointWithoutAGrid) {
    Snapping snapping;
    snapping.gridM = 0;
    EXPECT_EQ(snapped({1.2345, 6.789}, snapping), Vector2d(1.2345, 6.789));
}

TEST(OutlinePen, AClickOnTheFirstCornerCloses) {
    OutlinePen pen;
    pen.start();
    for (const Vector2d& corner : {Vector2d(0, 0), Vector2d(2, 0), Vector2d(2, 1)}) {
        pen.moveTo(corner);
        EXPECT_FALSE(pen.press());
    }
    pen.moveTo({0, 0});
    const auto polygon = pen.press();
    ASSERT_TRUE(polygon);
    EXPECT_EQ(*polygon, Polygon({{0, 0}, {2, 0}, {2, 1}}));
    EXPECT_FALSE(pen.isDrawing());
}

TEST(OutlinePen, ATypedLengthPutsTheCornerTowardsThePointer) {
    OutlinePen pen;
    pen.start();
    pen.moveTo({1, 1});
    pen.press();
    pen.moveTo({1, 1.4});
    for (const char c : {'3', ',', '2', '5'}) {
        EXPECT_TRUE(pen.type(QChar(c)));
    }
    EXPECT_FALSE(pen.type('x'));
    EXPECT_EQ(pen.tip(), Vector2d(1, 4.25));
    pen.press();
    EXPECT_EQ(pen.corners().back(), Vector2d(1, 4.25));
    EXPECT_TRUE(pen.typed().isEmpty());
}

TEST(OutlinePen, TakesBackCharactersThenCorners) {
    OutlinePen pen;
    pen.start();
    pen.moveTo({0, 0});
    pen.press();
    pen.moveTo({1, 0});
    pen.type('5');
    pen.takeBack();
    EXPECT_EQ(pen.tip(), Vector2d(1, 0));
    pen.takeBack();
    EXPECT_TRUE(pen.corners().empty());
}

TEST(OutlinePen, DoesNotCloseWithFewerThanThreeCorners) {
    OutlinePen pen;
    pen.start();
    pen.press();
    EXPECT_FALSE(pen.close());
    EXPECT_TRUE(pen.isDrawing());
}

TEST(PlanDraft, NamesCornersOfTheOutlineAsTheTableDoes) {
    PlanDraft draft = firstDraft();
    draft.room.outline = {{0, 0}, {3, 0}, {0, 3}, {3, 3}};
    EXPECT_TRUE(outcomeOf(draft).problem.contains("the wall after corner B crosses the wall after corner D"))
        << outcomeOf(draft).problem.toStdString();
    draft.room.outline = {{0, 0}, {3, 0}, {3, 0}, {3, 3}};
    EXPECT_TRUE(outcomeOf(draft).problem.contains("corners B and C are the same point"))
        << outcomeOf(draft).problem.toStdString();
}

} // namespace spherewalk::ui
