// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture_fixture.h"
#include "event_loop_gap.h"
#include "ui/capture/live_preview.h"
#include "ui/capture/profile_form.h"

#include "spherewalk/practice/fault.h"

#include <QComboBox>
#include <QPointer>
#include <QPushButton>
#include <QTest>

#include <algorithm>
#include <numeric>

namespace spherewalk::ui {

using State = CaptureDesk::State;

namespace {

class PreviewFeedTest : public testing::Test {
  protected:
    void waitFor(PreviewFeed::State state) {
        QElapsedTimer time;
        time.start();
        QSignalSpy changes(&feed, &PreviewFeed::changed);
        while (feed.state() != state) {
            constexpr int kMostMs = 100'000;
            ASSERT_LT(time.elapsed(), kMostMs) << "state " << static_cast<int>(feed.state());
            changes.wait(50);
        }
    }

    /// Small, and with the patience that a busy machine's drawing needs.
    void start() {
        camera::PreviewOptions options;
        options.frameTimeout = std::chrono::minutes(1);
        options.mostWidth = 640;
        feed.start(host.endpoint(), 0.001, options);
    }

    PracticeHost host{{.width = 512, .timeScale = 0.001, .keepsPhotos = false}};
    PreviewFeed feed;
};

} // namespace

TEST_F(PreviewFeedTest, ShowsWhatTheCameraSees) {
    start();
    EXPECT_EQ(feed.state(), PreviewFeed::State::Starting);
    waitFor(PreviewFeed::State::Showing);
    EXPECT_EQ(feed.picture().width(), 2 * feed.picture().height());
    feed.stop();
    EXPECT_EQ(feed.state(), PreviewFeed::State::Off);
    feed.endAndWait();
    EXPECT_FALSE(feed.endAndWait());
}

TEST_F(PreviewFeedTest, ADamagedPartOnTheWayDoesNotEndIt) {
    host.camera().arm({practice::FaultKind::PreviewWithoutBoundary, "camera.getLivePreview", 0, 1, 0});
    host.camera().arm({practice::FaultKind::PreviewWrongLength, "camera.getLivePreview", 0, 1, 5});
    start();
    waitFor(PreviewFeed::State::Showing);
}

TEST_F(PreviewFeedTest, SaysWhyThereIsNone) {
    feed.start({"127.0.0.1", 1}, 0.001);
    waitFor(PreviewFeed::State::Ended);
    EXPECT_TRUE(feed.sentence().contains("127.0.0.1:1")) << feed.sentence().toStdString();
}

TEST_F(PreviewFeedTest, EndsWithTheCameras) {
    start();
    waitFor(PreviewFeed::State::Showing);
    camera::OscClient client(host.endpoint(), {}, systemClock());
    client.takePicture({});
    waitFor(PreviewFeed::State::Ended);
    EXPECT_EQ(feed.sentence(), "");
}

TEST(Brightness, CountsEachPixelOnce) {
    QImage picture(200, 100, QImage::Format_RGB32);
    picture.fill(QColor(128, 128, 128));
    for (int y = 0; y < 100; ++y) {
        for (int x = 0; x < 50; ++x) {
            picture.setPixelColor(x, y, x < 20 ? Qt::black : Qt::white);
        }
    }
    const Brightness found = brightnessOf(picture);
    EXPECT_NEAR(found.black, 0.10, 1e-9);
    EXPECT_NEAR(found.white, 0.15, 1e-9);
    EXPECT_NEAR(found.shares.front(), 0.10, 1e-9);
    EXPECT_NEAR(found.shares[32], 0.75, 1e-9);
    EXPECT_NEAR(found.shares.back(), 0.15, 1e-9);
    EXPECT_EQ(brightnessOf({}).shares.front(), 0);
}

using LivePreviewTest = CaptureFixture;

TEST_F(LivePreviewTest, HasAHistogramInItsCorner) {
    auto& view = *mode.findChild<PreviewView*>("livePreview");
    mode.findChild<QPushButton*>("showPreview")->click();
    connectPractice();
    waitUntil([&] { return desk().preview().state() == PreviewFeed::State::Showing; });
    const auto& shares = view.brightness().shares;
    EXPECT_NEAR(std::accumulate(shares.begin(), shares.end(), 0.0), 1, 1e-6);
    EXPECT_EQ(view.accessibleDescription(), view.exposureWords());
    const QImage live = view.grab().toImage();
    // The highest bar is white over all of its height.
    const auto bar = static_cast<int>(std::max_element(shares.begin(), shares.end()) - shares.begin());
    EXPECT_EQ(live.pixelColor(view.width() - 2 * 64 - 12 + 2 * bar, view.height() - 12 - 40 + 1),
              QColor(Qt::white));
}

TEST_F(LivePreviewTest, GoesOnBesideTheFormOfTheExposure) {
    const auto open = [&] {
        mode.findChild<QPushButton*>("captureProfile")->click();
        QList<ProfileForm*> forms = mode.findChildren<ProfileForm*>();
        forms.removeIf([](const ProfileForm* form) { return !form->isVisible(); });
        EXPECT_EQ(forms.size(), 1);
        return forms.value(0);
    };
    mode.findChild<QPushButton*>("showPreview")->click();
    connectPractice();
    waitUntil([&] { return desk().preview().state() == PreviewFeed::State::Showing; });
    QPointer<ProfileForm> form = open();
    ASSERT_NE(form, nullptr);
    EXPECT_FALSE(form->isModal());
    EXPECT_EQ(open(), form); // not a second one
    EXPECT_EQ(desk().preview().state(), PreviewFeed::State::Showing);
    auto* iso = form->findChild<QComboBox*>("iso");
    iso->setCurrentIndex(iso->findText("200"));
    QTest::keyClick(form, Qt::Key_Return);
    EXPECT_FALSE(form && form->isVisible());
    EXPECT_EQ(session->store().captureProfile()->iso, 200);
    form = open();
    desk().trigger(); // the run has its settings
    EXPECT_FALSE(form && form->isVisible());
}

TEST_F(LivePreviewTest, RestsDuringAShotAndGoesOnAtTheNextStation) {
    auto* view = mode.findChild<PreviewView*>("livePreview");
    EXPECT_FALSE(view->isVisibleTo(&mode));
    mode.findChild<QPushButton*>("showPreview")->click();
    EXPECT_TRUE(view->isVisibleTo(&mode));
    connectPractice();
    QSignalSpy pictures(&desk().preview(), &PreviewFeed::changed);
    const auto waitForPicture = [&] {
        while (desk().preview().state() != PreviewFeed::State::Showing && pictures.wait(100'000)) {
        }
        EXPECT_EQ(desk().preview().state(), PreviewFeed::State::Showing);
    };
    const auto shoot = [&] {
        const std::size_t shots = played.size() + 1;
        desk().trigger();
        EXPECT_EQ(desk().preview().state(), PreviewFeed::State::Off);
        waitUntil([&] { return desk().state() == State::AtStation && played.size() == shots; });
        waitForPicture();
    };
    waitForPicture();
    desk().trigger();
    EXPECT_EQ(desk().preview().state(), PreviewFeed::State::Off);
    waitFor(State::AtStation);
    waitForPicture();
    shoot();
    const double heldMs = test::heldMs([&](const test::EventLoopGap&) { shoot(); });
    EXPECT_LT(heldMs, test::kMostHeldMs);
    RecordProperty("longest_gap_ms", std::to_string(heldMs));
    EXPECT_TRUE(std::ranges::all_of(played, [](auto quality) { return quality == survey::Quality::Good; }));
    EXPECT_EQ(desk().practice()->camera().stats().exposures, static_cast<int>(played.size()));
}

TEST_F(LivePreviewTest, SwitchedOffItStaysOff) {
    connectPractice();
    desk().setShowsPreview(true);
    EXPECT_EQ(desk().preview().state(), PreviewFeed::State::Starting);
    desk().setShowsPreview(false);
    EXPECT_EQ(desk().preview().state(), PreviewFeed::State::Off);
    desk().trigger();
    waitFor(State::AtStation);
    EXPECT_EQ(desk().preview().state(), PreviewFeed::State::Off);
}

} // namespace spherewalk::ui
