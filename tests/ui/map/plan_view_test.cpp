// SPDX-License-Identifier: GPL-3.0-or-later
#include "qt_application.h"
#include "ui/map/plan_view.h"
#include "ui/map/station_words.h"

#include <QApplication>
#include <QHelpEvent>
#include <QToolTip>
#include <gtest/gtest.h>

namespace spherewalk::ui {

namespace {

survey::Room squareRoom() {
    survey::Room room;
    room.outline = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
    return room;
}

StationMark mark(Standing standing) {
    StationMark result;
    result.id = 7;
    result.positionM = {1, 1};
    result.name = "rail 1, stop 2";
    result.standing = standing;
    return result;
}

} // namespace

TEST(StationWords, AreThePlansOwnNamesInTheUsersWords) {
    EXPECT_EQ(stationWords("rail 3, stop 12"), "Rail 3, stop 12");
    EXPECT_EQ(stationWords("rail 1, stop 2 at 1.20 m"), "Rail 1, stop 2, at 1.20 m");
    for (const std::string name : {"unplanned position (here)", "rail 1, stop two", ""}) {
        EXPECT_EQ(stationWords(name).toStdString(), name);
    }
    survey::Plan byHand;
    byHand.stations.push_back({-1, 0, {1, -2.504, 1.2}});
    EXPECT_EQ(stationWords(survey::stationName(byHand, 0)), "At x 1.00, y -2.50");
    // As survey::plan() names them.
    survey::PlanOptions options;
    options.heightsM = {0.8, 1.6};
    survey::Room room = squareRoom();
    room.ceilingM = 2.5;
    for (const std::string& name : survey::stationNames(survey::plan(room, options))) {
        EXPECT_TRUE(stationWords(name).startsWith("Rail ")) << name;
    }
}

TEST(PlanView, NamesTheStationUnderThePointer) {
    PlanView view;
    view.setRoom(squareRoom());
    view.setStations({mark(Standing::Taken)});
    view.resize(400, 400);
    view.show();
    QHelpEvent overStation(QEvent::ToolTip, {200, 200}, view.mapToGlobal(QPoint(200, 200)));
    QApplication::sendEvent(&view, &overStation);
    EXPECT_EQ(QToolTip::text(), "rail 1, stop 2");
}

TEST(PlanView, ShowsAllStationsWhereverTheWallsAreAndWhereNobodyKnowsThem) {
    PlanView view;
    view.resize(400, 400);
    StationMark far = mark(Standing::Taken);
    far.positionM = {9, 1};
    for (const survey::Room& room : {squareRoom(), survey::Room()}) {
        view.setRoom(room);
        view.setStations({mark(Standing::Taken), far});
        for (const StationMark& station : view.stations()) {
            const QPointF at =
                view.widgetFromRoom().map(QPointF(station.positionM.x(), station.positionM.y()));
            EXPECT_TRUE(QRectF(view.rect()).contains(at)) << at.x() << ", " << at.y();
        }
        EXPECT_TRUE(view.words().isEmpty());
    }
    view.setStations({});
    EXPECT_FALSE(view.words().isEmpty()) << "there is nothing to see";
}

TEST(PlanView, TellsStandingsByMoreThanColour) {
    PlanView view;
    view.setRoom(squareRoom());
    view.resize(400, 400);
    std::vector<QImage> forms;
    for (const Standing standing :
         {Standing::Missing, Standing::Taken, Standing::Doubtful, Standing::Failed, Standing::Rejected}) {
        view.setStations({mark(standing)});
        const QImage shown = view.grab().toImage().convertToFormat(QImage::Format_Grayscale8);
        QImage form = shown.copy(180, 180, 40, 40).convertToFormat(QImage::Format_Grayscale8);
        for (int y = 0; y < form.height(); ++y) { // only where something is drawn counts, not how light it is
            for (int x = 0; x < form.width(); ++x) {
                form.scanLine(y)[x] = form.constScanLine(y)[x] > 235 ? 255 : 0;
            }
        }
        for (const QImage& other : forms) {
            EXPECT_NE(form, other) << static_cast<int>(standing);
        }
        forms.push_back(form);
    }
}

TEST(PlanView, PutsEachPointOfTheFloorBackWhereItWasAfterZooming) {
    PlanView view;
    view.setRoom(squareRoom());
    view.resize(400, 300);
    view.zoom(1.7, {120, 80});
    const QPointF inRoom = view.roomFromWidget({33, 44});
    const QPointF back = view.widgetFromRoom().map(inRoom);
    EXPECT_NEAR(back.x(), 33, 1e-9);
    EXPECT_NEAR(back.y(), 44, 1e-9);
}

} // namespace spherewalk::ui
