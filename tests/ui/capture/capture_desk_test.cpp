// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture_fixture.h"
#include "event_loop_gap.h"
#include "stalled_server.h"
#include "ui/shell/application.h"

#include "spherewalk/base/file.h"
#include "spherewalk/practice/fault.h"
#include "spherewalk/practice/theta_jpeg.h"

#include <QLabel>
#include <QPushButton>
#include <QTranslator>

namespace spherewalk::ui {

using State = CaptureDesk::State;

namespace {

/// Options of a camera that the desk does not own.
practice::PracticeCameraOptions quickCamera() {
    practice::PracticeCameraOptions options;
    options.width = 1024;
    options.timeScale = 0.001;
    return options;
}

class CaptureDeskTest : public CaptureFixture {
  protected:
    /// Asks a practice camera that refuses for a picture.
    void shootInVain() {
        connectPractice();
        desk().trigger();
        waitFor(State::AtStation);
        desk().practice()->camera().arm(
            {practice::FaultKind::ServiceUnavailable, "camera.takePicture", 0, 50, 0});
        desk().trigger();
        waitFor(State::AskAgain);
    }
};

} // namespace

TEST_F(CaptureDeskTest, TellsARefusalOfTheCameraInTheWindowsLanguage) {
    QTranslator german;
    ASSERT_TRUE(loadWords(german, QLocale("de")));
    QCoreApplication::installTranslator(&german);
    shootInVain();
    EXPECT_TRUE(desk().sentence().contains("warten Sie einen Augenblick")) << desk().sentence().toStdString();
    EXPECT_FALSE(desk().sentence().contains("refused"));
    QCoreApplication::removeTranslator(&german);
}

TEST_F(CaptureDeskTest, SaysHowTheCameraIs) {
    connectPractice();
    ASSERT_TRUE(desk().camera());
    EXPECT_FALSE(desk().camera()->model.isEmpty());
    EXPECT_TRUE(desk().camera()->batteryFraction);
    EXPECT_TRUE(desk().camera()->remainingPhotos);
}

TEST_F(CaptureDeskTest, SaysWhyAnAddressIsNone) {
    desk().connectTo("https://camera");
    EXPECT_EQ(desk().state(), State::NoCamera);
    EXPECT_EQ(desk().verdict(), survey::Quality::Failed);
    EXPECT_FALSE(desk().sentence().isEmpty());
}

TEST_F(CaptureDeskTest, WaitsForTheKeyAtEachStation) {
    connectPractice();
    desk().trigger();
    waitFor(State::AtStation);
    EXPECT_EQ(desk().next()->station.stop, 0);
    EXPECT_EQ(desk().practice()->camera().stats().exposures, 0);
    desk().trigger();
    waitUntil(
        [&] { return desk().state() == State::AtStation && desk().stationsLeft() == desk().stations() - 1; });
    EXPECT_EQ(desk().practice()->camera().stats().exposures, 1);
    EXPECT_EQ(played, std::vector<survey::Quality>{survey::Quality::Good});
}

TEST_F(CaptureDeskTest, ResumesAtTheExactStation) {
    connectPractice();
    desk().trigger();
    waitFor(State::AtStation);
    desk().trigger();
    waitUntil([&] { return desk().state() == State::AtStation && !played.empty(); });
    const std::int64_t next = desk().next()->id;
    desk().stop();
    waitFor(State::Ready);
    EXPECT_EQ(desk().next()->id, next);
    desk().trigger();
    waitFor(State::AtStation);
    EXPECT_EQ(desk().next()->id, next);
}

TEST_F(CaptureDeskTest, TriesAgainWhenNoPictureWasTaken) {
    shootInVain();
    EXPECT_EQ(desk().verdict(), survey::Quality::Failed);
    EXPECT_FALSE(desk().sentence().isEmpty());
    desk().practice()->camera().arm({practice::FaultKind::ServiceUnavailable, "/nothing", 0, 1, 0});
}

TEST_F(CaptureDeskTest, TakesAStationAgainThatHasAPhoto) {
    connectPractice();
    desk().setAutomatic(true);
    desk().trigger();
    waitUntil([&] { return desk().state() == State::Ready && desk().stationsLeft() == 0; });
    const std::int64_t station = session->store().stations().front().id;
    const std::int64_t before = session->store().chosenPhoto(station)->id;
    desk().setAgain(station, true);
    ASSERT_EQ(desk().again().size(), 1U);
    EXPECT_EQ(desk().next()->id, station);
    desk().trigger();
    waitUntil([&] { return desk().state() == State::Ready && desk().stationsLeft() == 0; });
    EXPECT_EQ(session->store().photosAt(station).size(), 2U);
    EXPECT_NE(session->store().chosenPhoto(station)->id, before);
}

TEST_F(CaptureDeskTest, APhotoThatCannotBeHadIsTakenAgainInTheNextRun) {
    connectPractice();
    desk().setAutomatic(true);
    desk().practice()->camera().arm({practice::FaultKind::SmallPhoto, "camera.takePicture", 0, 1, 0});
    desk().trigger();
    waitUntil([&] { return desk().state() == State::Ready && !played.empty(); });
    EXPECT_EQ(played.front(), survey::Quality::Doubtful); // it may be had later
    ASSERT_EQ(desk().stationsLeft(), 1);
    const auto photos = session->store().counts().photos;
    desk().trigger();
    waitUntil([&] { return desk().state() == State::Ready && desk().stationsLeft() == 0; });
    EXPECT_EQ(played.back(), survey::Quality::Good) << desk().sentence().toStdString();
    EXPECT_EQ(session->store().counts().photos, photos + 1);
}

TEST_F(CaptureDeskTest, OffersAPhotoThatTheChecksFailedToBeTakenAgain) {
    practice::PracticeCameraOptions options;
    options.width = 1024;
    options.photoFolder = folder / "black";
    std::filesystem::create_directories(options.photoFolder);
    writeFile(options.photoFolder / "a.JPG", practice::thetaJpeg(RgbImage(1024, 512), {}));
    options.photos = {{"a.JPG", {}, {}}};
    practice::PracticeCamera dark(options);
    dark.start();
    desk().connectTo(QString("127.0.0.1:%1").arg(dark.port()));
    waitFor(State::Ready);
    desk().trigger();
    waitFor(State::AtStation);
    const std::int64_t station = desk().next()->id;
    desk().trigger();
    waitUntil([&] { return !played.empty(); });
    EXPECT_EQ(played.front(), survey::Quality::Failed);
    EXPECT_TRUE(desk().sentence().contains("dark")) << desk().sentence().toStdString();
    EXPECT_TRUE(desk().isAgain(station));
    desk().stop();
    waitFor(State::Ready);
    EXPECT_EQ(desk().next()->id, station);
    desk().trigger();
    waitFor(State::AtStation);
    EXPECT_EQ(desk().next()->id, station);
}

TEST_F(CaptureDeskTest, AnotherCameraWaitsForTheKeyAfterThePracticeCamera) {
    desk().runPractice();
    waitUntil([&] { return desk().state() == State::Ready && desk().stationsLeft() == 0; });
    practice::PracticeCamera other(quickCamera());
    other.start();
    jobs::newPracticeSurvey(folder / "flat.spherewalk", 1.2);
    const auto flat = SurveySession::open(QString::fromStdString((folder / "flat.spherewalk").string()));
    mode.setSession(flat.get());
    desk().connectTo(QString("127.0.0.1:%1").arg(other.port()));
    waitFor(State::Ready);
    EXPECT_FALSE(desk().isAutomatic());
    auto* key = mode.findChild<QPushButton*>("shutter");
    key->click();
    waitFor(State::AtStation);
    EXPECT_TRUE(key->isEnabled());
    key->click();
    waitUntil(
        [&] { return desk().state() == State::AtStation && desk().stationsLeft() == desk().stations() - 1; });
    EXPECT_EQ(other.stats().exposures, 1);
    mode.setSession(session.get());
    waitFor(State::Ready); // the run that was stopped has ended
}

TEST_F(CaptureDeskTest, AnotherCameraShootsInTheSameSurveyToo) {
    connectPractice();
    desk().setAutomatic(true);
    practice::PracticeCamera other(quickCamera());
    other.start();
    desk().connectTo(QString("127.0.0.1:%1").arg(other.port()));
    waitFor(State::Ready);
    desk().trigger();
    waitFor(State::AtStation);
    desk().trigger();
    waitUntil([&] { return other.stats().exposures == 1; });
    EXPECT_EQ(desk().practice()->camera().stats().exposures, 0);
}

TEST_F(CaptureDeskTest, ThePracticeCameraIsLeftWithItsSurvey) {
    connectPractice();
    EXPECT_TRUE(desk().hasPracticeCamera());
    jobs::newPracticeSurvey(folder / "flat.spherewalk", 1.2);
    const auto flat = SurveySession::open(QString::fromStdString((folder / "flat.spherewalk").string()));
    mode.setSession(flat.get());
    EXPECT_EQ(desk().state(), State::NoCamera);
    EXPECT_FALSE(desk().hasPracticeCamera());
    EXPECT_FALSE(desk().camera());
    desk().trigger(); // what a Return does
    EXPECT_FALSE(desk().isRunning());
    EXPECT_EQ(flat->store().counts().photos, 0);
    mode.setSession(session.get());
}

TEST_F(CaptureDeskTest, ARunOfThePracticeCameraEndsWithItsSurvey) {
    connectPractice();
    desk().trigger();
    waitFor(State::AtStation);
    mode.setSession(nullptr);
    waitFor(State::NoCamera);
    EXPECT_FALSE(desk().camera());
}

TEST_F(CaptureDeskTest, ThePracticeCameraIsLeftWhileItIsConnected) {
    desk().connectToPractice();
    ASSERT_EQ(desk().state(), State::Connecting);
    mode.setSession(nullptr);
    EXPECT_EQ(desk().state(), State::NoCamera);
    QCoreApplication::processEvents();
    EXPECT_FALSE(desk().hasPracticeCamera());
    EXPECT_EQ(desk().state(), State::NoCamera);
}

TEST_F(CaptureDeskTest, AnotherSurveyBeginsWithThePlansPace) {
    connectPractice();
    desk().setAutomatic(true);
    desk().trigger();
    waitUntil([&] { return desk().state() == State::Ready && desk().stationsLeft() == 0; });
    ASSERT_TRUE(desk().photosAMinute());
    mode.setSession(nullptr);
    mode.setSession(session.get());
    EXPECT_FALSE(desk().photosAMinute());
}

TEST_F(CaptureDeskTest, SeesThatACameraAtRestIsSwitchedOff) {
    practice::PracticeCameraOptions options;
    options.width = 1024;
    options.timeScale = 0.001;
    practice::PracticeCamera camera(options);
    camera.start();
    desk().connectTo(QString("127.0.0.1:%1").arg(camera.port()));
    waitFor(State::Ready);
    ASSERT_TRUE(desk().camera()->batteryFraction);
    EXPECT_FALSE(desk().isSilent());
    camera.stop();
    waitUntil([&] { return desk().isSilent(); });
    EXPECT_FALSE(desk().sentence().isEmpty());
    EXPECT_FALSE(desk().camera()->batteryFraction);
    EXPECT_EQ(mode.findChild<QLabel*>("capture")->text(), "no answer");
    EXPECT_FALSE(mode.findChild<QLabel*>("battery")->text().contains('%'));
    EXPECT_EQ(desk().state(), State::Ready); // it may come back
}

TEST_F(CaptureDeskTest, AnotherCameraBeginsWithThePlansPace) {
    connectPractice();
    desk().setAutomatic(true);
    desk().trigger();
    waitUntil([&] { return desk().state() == State::Ready && desk().stationsLeft() == 0; });
    EXPECT_TRUE(desk().photosAMinute());
    desk().connectTo("127.0.0.1:1");
    EXPECT_FALSE(desk().photosAMinute());
    waitFor(State::NoCamera);
}

TEST_F(CaptureDeskTest, AKeyDuringTheCountdownEndsIt) {
    connectPractice();
    desk().setHideSeconds(30);
    desk().trigger();
    waitFor(State::AtStation);
    desk().trigger();
    EXPECT_EQ(desk().state(), State::Hiding);
    EXPECT_EQ(desk().countdown(), 30);
    desk().trigger();
    EXPECT_EQ(desk().state(), State::AtStation);
    EXPECT_EQ(desk().practice()->camera().stats().exposures, 0);
}

TEST_F(CaptureDeskTest, AStalledCameraDoesNotHoldTheWindow) {
    const test::StalledServer server;
    desk().connectTo(server.address());
    ASSERT_EQ(desk().state(), State::Connecting);
    const double heldMs = test::heldMs([this](const test::EventLoopGap& gap) {
        waitUntil([&] { return gap.beats() > 500; });
        EXPECT_EQ(desk().state(), State::Connecting); // it does hang
    });
    EXPECT_LT(heldMs, test::kMostHeldMs);
    RecordProperty("longest_gap_ms", std::to_string(heldMs));
    desk().stop();
    waitFor(State::NoCamera);
}

TEST_F(CaptureDeskTest, AWholeRunDoesNotHoldTheWindow) {
    // The camera draws its photos beside it, so a busy machine adds to what is measured.
    constexpr double kHeldMs = 10 * test::kMostHeldMs;
    connectPractice();
    desk().setAutomatic(true);
    const test::EventLoopGap gap;
    desk().trigger();
    waitUntil([&] { return desk().state() == State::Ready && desk().stationsLeft() == 0; });
    EXPECT_LT(gap.longestMs(), kHeldMs);
    RecordProperty("longest_gap_ms", std::to_string(gap.longestMs()));
}

TEST(Pace, IsThePlansUntilItsOwnIsKnown) {
    using namespace std::chrono_literals;
    survey::PlanOptions plan;
    plan.secondsPerPhoto = 10;
    plan.secondsPerPlacement = 100;
    const Clock::TimePoint begin{};
    Pace pace;
    pace.begin(begin);
    EXPECT_EQ(pace.left(6, 2, plan), 260s);
    EXPECT_FALSE(pace.photosAMinute());
    for (int i = 1; i <= 4; ++i) {
        pace.photo(begin + i * 30s);
    }
    EXPECT_DOUBLE_EQ(*pace.photosAMinute(), 2);
    EXPECT_EQ(pace.left(6, 2, plan), 180s);
}

} // namespace spherewalk::ui
