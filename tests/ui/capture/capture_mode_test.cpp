// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture_fixture.h"
#include "made_survey.h"
#include "ui/capture/operator_signals.h"
#include "ui/look/theme.h"

#include <QLabel>
#include <QMessageBox>
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

TEST_F(CaptureModeTest, ThePracticeCameraIsToldApartInColourAndWords) {
    auto* words = mode.findChild<QLabel*>("practiceWords");
    EXPECT_FALSE(words->isVisible());
    connectPractice();
    EXPECT_TRUE(words->isVisible());
    EXPECT_TRUE(words->text().contains("PRACTICE"));
    EXPECT_EQ(words->grab().toImage().pixelColor(words->width() - 20, 2), doubtfulColour());
    EXPECT_EQ(mode.findChild<QLabel*>("capture")->text(), "practice camera");
    mode.findChild<QPushButton*>("practiceCamera")->click(); // leaves it
    EXPECT_EQ(desk().state(), State::NoCamera);
    EXPECT_FALSE(words->isVisible());
}

TEST_F(CaptureModeTest, AsksBeforePracticePhotosComeIntoARealSurvey) {
    const auto flat =
        SurveySession::open(QString::fromStdString(test::makeSurvey(folder / "flat.spherewalk").string()));
    mode.setSession(flat.get());
    auto* practice = mode.findChild<QPushButton*>("practiceCamera");
    practice->click();
    auto* question = mode.findChild<QMessageBox*>("practiceQuestion");
    ASSERT_NE(question, nullptr);
    EXPECT_TRUE(question->text().contains(flat->name()));
    QTest::keyClick(question, Qt::Key_Return); // the safe answer is the first
    EXPECT_EQ(desk().state(), State::NoCamera);
    practice->click();
    for (auto* box : mode.findChildren<QMessageBox*>("practiceQuestion")) {
        if (box->isVisible()) {
            box->buttons().back()->text().contains("Use") ? box->buttons().back()->click()
                                                          : box->buttons().front()->click();
        }
    }
    waitFor(State::Ready);
    mode.setSession(session.get());
}

TEST_F(CaptureModeTest, SpaceIsTheShutterAlsoAfterATab) {
    connectPractice();
    mode.findChild<QPushButton*>("shutter")->click();
    waitFor(State::AtStation);
    auto* find = mode.findChild<QPushButton*>("findCameras");
    find->setFocus();
    QTest::keyClick(find, Qt::Key_Space);
    waitUntil([&] { return desk().stationsLeft() == desk().stations() - 1; });
    EXPECT_FALSE(mode.finder().isLooking());
}

TEST_F(CaptureModeTest, AnAnsweringCameraNeedsNoAdviceHowToFindOne) {
    camera::FindOptions nowhere;
    nowhere.places = {{{"127.0.0.1", 1}, "here"}};
    nowhere.browseTime = std::chrono::milliseconds(0);
    mode.finder().setOptions(nowhere);
    mode.finder().find();
    auto* words = mode.findChild<QLabel*>("findWords");
    EXPECT_TRUE(words->isVisible());
    connectPractice();
    EXPECT_FALSE(words->isVisible());
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
