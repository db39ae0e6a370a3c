// SPDX-License-Identifier: GPL-3.0-or-later
#include "qt_application.h"
#include "ui/plan/plan_draft.h"
#include "ui/plan/plan_panel.h"

#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>
#include <gtest/gtest.h>

namespace spherewalk::ui {

namespace {

/// The panel of a rectangular room, whose plan is computed.
class PlanPanelTest : public testing::Test {
  protected:
    PlanPanelTest() {
        editor.begin(firstDraft());
        panel.show();
        settlePlan();
    }

    void settlePlan() {
        QSignalSpy outcomes(&editor, &PlanEditor::outcomeChanged);
        while (!editor.isSettled()) {
            ASSERT_TRUE(outcomes.wait(100'000));
        }
    }

    QDoubleSpinBox& number(const char* name) { return *panel.findChild<QDoubleSpinBox*>(name); }

    QString words(const char* name) { return panel.findChild<QLabel*>(name)->text(); }

    void typeHeights(const QString& heights) {
        auto* field = panel.findChild<QLineEdit*>("heights");
        field->setText(heights);
        QTest::keyClick(field, Qt::Key_Return);
    }

    PlanEditor editor;
    PlanPanel panel{editor};
};

} // namespace

TEST_F(PlanPanelTest, ShowsTheNumbersOfTheDraft) {
    editor.change("edit", [](PlanDraft& draft) {
        draft.options.clearanceM = 0.35;
        draft.room.ceilingM = 3.1;
        draft.options.secondsPerPhoto = 12;
        draft.options.secondsPerPlacement = 90;
    });
    EXPECT_EQ(number("step").value(), 0.4);
    EXPECT_EQ(number("clearance").value(), 0.35);
    EXPECT_EQ(number("ceiling").value(), 3.1);
    EXPECT_EQ(number("photoPace").value(), 12);
    EXPECT_EQ(number("railPace").value(), 90);
}

TEST_F(PlanPanelTest, ShowingADraftIsNoEdit) {
    editor.begin(firstDraft());
    EXPECT_EQ(editor.undoStack()->count(), 0);
}

TEST_F(PlanPanelTest, ANewStepKeepsTheRailAsLongAsItWas) {
    number("railLength").setValue(2);
    number("step").setValue(0.25);
    EXPECT_EQ(editor.draft().options.railStops, 9);
    number("step").setValue(0.5);
    EXPECT_EQ(editor.draft().options.railStops, 5);
    EXPECT_EQ(number("railLength").value(), 2);
}

TEST_F(PlanPanelTest, TurningAnArrowIsOneStepOfUndo) {
    const double before = editor.draft().options.clearanceM;
    for (int i = 0; i < 3; ++i) {
        number("clearance").stepUp();
    }
    EXPECT_NE(editor.draft().options.clearanceM, before);
    editor.undoStack()->undo();
    EXPECT_EQ(editor.draft().options.clearanceM, before);
    EXPECT_EQ(number("clearance").value(), before);
}

TEST_F(PlanPanelTest, EditsOfTwoNumbersAreTwoStepsOfUndo) {
    number("photoPace").setValue(20);
    number("railPace").setValue(200);
    editor.undoStack()->undo();
    EXPECT_EQ(editor.draft().options.secondsPerPhoto, 20);
    EXPECT_NE(editor.draft().options.secondsPerPlacement, 200);
}

TEST_F(PlanPanelTest, SeveralHeightsMakeLayers) {
    const int before = editor.outcome().report.stations;
    typeHeights(QLocale().toString(0.8) + "; " + QLocale().toString(1.6));
    EXPECT_EQ(editor.draft().options.heightsM, std::vector<double>({0.8, 1.6}));
    settlePlan();
    EXPECT_EQ(editor.outcome().report.stations, 2 * before);
}

TEST_F(PlanPanelTest, HeightsThatAreNoNumbersAreTakenBack) {
    const std::vector<double> before = editor.draft().options.heightsM;
    const QString shown = panel.findChild<QLineEdit*>("heights")->text();
    typeHeights("high");
    EXPECT_EQ(editor.draft().options.heightsM, before);
    EXPECT_EQ(panel.findChild<QLineEdit*>("heights")->text(), shown);
}

TEST_F(PlanPanelTest, SaysWhatThePlanComesTo) {
    EXPECT_EQ(words("planCounts"), countsText(editor.outcome().report));
    EXPECT_FALSE(panel.findChild<QLabel*>("planProblem")->isVisible());
}

TEST_F(PlanPanelTest, SaysTheProblemInPlaceOfThePlan) {
    editor.setOutline({{0, 0}, {4, 4}, {4, 0}, {0, 4}});
    settlePlan();
    EXPECT_EQ(words("planProblem"), editor.outcome().problem);
    EXPECT_TRUE(panel.findChild<QLabel*>("planProblem")->isVisible());
    EXPECT_FALSE(panel.findChild<QLabel*>("planCounts")->isVisible());
}

TEST_F(PlanPanelTest, ALockedPlanHasNoNumbersToEdit) {
    editor.setLocked(true);
    editor.begin(firstDraft());
    EXPECT_FALSE(number("step").isEnabled());
    const CornerModel model(editor);
    EXPECT_FALSE(model.flags(model.index(0, 0)).testFlag(Qt::ItemIsEditable));
}

TEST_F(PlanPanelTest, AChosenRowSelectsItsCorner) {
    auto* corners = panel.findChild<QTableView*>("corners");
    corners->setCurrentIndex(corners->model()->index(2, 0));
    EXPECT_EQ(editor.selected(), (PlanPart{PlanPart::kOutline, 2}));
}

TEST_F(PlanPanelTest, ListsTheCornersOfTheSelectedObstacle) {
    auto* corners = panel.findChild<QTableView*>("corners");
    EXPECT_EQ(corners->model()->headerData(0, Qt::Vertical, Qt::DisplayRole).toString(), "A");
    editor.addObstacle({{2, 1}, {3, 1}, {3, 2}});
    EXPECT_EQ(corners->model()->rowCount(), 3);
    EXPECT_EQ(corners->model()->headerData(0, Qt::Vertical, Qt::DisplayRole).toString(), "1");
    EXPECT_EQ(corners->model()->index(1, 0).data(Qt::EditRole).toDouble(), 3);
}

TEST(PlanWords, NameEachReasonThatLeavesFloorUncovered) {
    survey::PlanReport report;
    report.floorM2 = 20;
    report.uncoveredM2 = 5;
    report.uncovered.resize(2);
    report.uncovered[0].reason = survey::UncoveredReason::Clearance;
    report.uncovered[0].areaM2 = 4;
    report.uncovered[1].reason = survey::UncoveredReason::Enclosed;
    report.uncovered[1].areaM2 = 1;
    const QStringList lines = uncoveredText(report, survey::PlanOptions());
    ASSERT_EQ(lines.size(), 2);
    EXPECT_TRUE(lines[0].startsWith("4.00 m²: closer than")) << lines[0].toStdString();
    EXPECT_EQ(lines[1], "1.00 m²: cut off by obstacles");
    EXPECT_EQ(floorText(report), "20.0 m² of floor, 5.0 m² not covered (25 %)");
}

TEST(PlanWords, TheSheetKeepsItsPlaceholders) {
    const report::SheetWords words = sheetWords();
    EXPECT_NE(words.title.find("%1"), std::string::npos);
    for (const char* placeholder : {"%1", "%2", "%3", "%4", "%5"}) {
        EXPECT_NE(words.summary.find(placeholder), std::string::npos) << placeholder;
    }
}

TEST_F(PlanPanelTest, TabLeavesTheTableOfCorners) {
    panel.show();
    test::activate(panel);
    auto* corners = panel.findChild<QTableView*>("corners");
    corners->setFocus();
    ASSERT_TRUE(corners->hasFocus());
    QTest::keyClick(corners, Qt::Key_Tab);
    EXPECT_FALSE(corners->hasFocus());
}

} // namespace spherewalk::ui
