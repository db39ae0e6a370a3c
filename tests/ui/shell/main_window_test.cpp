// SPDX-License-Identifier: GPL-3.0-or-later
#include "made_survey.h"
#include "qt_application.h"
#include "temporary_folder.h"
#include "ui/plan/plan_view.h"
#include "ui/shell/main_window.h"

#include <QLabel>
#include <QStatusBar>
#include <gtest/gtest.h>

namespace spherewalk::ui {

TEST(MainWindow, ShowsARealSurveyWithItsNameAndCounts) {
    const test::TemporaryFolder folder;
    MainWindow window;
    auto* plan = window.findChild<PlanView*>();
    window.resize(640, 480);
    const QImage before = plan->grab().toImage();
    const auto survey = test::makeSurvey(folder / "Küche.spherewalk");
    ASSERT_TRUE(window.openSurvey(QString::fromStdString(survey.string())));
    EXPECT_EQ(window.windowTitle(), "Küche - Spherewalk");
    EXPECT_TRUE(window.statusBar()->findChild<QLabel*>()->text().startsWith("0 of "));
    EXPECT_NE(plan->grab().toImage(), before);
}

TEST(MainWindow, SaysInTheStatusLineWhyItCannotOpen) {
    const test::TemporaryFolder folder;
    MainWindow window;
    EXPECT_FALSE(window.openSurvey(QString::fromStdString((folder / "absent").string())));
    EXPECT_TRUE(window.statusBar()->currentMessage().contains("absent"));
}

} // namespace spherewalk::ui
