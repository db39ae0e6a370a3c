// SPDX-License-Identifier: GPL-3.0-or-later
#include "qt_application.h"
#include "temporary_folder.h"
#include "ui/plan/plan_view.h"
#include "ui/shell/main_window.h"

#include "spherewalk/store/survey_store.h"

#include <QApplication>
#include <QHelpEvent>
#include <QLabel>
#include <QStatusBar>
#include <QToolTip>
#include <gtest/gtest.h>

namespace spherewalk::ui {

namespace {

std::filesystem::path makeSurvey(const test::TemporaryFolder& folder) {
    survey::Room room;
    room.outline = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
    room.obstacles = {{{1, 1}, {1.5, 1}, {1.5, 1.5}, {1, 1.5}}};
    room.ceilingM = 2.5;
    survey::PlanOptions options;
    options.stepM = 0.5;
    const auto path = folder / "Küche.spherewalk";
    store::SurveyStore::create(path, "Küche", room, options, survey::plan(room, options));
    return path;
}

} // namespace

TEST(MainWindow, ShowsARealSurveyWithItsNameAndCounts) {
    const test::TemporaryFolder folder;
    MainWindow window;
    auto* plan = window.findChild<PlanView*>();
    window.resize(640, 480);
    const QImage before = plan->grab().toImage();
    ASSERT_TRUE(window.openSurvey(QString::fromStdString(makeSurvey(folder).string())));
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

TEST(PlanView, NamesTheStationUnderThePointer) {
    PlanView view;
    survey::Room room;
    room.outline = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
    view.setRoom(room);
    view.setStations({{{1, 1}, "rail 1, stop 2", true}});
    view.resize(400, 400);
    view.show();
    QHelpEvent overStation(QEvent::ToolTip, {200, 200}, view.mapToGlobal(QPoint(200, 200)));
    QApplication::sendEvent(&view, &overStation);
    EXPECT_EQ(QToolTip::text(), "rail 1, stop 2");
}

TEST(PlanView, TellsPhotosFromMissingOnesByMoreThanColour) {
    PlanView view;
    survey::Room room;
    room.outline = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
    view.setRoom(room);
    view.resize(400, 400);
    const auto centreColour = [&](bool hasPhoto) {
        view.setStations({{{1, 1}, "x", hasPhoto}});
        return view.grab().toImage().pixelColor(200, 200);
    };
    EXPECT_EQ(centreColour(true), view.palette().color(QPalette::Highlight));
    EXPECT_EQ(centreColour(false), view.palette().color(QPalette::Base));
}

} // namespace spherewalk::ui
