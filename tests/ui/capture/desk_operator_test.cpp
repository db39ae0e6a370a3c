// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture_fixture.h"
#include "expect_error.h"
#include "ui/capture/operator_signals.h"

#include "spherewalk/camera/capture.h"

#include <QCheckBox>
#include <QTest>

#include <algorithm>
#include <thread>

namespace spherewalk::ui {

namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

camera::ShotOutcome outcomeAt(survey::ShotStep step) {
    camera::ShotOutcome outcome;
    outcome.shot.step = step;
    return outcome;
}

/// Columns from the first to the last one that differs from the background.
int inkedColumns(QWidget& widget) {
    const QImage shown = widget.grab().toImage();
    int first = shown.width();
    int last = -1;
    for (int x = 0; x < shown.width(); ++x) {
        for (int y = 0; y < shown.height(); ++y) {
            if (shown.pixel(x, y) != shown.pixel(shown.width() - 1, 0)) {
                first = std::min(first, x);
                last = x;
            }
        }
    }
    return last - first + 1;
}

} // namespace

TEST(ShutterKey, APressIsTakenOnce) {
    ShutterKey key;
    key.press();
    EXPECT_TRUE(key.wait(milliseconds(0), {}));
    EXPECT_FALSE(key.wait(milliseconds(0), {}));
}

TEST(ShutterKey, AForgottenPressTakesNoPicture) {
    ShutterKey key;
    key.press();
    key.forget();
    EXPECT_FALSE(key.wait(milliseconds(0), {}));
}

TEST(ShutterKey, APressWakesWhoWaits) {
    ShutterKey key;
    std::jthread person([&] { key.press(); });
    EXPECT_TRUE(key.wait(seconds(100), {}));
}

TEST(ShutterKey, AStoppedRunWaitsNoLonger) {
    ShutterKey key;
    std::stop_source stop;
    stop.request_stop();
    test::expectError(ErrorKind::Stopped, "", [&] { key.wait(seconds(30), stop.get_token()); });
}

TEST(ShutterKey, WhoeverWaitsGoesOnWhenTheOperatorLeaves) {
    ShutterKey key;
    key.leave();
    EXPECT_TRUE(key.wait(std::chrono::milliseconds(0), {}));
    EXPECT_TRUE(key.hasLeft());
    key.begin();
    EXPECT_FALSE(key.hasLeft());
    EXPECT_FALSE(key.wait(std::chrono::milliseconds(0), {}));
}

TEST(ShotQuality, IsGoodOnlyForAStoredPhotoWithoutAWord) {
    camera::ShotOutcome stored = outcomeAt(survey::ShotStep::Downloaded);
    EXPECT_EQ(qualityOf(stored, nullptr), survey::Quality::Good);
    stored.warnings = {"The battery is low."};
    EXPECT_EQ(qualityOf(stored, nullptr), survey::Quality::Doubtful);
}

TEST(ShotQuality, APhotoOnTheCameraIsDoubtfulAndNoPhotoIsFailed) {
    EXPECT_EQ(qualityOf(outcomeAt(survey::ShotStep::Taken), nullptr), survey::Quality::Doubtful);
    EXPECT_EQ(qualityOf(outcomeAt(survey::ShotStep::NotTaken), nullptr), survey::Quality::Failed);
}

TEST(BigText, GrowsWithItsPlace) {
    BigText words;
    words.setText("Rail 3, stop 12");
    words.resize(200, 50);
    const int small = inkedColumns(words);
    words.resize(400, 100);
    EXPECT_GT(inkedColumns(words), 1.5 * small);
    EXPECT_EQ(words.accessibleName(), "Rail 3, stop 12");
}

using PracticeRunTest = CaptureFixture;

TEST_F(PracticeRunTest, TakesEveryPhotoWithoutAKey) {
    desk().runPractice();
    waitUntil([&] { return desk().state() == CaptureDesk::State::Ready && desk().stationsLeft() == 0; });
    EXPECT_EQ(session->store().counts().photos, desk().stations());
}

TEST_F(PracticeRunTest, TicksTheBoxThatLeavesTheKeyOut) {
    desk().runPractice();
    EXPECT_TRUE(mode.findChild<QCheckBox*>("automatic")->isChecked());
}

TEST_F(PracticeRunTest, ALaterConnectionStartsNoRun) {
    desk().runPractice();
    waitUntil([&] { return desk().state() == CaptureDesk::State::Ready && desk().stationsLeft() == 0; });
    desk().setAgain(session->store().stations().front().id, true);
    connectPractice();
    EXPECT_EQ(desk().stationsLeft(), 1);
}

TEST_F(PracticeRunTest, AConnectionAfterAPracticeCameraThatFailedStartsNoRun) {
    const PracticeSettings working = desk().practiceSettings();
    PracticeSettings broken = working;
    broken.width = 3; // no photo has an odd width
    desk().setPracticeSettings(broken);
    desk().runPractice();
    waitUntil([&] { return desk().state() == CaptureDesk::State::NoCamera; });
    EXPECT_FALSE(desk().sentence().isEmpty());
    desk().setPracticeSettings(working);
    connectPractice();
    EXPECT_EQ(desk().stationsLeft(), desk().stations());
    EXPECT_FALSE(desk().isRunning());
}

} // namespace spherewalk::ui
