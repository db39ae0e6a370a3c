// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture_fixture.h"
#include "made_survey.h"
#include "ui/capture/camera_panel.h"
#include "ui/capture/operator_signals.h"
#include "ui/look/theme.h"
#include "ui/look/told_label.h"
#include "ui/shell/application.h"

#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QTest>
#include <QTranslator>
#include <sqlite3.h>

namespace spherewalk::ui {

using State = CaptureDesk::State;
using CaptureModeTest = CaptureFixture;

TEST_F(CaptureModeTest, NamesTheRoomOfTheNextStationAndHowFarItIs) {
    session->write(SurveySession::Plan, [](store::SurveyStore& store) {
        survey::Room room = store.room();
        const Bounds2 extent = bounds(room.outline);
        room.names = {{"kitchen", 0.5 * (extent.least + extent.greatest)}};
        store.replacePlan(room, store.planOptions(), survey::plan(room, store.planOptions()));
    });
    connectPractice();
    const QString all = QString::number(desk().stations());
    EXPECT_TRUE(desk().wayText().startsWith("kitchen: 0 of " + all + " taken\n"))
        << desk().wayText().toStdString();
    desk().trigger();
    waitFor(CaptureDesk::State::AtStation);
    desk().trigger();
    waitUntil([&] { return desk().stationsLeft() == desk().stations() - 1; });
    waitFor(CaptureDesk::State::AtStation);
    EXPECT_TRUE(desk().wayText().startsWith("kitchen: 1 of " + all + " taken\n"))
        << desk().wayText().toStdString();
}

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
    EXPECT_EQ(mode.findChild<ToldLabel*>("verdict")->words(), desk().sentence());
    EXPECT_EQ(desk().told().cure, Cure::Connecting);
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

TEST_F(CaptureModeTest, SaysAtTheEndWhatWasTakenAndWhatComesNext) {
    connectPractice();
    desk().setAutomatic(true);
    desk().trigger();
    waitUntil([&] { return desk().isComplete(); });
    const auto photos = session->store().chosenPhotos();
    session->write(SurveySession::Photos, [&](store::SurveyStore& store) {
        for (const store::PhotoRecord& photo : photos) {
            store.setVerdict({photo.id, survey::Quality::Good, "[]"});
        }
        store.setVerdict({photos.at(0).id, survey::Quality::Doubtful, "[]"});
        store.setVerdict({photos.at(1).id, survey::Quality::Failed, "[]"});
    });
    EXPECT_EQ(mode.findChild<BigText*>("nextStation")->text(),
              QString("%1 taken, 1 doubtful, 1 failed").arg(desk().stations()));
    EXPECT_FALSE(mode.findChild<QPushButton*>("shutter")->isVisible());
    QSignalSpy wanted(&mode, &Mode::pageRequested);
    QTest::keyClick(&mode, Qt::Key_R);
    QTest::keyClick(&mode, Qt::Key_A);
    QTest::keyClick(&mode, Qt::Key_Space); // the first of the buttons
    ASSERT_EQ(wanted.size(), 3);
    EXPECT_EQ(wanted[0][0].toString(), "review");
    EXPECT_EQ(wanted[1][0].toString(), "align");
    EXPECT_EQ(wanted[2][0].toString(), "review");
    QTest::keyClick(&mode, Qt::Key_T);
    EXPECT_EQ(desk().stationsLeft(), 2);
    EXPECT_TRUE(mode.findChild<QPushButton*>("shutter")->isVisible());
}

TEST_F(CaptureModeTest, AtTheEndOfAGoodSurveyTheKeyGoesOnToAlign) {
    connectPractice();
    desk().setAutomatic(true);
    desk().trigger();
    waitUntil([&] { return desk().isComplete(); });
    session->write(SurveySession::Photos, [&](store::SurveyStore& store) {
        for (const store::PhotoRecord& photo : store.chosenPhotos()) {
            store.setVerdict({photo.id, survey::Quality::Good, "[]"});
        }
    });
    QSignalSpy wanted(&mode, &Mode::pageRequested);
    QTest::keyClick(&mode, Qt::Key_PageDown);
    ASSERT_EQ(wanted.size(), 1);
    EXPECT_EQ(wanted[0][0].toString(), "align");
}

TEST_F(CaptureModeTest, AWalkByHandShowsWherePhotosWereTaken) {
    const std::filesystem::path byHand = folder / "walk.spherewalk";
    store::SurveyStore::create(byHand, "walk", survey::unknownRoom(), {}, {});
    const auto walk = SurveySession::open(QString::fromStdString(byHand.string()));
    mode.setSession(walk.get());
    auto* stop = mode.findChild<QPushButton*>("stopCapture");
    auto* plan = mode.findChild<CapturePlanView*>();
    auto* toAlign = mode.findChild<QPushButton*>("goToAlign");
    connectPractice();
    EXPECT_TRUE(desk().isByHand());
    EXPECT_EQ(desk().nextText(), "Photo 1");
    EXPECT_FALSE(toAlign->isVisible());
    for (int photo = 1; photo <= 4; ++photo) {
        QTest::keyClick(&mode, Qt::Key_Space);
        waitUntil([&] {
            return desk().state() == State::AtStation && desk().nextText().endsWith(QString::number(photo));
        });
    }
    stop->click(); // what was shot comes in, and is looked at
    waitFor(State::Ready);
    waitUntil([&] { return desk().places() && desk().places()->placed.size() == 3; });
    waitUntil([&] { return plan->stations().size() == 3; });
    EXPECT_EQ(walk->state().counts.stationsWithPhoto, 3);
    EXPECT_EQ(desk().nextText(), "Photo 4");
    EXPECT_EQ(mode.findChild<BigText*>("photosLeft")->text(), "3");
    EXPECT_EQ(mode.findChild<BigText*>("timeLeft")->text(), "3");
    EXPECT_NE(walk->state().room.outline, survey::unknownRoom().outline);
    EXPECT_TRUE(toAlign->isVisible());
    EXPECT_TRUE(mode.findChild<QPushButton*>("shutter")->isEnabled());
    QSignalSpy wanted(&mode, &Mode::pageRequested);
    QTest::keyClick(&mode, Qt::Key_A);
    ASSERT_EQ(wanted.size(), 1);
    EXPECT_EQ(wanted[0][0].toString(), "align");
    QTest::keyClick(&mode, Qt::Key_Space);
    waitFor(State::AtStation);
    mode.setSession(session.get());
    waitUntil([&] { return !desk().isRunning(); });
}

TEST_F(CaptureModeTest, OnTheWholeScreenOnlyWhatTheCartNeedsIsShown) {
    connectPractice();
    desk().setHideSeconds(30);
    mode.setWholeScreen(true);
    EXPECT_FALSE(mode.findChild<CameraPanel*>()->isVisible());
    EXPECT_TRUE(mode.findChild<QLabel*>("captureState")->text().startsWith("PRACTICE"));
    desk().trigger();
    waitFor(State::AtStation);
    desk().trigger();
    EXPECT_EQ(mode.findChild<BigText*>("nextStation")->text(), "30"); // as large as it can be
    desk().trigger();
    desk().setHideSeconds(0);
    desk().trigger();
    waitUntil([&] { return !played.empty() && desk().state() == State::AtStation; });
    ASSERT_TRUE(desk().verdict());
    const QColor colour = *desk().verdict() == survey::Quality::Good ? goodColour() : doubtfulColour();
    const QImage shown = mode.grab().toImage();
    for (const QPoint& at : {QPoint(4, 400), QPoint(640, 4), QPoint(1275, 400), QPoint(640, 795)}) {
        EXPECT_EQ(shown.pixelColor(at), colour) << at.x() << ' ' << at.y();
    }
    mode.setWholeScreen(false);
    EXPECT_TRUE(mode.findChild<CameraPanel*>()->isVisible());
}

TEST_F(CaptureModeTest, LargeWordsOfTheCartMakeTheWindowNoWider) {
    QTranslator german;
    ASSERT_TRUE(loadWords(german, QLocale("de")));
    QCoreApplication::installTranslator(&german);
    connectPractice();
    desk().setHideSeconds(30);
    mode.setWholeScreen(true);
    desk().trigger();
    waitFor(State::AtStation);
    desk().trigger();
    constexpr int kSmallPx = 900;
    EXPECT_LE(mode.minimumSizeHint().width(), kSmallPx);
    desk().stop();
    mode.setWholeScreen(false);
    QCoreApplication::removeTranslator(&german);
}

TEST_F(CaptureModeTest, SaysBeforeTheFirstPhotoThatTheDiskIsTooSmall) {
    connectPractice();
    desk().trigger();
    waitFor(State::AtStation);
    desk().trigger();
    waitUntil([&] { return played.size() == 1; });
    desk().stop();
    waitFor(State::Ready);
    sqlite3* database = nullptr; // as if photos were so large that the disk has room for three
    ASSERT_EQ(sqlite3_open((path / "survey.sqlite").c_str(), &database), SQLITE_OK);
    const auto free = std::filesystem::space(path).available;
    const std::string large = "UPDATE photo SET size_bytes = " + std::to_string(free * 10 / 35);
    ASSERT_EQ(sqlite3_exec(database, large.c_str(), nullptr, nullptr, nullptr), SQLITE_OK);
    sqlite3_close(database);
    desk().trigger();
    waitFor(State::AtStation);
    const QString words = mode.findChild<ToldLabel*>("verdict")->words();
    EXPECT_TRUE(words.contains(QString("room for about 3 of the %1 photos").arg(desk().stationsLeft())))
        << words.toStdString();
    EXPECT_EQ(desk().verdict(), survey::Quality::Doubtful);
}

} // namespace spherewalk::ui
