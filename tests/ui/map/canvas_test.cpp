// SPDX-License-Identifier: GPL-3.0-or-later
#include "made_survey.h"
#include "qt_application.h"
#include "temporary_folder.h"
#include "ui/map/floor_picture.h"
#include "ui/map/plan_view.h"
#include "ui/map/station_words.h"

#include <QSettings>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <gtest/gtest.h>

namespace spherewalk::ui {

namespace {

/// A canvas with a floor of one colour.
class RedFloor : public PlanCanvas {
  public:
    RedFloor() {
        resize(400, 300);
        setExtent({{0, 0}, {4, 3}});
        show();
    }

  protected:
    void paintFloor(QPainter& painter, const QTransform& widgetFromRoom) override {
        painter.fillRect(widgetFromRoom.mapRect(QRectF(0, 0, 4, 3)), Qt::red);
    }
};

class BlueLayer : public PlanLayer {
  public:
    void paint(QPainter& painter, const QTransform& widgetFromRoom) override {
        painter.fillRect(widgetFromRoom.mapRect(QRectF(1, 1, 2, 1)), Qt::blue);
    }
};

QColor colourAt(PlanCanvas& canvas, double x, double y) {
    return canvas.grab().toImage().pixelColor(canvas.widgetFromRoom().map(QPointF(x, y)).toPoint());
}

/// The open survey of a room of 4 x 3 m, and its plan.
class SurveyPlanTest : public testing::Test {
  protected:
    SurveyPlanTest()
        : session(SurveySession::open(
              QString::fromStdString(test::makeSurvey(folder / "room.spherewalk", 1).string()))) {
        view.resize(400, 300);
        view.setSession(session.get());
        view.show();
    }

    ~SurveyPlanTest() override { view.setSession(nullptr); }

    test::TemporaryFolder folder;
    std::unique_ptr<SurveySession> session;
    SurveyPlanView view;
};

} // namespace

TEST(PlanCanvas, ShowsItsExtentUprightAndWhole) {
    RedFloor canvas;
    const QPointF corner = canvas.widgetFromRoom().map(QPointF(0, 0));
    const QPointF opposite = canvas.widgetFromRoom().map(QPointF(4, 3));
    EXPECT_LT(corner.x(), opposite.x());
    EXPECT_GT(corner.y(), opposite.y()); // y points up
    EXPECT_TRUE(QRectF(canvas.rect()).contains(corner));
    EXPECT_TRUE(QRectF(canvas.rect()).contains(opposite));
}

TEST(PlanCanvas, TheWheelKeepsThePlaceUnderThePointer) {
    RedFloor canvas;
    const QPointF at(100, 90);
    const QPointF before = canvas.roomFromWidget(at);
    const double scale = canvas.pixelsPerMetre();
    QWheelEvent wheel(at, canvas.mapToGlobal(at), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&canvas, &wheel);
    EXPECT_GT(canvas.pixelsPerMetre(), scale);
    EXPECT_LT(QLineF(canvas.roomFromWidget(at), before).length(), 1e-9);
}

TEST(PlanCanvas, DraggingWithCtrlMovesTheFloor) {
    RedFloor canvas;
    QSignalSpy presses(&canvas, &PlanCanvas::pressedAt);
    const QPointF held = canvas.roomFromWidget({100, 100});
    QTest::mousePress(&canvas, Qt::LeftButton, Qt::ControlModifier, {100, 100});
    QTest::mouseMove(&canvas, {150, 120});
    QTest::mouseRelease(&canvas, Qt::LeftButton, Qt::ControlModifier, {150, 120});
    EXPECT_LT(QLineF(canvas.roomFromWidget({150, 120}), held).length(), 1e-9);
    EXPECT_EQ(presses.size(), 0);
}

TEST(PlanCanvas, TheKeyZeroFitsAgain) {
    RedFloor canvas;
    const QTransform fitting = canvas.widgetFromRoom();
    QTest::keyClick(&canvas, Qt::Key_Plus);
    ASSERT_NE(canvas.widgetFromRoom(), fitting);
    QTest::keyClick(&canvas, Qt::Key_0);
    EXPECT_EQ(canvas.widgetFromRoom(), fitting);
}

TEST(PlanCanvas, TellsThePlaceOfAClickInTheRoom) {
    RedFloor canvas;
    QSignalSpy presses(&canvas, &PlanCanvas::pressedAt);
    const QPoint at = canvas.widgetFromRoom().map(QPointF(1, 2)).toPoint();
    QTest::mouseClick(&canvas, Qt::LeftButton, {}, at);
    ASSERT_EQ(presses.size(), 1);
    EXPECT_LT(QLineF(presses[0][0].toPointF(), QPointF(1, 2)).length(), 1 / canvas.pixelsPerMetre());
}

TEST(PlanCanvas, ALayerLiesAboveTheFloorUntilItIsRemoved) {
    RedFloor canvas;
    BlueLayer layer;
    canvas.addLayer(&layer);
    EXPECT_EQ(colourAt(canvas, 2, 1.5), QColor(Qt::blue));
    EXPECT_EQ(colourAt(canvas, 0.5, 0.5), QColor(Qt::red));
    canvas.removeLayer(&layer);
    EXPECT_EQ(colourAt(canvas, 2, 1.5), QColor(Qt::red));
}

TEST_F(SurveyPlanTest, HasAMarkForEachStation) {
    ASSERT_EQ(view.stations().size(), session->state().stations.size());
    EXPECT_EQ(view.stations().front().standing, Standing::Missing);
    EXPECT_EQ(view.stations().front().note, "missing");
}

TEST_F(SurveyPlanTest, FollowsAChangeOfThePlan) {
    const std::size_t before = view.stations().size();
    session->write(SurveySession::Plan, [](store::SurveyStore& store) { store.addStation({2, 2, 1.2}); });
    EXPECT_EQ(view.stations().size(), before + 1);
}

TEST_F(SurveyPlanTest, AClickChoosesTheStationForAllViews) {
    const StationMark& mark = view.stations().back();
    QTest::mouseClick(&view, Qt::LeftButton, {}, mapped(mark.positionM, view.widgetFromRoom()).toPoint());
    EXPECT_EQ(session->selection()->current(), mark.id);
}

TEST_F(SurveyPlanTest, ArrowKeysGoFromStationToStation) {
    QTest::keyClick(&view, Qt::Key_Right);
    EXPECT_EQ(session->selection()->current(), view.stations()[0].id);
    QTest::keyClick(&view, Qt::Key_Right);
    EXPECT_EQ(session->selection()->current(), view.stations()[1].id);
    QTest::keyClick(&view, Qt::Key_Left);
    EXPECT_EQ(session->selection()->current(), view.stations()[0].id);
}

TEST_F(SurveyPlanTest, IsEmptyWithoutASurvey) {
    view.setSession(nullptr);
    EXPECT_TRUE(view.stations().empty());
    EXPECT_TRUE(view.room().outline.empty());
}

TEST(PlanView, AGreaterHeatIsDarker) {
    int before = 256;
    for (const double heat : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const int grey = qGray(PlanView::heatColour(heat).rgb());
        EXPECT_LT(grey, before) << heat;
        before = grey;
    }
}

TEST(StationWords, SayWhereTheLensBelongs) {
    survey::Station station;
    station.positionM = {1.2, 0.8, 1.25};
    EXPECT_EQ(positionWords(station), "x 1.20 m, y 0.80 m, lens at 1.25 m");
}

} // namespace spherewalk::ui
