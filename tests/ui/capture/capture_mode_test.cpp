// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture_fixture.h"
#include "ui/capture/operator_signals.h"

#include <QLabel>
#include <QPushButton>
#include <QTest>

namespace spherewalk::ui {

using State = CaptureDesk::State;
using CaptureModeTest = CaptureFixture;

TEST_F(CaptureModeTest, OneKeyTakesThePictureAndTheNextStationIsNamed) {
    connectPractice();
    auto* next = mode.findChild<BigText*>("nextStation");
    EXPECT_EQ(next->text(), "Rail 1, stop 1");
    QTest::keyClick(&mode, Qt::Key_Space);
    waitFor(State::AtStation);
    QTest::keyClick(&mode, Qt::Key_PageDown); // what a presenter sends
    waitUntil(
        [&] { return desk().state() == State::AtStation && desk().stationsLeft() < desk().stations(); });
    EXPECT_EQ(played.size(), 1U);
    EXPECT_EQ(next->text(), "Rail 1, stop 2");
    EXPECT_EQ(mode.findChild<BigText*>("photosLeft")->text(), QString::number(desk().stations() - 1));
}

TEST_F(CaptureModeTest, ANewRailIsLaidByTape) {
    const QString way = mode.findChild<QLabel*>("way")->text();
    EXPECT_TRUE(way.startsWith("Lay the rail")) << way.toStdString();
    EXPECT_TRUE(way.contains("A ")) << way.toStdString();
}

TEST_F(CaptureModeTest, TheStopButtonEndsTheRun) {
    connectPractice();
    mode.findChild<QPushButton*>("shutter")->click();
    waitFor(State::AtStation);
    QTest::mouseClick(mode.findChild<QPushButton*>("stopCapture"), Qt::LeftButton);
    waitFor(State::Ready);
    EXPECT_EQ(session->store().counts().openShots, 0);
}

TEST_F(CaptureModeTest, SaysWhatWentWrong) {
    desk().connectTo("127.0.0.1:1");
    waitUntil([&] { return desk().state() == State::NoCamera && !desk().sentence().isEmpty(); });
    EXPECT_EQ(mode.findChild<QLabel*>("verdict")->text(), desk().sentence());
}

TEST_F(CaptureModeTest, ASelectedStationGoesOnTheListAndOff) {
    connectPractice();
    const std::int64_t station = session->store().stations().back().id;
    session->selection()->setCurrent(station);
    auto* button = mode.findChild<QPushButton*>("takeAgain");
    ASSERT_TRUE(button->isEnabled());
    button->click();
    EXPECT_TRUE(desk().isAgain(station));
    button->click();
    EXPECT_FALSE(desk().isAgain(station));
}

} // namespace spherewalk::ui
